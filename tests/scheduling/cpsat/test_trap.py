"""
Wrong answers that the solver's version 9.15 calls optimal, in the forms in which missiontree asks.

The trap is optional intervals of several robots that share one start and one end: four tasks whose least makespan is 7 are certified at 10.
The others have no optional interval at all, are random missions with tours, and depend on one parameter each.
"""

from __future__ import annotations

from itertools import product

from benchmarks.campaign import luck
from benchmarks.schedule_cases import random_schedule_case
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.scene import Scene
from missiontree.mission.terms import NO_TERMS
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.cpsat.formulation import Formulation
from missiontree.scheduling.cpsat.model import Affine, ExactlyOne, Interval, Model, NoOverlap
from missiontree.scheduling.cpsat.search import Effort, search
from missiontree.scheduling.cpsat.verify import broken
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.problem import Problem
from tests.scheduling.instances import Part, mission, move, robots, scene, work

DURATIONS = [[4, 3, 4], [1, 9, 6], [4, 7, 8], [5, 3, 2]]
ABLE = [[1, 1, 1], [1, 1, 0], [1, 0, 1], [1, 0, 1]]
BEFORE = [(1, 3), (2, 3)]
LEAST = 7  # t0 on r1 0-3, t1 on r0 0-1, t2 on r0 1-5, t3 on r2 5-7


def test_the_trap_over_all_choices_of_robots_comes_to_seven() -> None:
    """Each task by each robot able to do it, a mission per choice: the shortest of all takes 7 s."""
    found = []
    for chosen in product(*([r for r in range(3) if able[r]] for able in ABLE)):
        parts = [Part(f"t{t}", f"r{r}", [work(DURATIONS[t][r])]) for t, r in enumerate(chosen)]
        made = mission(parts, [(f"t{a}", f"t{b}") for a, b in BEFORE])
        fleet = Fleet(tuple(robots(f"r{r}") for r in range(3)))
        result = SCHEDULERS["cpsat"](made.tree, made.alternative, fleet, Scene(), Control())
        assert result.status == "optimal"
        found.append(result.makespan_s)
    assert min(found) == LEAST


def trap() -> Model:
    """The trap as one model, in the safe form: intervals of fixed size on the shared start, whose end the literal enforces."""
    model, far = Model(), 40
    start = [Affine(model.integer(0, far)) for _ in DURATIONS]
    end = [Affine(model.integer(0, far)) for _ in DURATIONS]
    by_robot: list[list[int]] = [[], [], []]
    for task, able in enumerate(ABLE):
        literals = []
        for robot in (robot for robot in range(3) if able[robot]):
            takes, literal = DURATIONS[task][robot], model.boolean()
            literals.append(literal)
            by_robot[robot].append(
                model.add(Interval(start[task], Affine(None, takes), start[task] + takes, (literal,)))
            )
            model.at_least(end[task], start[task], takes, (literal,))
            model.at_least(start[task], end[task], -takes, (literal,))
        model.add(ExactlyOne(tuple(literals)))
    for intervals in by_robot:
        model.add(NoOverlap(tuple(intervals)))
    for first, second in BEFORE:
        model.at_least(start[second], end[first])
    makespan = model.integer(0, far)
    for one in end:
        model.at_least(Affine(makespan), one)
    model.objective = ((1, makespan),)
    return model


def test_the_trap_as_one_model_comes_to_seven_whatever_the_seed() -> None:
    for seed in range(5):
        found = search(trap(), 60, lambda: False, Effort(seed))
        assert (found.verdict, found.objective) == ("optimal", LEAST)
        assert not list(broken(trap(), found.values))


def test_a_mission_with_tours_that_was_called_optimal_too_late() -> None:
    """
    Two robots of unknown speed: moves take their nominal time, other ways none.

    One brings the cat to p (0-3) and works at a lost place (3-8); the other works at the cat (3-5). From 8 both work jointly for 5 s,
    after which the second has 2 s left: 15 s. With the propagator on, 17 s is called optimal, and 15 s found as soon as it is asked for.
    """
    parts = [
        Part("R0", "a", [move("p", "cat", nominal_s=3), work(5, at="lost", uses={"e": 1})]),
        Part("R1", "a", [work(2, at="cat"), work(5, at="r", sync=0), work(2, uses={"e": 2.5})], team=0),
        Part("R2", "a", [work(5, at="p", sync=0, uses={"e": 1})], team=0),
    ]
    pair = (Robot(id="a0", remaining={"e": 17.0}), Robot(id="a1", remaining={"e": 36.0}))
    fleet = Fleet((robots("a", uses_per_m={"e": 1.0}, limits={"e": 26.0}, robots=pair),))
    made = mission(parts)
    problem = read_problem(made.tree, made.alternative, fleet, scene(p=0, r=7, lost=None, cat=5), NO_TERMS)
    assert isinstance(problem, Problem)
    found = search(Formulation(problem, 20_000).model, 60, lambda: False)
    assert (found.verdict, found.objective) == ("optimal", 15_000)


def test_a_mission_that_presolve_cut_the_best_answer_from() -> None:
    """
    One robot whose start is unknown does all; a cat at 5 that it brings to p, at 0, and then to r, at 7, at 0.5 m/s. It goes 2 m/s alone.

    Work at the cat (0-5), at r, 2 m off (6-11), and at the cat again (12-17 and 17-22); the cat to p takes 10 s (22-32), then 2 s of work
    at the box, 2 m off (33-35), the cat to r 10 s (35-45), and 3 s anywhere: 48 s. With the whole of presolve, 53 s is called optimal.
    """
    case = random_schedule_case(luck(47, 36_753))
    problem = read_problem(case.tree, case.alternative, case.fleet, case.scene, case.terms)
    assert isinstance(problem, Problem)
    found = search(Formulation(problem, 75_500).model, 60, lambda: False)
    assert (found.verdict, found.objective) == ("optimal", 48_000)
