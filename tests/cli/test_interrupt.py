"""Ctrl-C and SIGTERM are the same: the first asks, the second interrupts; afterwards all is as before."""

from __future__ import annotations

import signal
from threading import Thread

import pytest

from missiontree.cli.interrupt import SIGNALS, Kept, controlled, deaf
from missiontree.mission.control import Progress


@pytest.mark.parametrize("first", SIGNALS)
@pytest.mark.parametrize("second", SIGNALS)
def test_the_first_signal_asks_and_the_second_interrupts(first: signal.Signals, second: signal.Signals) -> None:
    before = [signal.getsignal(one) for one in SIGNALS]
    with controlled(None, 0) as control:
        assert not control.ended()
        signal.raise_signal(first)
        assert control.ended()
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(second)
    assert [signal.getsignal(one) for one in SIGNALS] == before


def test_who_is_to_stop_with_nothing_to_keep_is_interrupted_where_it_asks() -> None:
    """Alternatives without a schedule are nothing to keep; other threads than the first are told to stop, and no more than that."""
    told: list[bool] = []
    with controlled(None, 0, kept=Kept("scheduling")) as control:
        control.report(Progress("allocation", done=1, found=1))
        control.report(Progress("scheduling", done=1, found=0))
        signal.raise_signal(signal.SIGINT)
        beside = Thread(target=lambda: told.append(control.ended()))
        beside.start()
        beside.join()
        assert told == [True]
        with pytest.raises(KeyboardInterrupt):
            control.ended()


def test_who_has_something_to_keep_is_asked_to_stop() -> None:
    heard: list[Progress] = []
    with controlled(None, 0, heard.append, Kept("scheduling")) as control:
        control.report(Progress("scheduling", done=1, found=1))
        control.report(Progress("scheduling", done=2, found=0))
        signal.raise_signal(signal.SIGINT)
        assert control.ended()
    assert [one.done for one in heard] == [1, 2]


def test_without_a_signal_nothing_ends_it() -> None:
    before = [signal.getsignal(one) for one in SIGNALS]
    with controlled(60.0, 0) as control:
        assert not control.ended()
    assert [signal.getsignal(one) for one in SIGNALS] == before


def test_a_signal_after_all_is_said_changes_nothing() -> None:
    before = {one: signal.getsignal(one) for one in SIGNALS}
    try:
        deaf()
        for one in SIGNALS:
            signal.raise_signal(one)
    finally:
        for one, handler in before.items():
            signal.signal(one, handler)
