"""The refill bound: numbers derived by hand, and against every order of jobs and visits of one robot."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import permutations, product
from random import Random
from typing import NamedTuple

import pytest

from benchmarks.campaign import luck
from benchmarks.schedule_cases import random_schedule_case
from missiontree.mission.charger import Charger
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.terms import Terms
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.bounds import Bounds
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.problem import Problem
from tests.scheduling.instances import Part, at, mission, scene, work
from tests.scheduling.test_recharging import JOB, PLUG, battery, planned

CASES = [index for index in range(300) if "chargers" in random_schedule_case(luck(9, index)).features]


def test_what_is_lacking_and_the_way_to_the_charger_count_as_work() -> None:
    """
    120 J for two jobs, 100 J held: 20 J are lacking, and 2 J for the one way of 2 m that a visit takes at least. 22 J at 10 J/s take
    2.2 s, the way 2 s, the jobs 20 s: none is shorter than 24.2 s (the way back is not counted, for p is where the robot starts).
    """
    made = mission([Part("a", "r", [JOB]), Part("b", "r", [JOB])])
    result = planned(made, battery())
    assert (result.makespan_s, result.status) == (26.4, "feasible")
    assert (result.certificate.method, result.certificate.bound) == ("refill_load", 24.2)


def test_a_charger_at_the_place_of_work_makes_the_bound_tight() -> None:
    """Nobody has to go there: 20 J in 2 s between two jobs of 10 s, and 22 s are proven to be the least."""
    made = mission([Part("a", "r", [JOB]), Part("b", "r", [JOB])])
    result = planned(made, battery(), chargers=(replace(PLUG, position=at(0)),))
    assert (result.makespan_s, result.status) == (22, "optimal")
    assert (result.certificate.claim, result.certificate.method) == ("proven", "refill_load")


def test_a_charger_has_room_for_so_many() -> None:
    """
    Four jobs of 60 J, two robots of 100 J: 40 J are lacking and 2 J for a way. At 1 J/s for one robot at a time that is 42 s, not before
    the 2 s to the charger, and 10 s of some job follow: 54 s. With room for two, 21 s: then the robots have more to do, 40 s of jobs
    and 44 s for the charger and the way, 42 s each.
    """
    made = mission([Part(name, "r", [JOB]) for name in "abcd"])
    slow = replace(PLUG, rate_per_s=1)
    assert planned(made, battery(2), chargers=(slow,)).certificate.bound == 54
    assert planned(made, battery(2), chargers=(replace(slow, capacity=2),)).certificate.bound == 42


def test_each_visit_gives_a_full_store_at_most() -> None:
    """
    Five jobs of 90 J and 100 J held: 350 J. A way to the charger takes 2 J, so a visit brings 98 J at most and four are needed:
    358 J in 35.8 s, four ways of 2 s, and 50 s of jobs are 93.8 s.
    """
    job = work(10, at="p", uses={"energy_j": 90.0})
    made = mission([Part(name, "r", [job]) for name in "abcde"])
    result = planned(made, battery())
    assert result.certificate.bound == 93.8
    assert result.makespan_s >= 93.8


def test_a_robot_that_takes_no_part_lends_its_level_to_nobody() -> None:
    """Of two robots one may be in use: the fuller one, of 100 J. The other's 100 J do not count."""
    made = mission([Part("a", "r", [JOB]), Part("b", "r", [JOB])])
    kind = battery(
        robots=(
            Robot(id="x", position=at(0), remaining={"energy_j": 50.0}),
            Robot(id="y", position=at(0), remaining={"energy_j": 100.0}),
        ),
        max_in_use=1,
    )
    assert planned(made, kind).certificate.bound == 24.2


def test_levels_that_last_leave_the_other_bounds_alone() -> None:
    made = mission([Part("a", "r", [JOB])])
    assert planned(made, battery()).certificate.method == "critical_path"


class Job(NamedTuple):
    """What one robot is to do: where on the x axis, for how long, and what it uses."""

    x: int
    seconds: int
    joules: int


