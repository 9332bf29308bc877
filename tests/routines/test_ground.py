"""A mission tree over a fleet: shape, texts, estimates, links, notices, findings, and the paper's numbers."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import Any

import pytest

from missiontree.errors import InputError
from missiontree.mission.brief import MissionBrief
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Capability, CostModel, DurationModel, Fleet, Robot, RobotType
from missiontree.mission.grounded import Action, GroundedLink, GroundedTree, Grounding
from missiontree.mission.position import Position
from missiontree.mission.routine import ActionStep, Argument, Branch, Part, RoleSpec, Routine
from missiontree.mission.scene import Area, Entity, KeepOut, Scene
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.routines.ground import ground
from missiontree.routines.library import built_in, with_routines
from tests.builders import (
    brief_of,
    flat_tree,
    paper_fleet,
    rescue_tree,
    reunite_tree,
    routine_node,
    trivial_fleet,
    with_type,
)

CRATE = Entity(id="crate", position=Position(30, 40))
DOCK = Entity(id="dock", kind="place", position=Position(30, 100))


def on(tree: MissionTree, **brief: Any) -> Grounding:
    return ground(tree, brief_of(tree, **brief))


def staffings(tree: GroundedTree, node: int = 0) -> list[tuple[int, ...]]:
    """Every choice of leaves, by brute force; small trees only."""
    if tree.nodes[node].kind == "action":
        return [(node,)]
    below = [staffings(tree, child) for child in tree.children[node]]
    if tree.nodes[node].kind == "xor":
        return [choice for choices in below for choice in choices]
    return [tuple(leaf for part in parts for leaf in part) for parts in product(*below)]


def utilities(grounding: Grounding) -> list[float]:
    tree, weights = grounding.tree, Weights()
    sums = (sum(weights.utility_micro(tree.action(leaf).estimate) for leaf in leaves) for leaves in staffings(tree))
    return sorted((total / 1e6 for total in sums), reverse=True)


def texts(tree: GroundedTree, leaves: tuple[int, ...]) -> list[str]:
    return [tree.action(leaf).text for leaf in leaves]


def actions(grounding: Grounding) -> list[Action]:
    return [node.action for node in grounding.tree.nodes if node.action is not None]


# The paper's numbers (design section 13)


def test_reunite_has_the_papers_four_alternatives() -> None:
    # Search: Tele-Robot 3 * 1.0 or Transportation Robot 3 * 0.3. Then 2 * 0.3 reaching and 2 * 1.0 by either of the two ways.
    assert utilities(on(reunite_tree())) == [5.6, 5.6, 3.5, 3.5]


def test_rescue_with_kinds_on_and_off() -> None:
    # Two searches (3.0 or 0.9 each) and 2.6: 8.6, 6.5 twice, 4.4; all of it twice if the cat could read.
    assert utilities(on(rescue_tree())) == [8.6, 6.5, 6.5, 4.4]
    assert utilities(on(rescue_tree(), check_kinds=False)) == [8.6] * 2 + [6.5] * 4 + [4.4] * 2


def test_reunite_says_it_in_the_papers_words() -> None:
    tree = on(reunite_tree()).tree
    search = ["Get search path to find Child", "Detect Child", "Report detection of Child to server"]
    reach = ["Get Child location to reach", "Get to Child location"]
    carry, message = (texts(tree, leaves) for leaves in staffings(tree)[:2])
    assert carry == [*search, *reach, "Carry Child", "Get to Mom location"]
    assert message == [
        *search,
        *reach,
        "Display message to Child to follow Social Robot to Mom",
        "Get to Mom location",
    ]


def test_each_action_keeps_the_rating_of_its_part() -> None:
    leaves = staffings(on(reunite_tree()).tree)[0]
    tree = on(reunite_tree()).tree
    assert [tree.action(leaf).capability for leaf in leaves] == ["search"] * 3 + ["reach"] * 2 + ["carry"] * 2
    assert [tree.action(leaf).estimate.quality for leaf in leaves] == [1, 1, 1, 0.3, 0.3, 1, 1]


# Shape


def test_shape_of_a_single_role() -> None:
    tree = on(flat_tree(routine_node("s", "Search", agent="x"), entities=(Entity(id="x", label="Rex"),))).tree
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
    grounding = on(flat_tree(routine_node("s", "Search", agent="x"), entities=(Entity(id="x"),)), fleet=fleet)
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
    return on(tree, fleet=fleet, routines=with_routines(built_in(), [pair(robots)]))


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
    grounding = on(tree, routines=with_routines(built_in(), [both]))
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
    grounding = on(tree, routines=with_routines(built_in(), [held]))
    nodes = grounding.tree.nodes
    (follower,) = [i for i, node in enumerate(nodes) if node.label == "follower"]
    reports = [i for i, node in enumerate(nodes) if node.action and node.action.name == "report_detection"]
    reaches = [i for i, node in enumerate(nodes) if node.action and node.action.name == "get_location"]
    # Tele-Robot and Transportation Robot can hold the role.
    assert len(reports) == len(reaches) == 2
    assert set(grounding.tree.links) == {GroundedLink(r, follower) for r in reports} | {
        GroundedLink(follower, r) for r in reaches
    }


def test_links_of_the_mission_are_mapped() -> None:
    tree = reunite_tree()
    grounding = on(replace(tree, links=(Link("search", "reunite"), Link("locate", "transport", "different_robot"))))
    sources = [
        (grounding.tree.nodes[link.first].source, grounding.tree.nodes[link.second].source, link.kind)
        for link in grounding.tree.links
    ]
    assert sources == [("search", "reunite", "precedence"), ("locate", "transport", "different_robot")]


# Estimates


def measured(**tug: Any) -> list[Action]:
    fleet = Fleet(
        (
            RobotType(
                id="tug",
                **{
                    "count": 1,
                    "position": Position(0, 0),
                    "capabilities": {"reach": 0.5, "carry": 0.9},
                    "limits": {"max_speed_mps": 2.0, "energy_j": 1000},
                    "uses_per_m": {"energy_j": 3},
                    **tug,
                },
            ),
        )
    )
    tree = flat_tree(routine_node("n", "ReachAndTransport", agent="crate", location="dock"))
    return actions(on(tree, fleet=fleet, scene=Scene(places=(DOCK,), entities=(CRATE,))))


def test_estimates_count_the_approach_and_bounds_do_not() -> None:
    get, go, carry, bring = measured()
    # From (0, 0) to the crate at (30, 40): 50 m at 2 m/s. From there to the dock at (30, 100): 60 m.
    assert [each.estimate.duration_s for each in (get, go, carry, bring)] == [5, 25, 20, 30]
    # The approach may be shorter when the time comes; the way with the crate is certain: 60 m * 3 J/m.
    assert [dict(each.uses_at_least) for each in (get, go, carry, bring)] == [{}, {}, {}, {"energy_j": 180}]
    assert dict(bring.uses) == {}
    assert (bring.at, bring.brings, bring.moves, bring.duration_s) == ("dock", ("crate",), True, 60)


def test_the_nearest_robot_counts() -> None:
    robots = (Robot(id="far", position=Position(0, 0)), Robot(id="near", position=Position(30, 30)), Robot(id="lost"))
    assert measured(count=None, position=None, robots=robots)[1].estimate.duration_s == 5  # 10 m at 2 m/s


def test_without_a_speed_moves_take_their_nominal_time_and_metres_still_cost() -> None:
    _, go, _, bring = measured(limits={})
    assert (go.estimate.duration_s, bring.estimate.duration_s) == (60, 60)
    assert dict(bring.uses_at_least) == {"energy_j": 180}


def test_without_a_start_the_first_move_takes_its_nominal_time() -> None:
    _, go, _, bring = measured(position=None)
    assert (go.estimate.duration_s, bring.estimate.duration_s) == (60, 30)


def test_duration_and_cost_models() -> None:
    carry = Capability(0.9, DurationModel(scale=2, plus_s=1), CostModel(fixed=10, per_s=0.5, per_m=0.1))
    _, _, lift, bring = measured(capabilities={"reach": 0.5, "carry": carry})
    # Carry: 1 + 2 * 20 = 41 s, cost 10 + 0.5 * 41. Bring: 30 s of travel, cost 10 + 0.5 * 30 + 0.1 * 60.
    assert (lift.estimate.duration_s, lift.estimate.cost, lift.duration_s) == (41, 30.5, 41)
    assert (bring.estimate.duration_s, bring.estimate.cost, bring.duration_s) == (30, 31, 121)


def test_a_way_with_something_that_others_move_is_not_certain() -> None:
    fleet = with_type(paper_fleet(), "transportation_robot", uses_per_m={"energy_j": 3})
    nodes = [routine_node(f"n{i}", "ReachAndTransport", agent="crate", location="dock") for i in range(2)]
    grounding = on(flat_tree(*nodes), fleet=fleet, scene=Scene(places=(DOCK,), entities=(CRATE,)))
    assert all(not each.uses_at_least for each in actions(grounding))


def test_a_type_that_can_never_get_there_is_refused() -> None:
    ring = [
        Area(corners=c)
        for c in (
            ((20, 20), (40, 20), (40, 25), (20, 25)),
            ((20, 55), (40, 55), (40, 60), (20, 60)),
            ((20, 20), (25, 20), (25, 60), (20, 60)),
            ((35, 20), (40, 20), (40, 60), (35, 60)),
        )
    ]
    scene = Scene(
        entities=(CRATE,),
        keep_outs=tuple(KeepOut(id=f"wall{i}", area=area, types=("tug",)) for i, area in enumerate(ring)),
    )
    fleet = trivial_fleet(["tug", "drone"], capabilities={"reach": 1}, position=Position(0, 0))
    grounding = on(flat_tree(routine_node("n", "Reach", agent="crate")), fleet=fleet, scene=scene)
    assert {each.robot_type for each in actions(grounding)} == {"drone"}
    assert [(reason.rule, reason.robot, reason.node) for reason in grounding.not_offered] == [
        ("unreachable", "tug", "n")
    ]


# Order of uses of one entity


def orders(grounding: Grounding) -> set[tuple[str | None, str | None]]:
    nodes = grounding.tree.nodes
    return {
        (nodes[link.first].source, nodes[link.second].source)
        for link in grounding.tree.links
        if link.kind == "precedence"
    }


def people(*names: str) -> tuple[Entity, ...]:
    return tuple(Entity(id=name, kind="person") for name in names)


def test_a_move_and_another_use_get_the_order_of_the_tree_with_a_notice() -> None:
    bring = routine_node("bring", "ReachAndTransport", agent="x", location="y")
    follow = routine_node("follow", "Follow", agent="x")
    grounding = on(flat_tree(bring, follow, entities=people("x", "y")))
    assert orders(grounding) == {("bring", "follow")}
    (notice,) = grounding.notices
    assert (notice.rule, notice.severity, notice.node) == ("order_added", "notice", "bring")
    assert "moves x" in notice.message


def test_a_given_order_stands() -> None:
    bring = routine_node("bring", "ReachAndTransport", agent="x", location="y")
    follow = routine_node("follow", "Follow", agent="x")
    grounding = on(flat_tree(bring, follow, entities=people("x", "y"), links=(Link("follow", "bring"),)))
    assert (orders(grounding), grounding.notices) == ({("follow", "bring")}, ())


def test_two_searches_need_no_order() -> None:
    nodes = [routine_node(f"n{i}", "Search", agent="x") for i in range(2)]
    assert orders(on(flat_tree(*nodes, entities=people("x")))) == set()


# Findings and assumptions


def test_a_lost_entity_without_a_search_is_a_finding_in_a_scene_only() -> None:
    follow = flat_tree(routine_node("f", "Follow", agent="x"), entities=people("x"))
    assert on(follow).findings == ()
    (finding,) = on(follow, scene=Scene()).findings
    assert (finding.rule, finding.severity, finding.node) == ("entity_not_located", "warning", "f")


@pytest.mark.parametrize(("linked", "found"), [(True, []), (False, ["entity_not_located"])])
def test_a_search_must_come_before(linked: bool, found: list[str]) -> None:
    links = (Link("s", "f"),) if linked else ()
    nodes = routine_node("s", "Search", agent="x"), routine_node("f", "Follow", agent="x")
    findings = on(flat_tree(*nodes, links=links, entities=people("x")), scene=Scene()).findings
    assert [finding.rule for finding in findings] == found


def test_a_routine_that_searches_first_itself_is_fine() -> None:
    tree = flat_tree(routine_node("n", "SearchAndFollow", agent="x"), entities=people("x"))
    assert on(tree, scene=Scene()).findings == ()


def test_a_search_that_may_not_be_chosen_does_not_count() -> None:
    nodes = (
        MissionNode(id="root", label="r", gate="and", children=("either", "f")),
        MissionNode(id="either", label="e", gate="xor", children=("s", "g")),
        routine_node("s", "Search", agent="x"),
        routine_node("g", "Search", agent="y"),
        routine_node("f", "Follow", agent="x"),
    )
    tree = MissionTree(objective="o", nodes=nodes, links=(Link("either", "f"),), entities=people("x", "y"))
    assert [finding.node for finding in on(tree, scene=Scene()).findings] == ["f"]


def test_precedence_between_alternatives_is_a_finding() -> None:
    nodes = (
        MissionNode(id="root", label="r", gate="xor", children=("s", "f")),
        routine_node("s", "Search", agent="x"),
        routine_node("f", "Follow", agent="x"),
    )
    tree = MissionTree(objective="o", nodes=nodes, links=(Link("s", "f"),), entities=people("x"))
    assert [(finding.rule, finding.severity) for finding in on(tree).findings] == [("never_binds", "warning")]


def test_assumed_and_unknown_positions_are_stated_once_each() -> None:
    area = Area(corners=((0, 0), (4, 0), (4, 2), (0, 2)))
    entities = (
        Entity(id="seen", last_seen=Position(3, 4)),
        Entity(id="around", search_area=area),
        Entity(id="lost"),
        Entity(id="known", position=Position(0, 0)),
    )
    nodes = [routine_node(f"{each.id}{i}", "Search", agent=each.id) for each in entities for i in range(2)]
    told = on(flat_tree(*nodes), scene=Scene(entities=entities)).assumptions
    assert [(reason.rule, reason.node) for reason in told] == [
        ("position_assumed", "seen"),
        ("position_assumed", "around"),
        ("position_unknown", "lost"),
    ]
    assert "(2, 1)" in told[1].message  # the middle of the area


# Bad input


@pytest.mark.parametrize(
    ("node", "message"),
    [
        (routine_node("n", "Serach", agent="x"), "Did you mean 'Search'"),
        (routine_node("n", "Search", agent="alicf"), "Did you mean 'alice'"),
        (routine_node("n", "Search", thing="x"), "no argument 'thing'"),
        (routine_node("n", "Transport", agent="x"), "lacks its argument 'location'"),
        (routine_node("n", "Search", resources=("tele_robto",), agent="x"), "Did you mean 'tele_robot'"),
        (MissionNode(id="n", label="Think"), "'Think' is a leaf"),
    ],
)
def test_what_nobody_knows_is_bad_input(node: MissionNode, message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        on(flat_tree(node, entities=people("x", "alice")))
    assert caught.value.where.startswith("n")


def test_entities_that_stand_twice_are_bad_input() -> None:
    tree = flat_tree(routine_node("n", "Search", agent="x"), entities=people("x"))
    with pytest.raises(InputError, match="stands twice"):
        on(tree, scene=Scene(entities=people("x")))


def test_links_that_contradict_each_other_are_bad_input() -> None:
    nodes = [routine_node(name, "Search", agent="x") for name in "abc"]
    links = (Link("a", "b"), Link("b", "c"), Link("c", "a"))
    with pytest.raises(InputError, match="wait for each other"):
        on(flat_tree(*nodes, links=links, entities=people("x")))


def test_wire_names_are_accepted() -> None:
    tree = flat_tree(routine_node("n", "SearchTree", agent="x"), entities=people("x"))
    assert len(actions(on(tree))) == 6


def test_a_brief_is_all_it_takes() -> None:
    brief = MissionBrief(text="m", fleet=paper_fleet(), routines=built_in())
    assert ground(reunite_tree(), brief) == ground(reunite_tree(), brief)
