"""Whose budget is too small is said rightly, and nothing is advised that would not help."""

from __future__ import annotations

import pytest

from missiontree.allocation.flat import flatten
from missiontree.allocation.possible import possible_nodes, reasons_of
from missiontree.allocation.wording import of_types
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.reason import Reason
from tests.builders import and_, grounded, leaf, trivial_fleet


def refusal(fleet: Fleet, *roles: str) -> Reason:
    """Two actions of 60 each, in the named roles of type r."""
    root = and_(*(leaf(f"a{place}", "r", role, uses={"energy_j": 60}) for place, role in enumerate(roles)))
    flat = flatten(grounded(root), fleet, Weights())
    (reason,) = reasons_of(flat, possible_nodes(flat), "error")
    return reason


@pytest.mark.parametrize("count", [1, 2])
def test_a_total_of_the_type(count: int) -> None:
    """A further robot would share the same total."""
    reason = refusal(trivial_fleet({"r": count}, total_limits={"energy_j": 100}), "x", "y")
    assert reason.message.endswith("uses 120 of energy_j, and all robots of type r together may use 100.")
    assert reason.hint.startswith("Raise energy_j in the total_limits of type r,")
    assert "a further robot would not help" in reason.hint
    assert reason.robot == "r"


def test_a_total_below_what_the_robots_could_use() -> None:
    # Two robots of 80 are 160, but the total is 100.
    fleet = trivial_fleet({"r": 2}, limits={"energy_j": 80}, total_limits={"energy_j": 100})
    assert "all robots of type r together may use 100" in refusal(fleet, "x", "y").message


def test_the_only_robot() -> None:
    reason = refusal(trivial_fleet(limits={"energy_j": 100}), "x", "y")
    assert reason.message.endswith("and the only robot of type r may use 100.")
    assert "add a robot of that type" in reason.hint


def test_all_robots_by_their_own_limits() -> None:
    # One role wants 120 of one robot; three roles want 180 of 2 * 60.
    reason = refusal(trivial_fleet({"r": 3}, limits={"energy_j": 60}), "x", "x")
    assert reason.message.endswith("and one robot of type r may use 60.")
    assert "more robots like it would not help" in reason.hint
    wide = refusal(trivial_fleet({"r": 2}, limits={"energy_j": 60}), "w", "x", "y")
    assert wide.message.endswith("uses 180 of energy_j, and the 2 robots of type r together may use 120.")
    assert "add a robot of that type" in wide.hint


def test_one_robot_in_one_role_under_a_total() -> None:
    """Robots without a limit of their own: the total is what one role breaks."""
    reason = refusal(trivial_fleet({"r": 2}, total_limits={"energy_j": 100}), "x", "x")
    assert "all robots of type r together may use 100" in reason.message


def test_several_types_are_named() -> None:
    assert of_types(["r"], "energy_j").whose == "type r"
    assert of_types(["r", "s", "t"], "energy_j").whose == "types r, s and t together"
