"""Small missions of coalitions, drawn by chance, and the least makespan of each by trying everything."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, permutations, product
from random import Random

from missiontree.mission.coalitions import CoalitionMission, CoalitionTask


def drawn(seed: int, tasks: int = 4) -> CoalitionMission:
    """Up to three robots and three skills."""
    luck = Random(seed)  # noqa: S311 - luck for tests, not for secrets
    robots, skills = luck.randint(1, 3), luck.randint(1, 3)
    pairs = [(one, other) for one in range(tasks) for other in range(one + 1, tasks) if luck.random() < 0.2]
    return CoalitionMission(
        skills=tuple(tuple(skill for skill in range(skills) if luck.random() < 0.7) for _ in range(robots)),
        tasks=tuple(
            CoalitionTask(
                needs=tuple(skill for skill in range(skills) if luck.random() < 0.5),
                duration_s=luck.randint(0, 9),
                x_m=luck.randint(0, 9),
                y_m=luck.randint(0, 9),
            )
            for _ in range(tasks)
        ),
        start=(0.0, 0.0),
        end=(luck.randint(0, 9), 9.0),
        precedence=tuple(pairs),
    )


def least_makespan(mission: CoalitionMission) -> int | None:
    """In ticks: every coalition that covers, spare robots included, and every order of tasks; None if a task has no coalition."""
    robots = range(len(mission.skills))
    able: list[list[Sequence[int]]] = []
    for task in mission.tasks:
        every = (members for size in robots for members in combinations(robots, size + 1))
        able.append([m for m in every if set(task.needs) <= {skill for robot in m for skill in mission.skills[robot]}])
    best: int | None = None
    for order in permutations(range(len(mission.tasks))):
        if any(order.index(before) > order.index(after) for before, after in mission.precedence):
            continue
        for teams in product(*able):
            makespan = _in_turn(mission, order, teams)
            if best is None or makespan < best:
                best = makespan
    return best


def _in_turn(mission: CoalitionMission, order: Sequence[int], teams: Sequence[Sequence[int]]) -> int:
    start, end = len(mission.tasks), len(mission.tasks) + 1
    place, free = [start] * len(mission.skills), [0] * len(mission.skills)
    over: dict[int, int] = {}
    for task in order:
        began = max([over[before] for before, after in mission.precedence if after == task], default=0)
        for robot in teams[task]:
            began = max(began, free[robot] + mission.travel[place[robot]][task])
        over[task] = began + mission.lengths[task]
        for robot in teams[task]:
            place[robot], free[robot] = task, over[task]
    return max(free[robot] + mission.travel[place[robot]][end] for robot in range(len(free)))