def least_of(jobs: list[Job], plug: float, rate: int, full: int) -> float | None:
    """
    The least makespan of a robot that starts full at 0, 1 m/s and 1 J/m: every order, and every set of gaps for a visit.

    At each visit it takes in what lasts until the next one, or until the end: any less does not last, and any more only takes longer.
    """
    best: float | None = None
    for order in permutations(jobs):
        for visiting in product((False, True), repeat=len(jobs)):
            took = _lasting(order, visiting, plug, rate, full)
            if took is not None and (best is None or took < best):
                best = took
    return best


def _lasting(order: tuple[Job, ...], visiting: tuple[bool, ...], plug: float, rate: int, full: int) -> float | None:
    stretches: list[tuple[float, float]] = []  # metres and other joules between visits
    here, metres, joules, seconds = 0.0, 0.0, 0.0, 0.0
    for job, visits in zip(order, visiting, strict=True):
        if visits:
            stretches.append((metres + abs(plug - here), joules))
            here, metres, joules = plug, 0.0, 0.0
        metres, joules, seconds = metres + abs(job.x - here), joules + job.joules, seconds + job.seconds
        here = job.x
    stretches.append((metres, joules))
    level, taken = float(full), 0.0
    for number, (way, used) in enumerate(stretches):
        if number:
            more = max(0.0, way + used - level)
            level, taken = level + more, taken + more
        if level > full or way + used > level:
            return None
        level -= way + used
    return seconds + sum(way for way, _ in stretches) + math.ceil(1000 * taken / rate - 1e-6) / 1000


@pytest.mark.parametrize("seed", range(60))
def test_the_bound_is_never_above_the_best_of_all_orders_and_visits(seed: int) -> None:
    """One robot, up to four jobs on a line, one charger that may be anywhere: at a job's place too, or where the robot starts."""
    draw = Random(f"refilling {seed}")  # noqa: S311 - luck for tests, not for secrets
    jobs = [Job(draw.randint(-6, 6), draw.randint(1, 5), draw.randint(5, 40)) for _ in range(draw.randint(2, 4))]
    plug, rate, full = draw.choice([0, draw.randint(-6, 6), jobs[0].x]), draw.choice([1, 5, 10]), draw.randint(45, 70)
    least = least_of(jobs, plug, rate, full)
    made = mission(
        [
            Part(f"p{n}", "r", [work(job.seconds, at=f"x{n}", uses={"energy_j": float(job.joules)})])
            for n, job in enumerate(jobs)
        ]
    )
    charger = Charger(id="plug", position=at(plug), rate_per_s=rate)
    world = replace(scene(None, **{f"x{n}": float(job.x) for n, job in enumerate(jobs)}), chargers=(charger,))
    fleet, terms = Fleet((battery(limits={"energy_j": float(full)}),)), Terms(chargers=(charger,))
    problem = read_problem(made.tree, made.alternative, fleet, world, terms)
    if not isinstance(problem, Problem):
        assert least is None
        return
    result = SCHEDULERS["cpsat"](made.tree, made.alternative, fleet, world, Control(), terms)
    if least is None:
        assert result.status == "unknown"
        return
    assert problem.bounds.makespan <= round(1000 * least)
    if result.status in {"optimal", "feasible"}:
        assert result.makespan_s >= least - 1e-6
    if result.status == "optimal":
        assert result.makespan_s == pytest.approx(least)


@pytest.mark.parametrize("index", CASES[:30])
def test_no_engine_finds_anything_below_the_bound(index: int) -> None:
    """Random missions with every rule, chargers among them."""
    case = random_schedule_case(luck(9, index))
    problem = read_problem(case.tree, case.alternative, case.fleet, case.scene, case.terms)
    if not isinstance(problem, Problem):
        return
    assert isinstance(problem.bounds, Bounds)
    for name in ("greedy", "auto"):
        found = SCHEDULERS[name](case.tree, case.alternative, case.fleet, case.scene, Control(), case.terms)
        assert found.status not in {"optimal", "feasible"} or found.makespan_s * 1000 >= problem.bounds.makespan - 1e-3
