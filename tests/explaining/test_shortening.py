"""Which robot to add: answered by schedules, with numbers that can be derived by hand."""

from dataclasses import replace
from random import Random

import pytest

from benchmarks.schedule_cases import random_schedule_case
from missiontree.explaining.enlarging import with_more, with_room
from missiontree.explaining.shortening import why_so_long
from missiontree.mission.chain import Addition
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.tree import Link, MissionTree
from missiontree.mission.ways import Road, RoadGraph, RoadNode
from missiontree.reporting.critical.additions import addition_lines
from missiontree.reporting.critical.bonds import Bonds
from missiontree.reporting.critical.spans import ms
from missiontree.reporting.critical.view import why_view
from missiontree.reporting.gantt.waits import why_stayed
from missiontree.reporting.text import render
from missiontree.scheduling.greedy import greedy
from tests.builders import flat_tree, routine_node
from tests.reporting.charts import plan_of, planned
from tests.scheduling import test_passage as passage
from tests.scheduling.instances import Instance, Part, at, mission, robots, scene, work


def made(instance: Instance, fleet: Fleet, world: Scene | None = None) -> Plan:
    """A plan with the greedy schedule of an instance, and with the utility that its actions give: 1 each."""
    leaves = sum(node.action is not None for node in instance.tree.nodes)
    alternative = replace(instance.alternative, utility=float(leaves))
    plan = planned(Instance(instance.tree, alternative, instance.node), fleet, world)
    return replace(plan, brief=replace(plan.brief, scene=world))


def told(plan: Plan) -> list[tuple[dict[str, int], str, float]]:
    return [(dict(one.robots), one.verdict, one.makespan_s) for one in why_so_long(plan, 1).additions]


def lines(plan: Plan) -> list[str]:
    return list(addition_lines(why_so_long(plan, 1), plan.schedules[0], plan.brief.fleet))


def test_one_more_of_the_busy_robot_halves_what_it_does_alone() -> None:
    """Two roles of 3 s, one robot: 6 s, which is its load and so the least. With two robots 3 s, the length of a role."""
    plan = made(mission([Part("A", "a", [work(3)]), Part("B", "a", [work(3)])]), Fleet((robots("a"),)))
    assert told(plan) == [({"a": 1}, "shorter", 3.0)]
    assert lines(plan) == ["one more a: 3 s instead of 6 s (proven shortest); without it that is impossible"]


def test_where_order_makes_the_length_no_robot_helps_and_that_is_proven() -> None:
    """A before B, 3 s and 4 s: 7 s, however many robots there are."""
    instance = mission([Part("A", "a", [work(3)]), Part("B", "b", [work(4)])], [("A", "B")])
    plan = made(instance, Fleet((robots("a"), robots("b"))))
    assert told(plan) == [({"a": 1}, "not_shorter", 7.0), ({"b": 1}, "not_shorter", 7.0)]
    assert lines(plan) == [
        "one more a; one more b; a robot for every role (one more a, one more b): no schedule is shorter than 7 s, proven by "
        "critical path",
        "Nothing of this shortens it: no part of the chain waits for a busy robot; work, ways, order and times make it "
        "that long.",
    ]


def test_of_two_types_the_one_that_helps_stands_first() -> None:
    """B waits for A's robot to end its second job, 2 s + 5 s + 1 s; with another b the 1 s is done beside, with another a nothing is."""
    instance = mission([Part("A", "a", [work(2)]), Part("B", "b", [work(5)]), Part("C", "b", [work(4)])])
    plan = made(instance, Fleet((robots("a"), robots("b"))))
    assert plan.schedules[0].makespan_s == 9
    assert told(plan) == [({"b": 1}, "shorter", 5.0), ({"a": 1}, "not_shorter", 9.0)]


def test_where_one_more_does_not_help_as_many_as_roles_may() -> None:
    """Joint work of a and b, twice, 4 s each: 8 s. One more of either changes nothing; one more of both gives 4 s."""
    parts = [
        Part("A", "a", [work(4, sync=0)]),
        Part("B", "b", [work(4, sync=0)]),
        Part("C", "a", [work(4, sync=1)]),
        Part("D", "b", [work(4, sync=1)]),
    ]
    plan = made(mission(parts), Fleet((robots("a"), robots("b"))))
    why = why_so_long(plan, 1)
    assert {one.verdict for one in why.additions} == {"not_shorter"}
    assert why.unlimited is not None
    assert (dict(why.unlimited.robots), why.unlimited.verdict, why.unlimited.makespan_s) == (
        {"a": 2, "b": 2},
        "shorter",
        4.0,
    )
    assert lines(plan)[-1].startswith(
        "a robot for every role (2 more a, 2 more b): 4 s instead of 8 s (proven shortest)"
    )


