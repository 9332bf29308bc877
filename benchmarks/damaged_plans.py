"""
Does a damaged plan pass? Sound plans with some sixty kinds of damage, through both checkers apart.

::

    python -m benchmarks.damaged_plans --count 58000 --seed 1 --state damaged.json

Sound plans are made of random missions over every kind of map, half of them under rules for the whole mission, and damaged in turn in
every way, at a place that is drawn. Digests are made anew, so that it is the rule that must tell, not the fingerprint.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from itertools import islice
from random import Random

from benchmarks.campaign import Campaign, Verdict, luck, run
from benchmarks.plan_damages import WAYS, Way, with_its_digests
from missiontree.checking.case import Case, Rule
from missiontree.checking.checker import RULES
from missiontree.mission.plan import Plan
from missiontree.rechecking import recheck
from tests.checking.missions import random_mission, ruled_mission
from tests.checking.plans import PLANS, made

EACH = 1000
BASES = 400
PLACES = 60
PASSED_FIRST = "passed by the first checker"
PASSED_SECOND = "passed by the second checker"


def breaks(plan: Plan, rules: Iterable[Rule] = RULES) -> set[str]:
    """Rules that the first checker finds broken, without the second's opinion."""
    case = Case(plan)
    return {rule.__name__ for rule in rules if next(iter(rule(case)), None) is not None}


@cache
def base(number: int) -> Plan | None:
    """A sound plan of that number, all of whose alternatives are scheduled; None if the mission of that number gives none."""
    if number < len(PLANS):
        return list(PLANS.values())[number]()
    plan = made(*(ruled_mission if number % 2 else random_mission)(number))
    works = plan.schedules and all(one.status in {"optimal", "feasible"} for one in plan.schedules)
    return plan if plan.outcome == "delivered" and works else None


@cache
def places(way: Way, number: int) -> int:
    """At how many places the plan of that number can be damaged in a way, as far as it is counted."""
    plan, found = base(number), 0
    try:
        for _ in islice(way.damage(plan), PLACES) if plan is not None else ():
            found += 1
    except ValueError:
        pass  # the damage at the next place would make something that is no plan, such as an action that ends before it starts
    return found


def drawn(way: Way, rng: Random) -> Plan:
    """A plan damaged in a way, drawn."""
    while True:
        number = rng.randrange(BASES)
        plan, found = base(number), places(way, number)
        if plan is not None and found:
            return next(islice(way.damage(plan), rng.randrange(found), None))


def judge(seed: int, index: int) -> Verdict:
    """One damaged plan before both checkers."""
    way = WAYS[index % len(WAYS)]
    damaged = drawn(way, luck(seed, index))
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
