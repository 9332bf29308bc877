"""What a person sees while a language model builds a tree: its words as they come, what was called, and what it took."""

from __future__ import annotations

import sys
from dataclasses import replace
from typing import TYPE_CHECKING

from missiontree.cli.screen import remark

if TYPE_CHECKING:
    from missiontree.authoring.outcome import Authored
    from missiontree.briefing import Request
    from missiontree.mission.control import Progress
    from missiontree.mission.reason import Reason


class Watch:
    """
    Shows a dialogue on standard error.

    Parameters
    ----------
    quiet
        Show nothing.
    colour
        As the other commands take it.
    """

    def __init__(self, quiet: bool, colour: bool | None) -> None:
        self._quiet, self._colour = quiet, colour
        self._turns = 0
        self._in_line = False
        self._live = not quiet and sys.stderr.isatty()

    def listen(self, piece: str) -> None:
        """A piece of the model's text. Only a terminal shows it; it is made harmless first."""
        if self._live:
            from missiontree.reporting.escape import terminal_safe

            sys.stderr.write(terminal_safe(piece))
            sys.stderr.flush()
            self._in_line = True

    def report(self, progress: Progress) -> None:
        """A turn has ended."""
        if self._quiet:
            return
        self._turns += 1
        if self._in_line:
            sys.stderr.write("\n")
            self._in_line = False
        calls = "1 call" if progress.done == 1 else f"{progress.done} calls"
        remark(f"turn {self._turns}: {calls} so far, {progress.found} nodes", self._colour)


def authored(request: Request, quiet: bool, colour: bool | None) -> Authored:
    """
    Have the tree of a mission built under the eyes of the operator.

    Ctrl-C ends a dialogue at once and keeps the tree so far, unlike later stages, which are asked to stop.
    """
    from missiontree.mission.control import Control
    from missiontree.planner import author

    advice = advised(request, quiet, colour)
    watch = Watch(quiet, colour)
    made = author(request, Control(report=watch.report, seed=request.seed), watch.listen)
    made = replace(made, notices=(*made.notices, *advice))
    if made.spent is not None and not quiet:
        from missiontree.reporting.spent_view import author_in_words

        remark(author_in_words(made.author, made.model, made.spent), colour)
    return made


def advised(request: Request, quiet: bool, colour: bool | None) -> tuple[Reason, ...]:
    """What is evident before a language model is asked, shown before anything is spent; it keeps nobody from asking."""
    from missiontree.explaining.advice import advice_on, asks_a_model

    advice = advice_on(request) if asks_a_model(request) else ()
    for reason in () if quiet else advice:
        remark(f"advice: {reason.message}", colour)
    if advice and not quiet:
        remark("advice, no verdict: read without a model, which is asked all the same", colour)
    return advice


def hint_at_keys(request: Request, colour: bool | None) -> None:
    """A key that lies about in the environment earns a hint, and is never used unasked."""
    import os

    from missiontree.llm.opening import keys_found

    if request.model != "offline" or request.tree is not None or os.environ.get("MISSIONTREE_MODEL"):
        return
    for key, provider in keys_found(os.environ):
        say = (
            f"{key} is set: --model {provider.name}:NAME would have a language model build the tree. Nothing was sent."
        )
        remark(say, colour)