def test_a_copy_of_a_named_robot_starts_where_that_one_does() -> None:
    """
    Near is 2 m and far 20 m from p; two jobs of 10 s there, 1 m/s. Near does both: 2 + 10 + 10 = 22 s; far would be there at 20 s.
    One more like near: both at once, 12 s. One more like far: nothing gained.
    """
    named = robots("a", speed=1.0, robots=(Robot(id="near", position=at(2)), Robot(id="far", position=at(-16))))
    instance = mission([Part("A", "a", [work(10, at="p")]), Part("B", "a", [work(10, at="p")])])
    plan = made(instance, Fleet((named,)), scene(p=4))
    assert plan.schedules[0].makespan_s == 22
    only = why_so_long(plan, 1).additions
    assert [(one.like, one.verdict, one.makespan_s) for one in only] == [("near", "shorter", 12.0)]
    assert "one more a like near: 12 s instead of 22 s" in lines(plan)[0]


def test_robots_that_are_kept_out_of_use_may_take_part_when_one_is_added() -> None:
    """Of two robots one may be in use: 6 s. One more may be, too: 3 s."""
    plan = made(mission([Part("A", "a", [work(3)]), Part("B", "a", [work(3)])]), Fleet((robots("a", 2, max_in_use=1),)))
    assert told(plan) == [({"a": 1}, "shorter", 3.0)]


def test_what_is_not_proven_is_not_said_to_be() -> None:
    """A greedy schedule above its bound, and no shorter one found: nothing is excluded, and the sentence says so."""
    plan = next(plan for plan in map(drawn, range(400)) if plan is not None and "none_found" in verdicts(plan))
    assert any("none is excluded" in line for line in lines(plan))


def verdicts(plan: Plan) -> set[str]:
    return {one.verdict for one in why_so_long(plan, 1).additions}


def drawn(seed: int) -> Plan | None:
    """A random mission with its greedy schedule; None if it has none."""
    case = random_schedule_case(Random(seed))  # noqa: S311 - reproducible draws
    schedule = greedy(case.tree, case.alternative, case.fleet, case.scene, Control(seed=1), case.terms)
    if not schedule.makespan_s or "terms" in case.features:
        return None
    plan = plan_of(Instance(case.tree, case.alternative, {}), schedule, case.fleet)
    return replace(plan, brief=replace(plan.brief, scene=case.scene))


@pytest.mark.parametrize("seed", range(0, 1200, 30))
def test_no_verdict_is_beyond_what_the_schedule_shows(seed: int) -> None:
    """Every schedule of a larger team passes the checker on the way (else an error); and the verdict is what its numbers say."""
    plan = drawn(seed)
    if plan is None:
        return
    why = why_so_long(plan, 1)
    now = ms(plan.schedules[0].makespan_s)
    tried: list[Addition] = [*why.additions, *([why.unlimited] if why.unlimited else [])]
    assert tried
    for one in tried:
        bound = one.certificate.bound
        shorter = one.status in {"optimal", "feasible"} and ms(one.makespan_s) < now
        proven = bound is not None and ms(bound) >= now and one.certificate.claim in {"proven", "bounded"}
        assert one.verdict == ("shorter" if shorter else "not_shorter" if proven else "none_found")


def test_one_more_place_at_a_shared_resource_is_tried_where_the_chain_waits_for_it() -> None:
    """Two robots, two jobs of 3 s at one door with room for one: 6 s. With room for two, 3 s; with more robots, still 6 s."""
    instance = mission([Part("A", "a", [work(3, holds=("door",))]), Part("B", "a", [work(3, holds=("door",))])])
    world = Scene(resources=(SharedResource(id="door"),))
    plan = made(instance, Fleet((robots("a", 2),)), world)
    assert plan.schedules[0].makespan_s == 6
    found = [
        (dict(one.robots), dict(one.resources), one.verdict, one.makespan_s) for one in why_so_long(plan, 1).additions
    ]
    assert found[0] == ({}, {"door": 1}, "shorter", 3.0)
    assert found[1][:3] == ({"a": 1}, {}, "not_shorter")
    assert lines(plan)[0].startswith("one more place at door: 3 s instead of 6 s (proven shortest)")
    told_in_parts = render(why_view(why_so_long(plan, 1), plan, plan.schedules[0]))
    assert "once a-1 has left what both need: A.0" in told_in_parts


