"""Greedy schedules against numbers derived by hand."""

from __future__ import annotations

from itertools import combinations, count

import pytest

from missiontree.mission.area import Area, KeepOut
from missiontree.mission.control import Control
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.ways import Lift, RoadGraph
from missiontree.scheduling import SCHEDULERS
from tests.scheduling.instances import (
    Group,
    Instance,
    Part,
    at,
    mission,
    move,
    robot_of,
    robots,
    scene,
    schedule,
    times,
    work,
)


def legs(instance: Instance, result: Schedule) -> dict[str, tuple[float, float, float]]:
    """Start, end and metres of travel by action name."""
    return {instance.tree.action(leg.leaf).text: (leg.start_s, leg.end_s, leg.distance_m) for leg in result.legs}


def test_the_list_of_schedulers_has_it() -> None:
    made = mission([Part("a", "r", [work(1)])])
    result = SCHEDULERS["greedy"](made.tree, made.alternative, Fleet((robots("r"),)), Scene(), Control())
    assert result.makespan_s == 1


def test_a_precedence_between_inner_nodes_waits_for_the_latest_leaf() -> None:
    """G holds a (3 s) and b (5 s), done in parallel by two types; c of a third type starts at the later end, 5 s."""
    made = mission(
        [Group("G", [Part("a", "x", [work(3)]), Part("b", "y", [work(5)])]), Part("c", "z", [work(1)])], [("G", "c")]
    )
    result = schedule(made, robots("x"), robots("y"), robots("z"))
    assert times(made, result) == {"a.0": (0, 3), "b.0": (0, 5), "c.0": (5, 6)}
    # critical path b, c = 6 s is what came out, so it is proven
    assert (result.status, result.certificate.claim, result.certificate.method) == (
        "optimal",
        "proven",
        "critical_path",
    )


def test_two_roles_of_one_robot_come_one_after_the_other() -> None:
    """4 + 2 s of work for a single robot: the load bound is 6 s, the longest role only 4 s."""
    made = mission([Part("a", "r", [work(4)]), Part("b", "r", [work(2)])])
    result = schedule(made, robots("r"))
    assert times(made, result) == {"a.0": (0, 4), "b.0": (4, 6)}
    assert (result.status, result.certificate.method, result.certificate.bound) == ("optimal", "load", 6)


def test_interchangeable_robots_share_independent_work() -> None:
    """The paper's rescue: two searches at the same time by both Tele-Robots, the second one's end frees the transport."""
    search = [work(2), work(3), work(1)]
    made = mission(
        [Part("firefighter", "tele", search), Part("cat", "tele", search), Part("bring", "carrier", [work(5)])],
        [("cat", "bring")],
    )
    result = schedule(made, robots("tele", 2), robots("carrier"))
    assert times(made, result)["firefighter.0"] == times(made, result)["cat.0"] == (0, 2)
    assert len(set(robot_of(made, result).values())) == 3
    assert result.makespan_s == 11  # 2 + 3 + 1, then 5
    assert result.status == "optimal"


def test_a_moved_child_is_found_where_it_was_taken() -> None:
    """
    t (2 m/s, from 0) reaches the child at 10 in 5 s, works 1 s, and leads it at its 0.5 m/s over 20 m to mom at 30: 40 s, till 46.

    s (1 m/s, from 0) needs 30 s to mom's, is there before the child is, and works from 46 to 51.
    """
    made = mission(
        [Part("lead", "t", [work(1, at="child"), move("mom", "child")]), Part("use", "s", [work(5, at="child")])],
        [("lead", "use")],
    )
    world = scene({"child": 0.5}, child=10, mom=30)
    result = schedule(made, robots("t", speed=2, position=at(0)), robots("s", speed=1, position=at(0)), world=world)
    assert times(made, result) == {"lead.0": (5, 6), "lead.1": (6, 46), "use.0": (46, 51)}
    assert legs(made, result) == {"lead.0": (0, 5, 10), "lead.1": (6, 46, 20), "use.0": (0, 30, 30)}
    assert result.status == "optimal"
    assert result.assumptions == ()


