"""The largest part of a mission that can be done: by hand, against brute force, and what both checkers make of it."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.authoring.author import authored_from_tree
from missiontree.briefing import Request, request_from
from missiontree.checking import check, taken_on_trust
from missiontree.errors import InputError
from missiontree.explaining.nearest import nearest_part
from missiontree.explaining.weighing import topmost, weights_of, without_parts
from missiontree.mission.brief import MissionBrief
from missiontree.mission.charger import Charger
from missiontree.mission.control import Control
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.goal import Goal
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, LinkKind, MissionNode, MissionTree
from missiontree.planner import author, plan_authored
from missiontree.reporting.text import plan_text
from missiontree.routines.library import built_in
from tests.builders import brief_of, flat_tree, rescue_tree, routine_node
from tests.checking.missions import random_mission, ruled_mission
from tests.explaining.every_part import best_by_force, sets_of

THINGS = tuple(Entity(id=name, kind="object") for name in ("a", "b", "c"))


def nearest(tree: MissionTree, brief: MissionBrief, scheduler: str = "greedy") -> Plan | None:
    authored, request = authored_from_tree(tree, brief), Request(brief=brief, scheduler=scheduler)
    return nearest_part(plan_authored(request, authored, Control()), request, authored, Control())


def left_out(plan: Plan | None) -> list[str]:
    assert plan is not None
    assert plan.partial is not None
    return [one.node for one in plan.partial.left_out]


def test_what_no_robot_can_do_is_left_out_and_all_else_is_done() -> None:
    tree = rescue_tree()
    plan = nearest(tree, brief_of(tree, without=("transportation_robot",)))
    assert left_out(plan) == ["bring"]
    assert plan is not None
    assert plan.partial is not None
    assert (plan.outcome, plan.partial.kept, plan.partial.total, plan.partial.claim) == ("partial", 2, 3, "proven")
    assert plan.tree == replace(
        tree, nodes=(replace(tree.nodes[0], children=("firefighter", "cat")), *tree.nodes[1:3]), links=()
    )
    assert check(plan) == ()


def test_a_mission_that_can_be_done_has_no_nearest_part() -> None:
    assert nearest(rescue_tree(), brief_of(rescue_tree())) is None


def test_nothing_is_offered_where_no_part_can_be_done() -> None:
    tree = flat_tree(*(routine_node(name, "Transport", agent=name, location="b") for name in "ac"), entities=THINGS)
    brief = brief_of(
        tree, fleet=Fleet((RobotType(id="eye", count=1, capabilities={"search": 1.0}),)), check_kinds=False
    )
    assert nearest(tree, brief) is None


def test_robots_that_are_half_charged_do_not_stand_in_the_way_of_an_answer() -> None:
    """A robot with 50 J of 100 J and a charger; one thing is looked for, and the other, due after a second, is left out."""
    eye = RobotType(
        id="eye",
        robots=(Robot(id="eye1", remaining={"energy_j": 50.0}),),
        capabilities={"search": 1.0},
        limits={"energy_j": 100.0},
    )
    scene = Scene(entities=THINGS, chargers=(Charger(id="plug", position=Position(0, 0), rate_per_s=1.0),))
    late, kept = (
        replace(routine_node("late", "Search", agent="a"), deadline_s=1.0),
        routine_node("kept", "Search", agent="b"),
    )
    tree = flat_tree(late, kept)
    plan = nearest(tree, brief_of(tree, fleet=Fleet((eye,)), scene=scene))
    assert left_out(plan) == ["late"]


def searches(names: str, *, deadline_s: float | None = None, links: tuple[Link, ...] = ()) -> MissionTree:
    """Searches for things side by side; each takes 67 s."""
    tree = flat_tree(*(routine_node(name, "Search", agent=name) for name in names), links=links, entities=THINGS)
    return replace(tree, nodes=(replace(tree.nodes[0], deadline_s=deadline_s), *tree.nodes[1:]))


def test_a_deadline_leaves_room_for_as_many_parts_as_one_robot_can_do_by_then() -> None:
    """One robot, 67 s a search: two of three are done by 140 s, and the lightest is left out."""
    tree = searches("abc", deadline_s=140.0)
    fleet = Fleet((RobotType(id="eye", count=1, capabilities={"search": 1.0}),))
    assert left_out(nearest(tree, brief_of(tree, fleet=fleet, parts={"a": 3.0, "Search(c)": 2.0}))) == ["b"]
    assert left_out(nearest(tree, brief_of(tree, fleet=fleet, parts={"b": 3.0, "search(A)": 0.5}))) == ["a"]


def test_one_heavy_part_goes_before_two_light_ones() -> None:
    """By 70 s one search can be done: the one that counts more than the two others together."""
    tree = searches("abc", deadline_s=70.0)
    fleet = Fleet((RobotType(id="eye", count=1, capabilities={"search": 1.0}),))
    assert left_out(nearest(tree, brief_of(tree, fleet=fleet, parts={"b": 2.5}))) == ["a", "c"]


def test_links_to_what_is_left_out_bind_nobody() -> None:
    """The carrying cannot be done and stood between two searches, which are then free of each other."""
    links = (Link("a", "x"), Link("x", "b"))
    leaves = (
        routine_node("a", "Search", agent="a"),
        routine_node("x", "Transport", agent="a", location="b"),
        routine_node("b", "Search", agent="b"),
    )
    tree = flat_tree(*leaves, links=links, entities=THINGS)
    plan = nearest(
        tree,
        brief_of(tree, fleet=Fleet((RobotType(id="eye", count=2, capabilities={"search": 1.0}),)), check_kinds=False),
    )
    assert left_out(plan) == ["x"]
    assert plan is not None
    assert plan.schedules[0].makespan_s == 67


def test_the_author_that_stopped_at_the_first_impossible_routine_is_asked_for_the_whole() -> None:
    """The tree of a mission in words ends where nobody can carry; what comes after it is planned all the same."""
    request = request_from(
        "Carry the cat to the vet, then find the keys", without=["transportation_robot", "social_robot"]
    )
    authored = author(request)
    whole = plan_authored(request, authored, Control())
    plan = nearest_part(whole, request, authored, Control())
    assert left_out(plan) == ["transport-cat-vet"]
    assert plan is not None
    text = plan_text(plan)
    assert "Cannot be done as a whole; this is a plan for a part of it" in text
    assert "1 of 2 routines can be done. Proven: no larger part can." in text


def test_a_goal_that_no_routine_serves_is_a_part_that_cannot_be_done() -> None:
    """The author stops at what nobody serves; what comes before and after it is planned, if somebody can do it."""
    words = "Find the keys, recommend a restaurant, and carry the cat to the vet"
    request = request_from(words, without=["transportation_robot", "social_robot"])
    authored = author(request)
    assert authored.status == "cannot_be_done"
    plan = nearest_part(plan_authored(request, authored, Control()), request, authored, Control())
    assert plan is not None
    assert plan.partial is not None
    labels = [plan.partial.whole.by_id[node].label for node in left_out(plan)]
    assert labels == ["Transport(Cat, Vet)", "recommend a restaurant"]
    assert (plan.partial.kept, plan.partial.total, plan.partial.claim) == (1, 3, "proven")
    assert {"recommend", "carry"} <= {reason.needed for reason in plan.reasons}
    assert check(plan) == ()


def test_a_weight_for_what_is_no_part_is_refused_with_what_is_meant() -> None:
    tree = rescue_tree()
    with pytest.raises(InputError, match="no part of the mission") as refusal:
        nearest(tree, brief_of(tree, without=("transportation_robot",), parts={"Serch(cat)": 2.0}))
    assert "Search(cat)" in refusal.value.hint


def test_what_is_lost_is_not_fetched_where_nobody_can_look_for_it() -> None:
    """Without searchers the cat could be carried, but nobody knows where it is: the search and the carrying are left out both."""
    tree = rescue_tree()
    plan = nearest(tree, brief_of(tree, min_quality={"Search": 0.5}, without=("tele_robot",)))
    assert plan is None  # the firefighter cannot be searched for either
    fleet = brief_of(tree).fleet
    kinds = tuple(replace(kind, zones=None) for kind in fleet.types)
    plan = nearest(
        replace(tree, nodes=(*tree.nodes[:1], replace(tree.nodes[1], routine="Reach"), *tree.nodes[2:])),
        brief_of(tree, fleet=replace(fleet, types=kinds), min_quality={"Search": 0.5}, without=("tele_robot",)),
    )
    assert left_out(plan) == ["cat", "bring"]


@pytest.mark.parametrize("kind", ["same_robot", "different_robot"])
def test_links_about_robots_do_not_speak_of_who_does_what_is_left_out(kind: LinkKind) -> None:
    """In each of two tasks the carrying cannot be done: both searches stay, by one robot or by two as the link of the tasks says."""
    leaves = [routine_node(name, "Search", agent=name) for name in "ab"]
    carried = [routine_node(f"carry-{name}", "Transport", agent=name, location="c") for name in "ab"]
    tasks = [
        MissionNode(id=f"task-{name}", label=f"Task {name}", gate="and", children=(name, f"carry-{name}"))
        for name in "ab"
    ]
    root = MissionNode(id="root", label="Mission", gate="and", children=("task-a", "task-b"))
    nodes = (root, tasks[0], leaves[0], carried[0], tasks[1], leaves[1], carried[1])
    tree = MissionTree(objective="Mission", nodes=nodes, links=(Link("task-a", "task-b", kind),), entities=THINGS)
    fleet = Fleet((RobotType(id="eye", count=2, capabilities={"search": 1.0}),))
    plan = nearest(tree, brief_of(tree, fleet=fleet, check_kinds=False))
    assert left_out(plan) == ["carry-a", "carry-b"]
    assert plan is not None
    robots = {assigned.robot for assigned in plan.schedules[0].assignments}
    assert len(robots) == (1 if kind == "same_robot" else 2)


def test_goals_say_how_much_they_count() -> None:
    """One searcher and 140 s for three searches of 67 s: two can be done, and not the one that counts least."""
    brief = brief_of(
        "Look for things",
        fleet=Fleet((RobotType(id="eye", count=1, capabilities={"search": 1.0}),)),
        goals=(Goal(do="Search(a)", weight=3.0), Goal(do="Search(b)"), Goal(do="Search(c)", weight=2.0)),
        entities=THINGS,
        deadline_s=140.0,
    )
    request = Request(brief=brief)
    authored = author(request)
    plan = nearest_part(plan_authored(request, authored, Control()), request, authored, Control())
    assert left_out(plan) == ["search-b"]
    assert plan is not None
    assert plan.partial is not None
    assert (plan.partial.kept, plan.partial.total) == (5, 6)
    assert check(plan) == ()
    with pytest.raises(ValueError, match="has no weight of its own"):
        Goal(method="rescue", slots={"victim": "a"}, weight=2.0)


def test_weights_go_down_the_tree_in_proportion() -> None:
    """A task of weight 4 with a routine of weight 3 and one of 1; an XOR weighs what its lighter child does, and so do both."""
    leaves = [routine_node(name, "Search", agent="a") for name in ("p", "q", "r", "s", "t")]
    nodes = (
        MissionNode(id="root", label="Mission", gate="and", children=("task", "choice")),
        MissionNode(id="task", label="Task", gate="and", children=("p", "q")),
        *leaves[:2],
        MissionNode(id="choice", label="Choice", gate="xor", children=("both", "t")),
        MissionNode(id="both", label="Both", gate="and", children=("r", "s")),
        *leaves[2:],
    )
    tree = MissionTree(objective="Mission", nodes=nodes, entities=THINGS)
    weights = weights_of(tree, {"p": 3.0})
    assert {node: float(weight) for node, weight in weights.items()} == {
        **{"root": 5, "task": 4, "p": 3, "q": 1, "choice": 1, "both": 1, "t": 1, "r": 0.5, "s": 0.5}
    }


def test_a_task_that_loses_all_its_children_is_left_out_itself() -> None:
    tree = rescue_tree()
    assert topmost(tree, {"firefighter", "cat"}) == ("firefighter", "cat")
    assert topmost(tree, {"firefighter", "cat", "bring"}) == ("root",)
    assert [node.id for node in without_parts(tree, {"cat"}, built_in()).nodes] == ["root", "firefighter", "bring"]


def test_what_the_checker_cannot_work_out_itself_it_takes_on_trust() -> None:
    """Without times and places all alternatives of all larger parts can be written out; with a deadline they cannot tell."""
    tree = rescue_tree()
    sure = nearest(tree, brief_of(tree, without=("transportation_robot",)))
    assert sure is not None
    assert [notice.rule for notice in taken_on_trust(sure)] == []
    fleet = Fleet((RobotType(id="eye", count=1, capabilities={"search": 1.0}),))
    timed = nearest(searches("abc", deadline_s=140.0), brief_of("Mission", fleet=fleet))
    assert timed is not None
    assert "part_on_trust" in [notice.rule for notice in taken_on_trust(timed)]


def with_a_deadline(tree: MissionTree, seed: int) -> MissionTree:
    """A third of the missions have to be done by some time, so that schedules tell what can be done."""
    if seed % 3:
        return tree
    return replace(tree, nodes=(replace(tree.nodes[0], deadline_s=float(30 + seed % 170)), *tree.nodes[1:]))


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 2**20), st.booleans())
def test_no_set_of_parts_is_better_than_the_one_that_is_kept(seed: int, ruled: bool) -> None:
    """Differential: every set of parts is left out in turn, and what remains is planned."""
    tree, brief = (ruled_mission if ruled else random_mission)(seed)
    tree = with_a_deadline(tree, seed)
    authored, request = authored_from_tree(tree, brief), Request(brief=brief)
    if authored.status != "complete" or len(sets_of(tree)) > 60:
        return
    whole = plan_authored(request, authored, Control())
    found = nearest_part(whole, request, authored, Control())
    if whole.outcome != "cannot_be_done":
        return
    best, decided = best_by_force(request, authored, weights_of(tree, {}))
    if found is None or found.partial is None:
        assert best is None
    elif decided or found.partial.claim == "proven":
        assert found.partial.kept == best
        assert check(found) == ()


def test_where_too_many_sets_would_have_to_be_looked_at_some_part_is_found_all_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """
    One robot, 1 m/s, is to reach things 10 m to the right, and 200 m and 210 m to the left, within 60 s: the first alone can be done.

    That is the last but one set in order of weight. With one set looked at, which is a single part, the rest is found by giving up more.
    """
    monkeypatch.setattr("missiontree.explaining.nearest.LEAST_EXAMINED", 1)
    monkeypatch.setattr("missiontree.explaining.nearest.MOST_WORK", 0)
    tree = flat_tree(*(routine_node(name, "Reach", agent=name) for name in "abc"))
    things = zip("abc", (10.0, -200.0, -210.0), strict=True)
    scene = Scene(entities=tuple(Entity(id=name, kind="object", position=Position(x_m, 0.0)) for name, x_m in things))
    fleet = Fleet(
        (
            RobotType(
                id="r", count=1, capabilities={"reach": 1.0}, limits={"max_speed_mps": 1.0}, position=Position(0.0, 0.0)
            ),
        )
    )
    plan = nearest(tree, brief_of(tree, fleet, scene=scene, deadline_s=60.0))
    assert left_out(plan) == ["b", "c"]
    assert plan is not None
    assert plan.partial is not None
    assert plan.partial.claim == "found"
    assert check(plan) == ()
