"""What calls mean for the entities they name, and that calls that are alike are worked out once."""

from __future__ import annotations

import pytest

from missiontree.mission.entity import Entity
from missiontree.routines.calls import Call, calls_of
from tests.builders import brief_of, flat_tree, paper_fleet, people, routine_node, trivial_fleet

PEOPLE = (*people("x"), Entity(id="y", kind="place"))


def calls(*nodes: tuple[str, dict[str, str]], **brief: object) -> list[Call]:
    leaves = [routine_node(f"n{number}", name, None, **arguments) for number, (name, arguments) in enumerate(nodes)]
    tree = flat_tree(*leaves, entities=PEOPLE)
    made = brief_of(tree, **brief)  # type: ignore[arg-type]
    return list(calls_of(tree, made, made.world.extended(tree.entities)).values())


@pytest.mark.parametrize(
    ("routine", "places", "moves", "finds", "unfound"),
    [
        ("Search", ("x",), (), ("x",), ()),
        ("Follow", ("x",), (), (), ("x",)),
        ("Reach", ("x",), (), (), ("x",)),
        ("SearchAndFollow", ("x",), (), ("x",), ()),
        ("Transport", ("x", "y"), ("x",), (), ("x", "y")),
        ("ReachAndTransport", ("x", "y"), ("x",), (), ("x", "y")),
    ],
)
def test_what_each_built_in_routine_touches(
    routine: str, places: tuple[str, ...], moves: tuple[str, ...], finds: tuple[str, ...], unfound: tuple[str, ...]
) -> None:
    arguments = {"agent": "x", "location": "y"} if "Transport" in routine else {"agent": "x"}
    (call,) = calls((routine, arguments))
    assert (call.touch.places, call.touch.moves, call.touch.finds, call.touch.unfound) == (
        places,
        moves,
        finds,
        unfound,
    )


def test_a_call_that_nobody_can_do_touches_nothing() -> None:
    (call,) = calls(("Transport", {"agent": "x", "location": "y"}), fleet=trivial_fleet())
    assert (call.ways, call.touch.uses) == ((), ())


def test_alike_calls_are_one() -> None:
    first, second, third = calls(("Search", {"agent": "x"}), ("Search", {"agent": "x"}), ("Search", {"agent": "y"}))
    assert first is second
    assert first != third


def test_ten_thousand_robots_and_two_thousand_calls() -> None:
    """Work grows with types and calls, not with robots; were it otherwise, this would take minutes."""
    fleet = trivial_fleet({kind.id: 2500 for kind in paper_fleet().types}, capabilities={"search": 1})
    entities = people(*(f"p{number}" for number in range(2000)))
    leaves = [routine_node(f"n{number}", "Search", agent=entity.id) for number, entity in enumerate(entities)]
    tree = flat_tree(*leaves, entities=entities)
    made = brief_of(tree, fleet)
    found = calls_of(tree, made, made.world.extended(entities))
    assert [len(call.ways[0].offer.types[0]) for call in found.values()] == [4] * 2000
