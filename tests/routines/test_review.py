"""What may be wrong with a tree, and what is taken for granted about positions."""

from __future__ import annotations

import pytest

from missiontree.mission.area import Area
from missiontree.mission.charger import Charger
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.routines.review import idle_chargers
from tests.builders import (
    flat_tree,
    grounding_of,
    people,
    routine_node,
)


def test_a_lost_entity_without_a_search_is_a_finding_in_a_scene_only() -> None:
    follow = flat_tree(routine_node("f", "Follow", agent="x"), entities=people("x"))
    assert grounding_of(follow).findings == ()
    (finding,) = grounding_of(follow, scene=Scene()).findings
    assert (finding.rule, finding.severity, finding.node) == ("entity_not_located", "warning", "f")


@pytest.mark.parametrize(("linked", "found"), [(True, []), (False, ["entity_not_located"])])
def test_a_search_must_come_before(linked: bool, found: list[str]) -> None:
    links = (Link("s", "f"),) if linked else ()
    nodes = routine_node("s", "Search", agent="x"), routine_node("f", "Follow", agent="x")
    findings = grounding_of(flat_tree(*nodes, links=links, entities=people("x")), scene=Scene()).findings
    assert [finding.rule for finding in findings] == found


def test_a_routine_that_searches_first_itself_is_fine() -> None:
    tree = flat_tree(routine_node("n", "SearchAndFollow", agent="x"), entities=people("x"))
    assert grounding_of(tree, scene=Scene()).findings == ()


def test_a_search_that_may_not_be_chosen_does_not_count() -> None:
    nodes = (
        MissionNode(id="root", label="r", gate="and", children=("either", "f")),
        MissionNode(id="either", label="e", gate="xor", children=("s", "g")),
        routine_node("s", "Search", agent="x"),
        routine_node("g", "Search", agent="y"),
        routine_node("f", "Follow", agent="x"),
    )
    tree = MissionTree(objective="o", nodes=nodes, links=(Link("either", "f"),), entities=people("x", "y"))
    assert [finding.node for finding in grounding_of(tree, scene=Scene()).findings] == ["f"]


def test_precedence_between_alternatives_is_a_finding() -> None:
    nodes = (
        MissionNode(id="root", label="r", gate="xor", children=("s", "f")),
        routine_node("s", "Search", agent="x"),
        routine_node("f", "Follow", agent="x"),
    )
    tree = MissionTree(objective="o", nodes=nodes, links=(Link("s", "f"),), entities=people("x"))
    assert [(finding.rule, finding.severity) for finding in grounding_of(tree).findings] == [
        ("link_never_binds", "warning")
    ]


def test_assumed_and_unknown_positions_are_stated_once_each() -> None:
    area = Area(corners=((0, 0), (4, 0), (4, 2), (0, 2)))
    entities = (
        Entity(id="seen", last_seen=Position(3, 4)),
        Entity(id="around", search_area=area),
        Entity(id="lost"),
        Entity(id="known", position=Position(0, 0)),
    )
    nodes = [routine_node(f"{each.id}{i}", "Search", agent=each.id) for each in entities for i in range(2)]
    told = grounding_of(flat_tree(*nodes), scene=Scene(entities=entities)).assumptions
    assert [(reason.rule, reason.node) for reason in told] == [
        ("position_assumed", "seen"),
        ("position_assumed", "around"),
        ("position_unknown", "lost"),
    ]
    assert "(2, 1)" in told[1].message  # the middle of the area


@pytest.mark.parametrize(
    ("stock", "types", "hint"),
    [
        ("energi_j", None, "Did you mean 'energy_j'?"),
        ("water_l", None, "State how much is full as limit water_l of a type."),
        ("energy_j", ("cart",), "State how much is full as limit energy_j of a type."),
        ("energy_j", None, ""),
    ],
)
def test_a_charger_of_which_nobody_has_a_use_is_a_finding(stock: str, types: tuple[str, ...] | None, hint: str) -> None:
    """The drone has a limit of energy, the cart has none."""
    fleet = Fleet(
        (
            RobotType(id="drone", count=1, capabilities={"camera": 1.0}, limits={"energy_j": 9.0}),
            RobotType(id="cart", count=1, capabilities={"camera": 1.0}),
        )
    )
    plug = Charger(id="plug", label="Big Plug", position=Position(0, 0), rate_per_s=1, stock=stock, types=types)
    found = idle_chargers(fleet, Scene(chargers=(plug,)))
    assert [(one.rule, one.severity, one.node, one.hint) for one in found] == (
        [("charger_idle", "warning", "plug", hint)] if hint else []
    )


def test_a_plan_tells_of_an_idle_charger() -> None:
    plug = Charger(id="plug", position=Position(0, 0), rate_per_s=1, stock="energi_j")
    search = flat_tree(routine_node("s", "Search", agent="x"), entities=people("x"))
    assert [one.rule for one in grounding_of(search, scene=Scene(chargers=(plug,))).findings] == ["charger_idle"]
