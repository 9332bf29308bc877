"""Trying everything comes to what can be derived by hand, says when it was too much, and finds nothing where nothing is."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.scheduling.enumeration.approaches import Approaches
from missiontree.scheduling.enumeration.proving import tried_out
from missiontree.scheduling.enumeration.trying import MOST_ACTIVITIES, Tried, Trying
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.horizon import horizon_of
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.replay import replay
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, work


def problem_of(instance: Instance, *types: RobotType, world: Scene | None = None, terms: Terms = NO_TERMS) -> Problem:
    """The problem that schedulers read."""
    problem = read_problem(instance.tree, instance.alternative, Fleet(types), world or Scene(), terms)
    assert isinstance(problem, Problem)
    return problem


def tried(problem: Problem, limit: int, most_steps: int = 10_000) -> Tried:
    """Everything that is over by a limit."""
    return Trying(problem, limit, most_steps, lambda: False)()


def makespan(problem: Problem, found: Tried) -> int | None:
    """Of the course that was found, played through."""
    draft = replay(problem, found.course) if found.course is not None else None
    return None if draft is None else draft.makespan


def far_and_near() -> tuple[Instance, RobotType, Scene]:
    """Work at 4 and at -3, 1 s each; one robot at 0, 1 m/s: -3 first, 3 + 1 + 7 + 1 = 12 s; 4 first, 4 + 1 + 7 + 1 = 13 s."""
    made = mission([Part("p", "r", [work(1, at="p")]), Part("q", "r", [work(1, at="q")])])
    return made, robots("r", speed=1, position=at(0)), scene(p=4, q=-3)


def test_the_nearer_first() -> None:
    made, kind, world = far_and_near()
    problem = problem_of(made, kind, world=world)
    found = tried(problem, 20_000)
    assert found.complete
    assert makespan(problem, found) == 12_000
    assert found.course is not None
    assert list(found.course.tours["r-1"]) == [1, 0]


def test_nothing_beats_the_least() -> None:
    made, kind, world = far_and_near()
    found = tried(problem_of(made, kind, world=world), 11_999)
    assert (found.complete, found.course) == (True, None)


def test_nobody_asks_how_long_it_may_take_where_there_is_too_much_to_try() -> None:
    """The latest end is dear to tell in a large mission, and of use only to trying."""
    made = mission([Part(f"p{n}", "r", [work(1)]) for n in range(MOST_ACTIVITIES + 1)])
    problem = problem_of(made, robots("r"))

    def horizon() -> int:
        pytest.fail("it was asked")

    assert tried_out(problem, None, horizon, 100, lambda: False) == (None, None)


def test_too_many_steps_leave_it_open() -> None:
    made = mission([Part(f"p{n}", "r", [work(n + 1)]) for n in range(8)])
    found = tried(problem_of(made, robots("r", 3)), 12_000, most_steps=20)
    assert not found.complete


def test_who_is_told_to_stop_stops() -> None:
    made = mission([Part(f"p{n}", "r", [work(n + 1)]) for n in range(12)])
    found = Trying(problem_of(made, robots("r", 3)), 40_000, 10**9, lambda: True)()
    assert not found.complete
    assert found.steps < 100


def test_who_must_take_part_does() -> None:
    """Two robots, equal but for their names, and two roles in a row by precedence: r-2 must do one of them."""
    made = mission([Part("a", "r", [work(1)]), Part("b", "r", [work(1)])], [("a", "b")])
    problem = problem_of(made, robots("r", 2), terms=Terms(require=("r-2",)))
    found = tried(problem, 2_000)
    assert found.course is not None
    assert "r-2" in found.course.robots.values()
    assert makespan(problem, found) == 2_000


def test_all_ways_of_being_under_way_are_tried() -> None:
    """a's following starts at 5; it lasts until c (3 s) and d (1 s) have ended, one of which must end at 5.001 or later."""
    parts = [Part("a", "r", [work(5), work(9, open_ended=True)]), Part("c", "s", [work(3)]), Part("d", "t", [work(1)])]
    made = mission(parts, [("a", "c", "until"), ("a", "d", "until")])
    problem = problem_of(made, robots("r"), robots("s"), robots("t"))
    assert makespan(problem, tried(problem, 20_000)) == 5_001


