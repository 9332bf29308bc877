"""
Do mean, least and different teams come out right? Random trees with fleets, the exact search against all alternatives written out.

::

    python -m benchmarks.aim_agreement --count 2000 --seed 1

Each tree is ranked for every aim but the plain one, by the search as it ships and by ones that are cut short or made to prove by bounds.
A *mismatch* is a list that is not what it should be; a *false proof* is a claim (status, certificate, bound) that the list of all
alternatives refutes.
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import product
from random import Random
from typing import NamedTuple

from benchmarks.random_rules import RULES, TREE_RULES
from benchmarks.random_trees import Case, random_case
from missiontree.allocation.aimed import reaching
from missiontree.allocation.allocator import Allocator
from missiontree.allocation.enumerated import Enumerated
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.kbest import ExactKBest
from missiontree.errors import InputError
from missiontree.mission.aim import PLAIN_AIM, Accumulate, Aim
from missiontree.mission.alternative import Alternative, Ranking, selected_leaves
from missiontree.mission.control import Control

EVERYTHING = 10**9
EVERY_RULE = (*RULES, *TREE_RULES)
HOWS: tuple[Accumulate, ...] = ("sum", "mean", "min")
AIMS = tuple(
    aim for how, diverse in product(HOWS, (False, True)) if (aim := Aim(accumulate=how, diverse=diverse)) != PLAIN_AIM
)
Fault = tuple[str, str]


class Truth(NamedTuple):
    """
    All alternatives of a case, and what they are worth.

    Parameters
    ----------
    ranked
        Best first by exact worth, then by choice indices, with their rounded worth.
    all
        The same before teams seen above were left out.
    """

    ranked: list[Alternative]
    all: list[Alternative]


def main() -> None:
    """Compare, and print a table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=2000, help="trees (default 2000)")
    parser.add_argument("--seed", type=int, default=1, help="seed (default 1)")
    given = parser.parse_args()
    began, counts, faults = time.perf_counter(), Counter[str](), list[str]()
    for index in range(given.count):
        case = numbered_case(given.seed, index)
        for aim in AIMS:
            counts["lists"] += 1
            faults += [
                f"{index}, {aim.in_words}: {kind}: {message}" for kind, message in judge(case, aim, 1 + index % 10)
            ]
    print(f"{given.count} trees, {counts['lists']} lists, {len(faults)} faults, {time.perf_counter() - began:.0f} s")
    print("\n".join(faults[:20]))
    if faults:
        raise SystemExit(1)