def test_carrying_together_takes_as_long_as_the_slower_robot() -> None:
    """fast (2 m/s) and slow (1 m/s) start at 0; the box is at 4: 2 s and 4 s; both lift at 4 for 1 s and go 6 m by 5 + 6 = 11 s."""
    steps = [work(1, at="box", sync=0), move("goal", "box", sync=1)]
    made = mission([Part("a", "fast", steps, team=0), Part("b", "slow", steps, team=0)])
    result = schedule(
        made,
        robots("fast", speed=2, position=at(0)),
        robots("slow", speed=1, position=at(0)),
        world=scene(box=4, goal=10),
    )
    assert times(made, result) == {"a.0": (4, 5), "b.0": (4, 5), "a.1": (5, 11), "b.1": (5, 11)}
    assert legs(made, result)["a.0"] == (0, 2, 4)
    assert result.status == "optimal"


def test_a_team_takes_different_robots_of_one_type() -> None:
    made = mission([Part("a", "r", [work(1), work(2, sync=0)], team=0), Part("b", "r", [work(2, sync=0)], team=0)])
    result = schedule(made, robots("r", 2))
    assert times(made, result) == {"a.0": (0, 1), "a.1": (1, 3), "b.0": (1, 3)}
    assert len(set(robot_of(made, result).values())) == 2


def test_two_teams_of_two_never_wait_for_each_other_for_ever() -> None:
    """Each team needs both robots; taken one by one, each team could hold one and wait. One team after the other: 3 + 3 s."""
    team = [work(1), work(2, sync=0)]
    other = [work(1), work(2, sync=1)]
    made = mission(
        [
            Part("a", "r", team, team=0),
            Part("c", "r", other, team=1),
            Part("b", "r", team, team=0),
            Part("d", "r", other, team=1),
        ]
    )
    result = schedule(made, robots("r", 2))
    assert (result.status, result.makespan_s) == ("optimal", 6)


def test_following_lasts_until_the_other_has_ended() -> None:
    """Following has a nominal second, but lasts until the transport ends at 7; the robot is held so long and rests of b wait."""
    made = mission(
        [Part("a", "r", [work(1), work(1, open_ended=True)]), Part("b", "s", [work(7)]), Part("c", "r", [work(2)])],
        [("a", "b", "until"), ("a", "c")],
    )
    result = schedule(made, robots("r"), robots("s"))
    assert times(made, result) == {"a.0": (0, 1), "b.0": (0, 7), "a.1": (1, 7), "c.0": (7, 9)}
    assert result.status == "optimal"


def test_what_is_followed_to_its_end_waits_as_long_as_it_must() -> None:
    """a's following starts at 5, after five seconds of work; b takes 2 s and may end a tick later, no sooner: 3.001 to 5.001."""
    made = mission(
        [Part("a", "r", [work(5), work(9, open_ended=True)]), Part("b", "s", [work(2)])], [("a", "b", "until")]
    )
    result = schedule(made, robots("r"), robots("s"))
    assert times(made, result) == {"a.0": (0, 5), "a.1": (5, 5.001), "b.0": (3.001, 5.001)}


def test_one_robot_cannot_follow_until_it_has_done_something_else() -> None:
    """With one robot proven impossible, whether by its type or by a link; with two there is a schedule."""
    parts = [Part("a", "r", [work(5), work(9, open_ended=True)]), Part("b", "r", [work(2)])]
    made = mission(parts, [("a", "b", "until")])
    alone = schedule(made, robots("r"))
    assert (alone.status, alone.reasons[0].rule) == ("infeasible", "until_needs_two")
    assert schedule(made, robots("r", 2)).makespan_s == 5.001
    held = schedule(mission(parts, [("a", "b", "until"), ("a", "b", "same_robot")]), robots("r", 2))
    assert (held.status, held.reasons[0].rule) == ("infeasible", "until_needs_two")


