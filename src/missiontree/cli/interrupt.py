"""Ctrl-C, and SIGTERM: the first one asks long work to stop with what it has, the second one interrupts."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
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


@contextmanager
def controlled(
    time_limit_s: float | None, seed: int, report: Callable[[Progress], None] | None = None
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

    Raises
    ------
    InputError
        If the time limit is not a number of seconds.
    """
    from missiontree.mission.control import Control, silent

    if time_limit_s is not None and not time_limit_s >= 0:
        raise InputError(f"--time-limit {time_limit_s}", accepted="a number of seconds of at least 0")
    asked: list[bool] = []

    def ask(signum: int, frame: object) -> None:
        asked.append(True)
        for one in SIGNALS:
            signal.signal(one, interrupts)

    before = {one: signal.signal(one, ask) for one in SIGNALS}
    try:
        yield Control(time_limit_s=time_limit_s, stop=lambda: bool(asked), report=report or silent, seed=seed)
    finally:
        for one, handler in before.items():
            signal.signal(one, handler)
