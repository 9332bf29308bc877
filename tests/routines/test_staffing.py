"""Different robots for the roles of a team: a matching exists, or the Reason names the types that are too few."""

from __future__ import annotations

from itertools import permutations

from hypothesis import given
from hypothesis import strategies as st

from missiontree.routines.compose import FlatBranch, FlatRole
from missiontree.routines.staffing import shortage
from tests.builders import trivial_fleet


def branch(*robots: int, team: int | None = 0) -> FlatBranch:
    return FlatBranch("b", (), tuple(FlatRole(f"r{i}", (), (), count, team) for i, count in enumerate(robots)))


def test_alike_roles_need_as_many_robots() -> None:
    fleet = trivial_fleet({"a": 2})
    assert shortage(branch(2), [("a",)], fleet, "Lift") is None
    reason = shortage(branch(3), [("a",)], fleet, "Lift")
    assert reason is not None
    assert (reason.rule, reason.robot, reason.found, reason.needed) == ("too_few_robots", "a", "a 2", "3 robots")


def test_a_robot_is_moved_to_make_room() -> None:
    # r0 takes a first; r1 can only be a, so r0 must move on to b.
    assert shortage(branch(1, 1), [("a", "b"), ("a",)], trivial_fleet(["a", "b"]), "Lift") is None


def test_the_types_in_short_supply_are_named_and_others_are_not() -> None:
    # r1 and r2 can only be a, of which there is one; b does not help them.
    reason = shortage(branch(1, 1, 1), [("b",), ("a",), ("a",)], trivial_fleet(["a", "b"]), "Lift")
    assert reason is not None
    assert (reason.found, reason.needed) == ("a 1", "2 robots")


def test_roles_that_stand_alone_share_a_robot() -> None:
    assert shortage(branch(1, 1, team=None), [("a",), ("a",)], trivial_fleet(["a"]), "Lift") is None


@given(
    st.lists(st.tuples(st.sets(st.sampled_from("abc"), min_size=1), st.integers(1, 2)), min_size=1, max_size=3),
    st.lists(st.integers(1, 2), min_size=3, max_size=3),
)
def test_as_trying_every_assignment_says(roles: list[tuple[set[str], int]], counts: list[int]) -> None:
    fleet = trivial_fleet(dict(zip("abc", counts, strict=True)))
    slots = [types for types, robots in roles for _ in range(robots)]
    robots = [name for name, count in zip("abc", counts, strict=True) for _ in range(count)]
    possible = any(
        all(name in types for name, types in zip(order, slots, strict=True))
        for order in permutations(robots, len(slots))
    )
    found = shortage(branch(*(count for _, count in roles)), [sorted(types) for types, _ in roles], fleet, "Lift")
    assert (found is None) is possible