def numbered_case(seed: int, index: int) -> Case:
    """The case of that number; every second one is under one rule for the whole mission, each rule in its turn."""
    rng = Random(f"aims:{seed}:{index}")  # noqa: S311 - luck for tests, not for secrets
    return random_case(rng, (EVERY_RULE[index // 2 % len(EVERY_RULE)],) if index % 2 else None)


def judge(case: Case, aim: Aim, k: int, chosen: Iterable[tuple[str, Allocator]] | None = None) -> Iterator[Fault]:
    """What is wrong with lists for an aim, by some searches; by default, by all of :func:`searches`."""
    flat = case.flat
    truth = truth_of(case, aim)
    for name, by_sum in searches(k) if chosen is None else chosen:
        try:
            result = reaching(aim, by_sum)(flat, case.fleet, case.weights, k, Control())
        except InputError:
            return  # too many ways of doing nothing
        if name.startswith("whole"):
            expected = _entries(truth.ranked[:k])
            if _entries(result.alternatives) != expected:
                yield "mismatch", f"{name} lists {_entries(result.alternatives)}, not {expected}"
            if result.status != ("exact" if expected else "infeasible"):
                yield "mismatch", f"{name} says {result.status}"
        yield from false_claims(name, aim, result, truth, k)


def searches(k: int) -> Iterator[tuple[str, Allocator]]:
    """The search as it ships, one that proves by bounds, and ones that end early."""
    few = k % 5
    yield "whole", ExactKBest()
    yield "whole by bounds", ExactKBest(patience=0)
    yield "few candidates", ExactKBest(max_examined=few)
    yield "few steps", ExactKBest(packing_steps=few)
    yield "few nodes", ExactKBest(patience=0, max_nodes=(few, few))


def truth_of(case: Case, aim: Aim) -> Truth:
    """Everything, by enumeration, sorted here by fractions of its own making."""
    all_of = Enumerated(Aim(accumulate=aim.accumulate), Exhaustive(EVERYTHING, EVERYTHING))
    ranked = list(all_of(case.flat, case.fleet, case.weights, EVERYTHING, Control()).alternatives)
    children = case.tree.children

    def order(one: Alternative) -> tuple[Fraction, list[int]]:
        places = [children[choice.xor].index(choice.child) for choice in one.choices]
        return -worth(case, aim.accumulate, one), places

    ranked.sort(key=order)
    firsts: dict[frozenset[str], Alternative] = {}
    for one in ranked:
        firsts.setdefault(team(one), one)
    return Truth(list(firsts.values()) if aim.diverse else ranked, ranked)


def worth(case: Case, accumulate: Accumulate, one: Alternative) -> Fraction:
    """What an alternative is worth, in millionths, read off the tree."""
    leaves = selected_leaves(case.tree, one.choices)
    utilities = [case.weights.utility_micro(case.tree.action(leaf).estimate) for leaf in leaves] or [0]
    if accumulate == "min":
        return Fraction(min(utilities))
    return Fraction(sum(utilities), len(utilities) if accumulate == "mean" else 1)


def team(one: Alternative) -> frozenset[str]:
    """The robot types that take part."""
    return frozenset(filled.robot_type for filled in one.roles)


def false_claims(name: str, aim: Aim, result: Ranking, truth: Truth, k: int) -> Iterator[Fault]:
    """Claims that the list of all alternatives refutes."""
    listed = _entries(result.alternatives)
    true_list = _entries(truth.ranked)
    if result.status == "infeasible" and true_list:
        yield "false proof", f"{name} says infeasible"
    if result.status == "exact" and listed != true_list[:k]:
        yield "false proof", f"{name} says exact, lists {listed}, not {true_list[:k]}"
    teams = {team(one) for one in result.alternatives}
    if aim.diverse and len(teams) < len(listed):
        yield "mismatch", f"{name} lists a team twice"
    missing = [
        one.utility
        for one, entry in zip(truth.all, _entries(truth.all), strict=True)
        if entry not in listed and not (aim.diverse and team(one) in teams)
    ]
    most = max(missing, default=None)
    certificate = result.certificate
    if (
        certificate.claim != "unproven"
        and most is not None
        and certificate.bound is not None
        and most > certificate.bound
    ):
        yield "false proof", f"{name}: {most} is missing, the bound is {certificate.bound}"
    if certificate.claim == "proven" and certificate.bound is None and most is not None:
        yield "false proof", f"{name}: nothing is said to be missing, and {most} is"
    for rank, one in enumerate(result.alternatives):
        bound = one.certificate.bound
        if one.certificate.claim == "proven" and true_list[rank : rank + 1] != [listed[rank]]:
            yield "false proof", f"{name} claims rank {rank + 1}"
        if one.certificate.claim == "bounded" and (bound is None or (most is not None and most > bound)):
            yield "false proof", f"{name}: better than the bound of rank {rank + 1} is missing"
        if one.certificate.claim != "unproven" and listed[rank] not in _entries(truth.all):
            yield "false proof", f"{name} lists what is not feasible at rank {rank + 1}"


def _entries(alternatives: tuple[Alternative, ...] | list[Alternative]) -> list[tuple[float, object, object]]:
    return [(one.utility, one.choices, one.roles) for one in alternatives]


if __name__ == "__main__":
    main()
