"""Time limits and stop tokens, with a clock that is handed in."""

from __future__ import annotations

import pytest

from missiontree.mission.control import Control
from missiontree.mission.search_limit import SearchLimit


class Hands:
    """A clock that shows what it is told."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


def test_a_limit_counts_from_birth() -> None:
    clock = Hands()
    control = Control(time_limit_s=5, clock=clock)
    assert not control.ended()
    clock.now = 104.9
    assert not control.ended()
    clock.now = 105.0
    assert control.ended()


def test_a_part_gets_its_share_of_what_is_left() -> None:
    clock = Hands()
    control = Control(time_limit_s=10, clock=clock)
    clock.now = 106.0
    # 4 s are left, a quarter of them is 1 s.
    part = control.part(0.25)
    assert part.time_limit_s == pytest.approx(1.0)
    clock.now = 107.0
    assert part.ended()
    assert not control.ended()


def test_the_token_stops_at_once() -> None:
    assert Control(stop=lambda: True).ended()
    assert not Control().ended()


def test_a_negative_limit_is_refused() -> None:
    with pytest.raises(ValueError, match="at least 0"):
        Control(time_limit_s=-1)


def test_what_ended_the_work_is_told_as_it_was_set_for_the_whole() -> None:
    """A part of a part of 10 s is over after 1 s; what was set is 10 s."""
    clock = Hands()
    part = Control(time_limit_s=10, clock=clock).part(0.5).part(0.2)
    assert part.ended_by() is None
    clock.now = 101.0
    assert part.ended_by() == SearchLimit("time_s", 10)
    assert Control(time_limit_s=10, stop=lambda: True).ended_by() == SearchLimit("stopped")


def test_a_search_limit_has_a_number_unless_somebody_said_stop() -> None:
    assert SearchLimit("time_s", 2.5).in_words == "the time limit of 2.5 s"
    assert SearchLimit("candidates", 200_000).in_words == "the limit of 200,000 candidates"
    assert SearchLimit("stopped").in_words == "a stop that was asked for"
    with pytest.raises(ValueError, match="needs a number"):
        SearchLimit("nodes")
    with pytest.raises(ValueError, match="has no number"):
        SearchLimit("stopped", 3)


def test_what_is_kept_for_later_is_taken_off_the_limit() -> None:
    """10 s, of which 4 are gone: 6 are left; 2 of them kept make 4. Of 5 wanted, half of what is left is kept, 3."""
    clock = Hands()
    control = Control(time_limit_s=10, clock=clock)
    clock.now = 104.0
    assert control.without(2.0).time_limit_s == pytest.approx(4.0)
    assert control.without(5.0, 0.5).time_limit_s == pytest.approx(3.0)
    assert control.without(2.0).whole_limit_s == 10
    assert Control(clock=clock).without(2.0).time_limit_s is None
