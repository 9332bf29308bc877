"""Work in a thread of its own: its pieces and faults come over, and Ctrl-C need not wait for it."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing
from threading import Event, current_thread

import pytest

from missiontree.llm.local_thread import apart


class Panic(BaseException):
    """As native code raises them: no Exception."""


def test_pieces_come_in_order_from_another_thread() -> None:
    def work() -> Iterator[object]:
        yield from (1, None, "x", current_thread())

    *pieces, thread = apart(work)
    assert pieces == [1, None, "x"]
    assert thread is not current_thread()


def test_work_without_pieces_ends() -> None:
    assert list(apart(lambda: [])) == []


@pytest.mark.parametrize("fault", [ValueError("wrong"), Panic("worse"), StopIteration(), KeyboardInterrupt()])
def test_what_the_work_raises_is_raised_after_what_it_gave(fault: BaseException) -> None:
    def work() -> Iterator[int]:
        yield 1
        raise fault

    pieces = apart(work)
    assert next(pieces) == 1
    # A generator that lets StopIteration through is at fault itself, which Python says by a RuntimeError.
    with pytest.raises(RuntimeError if isinstance(fault, StopIteration) else type(fault)):
        next(pieces)


def test_work_that_cannot_begin_raises_too() -> None:
    def work() -> Iterator[int]:
        raise OSError("no file")

    with pytest.raises(OSError, match="no file"):
        list(apart(work))


def test_whoever_stops_listening_leaves_the_work_at_the_piece_it_is_at() -> None:
    go_on, ended = Event(), Event()
    given: list[int] = []

    def work() -> Iterator[int]:
        try:
            for number in range(1_000_000):
                given.append(number)
                yield number
                go_on.wait()
        finally:
            ended.set()

    with closing(apart(work)) as pieces:
        assert next(pieces) == 0
    go_on.set()
    assert ended.wait(timeout=60)
    assert len(given) <= 3, "at most the piece it was at, and one that was under way"


INTERRUPTED = """
import os, signal, sys
from threading import Event
from missiontree.llm.local_thread import apart

signal.signal(signal.SIGINT, signal.default_int_handler)
never = Event()

def work():
    os.kill(os.getpid(), signal.SIGINT)
    never.wait()
    yield 1

try:
    list(apart(work))
except KeyboardInterrupt:
    print("interrupted", never.is_set())
    sys.exit(3)
"""


def test_ctrl_c_comes_through_while_the_work_is_busy_and_the_process_ends() -> None:
    """The work waits for what never comes; neither the exception nor the end of the process waits for it."""
    ended = subprocess.run([sys.executable, "-c", INTERRUPTED], capture_output=True, text=True, timeout=60, check=False)
    assert (ended.stdout, ended.stderr, ended.returncode) == ("interrupted False\n", "", 3)
