"""``missiontree evaluate``: put models to a suite of missions whose right plans are known, to choose one."""

from __future__ import annotations

import os
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.files import refuse_unwritable, save
from missiontree.cli.gathering import budgets_from
from missiontree.cli.screen import remark, show
from missiontree.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from missiontree.evaluation.contestant import Contestant
    from missiontree.evaluation.evaluation import Evaluation
    from missiontree.evaluation.ledger import Ledger
    from missiontree.evaluation.run import Run

DEFAULT_SUITE = "models"
MOST_JOBS = 64


def command(
    suite: Annotated[
        str,
        typer.Argument(
            help="A built-in suite (models, english, everyday), a setting of one (paper), or a folder with a missions.yaml."
        ),
    ] = DEFAULT_SUITE,
    model: Annotated[
        list[str] | None,
        typer.Option(
            "--model",
            metavar="MODEL",
            help=(
                "A model to be compared; may be given several times. openai:NAME@http://HOST/v1 is asked at that address. "
                "Default: MISSIONTREE_MODEL, else offline."
            ),
        ),
    ] = None,
    base_url: options.BaseUrl = None,
    runs: Annotated[
        int,
        typer.Option("--runs", metavar="N", help="Runs of each mission by each model. Default 1.", show_default=False),
    ] = 1,
    jobs: Annotated[
        int, typer.Option("--jobs", metavar="N", help="Most runs at a time. Default 1.", show_default=False)
    ] = 1,
    only: Annotated[
        list[str] | None,
        typer.Option(
            "--only",
            metavar="PATTERN",
            help="Missions whose id or setting fits, such as 'mine-*'; may be given several times. Default: all.",
        ),
    ] = None,
    results: Annotated[
        Path | None,
        typer.Option(
            "--results", metavar="FILE", help="Keep each run in this file; what it holds already is not run again."
        ),
    ] = None,
    whole: Annotated[
        bool, typer.Option("--plan", help="Plan each tree to its end, too: ranked, scheduled, checked.")
    ] = False,
    as_json: Annotated[
        Path | None,
        typer.Option("--json", metavar="FILE", help="Write everything to this file as JSON; - prints it instead."),
    ] = None,
    html: Annotated[
        Path | None, typer.Option("--html", metavar="FILE", help="Write one page of HTML to this file.")
    ] = None,
    fail_under: Annotated[
        float | None,
        typer.Option(
            "--fail-under",
            metavar="SHARE",
            help="End with exit code 6 if pass^1 of some model is below this share, from 0 to 1.",
        ),
    ] = None,
    max_turns: options.MaxTurns = None,
    max_tokens: options.MaxTokens = None,
    max_seconds: options.MaxSeconds = None,
    quiet: options.Quiet = False,
    colour: options.Colour = None,
) -> int:
    """Put models to a suite of missions: how often each is right, in what it errs, what it takes."""
    _check_numbers(runs, jobs, fail_under)
    to_screen = as_json is not None and str(as_json) == "-"
    for file in (None if to_screen else as_json, html, results):
        refuse_unwritable(file)
    from missiontree.evaluation.built_in import suite_named
    from missiontree.evaluation.evaluation import Course, evaluate
    from missiontree.evaluation.examiner import Examiner
    from missiontree.evaluation.selection import chosen

    budgets = budgets_from(max_turns, max_tokens, max_seconds)
    name, loaded = suite_named(suite)
    missions = chosen(loaded, only or [])
    contestants = _contestants(model, base_url or "")
    examiner = Examiner(whole=whole) if budgets is None else Examiner(whole=whole, budgets=budgets)
    with ExitStack() as open_files:
        ledger = _ledger(results)
        if ledger is not None and not quiet:
            _tell_of_changes(ledger.changed(missions, whole), results, colour)
        course = Course(
            runs=runs,
            jobs=jobs,
            known=ledger.runs if ledger is not None else {},
            keep=open_files.enter_context(ledger.opened()) if ledger is not None else _forget,
            report=_progress(quiet or to_screen),
            examiner=examiner,
        )
        evaluation = evaluate(name, missions, contestants, course)
    _deliver(evaluation, as_json, to_screen, html, quiet, colour)
    if evaluation.interrupted:
        remark(_how_to_go_on(evaluation, results), colour)
        raise SystemExit(Exit.INTERRUPTED)  # not an exit code returned, of which it would be said that nothing is kept
    return _exit_code(evaluation, fail_under, colour)


