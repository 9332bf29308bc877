"""
Tables of missions in everyday words, and what is expected of each, written down before any was run.

``S`` search, ``F`` follow, ``R`` reach, ``T`` transport, ``RT`` reach and transport, ``SF`` search and follow; ``@type``: only by that
robot type; ``(A xor B)``: one of them, ``[A; B]``: both, as one option. Behind the bar, by number of the routine: ``1<2`` the first
ends before the second starts, ``1~2`` the first lasts until the second ends. Order is shown for routines, whichever tasks hold them,
and with all that follows from it.
"""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest

from missiontree.authoring.methods.method import built_in_methods
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.formats.document import read_file
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.tree import MissionTree
from missiontree.routines.library import built_in
from missiontree.samples.catalogue import FOLDER

FLEET: Fleet = read_file(FOLDER / "fleet.yaml", "fleet")
SHORT = {
    "Search": "S",
    "Follow": "F",
    "Reach": "R",
    "Transport": "T",
    "ReachAndTransport": "RT",
    "SearchAndFollow": "SF",
}
HOUSE = Scene(
    kinds={"dog": "animal"},
    places=(
        Entity(id="lobby", kind="place", label="Lobby", position=Position(0, 0)),
        Entity(id="kitchen", kind="place", label="Kitchen", position=Position(10, 0)),
        Entity(id="storeroom", kind="place", label="Storeroom", position=Position(0, 10)),
        Entity(id="ward_3", kind="place", label="Ward 3", position=Position(10, 10)),
        Entity(id="assembly_point", kind="place", label="Assembly Point", position=Position(30, 30)),
    ),
    entities=(
        Entity(id="anna", kind="person", label="Anna", aliases=("nurse",), place="kitchen"),
        Entity(id="bob", kind="person", label="Bob", position=Position(5, 5)),
        Entity(id="leo", kind="person", label="Leo"),
        Entity(id="rex", kind="dog", label="Rex", last_seen=Position(20, 20)),
        Entity(id="toolbox", label="Toolbox", place="storeroom"),
        Entity(id="cup_1", label="Cup 1", place="kitchen"),
        Entity(id="cup_2", label="Cup 2", place="lobby"),
        Entity(id="cart", label="Cart", position=Position(0, 0)),
        Entity(id="drone", label="Drone"),
    ),
)


def rows(name: str) -> list[tuple[str, str]]:
    text = (Path(__file__).with_name("tables") / f"{name}.txt").read_text(encoding="utf-8")
    lines = (line for line in text.splitlines() if not line.startswith("#"))
    return [(mission, expected) for mission, _, expected in (line.partition(" => ") for line in lines)]


def authored(text: str, scene: Scene | None = None) -> Authored:
    return author_offline(MissionBrief(text=text, fleet=FLEET, routines=built_in(), scene=scene), built_in_methods())


def outcome(made: Authored) -> str:
    """The plan in the notation of the tables, or why there is none."""
    if made.status == "cannot_be_done":
        return f"X:{made.reasons[0].needed.split(', ')[0]}"
    return plan_of(made.tree) if made.status == "complete" and made.tree is not None else "I"


def plan_of(tree: MissionTree) -> str:
    leaves = leaves_of(tree, tree.root.id)
    number = {leaf: place for place, leaf in enumerate(leaves, 1)}
    links = {"precedence": set[tuple[int, int]](), "until": set[tuple[int, int]]()}
    for link in tree.links:
        pairs = product(leaves_of(tree, link.first), leaves_of(tree, link.second))
        links[link.kind] |= {(number[first], number[second]) for first, second in pairs}
    before = links["precedence"]
    for middle, first, second in product(number.values(), repeat=3):  # Warshall: what follows by way of a third
        if {(first, middle), (middle, second)} <= before:
            before.add((first, second))
    shown = "; ".join(shown_node(tree, child) for child in tree.root.children)
    order = [f"{a}<{b}" for a, b in sorted(before)] + [f"{a}~{b}" for a, b in sorted(links["until"])]
    return f"{shown} | {', '.join(order)}" if order else shown


def shown_node(tree: MissionTree, name: str) -> str:
    node = tree.by_id[name]
    if node.routine is not None:
        return shown_leaf(tree, name)
    parts = [shown_node(tree, child) for child in node.children]
    if node.gate == "xor":
        return f"({' xor '.join(f'[{part}]' if '; ' in part else part for part in parts)})"
    return "; ".join(parts)


def shown_leaf(tree: MissionTree, leaf: str) -> str:
    node = tree.by_id[leaf]
    assert node.routine is not None
    return (
        SHORT[node.routine]
        + node.label.removeprefix(node.routine)
        + "".join(f"@{kind}" for kind in node.resources or ())
    )


def leaves_of(tree: MissionTree, start: str) -> list[str]:
    found, waiting = [], [start]
    while waiting:
        node = tree.by_id[waiting.pop()]
        found += [node.id] if node.routine else []
        waiting += reversed(node.children)
    return found


@pytest.mark.parametrize(("text", "expected"), rows("everyday"))
def test_everyday_mission_is_planned_as_a_roboticist_would(text: str, expected: str) -> None:
    made = authored(text)
    assert outcome(made) == expected, (made.reasons, made.reading)


@pytest.mark.parametrize(("text", "expected"), rows("scene"))
def test_mission_in_a_house_is_about_what_the_house_has(text: str, expected: str) -> None:
    made = authored(text, HOUSE)
    assert outcome(made) == expected, (made.reasons, made.reading)


@pytest.mark.parametrize(("text", "expected"), rows("declined"))
def test_mission_that_must_not_be_planned_is_declined_with_a_way_out(text: str, expected: str) -> None:
    """What is understood in part is declined whole: a plan for half of the words would be wrong and silent."""
    made = authored(text)
    # A mission of which nothing can be planned may be both: unclear, and impossible for this fleet.
    assert outcome(made) == expected or (expected == "I" and made.status == "cannot_be_done"), made.reading
    assert made.reasons
    assert made.reasons[0].message
    assert made.reasons[0].hint


def test_the_tables_are_as_long_as_was_asked_for() -> None:
    # 150 and more that are planned, 50 and more that are not.
    assert len(rows("everyday")) + len(rows("scene")) >= 150
    assert len(rows("declined")) >= 50
