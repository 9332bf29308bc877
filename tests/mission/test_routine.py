"""Libraries of routines: parts that are not there, circles, and chains that neither exhaust the stack nor the patience."""

import pytest

from missiontree.mission.routine import ActionStep, Argument, Branch, Part, RoleSpec, Routine, RoutineLibrary


def routine(name: str, *parts: str) -> Routine:
    role = RoleSpec(name="r", rating="c", actions=(ActionStep(name="do", text="Do it"),))
    return Routine(
        id=name,
        purpose="Do it",
        arguments=(Argument(name="agent", kinds=("person",)),),
        branches=() if parts else (Branch(name="b", roles=(role,)),),
        parts=tuple(Part(routine=part) for part in parts),
    )


def test_a_part_must_be_known() -> None:
    with pytest.raises(ValueError, match="'a' is composed of 'b', which is not known"):
        RoutineLibrary(routines=(routine("a", "b"),))


@pytest.mark.parametrize(
    ("links", "way"),
    [
        ({"a": ["a"]}, "a > a"),
        ({"a": ["b"], "b": ["c"], "c": ["b"]}, "b > c > b"),
        ({"x": [], "a": ["x", "b"], "b": ["x", "c"], "c": ["a", "x"]}, "a > b > c > a"),
    ],
)
def test_circles_are_named(links: dict[str, list[str]], way: str) -> None:
    with pytest.raises(ValueError, match=f"is composed of itself: {way}"):
        RoutineLibrary(routines=tuple(routine(name, *parts) for name, parts in links.items()))


def test_long_chains_are_checked_in_no_time() -> None:
    """Each routine uses the one before twice: 2 ** 2999 ways down, but only 2,999 routines."""
    chain = (routine("r0"), *(routine(f"r{n}", f"r{n - 1}", f"r{n - 1}") for n in range(1, 3000)))
    assert len(RoutineLibrary(routines=chain).by_id) == 3000
