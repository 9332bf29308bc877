"""Ctrl-C, and SIGTERM: the first one asks long work to stop with what it has, the second one, or one with nothing to keep, interrupts."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.mission.control import Control, Progress

SIGNALS = (signal.SIGINT, signal.SIGTERM)


def interrupts(signum: int, frame: object) -> None:
    """Handle a signal as Ctrl-C is handled."""
    raise KeyboardInterrupt


def deaf() -> None:
    """Hear no signal any more."""
    for one in SIGNALS:
        signal.signal(one, signal.SIG_IGN)


@dataclass
class Kept:
    """
    Whether long work has found anything that is worth keeping.

    Parameters
    ----------
    stage
        Of progress: what is found there is.
    anything
        Whether anything was found; whoever knows it otherwise may say so. Default: nothing was.
    """

    stage: str
    anything: bool = False

    def hear(self, progress: Progress) -> None:
        """Listen to progress."""
        self.anything = self.anything or (progress.stage == self.stage and progress.found > 0)


@contextmanager
def controlled(
    time_limit_s: float | None,
    seed: int,
    report: Callable[[Progress], None] | None = None,
    kept: Kept | None = None,
) -> Iterator[Control]:
    """
    Limits of one run, with Ctrl-C and SIGTERM as its stop token.

    What was found when the first of them comes is to be shown within this context, so that it is not lost on the way.

    Parameters
    ----------
    time_limit_s, seed
        As in :class:`missiontree.mission.control.Control`.
    report
        Told of progress. Default: nobody is.
    kept
        Told of progress as well. Long work that is asked to stop while there is nothing to keep ends where it asks whether it is to stop.
        Default: it ends as it does when there is something.

    Raises
    ------
    InputError
        If the time limit is not a number of seconds.
    KeyboardInterrupt
        Out of the stop token, if the work is to stop and there is nothing to keep.
    """
    from missiontree.mission.control import Control, silent

    if time_limit_s is not None and not time_limit_s >= 0:
        raise InputError(f"--time-limit {time_limit_s}", accepted="a number of seconds of at least 0")
    asked: list[bool] = []

    def ask(signum: int, frame: object) -> None:
        asked.append(True)
        for one in SIGNALS:
            signal.signal(one, interrupts)

    def stop() -> bool:
        if asked and kept is not None and not kept.anything and threading.current_thread() is threading.main_thread():
            raise KeyboardInterrupt
        return bool(asked)

    def heard(progress: Progress) -> None:
        if kept is not None:
            kept.hear(progress)
        (report or silent)(progress)

    before = {one: signal.signal(one, ask) for one in SIGNALS}
    try:
        yield Control(time_limit_s=time_limit_s, stop=stop, report=heard, seed=seed)
    finally:
        for one, handler in before.items():
            signal.signal(one, handler)