def test_a_resource_that_there_is_not_gets_no_room() -> None:
    with pytest.raises(ValueError, match="no shared resource 'gate'"):
        with_room(Scene(), "gate")


def test_with_no_time_left_nothing_is_tried_and_the_chain_stands() -> None:
    plan = made(mission([Part("A", "a", [work(3)])]), Fleet((robots("a"),)))
    why = why_so_long(plan, 1, Control(time_limit_s=0))
    assert (why.additions, why.unlimited, why.chain.makespan_s) == ((), None, 3.0)
    assert why.untried == "2 further additions were not tried, for want of time."
    assert why.untried in render(why_view(why, plan, plan.schedules[0]))


def test_without_a_schedule_there_is_nothing_to_explain() -> None:
    plan = made(mission([Part("A", "a", [work(3)])]), Fleet((robots("a"),)))
    with pytest.raises(ValueError, match="alternative 2 has no schedule"):
        why_so_long(plan, 2)


def test_more_robots_have_names_of_their_own() -> None:
    fleet = Fleet((robots("a", robots=(Robot(id="ada", position=Position(1, 2)), Robot(id="ada-2"))), robots("b", 2)))
    larger = with_more(with_more(fleet, "a", like="ada"), "b", 3)
    assert list(larger.robots) == ["ada", "ada-2", "ada-3", "b-1", "b-2", "b-3", "b-4", "b-5"]
    assert larger.robots["ada-3"].position == Position(1, 2)


@pytest.mark.parametrize(("type_id", "like"), [("c", None), ("a", "b-1")])
def test_a_type_or_a_robot_that_there_is_not_is_refused(type_id: str, like: str | None) -> None:
    with pytest.raises(ValueError, match="no robot type"):
        with_more(Fleet((robots("a"), robots("b"))), type_id, like=like)


def test_room_on_ways_is_offered_where_the_chain_waits_for_it() -> None:
    """
    Two must go 20 m through a corridor for one; with room for two both go at once. The corridor in two halves that name a resource each:
    more room in one of them brings nothing.
    """
    whole = passage.planned(passage.corridor(), "greedy", together())
    assert ({"gate": 1}, "shorter") in rooms(whole)
    middle = RoadNode(id="middle", position=Position(10, 0))
    scene = passage.corridor()
    halves = (Road(ends=("west", "middle"), resource="gate"), Road(ends=("middle", "east"), resource="track"))
    scene = replace(
        scene,
        roads=RoadGraph(nodes=(middle,), roads=halves),
        resources=(*scene.resources, SharedResource(id="track")),
    )
    found = rooms(passage.planned(scene, "greedy", together()))
    assert ({"gate": 1, "track": 1}, "shorter") in found
    assert all(verdict != "shorter" for names, verdict in found if len(names) == 1)


def test_a_robot_that_has_no_room_on_its_way_is_said_to_wait_for_it() -> None:
    plan = passage.planned(passage.corridor(), "greedy", together())
    assert plan.grounding is not None
    schedule = plan.schedules[0]
    bonds = Bonds(plan.grounding.tree, schedule, plan.brief.scene, plan.brief.fleet)
    first, second = sorted((leg for leg in schedule.legs if leg.distance_m), key=lambda leg: leg.start_s)
    text = plan.grounding.tree.action(first.leaf).text
    assert why_stayed(bonds, second.leaf) == f"for Gate, which {first.robot} holds: on the way to: {text}"
    assert why_stayed(bonds, first.leaf) == ""


def together() -> MissionTree:
    """Two searches by two robots."""
    searches = (routine_node(name, "Search", agent=name) for name in ("ann", "bob"))
    return flat_tree(*searches, links=(Link("ann", "bob", "different_robot"),))


def rooms(plan: Plan) -> list[tuple[dict[str, int], str]]:
    """What was tried with more room, and what came of it."""
    return [(dict(one.resources), one.verdict) for one in why_so_long(plan, 1).additions if one.resources]
