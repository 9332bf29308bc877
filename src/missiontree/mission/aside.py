"""
Work that cannot be asked to stop, done beside whoever waits for it, and left behind when time is up.

Loading a large library, compiling, and some solvers look at no clock. They are given a thread. Who waits looks up every few milliseconds,
and goes on without an answer once it is told to end. What was left behind is broken off at the next step of Python that it takes, unless
half of it would do harm, as with an import or a compiler, whose callbacks cannot raise.
"""

from __future__ import annotations

import atexit
import ctypes
import threading
from collections.abc import Callable
from typing import Generic, TypeVar

Result = TypeVar("Result")
LOOK_S = 0.01
PARTING_S = 1.0
"""For threads left behind, at the end of the process: one that is inside foreign code must not see it taken down."""


_LEFT: list[threading.Thread] = []


def anyone_left() -> bool:
    """Whether something that was left behind still goes on."""
    return any(thread.is_alive() for thread in _LEFT)


class _BrokenOff(BaseException):
    """Raised in a thread that nobody waits for any more."""


class Aside(Generic[Result]):
    """
    One piece of work in a thread of its own.

    Parameters
    ----------
    work
        What to do. Nobody hears of what it does or raises once it was left behind.
    """

    def __init__(self, work: Callable[[], Result]) -> None:
        self._work = work
        self._result: list[Result] = []
        self._failure: BaseException | None = None
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        try:
            self._result.append(self._work())
        except _BrokenOff:
            pass
        except BaseException as failure:  # raised again where somebody waits for it
            self._failure = failure

    def over(self, wait_s: float = 0.0) -> bool:
        """Whether it has come to its end, after so many seconds of waiting at most."""
        self._thread.join(wait_s)
        return not self._thread.is_alive()

    @property
    def result(self) -> Result | None:
        """What it came to; None if it did not. Raises what it raised."""
        if self._failure is not None:
            raise self._failure
        return self._result[0] if self._result else None

    def leave(self, *, whole: bool = False) -> None:
        """
        Leave it behind.

        Parameters
        ----------
        whole
            Whether it may go on to its end, for half of it would do harm. Default false.
        """
        thread = self._thread.ident
        if self.over() or thread is None:
            return
        _LEFT.append(self._thread)
        atexit.register(self._thread.join, PARTING_S)
        if not whole:
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(_BrokenOff))


def aside(work: Callable[[], Result], ended: Callable[[], bool], *, whole: bool = False) -> Result | None:
    """
    Do work aside; None if it was to end before it was done.

    Parameters
    ----------
    work
        What to do.
    ended
        Asked every 10 ms whether to go on without it.
    whole
        Whether half of it would do harm; see :meth:`Aside.leave`. Default false.

    Raises
    ------
    BaseException
        What the work raised.
    """
    doing = Aside(work)
    while not doing.over(LOOK_S):
        if ended():
            doing.leave(whole=whole)
            return None
    return doing.result
