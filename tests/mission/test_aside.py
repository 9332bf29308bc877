"""Work aside is waited for, fails where somebody waits, and is left behind and broken off when that is asked for."""

from __future__ import annotations

from itertools import count
from threading import Event

import pytest

from missiontree.mission.aside import Aside, aside

LONG_S = 60.0


def test_what_is_done_in_time_is_returned() -> None:
    assert aside(lambda: 7, lambda: False) == 7


def test_what_goes_wrong_is_raised_where_somebody_waits() -> None:
    def fail() -> int:
        raise ValueError("no")

    with pytest.raises(ValueError, match="no"):
        aside(fail, lambda: False)


def test_what_takes_for_ever_is_left_behind_and_broken_off() -> None:
    """It counts for ever; nobody waits once it has begun, and its last words are heard because it was broken off."""
    begun, broken = Event(), Event()

    def endless() -> int:
        try:
            for _ in count():
                begun.set()
        finally:
            broken.set()
        return 0

    assert aside(endless, begun.is_set) is None
    assert broken.wait(LONG_S)


def test_what_must_not_stay_half_done_goes_on_to_its_end() -> None:
    """It waits to be let go, which happens only after nobody waits for it any more."""
    begun, go, done = Event(), Event(), Event()

    def work() -> int:
        begun.set()
        go.wait(LONG_S)
        done.set()
        return 1

    doing = Aside(work)
    assert begun.wait(LONG_S)
    doing.leave(whole=True)
    go.set()
    assert done.wait(LONG_S)
    assert doing.over(LONG_S)
    assert doing.result == 1