def test_of_two_that_may_end_last_one_waits() -> None:
    """c (3 s) and d (1 s) stand below b; a's following starts at 5. One of the two ends at 5.001, the other need not wait."""
    parts: list[Part | Group] = [
        Part("a", "r", [work(5), work(9, open_ended=True)]),
        Group("b", [Part("c", "s", [work(3)]), Part("d", "t", [work(1)])]),
    ]
    result = schedule(made := mission(parts, [("a", "b", "until")]), robots("r"), robots("s"), robots("t"))
    ends = sorted(times(made, result)[name][1] for name in ("c.0", "d.0"))
    assert ends[0] <= 3
    assert (ends[1], result.makespan_s) == (5.001, 5.001)


def test_open_ended_without_until_lasts_its_duration() -> None:
    made = mission([Part("a", "r", [work(4, open_ended=True)])])
    assert schedule(made, robots("r")).makespan_s == 4


def test_a_robot_waits_inside_its_role_and_takes_nothing_else() -> None:
    """a.1 waits for b (8 s) of another type; a's robot is held from 0 to 9, so c (1 s) comes after it or before it, never within."""
    made = mission(
        [Part("a", "r", [work(1), work(1)]), Part("b", "s", [work(8)]), Part("c", "r", [work(1)])], [("b", "a.1")]
    )
    result = schedule(made, robots("r"), robots("s"))
    spans = times(made, result)
    assert spans["c.0"][1] <= spans["a.0"][0] or spans["c.0"][0] >= spans["a.1"][1]
    # best: c first (0-1), a.0 (1-2), then wait till 8: a.1 ends at 9 = critical path b, a.1
    assert (result.makespan_s, result.status) == (9, "optimal")


def test_the_way_to_a_role_overlaps_waiting() -> None:
    """b waits for a (10 s); its robot walks 6 m at 1 m/s meanwhile and is there at 6."""
    made = mission([Part("a", "s", [work(10)]), Part("b", "r", [work(1, at="p")])], [("a", "b")])
    result = schedule(made, robots("r", speed=1, position=at(0)), robots("s"), world=scene(p=6))
    assert legs(made, result)["b.0"] == (0, 6, 6)
    assert times(made, result)["b.0"] == (10, 11)


def test_a_move_waits_for_its_predecessors_before_it_starts() -> None:
    """The same with a move: the way is the action itself, 10 to 16."""
    made = mission([Part("a", "s", [work(10)]), Part("b", "r", [move("p")])], [("a", "b")])
    result = schedule(made, robots("r", speed=1, position=at(0)), robots("s"), world=scene(p=6))
    assert times(made, result)["b.0"] == legs(made, result)["b.0"][:2] == (10, 16)


def test_what_is_unknown_takes_no_travel_and_is_said() -> None:
    """
    Nowhere to start from: the approach to p is 0 s, the way on to q 3 m at 1 m/s. Without a speed the way is 0 s, 3 m.

    To an unknown place a move takes its nominal 7 s.
    """
    made = mission([Part("a", "r", [work(1, at="p"), work(1, at="q"), move("lost", nominal_s=7)])])
    result = schedule(made, robots("r", speed=1), world=scene(p=0, q=3, lost=None))
    assert times(made, result) == {"a.0": (0, 1), "a.1": (4, 5), "a.2": (5, 12)}
    assert [(reason.rule, reason.robot, reason.severity) for reason in result.assumptions] == [
        ("start_unknown", "r-1", "assumption")
    ]
    slow = schedule(made, robots("r", position=at(0)), world=scene(p=0, q=3, lost=None))
    assert times(made, slow)["a.1"] == (1, 2)
    assert legs(made, slow)["a.1"] == (1, 1, 3)
    assert [reason.rule for reason in slow.assumptions] == ["speed_unknown"]