def test_what_must_be_under_way_at_the_end_may_begin_before_what_is_put_down() -> None:
    """a works 5 s, then follows until c (6 s) has ended: c starts at 0, though it is put down after the following, and ends at 6."""
    parts = [Part("a", "r", [work(5), work(9, open_ended=True)]), Part("c", "s", [work(6)])]
    problem = problem_of(mission(parts, [("a", "c", "until")]), robots("r"), robots("s"))
    found = tried(problem, 6_000)
    assert (found.complete, makespan(problem, found)) == (True, 6_000)


def test_roles_that_have_nothing_to_do_with_each_other_are_put_down_in_one_order() -> None:
    """
    Beside the two roles of :func:`far_and_near`, of which no order takes less than 12 s, four robots of other types do three things each:
    12! / 3!^4 orders of these alone, and it matters in none which comes first.
    """
    others = [Part(name, name, [work(1), work(2), work(3)]) for name in "uvwx"]
    two = [Part("p", "r", [work(1, at="p")]), Part("q", "r", [work(1, at="q")])]
    kinds = [robots(name) for name in "uvwx"]
    problem = problem_of(mission([*two, *others]), robots("r", speed=1, position=at(0)), *kinds, world=scene(p=4, q=-3))
    found = tried(problem, 11_999)
    assert (found.complete, found.course) == (True, None)
    assert found.steps <= 60


def test_the_ways_into_what_is_left_count_from_where_robots_are() -> None:
    """
    Work at 4, at -3 and at 20 (5 s, 1 s and 1 s), 1 m/s from 0. Ways into all from the start and from each other are 3, 4 and 16 s at
    least, which with 7 s of work comes to 30 s; the best order is -3, 4, 20 with 3 + 7 + 16 s on the way: 33 s. Whichever comes
    first, the ways into the other two then show that 33 s cannot be beaten: four steps, the empty schedule and three with one role.
    """
    parts = [Part("p", "r", [work(5, at="p")]), Part("q", "r", [work(1, at="q")]), Part("s", "r", [work(1, at="s")])]
    problem = problem_of(mission(parts), robots("r", speed=1, position=at(0)), world=scene(p=4, q=-3, s=20))
    ways = Approaches(problem, "r", [0, 1, 2])
    assert ways.least([0, 1, 2], [(-1, at(0))]) == ([0, 0, 0], [4_000, 3_000, 16_000])
    assert ways.least([0, 1], [(2, at(0))]) == ([0, 0], [7_000, 7_000])  # held by the role at 20, which ends there
    found = tried(problem, 33_000)
    assert (found.complete, makespan(problem, found)) == (True, 33_000)
    assert tried(problem, 32_999) == Tried(complete=True, course=None, steps=4)


def test_a_joint_move_may_follow_the_way_to_where_the_other_works() -> None:
    """From 6, at 2 m/s: to the box at 2 in 2 s; then, with b at work there for 1 s, a moves to 3 in 1.5 s: 3.5 s in all."""
    made = mission([Part("a", "r", [move("q", sync=0)], team=0), Part("b", "r", [work(1, at="box", sync=0)], team=0)])
    problem = problem_of(made, robots("r", 2, speed=2, position=at(6)), world=scene(q=3, box=2))
    assert horizon_of(problem) >= 3_500
    assert makespan(problem, tried(problem, horizon_of(problem))) == 3_500


def test_a_robot_that_was_under_way_until_something_ended_is_free_after_it() -> None:
    """
    One robot works for 5 s, and watches until a tick, which takes no time and must come by 1 s: the watch comes first, and both are over
    at 5.001 s. The work has the smallest number, and starts when the tick does; but it could not have been put down before that.
    """
    parts = [
        Part("work", "a", [work(5)]),
        Part("watch", "a", [work(open_ended=True)]),
        Part("tick", "b", [work(0)]),
    ]
    made = mission(parts, [("watch", "tick", "until")]).timed(tick=(0, 1))
    problem = problem_of(made, robots("a"), robots("b"))
    found = tried(problem, 20_000)
    assert (found.complete, found.makespan, makespan(problem, found)) == (True, 5_001, 5_001)


