"""The tabu search: moves never break an order, both speeds do the same, and known optima are reached."""

from __future__ import annotations

from random import Random

from missiontree.checking.columns import check_tree
from missiontree.formats.importers.fjsp import shop_of
from missiontree.mission.certificate import Certificate
from missiontree.mission.columns import TreeColumns
from missiontree.mission.tree_schedule import TreeSchedule
from missiontree.scheduling.joint.compiled import PLAIN, Engine, fast_engine
from missiontree.scheduling.joint.listing import Aim, Listed, leaves_below, listed
from missiontree.scheduling.joint.paths import paths_of
from missiontree.scheduling.joint.problem import JointProblem, problem_of
from missiontree.scheduling.joint.shops import Workshop, workshop_of


def shop(seed: int, jobs: int = 4, machines: int = 3) -> TreeColumns:
    """A job shop drawn by chance."""
    luck = Random(seed)  # noqa: S311 - luck for tests, not for secrets
    lines = [f"{jobs} {machines}"]
    for _ in range(jobs):
        words = [luck.randint(1, 4)]
        for _ in range(words[0]):
            able = luck.sample(range(machines), luck.randint(1, machines))
            words += [len(able)]
            for machine in able:
                words += [machine, luck.randint(1, 9)]
        lines.append(" ".join(map(str, words)))
    return shop_of("\n".join(lines))


def started(tree: TreeColumns, engine: Engine) -> tuple[JointProblem, Workshop]:
    problem = problem_of(tree)
    paths = paths_of(problem)
    aim = Aim(0, [1.0] * len(problem.count), leaves_below(problem))
    first = listed(problem, paths, [-rest for rest in paths.rest], aim)
    return problem, workshop_of(problem, first, engine, 3, closed=lambda leaf: False)


def faults(tree: TreeColumns, found: Listed) -> tuple[object, ...]:
    certificate = Certificate(claim="bounded", method="load", bound=0.0)
    return check_tree(
        tree, TreeSchedule("feasible", certificate, found.chosen, found.start, found.robot, found.makespan)
    )


def test_the_best_is_a_schedule_and_never_longer_than_the_first() -> None:
    for seed in range(20):
        tree = shop(seed)
        _, workshop = started(tree, PLAIN)
        before = workshop.best().makespan
        workshop.engine.improve(workshop.shop, workshop.state, 200, 0)
        after = workshop.best()
        assert after.makespan <= before
        assert faults(tree, after) == ()


def test_compiled_and_plain_make_the_same_moves() -> None:
    for seed in range(5):
        tree = shop(seed, jobs=6, machines=4)
        ends = []
        for engine in (PLAIN, fast_engine()):
            _, workshop = started(tree, engine)
            engine.improve(workshop.shop, workshop.state, 300, 0)
            ends.append((list(map(int, workshop.state.best_way)), list(map(int, workshop.state.numbers))))
        assert ends[0] == ends[1]


def test_a_shop_that_needs_other_machines_and_another_order_is_put_right() -> None:
    """Two jobs of two operations on two machines, each 2 s on either: all four can be done in 4 s, as no machine has to wait."""
    tree = shop_of("2 2\n2 2 0 2 1 2 2 0 2 1 2\n2 2 0 2 1 2 2 0 2 1 2")
    _, workshop = started(tree, PLAIN)
    workshop.engine.improve(workshop.shop, workshop.state, 500, 4)
    assert workshop.best().makespan == 4
