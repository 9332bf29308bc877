"""
Does a damaged plan pass? Sound plans with some sixty kinds of damage, through both checkers apart.

::

    python -m benchmarks.damaged_plans --count 63000 --seed 1 --state damaged.json

Sound plans are made of random missions over every kind of map, half of them under rules for the whole mission, and half of them with a
front and a choice. In each way they are
damaged one after the other, at up to eight places of each plan, no two alike. A plan whose inputs were changed is given their digests, so
that it is the rule that must tell, not the fingerprint.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cache, lru_cache
from itertools import count, islice

from benchmarks.campaign import Campaign, Verdict, run
from benchmarks.plan_damages import WAYS, Way, with_its_digests
from missiontree.checking.case import Case, Rule
from missiontree.checking.checker import RULES
from missiontree.mission.plan import Plan
from missiontree.rechecking import recheck
from tests.checking.missions import random_mission, ruled_mission
from tests.checking.plans import PLANS, made

EACH = 1000
EIGHT = 8
MOST = 100
MANY = 10_000_000
PASSED_FIRST = "passed by the first checker"
PASSED_SECOND = "passed by the second checker"


def breaks(plan: Plan, rules: Iterable[Rule] = RULES) -> set[str]:
    """Rules that the first checker finds broken, without the second's opinion."""
    case = Case(plan)
    return {rule.__name__ for rule in rules if next(iter(rule(case)), None) is not None}


@lru_cache(maxsize=2000)
def base(seed: int, number: int) -> Plan | None:
    """A sound plan of that number, all of whose alternatives are scheduled; None if the mission of that number gives none."""
    if number < len(PLANS):
        return list(PLANS.values())[number]()
    tree, brief = (ruled_mission if number % 2 else random_mission)(seed * MANY + number)
    weighed = number % 8 < 2  # a quarter of all plans have a front and a choice, which take long to make
    plan = made(tree, replace(brief, objective="makespan") if weighed else brief, front=weighed)
    works = plan.schedules and all(one.status in {"optimal", "feasible"} for one in plan.schedules)
    return plan if plan.outcome == "delivered" and works else None


def places(way: Way, plan: Plan) -> list[int]:
    """Where the plan can be damaged in a way: up to eight places, spread over the first hundred, at which the damage differs."""
    damaged: list[Plan] = []
    try:
        for one in islice(way.damage(plan), MOST):
            damaged.append(one)
    except ValueError:
        pass  # the damage at the next place would make something that is no plan, such as an action that ends before it starts
    kept: list[int] = []
    for place in range(0, len(damaged), -(-len(damaged) // EIGHT) or 1):
        if all(damaged[place] != damaged[other] for other in kept):
            kept.append(place)
    return kept


@cache
def found(way: Way, seed: int) -> tuple[list[tuple[int, int]], Iterator[int]]:
    """Places of a way found so far, each a plan's number and a place in it, and the numbers of the plans not yet looked at."""
    return [], count()


def damaged_plan(way: Way, seed: int, number: int) -> Plan:
    """The plan of that number among those that are damaged in a way."""
    known, ahead = found(way, seed)
    while len(known) <= number:
        one = next(ahead)
        plan = base(seed, one)
        known.extend((one, place) for place in (places(way, plan) if plan is not None else ()))
    one, place = known[number]
    plan = base(seed, one)
    assert plan is not None
    return next(islice(way.damage(plan), place, None))


def judge(seed: int, index: int) -> Verdict:
    """One damaged plan before both checkers."""
    way = WAYS[index % len(WAYS)]
    damaged = damaged_plan(way, seed, index // len(WAYS))
    # Its own rule is asked first: where that tells, the others need not be asked.
    first = breaks(damaged, [rule for rule in RULES if rule.__name__ == way.rule]) or breaks(with_its_digests(damaged))
    second = {one.rule for one in recheck(damaged)}
    violations = []
    if not first:
        violations.append((PASSED_FIRST, way.name))
    if not second:
        violations.append((PASSED_SECOND, way.name))
    counts = {
        "first refuses": bool(first),
        "by its rule": way.rule in first,
        "second refuses": bool(second),
        "by its core rule": way.core_rule in second,
    }
    return Verdict(way.name, {name: int(count) for name, count in counts.items()}, tuple(violations))


CAMPAIGN = Campaign(
    name="damaged plans",
    about=__doc__,
    count=EACH * len(WAYS),
    judge=judge,
    never=(PASSED_FIRST, PASSED_SECOND),
    unit="damaged plans",
)


if __name__ == "__main__":
    run(CAMPAIGN)
