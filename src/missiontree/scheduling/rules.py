"""The rules by which runs decide, one after the other."""

from __future__ import annotations

import random
from collections.abc import Iterator
from itertools import islice, product

from missiontree.mission.alternative import Alternative
from missiontree.scheduling.problem import Crew, Problem, Rule

MAX_BINDINGS = 512
_CREWS: tuple[Crew, ...] = ("joint", "bundle", "none")


def rules(problem: Problem, alternative: Alternative, runs: int, seed: int) -> Iterator[Rule]:
    """Ways of deciding: the plain ones, allocation's witness, then variations; if all fail, fixed bindings."""
    witness = {
        problem.staffing.group_of[one.role]: one.robot for one in alternative.witness if one.role in problem.graph.roles
    }
    yield Rule("joint")
    yield Rule("bundle")
    yield Rule("none")
    if witness:
        yield from (Rule(crew, binding=witness) for crew in _CREWS)
    spread = max(1, problem.bounds.makespan // 4)
    yield from (Rule(crew, patience) for patience in (spread // 16, spread // 4, spread) for crew in _CREWS[:2])
    rng = random.Random(seed)  # noqa: S311 - variation, not secrecy
    for number in range(runs):
        jitter = {activity: rng.randrange(spread) for activity in range(len(problem.graph.activities))}
        binding = witness if number % 4 == 3 else {}
        yield Rule(_CREWS[number % 3], rng.choice((0, 0, spread // 16, spread // 4)), jitter, binding)
    for binding in islice(_bindings(problem), MAX_BINDINGS):
        yield from (Rule(crew, binding=binding) for crew in _CREWS[:2])


def _bindings(problem: Problem) -> Iterator[dict[int, str]]:
    """Every way of giving the groups of roles a robot, up to the first few types' interchangeable ones."""
    groups = sorted(problem.staffing.members)
    if len(groups) > 16:
        return
    robots = [
        [robot.id for robot in problem.fleet.by_id[problem.staffing.type_of[group]].members[: len(groups)]]
        for group in groups
    ]
    for chosen in product(*robots):
        yield dict(zip(groups, chosen, strict=True))
