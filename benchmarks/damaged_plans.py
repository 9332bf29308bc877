"""
Does a damaged plan pass? Sound plans, damaged in each of the ways of :mod:`benchmarks.plan_damages`, through both checkers apart.

::

    python -m benchmarks.damaged_plans --seed 1 --state damaged.json

Sound plans are made of random missions of four kinds: over every kind of map; under rules for the whole mission; with what is rare, such
as chargers, ways home, hand-overs and lifts with room for one; and such that only a part can be done. They come in blocks of a hundred,
and of every block ten damaged plans are asked for in each way: at most two of one plan, no two alike, at places drawn by lot. A way that
a block has fewer places for is told of, and costs no further search. A plan whose inputs were changed is given their digests, so that it
is the rule that must tell, not the fingerprint.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import islice
from math import ceil
from random import Random

from benchmarks.campaign import Campaign, Rows, Verdict, luck, run
from benchmarks.plan_damages import WAYS, Way, with_its_digests
from missiontree.checking.case import Case, Rule
from missiontree.checking.checker import RULES
from missiontree.errors import InternalError
from missiontree.mission.plan import Plan
from missiontree.rechecking import recheck
from tests.checking.driven_missions import crowded_mission, driven_mission, part_mission
from tests.checking.few_runs import few_runs
from tests.checking.missions import random_mission, ruled_mission
from tests.checking.plans import PLANS, made, part_made

EACH = 1000
PER_BLOCK = 10  # of each way
PER_PLAN = 2  # of each way
BLOCK = 100  # plans
SPARE = 1.2  # blocks, of those that would do if each had a place for all
BLOCKS = ceil(SPARE * EACH / PER_BLOCK)
MOST = 100  # places of a plan that are looked at
MANY = 10_000_000
ASKED, FOUND = "asked for", "damaged plans"
PASSED_FIRST = "passed by the first checker"
PASSED_SECOND = "passed by the second checker"


def breaks(plan: Plan, rules: Iterable[Rule] = RULES) -> set[str]:
    """Rules that the first checker finds broken, without the second's opinion."""
    case = Case(plan)
    return {rule.__name__ for rule in rules if next(iter(rule(case)), None) is not None}


def base(seed: int, number: int) -> Plan | None:
    """A sound plan of that number, all of whose alternatives are scheduled; None if the mission of that number gives none."""
    if number < len(PLANS):
        return list(PLANS.values())[number]()
    plan = _made(number % 8, seed * MANY + number)
    works = plan is not None and plan.schedules and all(one.status in {"optimal", "feasible"} for one in plan.schedules)
    return plan if works else None


def _made(kind: int, seed: int) -> Plan | None:
    """The first two of eight kinds have a front and a choice, which take long to make."""
    if kind < 4:
        tree, brief = (ruled_mission if kind % 2 else random_mission)(seed)
        return made(tree, replace(brief, objective="makespan") if kind < 2 else brief, front=kind < 2)
    if kind < 7:
        return made(*(crowded_mission if kind == 6 else driven_mission)(seed), k=2, scheduler=few_runs)
    return part_made(*part_mission(seed))


def places(way: Way, plan: Plan, rng: Random, most: int = PER_PLAN) -> list[Plan]:
    """The plan damaged in a way at some places of the first hundred, such that the damage differs."""
    damaged: list[Plan] = []
    try:
        for one in islice(way.damage(plan), MOST):
            damaged.append(one)
    except ValueError:
        pass  # the damage at the next place would make something that is no plan, such as an action that ends before it starts
    kept: list[Plan] = []
    for one in rng.sample(damaged, len(damaged)):
        if len(kept) == most:
            break
        if one not in kept:
            kept.append(one)
    return kept


class Block:
    """
    A hundred plans, damaged in all ways, one plan after the other until each way has what is asked for.

    Parameters
    ----------
    seed, number
        Seed of the campaign and number of the block.
    """

    def __init__(self, seed: int, number: int) -> None:
        self._seed = seed
        self._ahead = iter(range(number * BLOCK, (number + 1) * BLOCK))
        self._found: dict[str, list[Plan]] = {way.name: [] for way in WAYS}

    def damaged(self, way: Way, number: int) -> Plan | None:
        """The damaged plan of that number in a way; None if the block has not so many."""
        found = self._found[way.name]
        while len(found) <= number:
            one = next(self._ahead, None)
            if one is None:
                return None
            self._look(one)
        return found[number]

    def _look(self, number: int) -> None:
        plan = base(self._seed, number)
        if plan is None:
            return
        if refused := breaks(plan) | {one.rule for one in recheck(plan)}:
            raise InternalError(f"plan {number} is refused before it is damaged: {', '.join(sorted(refused))}")
        rng = luck(self._seed, number)
        for way in WAYS:
            found = self._found[way.name]
            if len(found) < PER_BLOCK:
                found += places(way, plan, rng, min(PER_PLAN, PER_BLOCK - len(found)))


@lru_cache(maxsize=1)
def block(seed: int, number: int) -> Block:
    """The block of that number; only the last is kept."""
    return Block(seed, number)


def judge(seed: int, index: int) -> Verdict:
    """One damaged plan before both checkers, if there is one of that number."""
    number, place = divmod(index, PER_BLOCK * len(WAYS))
    nth, which = divmod(place, len(WAYS))
    way = WAYS[which]
    damaged = block(seed, number).damaged(way, nth)
    if damaged is None:
        return Verdict(way.name)
    # Its own rule is asked first: where that tells, the others need not be asked.
    first = breaks(damaged, [rule for rule in RULES if rule.__name__ == way.rule]) or breaks(with_its_digests(damaged))
    second = {one.rule for one in recheck(damaged)}
    violations = []
    if not first:
        violations.append((PASSED_FIRST, way.name))
    if not second:
        violations.append((PASSED_SECOND, way.name))
    counts = {
        FOUND: True,
        "first refuses": bool(first),
        "by its rule": way.rule in first,
        "second refuses": bool(second),
        "by its core rule": way.core_rule in second,
    }
    return Verdict(way.name, {name: int(count) for name, count in counts.items()}, tuple(violations))


def short_of(rows: Rows) -> Mapping[str, object]:
    """How many damaged plans there are, and each way that has fewer than were asked for, and fewer than a thousand."""
    told: dict[str, object] = {"ways": len(WAYS), "damaged plans": sum(row.get(FOUND, 0) for row in rows.values())}
    for name, row in rows.items():
        if row.get(FOUND, 0) < min(EACH, row[ASKED]):
            told[f"of {name!r} found"] = f"{row.get(FOUND, 0)} of {min(EACH, row[ASKED])}"
    return told


CAMPAIGN = Campaign(
    name="damaged plans",
    about=__doc__,
    count=BLOCKS * PER_BLOCK * len(WAYS),
    judge=judge,
    never=(PASSED_FIRST, PASSED_SECOND),
    unit=ASKED,
    told=short_of,
    chunk=PER_BLOCK * len(WAYS),
)


if __name__ == "__main__":
    run(CAMPAIGN)
