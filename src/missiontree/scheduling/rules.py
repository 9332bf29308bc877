"""The rules by which runs decide, one after the other."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice, product

from missiontree.mission.alternative import Alternative
from missiontree.scheduling.problem import Crew, Problem, Rule

MAX_BINDINGS = 512
_CREWS: tuple[Crew, ...] = ("joint", "bundle", "none")


def rules(problem: Problem, alternative: Alternative, runs: int, seed: int) -> Iterator[Rule]:
    """
    Ways of deciding: the plain ones, allocation's witness, then variations; if all fail, fixed bindings.

    Where robots refill, each in two ways.
    """
    for rule in _rules(problem, alternative, runs, seed):
        yield rule
        if problem.chargers:
            yield replace(rule, refill="full")


def _rules(problem: Problem, alternative: Alternative, runs: int, seed: int) -> Iterator[Rule]:
    witness = {
        problem.staffing.group_of[one.role]: one.robot for one in alternative.witness if one.role in problem.graph.roles
    }
    # Who must take part gets one group of roles beforehand, so that no run leaves it out.
    asked = {
        min(group for group, one in witness.items() if one == robot): robot
        for robot in problem.required
        if robot in witness.values()
    }
    yield from (Rule(crew, binding=asked) for crew in ("joint", "bundle", "none"))
    if witness:
        yield from (Rule(crew, binding=witness) for crew in _CREWS)
    spread = max(1, problem.bounds.makespan // 4)
    far = max((problem.bounds.makespan, *problem.graph.deadline.values()))
    swing = far if problem.graph.deadline else spread
    patiences = (0, spread // 4, far) if problem.graph.deadline else (0, 0, spread // 16, spread // 4)
    yield from (
        Rule(crew, patience, binding=asked) for patience in (spread // 16, spread // 4, spread) for crew in _CREWS[:2]
    )
    if problem.graph.deadline:  # a robot that waits for what is due first
        yield from (Rule(crew, patience=far, binding=asked) for crew in _CREWS)
    rng = random.Random(seed)  # noqa: S311 - variation, not secrecy
    for number in range(runs):
        jitter = {activity: rng.randrange(swing) for activity in range(len(problem.graph.activities))}
        binding = witness if number % 4 == 3 else asked
        yield Rule(_CREWS[number % 3], rng.choice(patiences), jitter, binding)
    for binding in islice(_bindings(problem), MAX_BINDINGS):
        yield from (Rule(crew, binding=binding) for crew in _CREWS[:2])


def _bindings(problem: Problem) -> Iterator[dict[int, str]]:
    """Every way of giving the groups of roles a robot, up to the first few types' interchangeable ones."""
    groups = sorted(problem.staffing.members)
    if len(groups) > 16:
        return
    members = {kind.id: [robot.id for robot in kind.members] for kind in problem.fleet.types}
    for names in members.values():
        names.sort(key=lambda name: name not in problem.required)
    robots = [members[problem.staffing.type_of[group]][: len(groups)] for group in groups]
    for chosen in product(*robots):
        yield dict(zip(groups, chosen, strict=True))
