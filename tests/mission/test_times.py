"""Release times and deadlines of nodes."""

from __future__ import annotations

import pytest

from missiontree.mission.grounded import GroundedNode
from missiontree.mission.times import ALWAYS, Window, check_times, windows_of
from missiontree.mission.tree import MissionNode


def test_a_node_has_the_latest_release_and_the_earliest_deadline_of_all_above_it() -> None:
    """Root until 90 s; below it one from 5 s until 100 s, which the root's deadline overrules; below that one from 2 s until 60.5 s."""
    windows = windows_of([(-1, 0, 90), (0, 5, 100), (1, 2, 60.5), (0, 0, None)])
    assert windows == (
        Window(0, 90_000, 0),
        Window(5_000, 90_000, 0),
        Window(5_000, 60_500, 2),
        Window(0, 90_000, 0),
    )


def test_of_equal_deadlines_the_lowest_node_is_named() -> None:
    assert [window.due_to for window in windows_of([(-1, 0, 10), (0, 0, 10)])] == [0, 1]


def test_without_times_everything_may_happen_always() -> None:
    assert windows_of([(-1, 0, None), (0, 0, None)]) == (ALWAYS, ALWAYS)


def test_a_release_is_rounded_up_and_a_deadline_down() -> None:
    """1.0004 s lies between ticks 1000 and 1001: to start by then is not to start before, to end by then is to end before."""
    assert windows_of([(-1, 1.0004, None), (0, 0, 1.0008)]) == (Window(1001), Window(1001, 1000, 1))
    assert windows_of([(-1, 0.1 + 0.2, 0.1 + 0.2)]) == (Window(300, 300, 0),)


def test_a_deadline_before_the_release_time_is_refused() -> None:
    with pytest.raises(ValueError, match=r"deadline 4 s, before its release time 5 s"):
        check_times("node 'a'", 5, 4)
    check_times("node 'a'", 5, 5)
    with pytest.raises(ValueError, match="node 'a' has the deadline"):
        MissionNode(id="a", label="A", routine="Search", release_s=5, deadline_s=4)
    with pytest.raises(ValueError, match="node 'A' has the deadline"):
        GroundedNode(parent=-1, kind="and", label="A", release_s=5, deadline_s=4)


@pytest.mark.parametrize("wrong", [{"deadline_s": -1.0}, {"release_s": -1.0}, {"deadline_s": float("nan")}])
def test_times_are_no_less_than_the_start_of_the_mission(wrong: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="_s"):
        MissionNode(id="a", label="A", **wrong)  # type: ignore[arg-type]