def test_a_way_by_lift_alone_says_so_too_if_the_speed_is_not_known() -> None:
    """No metre is travelled, and the ride is left out all the same: who is slow in a corridor may wait for the lift, too."""
    p, q = Position(0, 0), Position(9, 0)
    world = Scene(
        places=(Entity(id="p", kind="place", position=p), Entity(id="q", kind="place", position=q)),
        roads=RoadGraph(lifts=(Lift(id="hoist", stops=("p", "q"), ride_s=5),)),
    )
    made = mission([Part("a", "r", [work(1, at="q")])])
    result = schedule(made, robots("r", position=p), world=world)
    assert (times(made, result)["a.0"], legs(made, result)) == ((0, 1), {})
    assert [reason.rule for reason in result.assumptions] == ["speed_unknown"]


def test_after_work_at_an_unknown_place_the_robot_is_somewhere_unknown() -> None:
    """r-1 starts at 0, works 2 s where nobody knows and 1 s at p, 6 m from its start: the way there is no travel, and that is said."""
    made = mission([Part("a", "r", [work(2, at="lost"), work(1, at="p")])])
    result = schedule(made, robots("r", speed=1, position=at(0)), world=scene(p=6, lost=None))
    assert times(made, result) == {"a.0": (0, 2), "a.1": (2, 3)}
    assert [(reason.rule, reason.robot, reason.node) for reason in result.assumptions] == [
        ("whereabouts_unknown", "r-1", "a.0")
    ]
    assert "because lost has no position" in result.assumptions[0].message


def test_of_two_robots_the_nearer_goes() -> None:
    kind = robots("r", speed=1, robots=(Robot(id="far", position=at(50)), Robot(id="near", position=at(9))))
    made = mission([Part("a", "r", [work(1, at="p")])])
    result = schedule(made, kind, world=scene(p=10))
    assert robot_of(made, result) == {"a": "near"}
    assert (result.makespan_s, result.status) == (2, "optimal")  # no robot of the type can be there before 1 s


def test_no_robot_takes_both_roles_if_travel_drains_it() -> None:
    """
    near stands between p (at 10) and q (at -10), far at -50. A metre uses 1 J, near has 25 J, far 100 J.

    near could do p and q one after the other in 10 + 1 + 20 + 1 s with 30 J, more than it has. So far must take one of them: q, 40 m
    away, which ends at 41 s (p would be 60 m).
    """
    kind = robots(
        "r",
        speed=1,
        uses_per_m={"energy_j": 1},
        robots=(
            Robot(id="near", position=at(0), remaining={"energy_j": 25}),
            Robot(id="far", position=at(-50), remaining={"energy_j": 100}),
        ),
    )
    made = mission([Part("p", "r", [work(1, at="p")]), Part("q", "r", [work(1, at="q")])])
    result = schedule(made, kind, world=scene(p=10, q=-10))
    assert robot_of(made, result) == {"p": "near", "q": "far"}
    assert (result.status, result.certificate.method, result.makespan_s) == ("optimal", "enumeration", 41)


def test_totals_of_a_type_bind_over_all_its_robots() -> None:
    """Two roles at 3 coins each, 5 for the type, though each robot has enough: proven impossible."""
    made = mission([Part("a", "r", [work(1, uses={"coins": 3})]), Part("b", "r", [work(1, uses={"coins": 3})])])
    result = schedule(made, robots("r", 2, total_limits={"coins": 5}))
    assert (result.status, result.certificate.claim) == ("infeasible", "proven")
    assert [reason.rule for reason in result.reasons] == ["budget_exceeded"]
    assert schedule(made, robots("r", 2, total_limits={"coins": 6})).status == "optimal"


def test_the_witness_is_tried_where_the_plain_choice_runs_dry() -> None:
    """
    big has 10 J, small 4 J. The 3 J role comes first and plainly takes big, being as early; the 9 J role then finds only small.

    The witness gives big to the 9 J role.
    """
    kind = robots("r", robots=(Robot(id="big", remaining={"e": 10}), Robot(id="small", remaining={"e": 4})))
    parts = [Part("light", "r", [work(1, uses={"e": 3})]), Part("heavy", "r", [work(1, uses={"e": 9})])]
    made = mission(parts, witness={"light": "small", "heavy": "big"})
    assert robot_of(made, schedule(made, kind)) == {"light": "small", "heavy": "big"}
    # and without one, every binding is tried before giving up
    assert robot_of(mission(parts), schedule(mission(parts), kind)) == {"light": "small", "heavy": "big"}