def test_a_course_that_takes_longer_than_it_seemed_proves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is found is 12 s long; carried out it takes 13 s, and nobody knows then whether 12.5 s would do."""
    made, kind, world = far_and_near()
    problem = problem_of(made, kind, world=world)
    found = tried(problem, 20_000).course
    assert found is not None
    draft = replay(problem, found)
    assert draft is not None
    longer = replace(draft, makespan=13_000)
    monkeypatch.setattr("missiontree.scheduling.enumeration.proving.replay", lambda problem, course: longer)
    best, proof = tried_out(problem, None, lambda: 20_000, 1_000, lambda: False)
    assert best is not None
    assert (best.makespan, proof) == (13_000, None)


def test_robots_that_may_exchange_what_they_bring_leave_it_unproven() -> None:
    """
    Two robots bring something to m, 30 s of way from each, and each could take what the other holds out, both at 31 s: done at 32 s.

    No order of events has that, so it is not tried, and what is found is no proof. If the second waits for the first to be taken, or
    those who take cannot give, there is no exchange.
    """

    def proven(links: list[tuple[str, str]], taker: str = "r") -> bool:
        parts = [
            Part("give1", "r", [work(1, at="m")]),
            Part("take1", taker, [work(1, at="m")]),
            Part("give2", "r", [work(1, at="m")]),
            Part("take2", taker, [work(1, at="m")]),
        ]
        overs = [("give1", "take1", "hand_over"), ("give2", "take2", "hand_over")]
        two = (Robot(id="w", position=at(0)), Robot(id="e", position=at(60)))
        types = [robots("r", speed=1, robots=two)]
        if taker != "r":
            types.append(robots(taker, 2, speed=1, position=at(30)))
        problem = problem_of(mission(parts, [*overs, *links]), *types, world=scene(m=30))
        found = tried(problem, 200_000, 200_000)
        assert found.course is not None
        return found.complete

    assert not proven([])
    assert proven([("take1", "give2")])
    assert proven([], taker="s")


def test_what_may_be_out_of_turn_is_tried_anyway_when_asked_and_proves_nothing() -> None:
    """Two pass one door, 3 s and 2 s; a light lasts until the first is through. Both are through after 5 s: found, but not proven."""
    parts = [
        Part("first", "r", [work(3, holds=("door",))]),
        Part("second", "r", [work(2, holds=("door",))]),
        Part("light", "s", [work(0, open_ended=True)]),
    ]
    made = mission(parts, [("light", "first", "until")])
    world = replace(scene(), resources=(SharedResource(id="door", capacity=1),))
    problem = problem_of(made, robots("r", 2), robots("s"), world=world)
    assert tried(problem, 20_000) == Tried(False, None, 0)
    found = Trying(problem, 20_000, 1_000, lambda: False, anyway=True)()
    assert (found.complete, makespan(problem, found)) == (False, 5_000)


def test_what_takes_no_time_does_not_pass_a_door_before_who_must_have_begun_to_hold_it() -> None:
    """
    From 5 s on b looks at a box, in a door, until c has worked for 4 s; a takes the box away in no time, through the door, and works 10 s.

    At 5 s b has to begin before the box is gone, and a would have to be through the door before b begins. So a waits until 9 s, and 19 s
    do; had the box gone first, b would have to come after it, for 30 s. By times alone 15 s would do.
    """
    parts = [
        Part("look", "b", [work(0, at="box", open_ended=True, holds=("door",))]),
        Part("work", "c", [work(4)]),
        Part("take", "a", [move("p", "box", holds=("door",)), work(10)]),
    ]
    made = mission(parts, [("look", "work", "until")]).timed(look=(5, None), work=(5, None), take=(5, None))
    world = replace(scene(p=0, box=30), resources=(SharedResource(id="door"),))
    kinds = (robots("a", speed=1, position=at(0)), robots("b", speed=1, position=at(30)), robots("c"))
    problem = problem_of(made, *kinds, world=world)
    found = tried(problem, 40_000)
    assert found.complete
    assert found.makespan == makespan(problem, found) == 19_000
