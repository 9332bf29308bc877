"""The parser. Each command lives in a file of its own and imports what it needs when it runs."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable
from functools import cache
from typing import Annotated, Any, NoReturn

import typer
from typer.main import get_command

from missiontree import __version__
from missiontree.cli import (
    check,
    compare,
    evaluate,
    explain,
    export,
    init,
    learn,
    models,
    plan,
    rank,
    schedule,
    schema,
    show,
)
from missiontree.cli.collecting import collect_seldom
from missiontree.cli.ending import end
from missiontree.cli.exits import Exit, guarded
from missiontree.cli.interrupt import interrupts
from missiontree.cli.screen import open_missing_streams
from missiontree.errors import InputError

JARGON = {
    "Input should be a valid integer, unable to parse string as an integer": "a whole number is needed.",
    "Input should be a valid number, unable to parse string as a number": "a number is needed.",
}

app = typer.Typer(
    name="missiontree",
    help="From a sentence to a checked, ranked, scheduled plan for a mixed team of robots.",
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.command("plan")(plan.command)
app.command("show")(show.command)
app.command("check")(check.command)
app.command("compare")(compare.command)
app.command("explain")(explain.command)
app.command("evaluate")(evaluate.command)
app.command("export-training")(export.command)
app.command("init")(init.command)
app.command("learn")(learn.command)
app.command("models")(models.command)
app.command("rank")(rank.command)
app.command("schedule")(schedule.command)
app.command("schema")(schema.command)


def _version(asked: bool) -> None:
    if asked:
        typer.echo(f"missiontree {__version__}")
        raise typer.Exit


@app.callback()
def options(
    version: Annotated[
        bool, typer.Option("--version", help="Print the version.", callback=_version, is_eager=True)
    ] = False,
    debug: Annotated[bool, typer.Option("--debug", help="Show the traceback of an internal error.")] = False,
) -> None:
    """Take the options that stand before the command."""


def main() -> NoReturn:
    """Entry point of the command ``missiontree``: the process ends with it."""
    open_missing_streams()
    collect_seldom()
    end(command_line())


def command_line() -> int:
    """Do what stands on the command line; its exit code. The process goes on, as tests and profilers want it."""
    signal.signal(signal.SIGTERM, interrupts)
    return guarded(_run, debug="--debug" in sys.argv)


def _plainly(message: str) -> str:
    """The parser's message without its checker's jargon."""
    for jargon, words in JARGON.items():
        message = message.replace(jargon, words)
    return message


@cache
def _parser() -> Callable[..., Any]:
    """Made once per process: making it reads the signatures of all commands."""
    return get_command(app)


def _run() -> int:
    if len(sys.argv) == 1:
        sys.argv.append("--help")
    try:
        code = _parser()(standalone_mode=False)
    except typer.TyperException as error:
        raise InputError(
            _plainly(error.format_message()), hint="`missiontree COMMAND --help` lists what a command takes."
        ) from error
    except typer.Abort as error:
        raise KeyboardInterrupt from error
    if code == Exit.INTERRUPTED:  # the parser turns an interruption into a code before anybody is told
        raise KeyboardInterrupt
    sys.stdout.flush()
    return code if isinstance(code, int) else Exit.DELIVERED
