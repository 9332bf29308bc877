"""The front of missions whose plans can be counted on the fingers."""

from __future__ import annotations

from dataclasses import replace

from missiontree.allocation.kbest import ExactKBest
from missiontree.choosing.choose import choose
from missiontree.choosing.fronts import handful
from missiontree.mission.alternative import Alternative
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.search_limit import SearchLimit
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.scheduling.greedy import greedy
from tests.choosing.asking import asked, brief, front_of, points, task, tasks, with_deadline

EXPERT, NOVICE, HAND = ("expert", 1.0, 10.0), ("novice", 0.5, 4.0), ("hand", 0.4, 6.0)


def test_the_slow_expert_and_the_fast_novice_are_both_on_the_front_and_who_is_neither_is_not() -> None:
    """The hand does it worse than the novice, and slower."""
    front = front_of(tasks(task(1, EXPERT, NOVICE, HAND)))
    assert points(front) == [(1.0, 10.0), (0.5, 4.0)]
    assert (front.found, front.certificate.claim) == (2, "proven")
    assert [option.certificate.claim for option in front.options] == ["proven", "proven"]
    assert [option.alternative.rank for option in front.options] == [1, 2]


def test_robots_work_side_by_side() -> None:
    """
    Two tasks, one expert and one novice.

    The expert does both in 20 s (2.0); one each takes 10 s (1.5); the novice does both in 8 s (1.0).
    """
    front = front_of(tasks(task(1, EXPERT, NOVICE), task(2, EXPERT, NOVICE)))
    assert points(front) == [(2.0, 20.0), (1.5, 10.0), (1.0, 8.0)]
    assert front.certificate.claim == "proven"


def test_a_front_of_one_plan_is_proven_too() -> None:
    front = front_of(tasks(task(1, ("expert", 1.0, 4.0), NOVICE)))
    assert (points(front), front.certificate.claim) == ([(1.0, 4.0)], "proven")


def test_of_equals_in_utility_the_faster_is_on_the_front() -> None:
    """The twin does it as well as the expert, and in 7 s."""
    assert points(front_of(tasks(task(1, EXPERT, ("twin", 1.0, 7.0), NOVICE)))) == [(1.0, 7.0), (0.5, 4.0)]


def test_a_deadline_of_the_mission_cuts_the_better_end_off() -> None:
    """Due by 9 s, the expert is too late."""
    assert points(front_of(with_deadline(tasks(task(1, EXPERT, NOVICE)), 9.0))) == [(0.5, 4.0)]


def test_mean_and_least_utility_have_fronts_of_their_own() -> None:
    """Two tasks as above: the mean of 1.0 and 0.5 is 0.75; the least of them is 0.5, for which the novice alone is as good, and faster."""
    tree = tasks(task(1, EXPERT, NOVICE), task(2, EXPERT, NOVICE))
    assert points(front_of(tree, brief(accumulate="mean"))) == [(1.0, 20.0), (0.75, 10.0), (0.5, 8.0)]
    assert points(front_of(tree, brief(accumulate="min"))) == [(1.0, 20.0), (0.5, 8.0)]


def test_that_teams_are_to_differ_in_the_list_plays_no_part() -> None:
    """Both ways of sending one each have one team; so have two plans here: 1.6 in 11 s, 1.5 in 10 s."""
    tree = tasks(task(1, EXPERT, NOVICE), task(2, ("expert", 1.1, 11.0), NOVICE))
    assert points(front_of(tree, brief(diverse=True))) == [(2.1, 21.0), (1.6, 11.0), (1.5, 10.0), (1.0, 8.0)]


def test_utilities_that_weigh_time_make_another_front() -> None:
    """With 0.1 for a second, the expert's 1.0 becomes 0.0 and the novice's 0.5 becomes 0.1: nothing speaks for the expert."""
    assert points(front_of(tasks(task(1, EXPERT, NOVICE)), brief(weights=Weights(1.0, 0.1)))) == [(0.1, 4.0)]


def test_what_is_stopped_at_once_claims_nothing() -> None:
    assert asked(tasks(task(1, EXPERT, NOVICE)), brief(), Control(stop=lambda: True), front=True).front is None


def test_what_is_known_when_the_search_is_stopped_stands_there_as_found() -> None:
    """The list has the expert and the novice, both scheduled; nothing more is looked at."""
    tree, mission, stopped = tasks(task(1, EXPERT, NOVICE, HAND)), brief(), Control(stop=lambda: True)
    ranking = ExactKBest()(tree, mission.fleet, mission.weights, 2, Control())
    schedules = tuple(greedy(tree, one, mission.fleet, mission.world, Control()) for one in ranking.alternatives)
    front = choose(tree, mission, mission.world, greedy, stopped, ranking, schedules, front=True).front
    assert front is not None
    assert points(front) == [(1.0, 10.0), (0.5, 4.0)]
    assert {option.certificate.claim for option in front.options} == {"unproven"}
    assert front.certificate.limit == SearchLimit("stopped")


def loose(
    tree: GroundedTree,
    alternative: Alternative,
    fleet: Fleet,
    scene: Scene,
    control: Control,
    terms: Terms = NO_TERMS,
) -> Schedule:
    """A scheduler that knows no more than that a schedule takes half of its time."""
    found = greedy(tree, alternative, fleet, scene, control, terms)
    certificate = Certificate(claim="bounded", method="load", bound=found.makespan_s / 2)
    return replace(found, status="feasible", certificate=certificate)


def test_schedules_that_are_not_proven_shortest_prove_no_front() -> None:
    """Of three hands of 3, 3 and 2 s, two at a time, it is not known whether they could be through before 5 s: 4 s is the load."""
    tree = tasks(*(task(number, ("hand", 1.0, takes_s)) for number, takes_s in enumerate((3.0, 3.0, 2.0))))
    mission = brief()
    pair = tuple(replace(kind, count=2) if kind.id == "hand" else kind for kind in mission.fleet.types)
    front = front_of(tree, replace(mission, fleet=replace(mission.fleet, types=pair)), scheduler=loose)
    assert points(front) == [(3.0, 5.0)]
    assert (front.certificate.claim, front.options[0].certificate.claim) == ("unproven", "unproven")


def test_a_handful_keeps_both_ends_and_what_lies_nearest_to_equal_steps() -> None:
    """From 100 to 0 in three steps of 33: 60 is nearest to 66.7, 40 to 33.3; then 1 is left out, and 99."""
    assert handful([100, 99, 60, 40, 1, 0], 4) == [0, 2, 3, 5]
    assert handful([100, 99, 0], 7) == [0, 1, 2]
