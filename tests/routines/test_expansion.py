"""One call becomes a subtree: ways, roles, teams, joint work, multisets of robots that are alike."""

from __future__ import annotations

import pytest

from missiontree.errors import InputError
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import GroundedLink, Grounding
from missiontree.mission.routine import ActionStep, Argument, Branch, Part, RoleSpec, Routine
from missiontree.routines.library import built_in, with_routines
from tests.builders import (
    flat_tree,
    grounding_of,
    routine_node,
    trivial_fleet,
)


def test_shape_of_a_single_role() -> None:
    tree = grounding_of(flat_tree(routine_node("s", "Search", agent="x"), entities=(Entity(id="x", label="Rex"),))).tree
    kinds = [(node.parent, node.kind, node.label, node.source) for node in tree.nodes]
    assert kinds[:3] == [
        (-1, "and", "Mission", "root"),
        (0, "xor", "Search(x)", "s"),
        (1, "and", "search by Tele-Robot", "s"),
    ]
    assert kinds[3] == (2, "action", "Get search path to find Rex", "s")
    assert len(tree.roles) == 1
    assert {tree.action(leaf).role for leaf in range(3, 6)} == {0}
    detect = tree.action(4)
    assert (detect.at, detect.finds, detect.moves, detect.brings) == ("x", "x", False, ())


def test_a_routine_that_nobody_can_do_is_an_empty_xor() -> None:
    fleet = Fleet((RobotType(id="blind", count=1),))
    grounding = grounding_of(flat_tree(routine_node("s", "Search", agent="x"), entities=(Entity(id="x"),)), fleet=fleet)
    assert grounding.tree.children == ((1,), ())
    assert [(reason.rule, reason.node, reason.robot) for reason in grounding.not_offered] == [
        ("capability_missing", "s", "blind")
    ]


def pair(robots: int) -> Routine:
    steps = (
        ActionStep(name="grip", text="Grip {a} with {robot}", sync="grip"),
        ActionStep(name="go", text="Go", goes_to="b", brings=("a",), sync="go"),
    )
    roles: tuple[RoleSpec, ...] = (RoleSpec(name="lifter", rating="lift", actions=steps, robots=robots),)
    if robots == 1:
        roles = (*roles, RoleSpec(name="guide", rating="guide", actions=steps))
    return Routine(
        id="Lift",
        purpose="Lift {a} to {b}",
        arguments=(Argument(name="a", kinds=("object",)), Argument(name="b", kinds=("place",))),
        branches=(Branch(name="together", roles=roles),),
    )


def lifted(robots: int, fleet: Fleet, calls: int = 1) -> Grounding:
    entities = (*(Entity(id=f"a{i}") for i in range(calls)), Entity(id="b", kind="place"))
    nodes = (routine_node(f"n{i}", "Lift", a=f"a{i}", b="b") for i in range(calls))
    tree = flat_tree(*nodes, entities=entities)
    return grounding_of(tree, fleet=fleet, routines=with_routines(built_in(), [pair(robots)]))


def test_a_branch_of_two_roles_is_an_and_of_xors_in_one_team_with_its_own_sync_numbers() -> None:
    fleet = Fleet(
        (
            RobotType(id="t", count=2, capabilities={"lift": 1, "guide": 1}),
            RobotType(id="g", count=1, capabilities={"guide": 1}),
        )
    )
    grounding = lifted(1, fleet, calls=2)
    labels = [(node.parent, node.kind, node.label) for node in grounding.tree.nodes if node.kind != "action"]
    assert labels[1:8] == [
        (0, "xor", "Lift(a0, b)"),
        (1, "and", "together"),
        (2, "xor", "lifter"),
        (3, "and", "lifter by t"),
        (2, "xor", "guide"),
        (7, "and", "guide by t"),
        (7, "and", "guide by g"),
    ]
    assert [role.team for role in grounding.tree.roles] == [0, 0, 1, 1]
    syncs: dict[str | None, set[tuple[str, int | None]]] = {"n0": set(), "n1": set()}
    for node in grounding.tree.nodes:
        if node.action is not None:
            syncs[node.source].add((node.action.name, node.action.sync))
    assert syncs == {"n0": {("grip", 0), ("go", 1)}, "n1": {("grip", 2), ("go", 3)}}


def test_alike_roles_are_one_xor_over_multisets() -> None:
    fleet = trivial_fleet({"x": 2, "y": 1}, capabilities={"lift": 1})
    tree = lifted(2, fleet).tree
    (choice,) = [index for index, node in enumerate(tree.nodes) if node.label == "lifter"]
    # Two of {x, x, y}: xx and xy; yy would need two y; yx is xy.
    assert [tree.nodes[child].label for child in tree.children[choice]] == ["lifter by x, x", "lifter by x, y"]
    both = tree.children[choice][1]
    assert [tree.nodes[child].label for child in tree.children[both]] == ["lifter 1 by x", "lifter 2 by y"]
    assert [tree.action(tree.children[child][0]).role for child in tree.children[both]] == [0, 1]
    assert [role.team for role in tree.roles] == [0, 0]
    assert [tree.action(tree.children[child][0]).text for child in tree.children[both]] == [
        "Grip a0 with x",
        "Grip a0 with y",
    ]


def test_too_many_multisets_are_refused_with_the_way_out() -> None:
    fleet = trivial_fleet({f"t{i}": 9 for i in range(30)}, capabilities={"lift": 1})
    with pytest.raises(InputError, match="too many ways") as caught:  # 30 types, 4 robots: 33 over 4 = 40,920
        lifted(4, fleet)
    assert "resources" in caught.value.hint


def test_parts_without_same_robot_are_ordered_in_the_tree() -> None:
    both = Routine(
        id="FindThenReach",
        purpose="p",
        arguments=(Argument(name="agent", kinds=("person",)),),
        parts=(Part(routine="Search"), Part(routine="Reach")),
    )
    tree = flat_tree(routine_node("n", "FindThenReach", agent="x"), entities=(Entity(id="x", kind="person"),))
    grounding = grounding_of(tree, routines=with_routines(built_in(), [both]))
    first, second = (
        next(i for i, node in enumerate(grounding.tree.nodes) if node.label == name) for name in ("searcher", "reacher")
    )
    assert grounding.tree.links == (GroundedLink(first, second),)


def test_a_part_between_is_ordered_against_the_held_roles_actions() -> None:
    held = Routine(
        id="Guard",
        purpose="p",
        arguments=(Argument(name="agent", kinds=("person",)),),
        parts=(Part(routine="Search"), Part(routine="Follow"), Part(routine="Reach")),
        same_robot=(0, 2),
    )
    tree = flat_tree(routine_node("n", "Guard", agent="x"), entities=(Entity(id="x", kind="person"),))
    grounding = grounding_of(tree, routines=with_routines(built_in(), [held]))
    nodes = grounding.tree.nodes
    (follower,) = [i for i, node in enumerate(nodes) if node.label == "follower"]
    reports = [i for i, node in enumerate(nodes) if node.action and node.action.name == "report_detection"]
    reaches = [i for i, node in enumerate(nodes) if node.action and node.action.name == "get_location"]
    # Tele-Robot and Transportation Robot can hold the role.
    assert len(reports) == len(reaches) == 2
    assert set(grounding.tree.links) == {GroundedLink(r, follower) for r in reports} | {
        GroundedLink(follower, r) for r in reaches
    }
