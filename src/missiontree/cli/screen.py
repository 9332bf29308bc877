"""The two streams: answers go to standard output, remarks to standard error."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console, RenderableType

PIPE_WIDTH = 100


def open_missing_streams() -> None:
    """Where a stream was closed before the start, Python has none: put one in its place that nobody hears, for that is no fault."""
    sys.stdout = sys.stdout or open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115 - open to the end
    sys.stderr = sys.stderr or open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115 - open to the end


def show(view: RenderableType, colour: bool | None = None) -> None:
    """Print an answer; colour as the terminal can, unless told. Into a file or a pipe it is plain text of fixed width."""
    if colour or (colour is None and sys.stdout.isatty() and not os.environ.get("NO_COLOR")):
        _console(colour).print(view)
        return
    from missiontree.reporting.text import render

    sys.stdout.write(render(view, _console(colour).width if sys.stdout.isatty() else PIPE_WIDTH))


def say(text: str, style: str = "", colour: bool | None = None) -> None:
    """Print a line of our own words as an answer."""
    from missiontree.reporting.text import words

    show(words(text, style), colour)


def remark(text: str, colour: bool | None = None) -> None:
    """Print a line beside the answer, on standard error."""
    from rich.console import Console

    from missiontree.reporting.text import words

    width = None if sys.stderr.isatty() else PIPE_WIDTH
    plain = colour is False or (colour is None and bool(os.environ.get("NO_COLOR")))
    console = Console(stderr=True, width=width, highlight=False, soft_wrap=True)
    console.print(words(text, "" if plain else "dim"))


def _console(colour: bool | None) -> Console:
    from rich.console import Console

    width = None if sys.stdout.isatty() else PIPE_WIDTH
    return Console(
        no_color=colour is False or None, force_terminal=True if colour else None, width=width, highlight=False
    )
