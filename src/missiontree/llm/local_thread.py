"""
Work done in a thread of its own, so that Ctrl-C is not kept waiting.

An engine in native code does not come back to Python while it reads a prompt or loads a file, which may take minutes; a signal is seen
only then. The thread that waits here sees it at once.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from threading import Event, Thread
from typing import Generic, TypeVar

T = TypeVar("T")

_LOOK_UP_S = 0.25  # on some systems a wait without an end is not ended by Ctrl-C either


@dataclass(frozen=True, slots=True)
class _Came(Generic[T]):
    piece: T


@dataclass(frozen=True, slots=True)
class _Ended:
    fault: BaseException | None


def apart(work: Callable[[], Iterable[T]]) -> Generator[T, None, None]:
    """
    The pieces of some work, each as it comes, the work being done in a thread of its own.

    Whoever stops listening leaves the work to end with the piece it is at. What it raises is raised here, whatever it is.

    Parameters
    ----------
    work
        Called in the thread; gives the pieces.
    """
    line: SimpleQueue[_Came[T] | _Ended] = SimpleQueue()
    left = Event()

    def do() -> None:
        fault: BaseException | None = None
        try:
            for piece in work():
                line.put(_Came(piece))
                if left.is_set():
                    break
        except BaseException as raised:  # a panic of native code is no Exception
            fault = raised
        line.put(_Ended(fault))

    Thread(target=do, name="missiontree-local-model", daemon=True).start()
    try:
        while not isinstance(next_one := _next(line), _Ended):
            yield next_one.piece
        if next_one.fault is not None:
            raise next_one.fault
    finally:
        left.set()


def _next(line: SimpleQueue[_Came[T] | _Ended]) -> _Came[T] | _Ended:
    while True:
        try:
            return line.get(timeout=_LOOK_UP_S)
        except Empty:
            continue