def test_same_robot_and_different_robot_links() -> None:
    """Two robots could do both at once (3 s); one robot needs 6 s."""
    parts = [Part("a", "r", [work(3)]), Part("b", "r", [work(3)])]
    same = mission(parts, [("a", "b", "same_robot")])
    result = schedule(same, robots("r", 2))
    assert len(set(robot_of(same, result).values())) == 1
    assert (result.makespan_s, result.status, result.certificate.method) == (6, "optimal", "load")
    apart = mission(parts, [("a", "b", "different_robot"), ("a", "b")])
    assert len(set(robot_of(apart, schedule(apart, robots("r", 2))).values())) == 2


@pytest.mark.parametrize(
    ("links", "fleet", "rule"),
    [
        pytest.param([("a", "b"), ("b", "a")], robots("r", 2), "cycle", id="cycle"),
        pytest.param([("a.0", "b"), ("b", "a.1")], robots("r", 1), "deadlock", id="held while only it could do b"),
        pytest.param(
            [("a.0", "b"), ("b", "a.1"), ("a", "b", "same_robot")], robots("r", 2), "deadlock", id="same robot"
        ),
        pytest.param(
            [("a", "b", "same_robot"), ("a", "b", "different_robot")], robots("r", 2), "same_robot", id="both"
        ),
    ],
)
def test_what_cannot_be_is_proven_with_its_reason(links: list[tuple[str, str]], fleet: object, rule: str) -> None:
    made = mission([Part("a", "r", [work(1), work(1)]), Part("b", "r", [work(1)])], links)
    result = schedule(made, fleet)  # type: ignore[arg-type]
    assert (result.status, result.certificate.claim) == ("infeasible", "proven")
    assert result.reasons[0].rule == rule
    assert result.actions == ()


def test_a_cycle_names_its_nodes() -> None:
    made = mission(
        [Part("fetch", "r", [work(1)]), Part("carry", "r", [work(1)])], [("fetch", "carry"), ("carry", "fetch")]
    )
    message = schedule(made, robots("r")).reasons[0].message
    assert "fetch" in message
    assert "carry" in message


def test_b_within_a_needs_a_second_robot_and_gets_it() -> None:
    """The same order that one robot cannot keep: a.0 (0-1), b (1-2) by the other robot, a.1 (2-3)."""
    made = mission([Part("a", "r", [work(1), work(1)]), Part("b", "r", [work(1)])], [("a.0", "b"), ("b", "a.1")])
    result = schedule(made, robots("r", 2))
    assert times(made, result) == {"a.0": (0, 1), "b.0": (1, 2), "a.1": (2, 3)}


def test_two_roles_that_hold_both_robots_in_vain_are_put_off() -> None:
    """
    a.1 and b.1 both wait for c, and there are two robots: if a and b begin first, c never finds one.

    c goes first (0-5) with one of a or b beside it; the load is 5 + 2 + 2 s for two robots, and the chain c, a.1 takes 6 s. The robot
    that did c then does the other role, from 5 to 7.
    """
    two = [work(1), work(1)]
    made = mission([Part("a", "r", two), Part("b", "r", two), Part("c", "r", [work(5)])], [("c", "a.1"), ("c", "b.1")])
    result = schedule(made, robots("r", 2))
    assert result.makespan_s == 7


