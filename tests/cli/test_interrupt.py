"""Ctrl-C and SIGTERM are the same: the first asks, the second interrupts; afterwards all is as before."""

from __future__ import annotations

import signal

import pytest

from missiontree.cli.interrupt import SIGNALS, controlled, deaf


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
