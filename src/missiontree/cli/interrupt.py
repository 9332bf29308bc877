"""Ctrl-C: the first one asks long work to stop with what it has, the second one interrupts."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.mission.control import Control


@contextmanager
def controlled(time_limit_s: float | None, seed: int) -> Iterator[Control]:
    """
    Limits of one run, with Ctrl-C as its stop token.

    Raises
    ------
    InputError
        If the time limit is not a number of seconds.
    """
    from missiontree.mission.control import Control

    if time_limit_s is not None and not time_limit_s >= 0:
        raise InputError(f"--time-limit {time_limit_s}", accepted="a number of seconds of at least 0")
    asked: list[bool] = []

    def ask(signum: int, frame: object) -> None:
        asked.append(True)
        signal.signal(signal.SIGINT, signal.default_int_handler)

    before = signal.signal(signal.SIGINT, ask)
    try:
        yield Control(time_limit_s=time_limit_s, stop=lambda: bool(asked), seed=seed)
    finally:
        signal.signal(signal.SIGINT, before)