def _check_numbers(runs: int, jobs: int, fail_under: float | None) -> None:
    if runs < 1:
        raise InputError(f"--runs {runs}", accepted="a whole number of at least 1")
    if not 1 <= jobs <= MOST_JOBS:
        raise InputError(f"--jobs {jobs}", accepted=f"a whole number from 1 to {MOST_JOBS}")
    if fail_under is not None and not 0 <= fail_under <= 1:
        raise InputError(f"--fail-under {fail_under:g}", accepted="a share from 0 to 1, such as 0.9")


def _contestants(models: list[str] | None, base_url: str) -> list[Contestant]:
    from missiontree.evaluation.contestant import named

    contestants = [named(name, base_url) for name in models or [os.environ.get("MISSIONTREE_MODEL") or "offline"]]
    names = [contestant.name for contestant in contestants]
    if twice := [name for place, name in enumerate(names) if name in names[:place]]:
        raise InputError(f"--model {twice[0]!r:.100} is given twice", accepted="each model once; --runs repeats it")
    return contestants


def _ledger(results: Path | None) -> Ledger | None:
    from missiontree.evaluation.ledger import read_ledger

    return None if results is None else read_ledger(results)


def _tell_of_changes(changed: Sequence[str], results: Path | None, colour: bool | None) -> None:
    """Say which missions are not what they were when their results were kept."""
    if changed:
        names = ", ".join(changed[:5]) + (f" and {len(changed) - 5} more" if len(changed) > 5 else "")
        remark(
            f"not used of {results}: results of missions that have changed since ({names}); they are run again", colour
        )


def _forget(run: Run) -> None:
    """Keep nothing."""


def _progress(quiet: bool) -> Callable[[int, int, Run | None], None]:
    """A line on a terminal that is written over with each run."""
    live = not quiet and sys.stderr.isatty()

    def report(done: int, size: int, run: Run | None) -> None:
        if not live:
            return
        from missiontree.evaluation.in_words import VERDICT_NAMES
        from missiontree.reporting.escape import one_line

        last = f": {run.mission} by {one_line(run.model)}: {VERDICT_NAMES[run.kind]}" if run is not None else ""
        end = "\n" if done == size else ""
        sys.stderr.write(f"\r\x1b[K{f'{done} of {size} runs{last}'[:100]}{end}")
        sys.stderr.flush()

    return report


def _deliver(
    evaluation: Evaluation,
    as_json: Path | None,
    to_screen: bool,
    html: Path | None,
    quiet: bool,
    colour: bool | None,
) -> None:
    """Print the tables, and write what is asked for."""
    from missiontree.evaluation.page import page
    from missiontree.evaluation.plain import plain_evaluation
    from missiontree.evaluation.table_view import evaluation_view
    from missiontree.formats.json_text import json_text
    from missiontree.llm.history import readable

    plain = readable(json_text(plain_evaluation(evaluation)))
    if to_screen:
        typer.echo(plain, nl=False)
    else:
        show(evaluation_view(evaluation), colour)
    if as_json is not None and not to_screen:
        save(as_json, plain)
    if html is not None:
        save(html, page(evaluation))
    for file in (None if to_screen else as_json, html):
        if file is not None and not quiet:
            remark(f"written to {file}", colour)


def _how_to_go_on(evaluation: Evaluation, results: Path | None) -> str:
    done = f"interrupted: {len(evaluation.runs)} of {evaluation.size} runs are done"
    if results is None:
        return f"{done}, and not kept in a file; with --results FILE the same command would go on from here."
    return f"{done} and kept in {results}; the same command goes on from here."


def _exit_code(evaluation: Evaluation, fail_under: float | None, colour: bool | None) -> int:
    from missiontree.evaluation.in_words import share
    from missiontree.evaluation.summary import summaries

    if evaluation.stopped:
        return Exit.FAILED
    below = [summary for summary in summaries(evaluation) if fail_under is not None and summary.right < fail_under]
    for summary in below:
        remark(f"{summary.model}: pass^1 is {share(summary.right)}, below {fail_under:g}", colour)
    return Exit.FAULTS if below else Exit.DELIVERED