def test_a_place_out_of_reach_is_proven_and_named() -> None:
    """p stands in the middle of a keep-out."""
    world = Scene(
        places=(Entity(id="p", kind="place", position=at(10)),),
        keep_outs=(KeepOut(id="fire", area=Area(corners=((8, -2), (12, -2), (12, 2), (8, 2)))),),
    )
    made = mission([Part("a", "r", [work(1, at="p")])])
    result = schedule(made, robots("r", speed=1, position=at(0)), world=world)
    assert (result.status, result.certificate.claim) == ("infeasible", "proven")
    assert (result.reasons[0].rule, result.reasons[0].needed) == ("unreachable", "p")


def test_another_floor_without_a_lift_is_out_of_reach() -> None:
    world = Scene(places=(Entity(id="p", kind="place", position=Position(1, 0, floor="first")),))
    made = mission([Part("a", "r", [move("p")])])
    assert schedule(made, robots("r", speed=1, position=at(0)), world=world).reasons[0].rule == "unreachable"


def test_too_few_robots_for_a_team() -> None:
    made = mission([Part("a", "r", [work(1, sync=0)], team=0), Part("b", "r", [work(1, sync=0)], team=0)])
    result = schedule(made, robots("r"))
    assert (result.status, result.reasons[0].rule, result.reasons[0].found, result.reasons[0].needed) == (
        "infeasible",
        "too_few_robots",
        "1",
        "2",
    )


def test_what_is_not_found_and_not_excluded_is_unknown() -> None:
    """
    Ten roles that pairwise exclude each other need ten robots; there are nine. No bound of ours proves it, and to try everything takes more
    steps than are taken, so it is not claimed. Of three roles and two robots everything is tried.
    """
    for roles, known in (("abcdefghij", ("unknown", "unproven")), ("abc", ("infeasible", "proven"))):
        apart = [(a, b, "different_robot") for a, b in combinations(roles, 2)]
        made = mission([Part(name, "r", [work(1)]) for name in roles], apart)
        result = schedule(made, robots("r", len(roles) - 1))
        assert (result.status, result.certificate.claim) == known
        assert result.reasons


def test_stopped_before_the_end_it_says_so() -> None:
    """Told to stop, it still makes one run of a small mission; of a large one it returns nothing and the reason."""
    small = mission([Part("a", "r", [work(1)])])
    assert schedule(small, robots("r"), control=Control(stop=lambda: True)).status == "optimal"
    large = mission([Part(f"a{number}", "r", [work(1)]) for number in range(300)])
    result = schedule(large, robots("r"), control=Control(stop=lambda: True))
    assert (result.status, result.reasons[0].rule) == ("unknown", "time_limit")


def test_time_runs_out_within_a_run_and_the_best_so_far_is_kept() -> None:
    """
    A clock that advances 1 s at every look: 300 actions of one robot need 300 looks or a few more for a run.

    With 5,000 s several runs are complete and the last is cut off; with 20 s none is, and that is said first.
    """
    made = mission([Part(f"a{number}", "r", [work(1, at="pq"[number % 2])]) for number in range(300)])
    kind, world = robots("r", speed=1, position=at(0)), scene(p=3, q=9)

    def within(limit_s: float) -> Schedule:
        looks = count()
        control = Control(time_limit_s=limit_s, clock=lambda: float(next(looks)))
        return schedule(made, kind, world=world, control=control)

    cut = within(20)
    assert (cut.status, cut.actions, cut.reasons[0].rule) == ("unknown", (), "time_limit")
    assert within(5_000).status in {"optimal", "feasible"}
    assert len(within(5_000).actions) == 300


def test_the_same_input_and_seed_give_the_same_schedule() -> None:
    parts = [Part(f"a{number}", "r", [work(number % 3 + 1), work(number % 2 + 1)]) for number in range(9)]
    made = mission(parts, [("a0", "a5"), ("a1.0", "a7"), ("a3", "a2")])
    kind = robots("r", 3)
    assert schedule(made, kind, control=Control(seed=4)) == schedule(made, kind, control=Control(seed=4))


def test_an_empty_selection_takes_no_time() -> None:
    result = schedule(mission([]), robots("r"))
    assert (result.status, result.makespan_s, result.actions) == ("optimal", 0, ())
