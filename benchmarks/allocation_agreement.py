"""
Do the allocators agree? Random trees with fleets, each allocator against the oracle that enumerates.

::

    python -m benchmarks.allocation_agreement --count 20000 --seed 1 --state agreement.json

The state file keeps what was done, so an interrupted run goes on where it was. A *mismatch* is a list that is not what it
should be; a *false proof* is a claim (status, certificate, bound, witness) that the oracle refutes.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Any

from benchmarks.random_trees import Case, random_case
from missiontree import __version__
from missiontree.allocation.coupling import couples
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.pruned import Pruned
from missiontree.mission.alternative import Alternative, Ranking, selected_leaves, selected_nodes
from missiontree.mission.control import Control
from missiontree.mission.terms import NO_TERMS

SAVE_EVERY = 250
EVERYTHING = 10**9

Entry = tuple[float, object, object]


def main() -> None:
    """Run or resume the campaign and print its table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=20_000, help="trees (default 20000)")
    parser.add_argument("--seed", type=int, default=1, help="seed of the campaign (default 1)")
    parser.add_argument("--state", type=Path, default=None, help="file to keep the state in and to resume from")
    given = parser.parse_args()
    state = _resume(given.state, given.seed)
    while state["done"] < given.count:
        began = time.perf_counter()
        for _ in range(min(SAVE_EVERY, given.count - state["done"])):
            _one(state)
        state["seconds"] += time.perf_counter() - began
        if given.state is not None:
            _save(given.state, state)
    print(table(state))
    if state["mismatch"] or state["false proof"]:
        raise SystemExit(1)


def _resume(path: Path | None, seed: int) -> dict[str, Any]:
    if path is not None and path.exists():
        state: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        if (state["seed"], state["version"]) != (seed, __version__):
            raise SystemExit(f"{path} belongs to seed {state['seed']} and version {state['version']}.")
        return state
    empty = {"done": 0, "seconds": 0.0, "mismatch": [], "false proof": [], "counts": {}}
    return {"seed": seed, "version": __version__, **empty}


def _save(path: Path, state: dict[str, Any]) -> None:
    beside = path.with_name(path.name + ".new")
    beside.write_text(json.dumps(state), encoding="utf-8")
    os.replace(beside, path)


def numbered_case(seed: int, index: int) -> Case:
    """The case of that number in the campaign of that seed."""
    return random_case(Random(f"{seed}:{index}"))  # noqa: S311 - luck for tests, not for secrets


def _one(state: dict[str, Any]) -> None:
    index = state["done"]
    case = numbered_case(state["seed"], index)
    truth, faults = judge(case)
    for kind, message in faults:
        state[kind].append(f"{index}: {message}")
    feasible = len(truth.alternatives)
    counts = Counter(state["counts"])
    counts["coupled"] += couples(case.flat)
    counts["ruled"] += case.terms != NO_TERMS or bool(
        case.fleet.total_limits or any(k.max_in_use for k in case.fleet.types)
    )
    counts["infeasible"] += not feasible
    counts["ties"] += len({entry.utility for entry in truth.alternatives}) < feasible
    counts["refused"] += truth.examined > feasible
    counts["alternatives"] += feasible
    state["counts"] = {**counts, "most alternatives": max(counts["most alternatives"], feasible)}
    state["done"] += 1


def table(state: dict[str, Any]) -> str:
    """The result as a Markdown table."""
    counts = state["counts"]
    rows = [
        ("trees", state["done"]),
        ("mismatches", len(state["mismatch"])),
        ("false proofs", len(state["false proof"])),
        ("trees that something couples", counts.get("coupled", 0)),
        ("trees with rules for the whole mission", counts.get("ruled", 0)),
        ("trees of which rules refuse something", counts.get("refused", 0)),
        ("trees with equal utilities", counts.get("ties", 0)),
        ("infeasible trees", counts.get("infeasible", 0)),
        ("feasible alternatives, all trees", counts.get("alternatives", 0)),
        ("feasible alternatives, largest tree", counts.get("most alternatives", 0)),
        ("seconds", round(state["seconds"])),
        ("seed", state["seed"]),
        ("missiontree", state["version"]),
        ("Python", platform.python_version()),
        ("machine", f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores"),
    ]
    lines = ["| what | value |", "|---|---|", *(f"| {what} | {value} |" for what, value in rows)]
    return "\n".join(lines + state["mismatch"][:20] + state["false proof"][:20])


def judge(case: Case) -> tuple[Ranking, list[tuple[str, str]]]:
    """The oracle's full list, and what is wrong with the other allocators' results, as (kind, message)."""
    truth = run(Exhaustive(), case, EVERYTHING)
    faults = list(exact_faults(case, truth))
    for as_printed in (False, True):
        faults += _pruned_faults(case, truth, as_printed)
    faults += _limited_faults(case, truth)
    return truth, faults


def run(allocator: Exhaustive | ExactKBest | Pruned, case: Case, k: int) -> Ranking:
    return allocator(case.flat, case.fleet, case.weights, k, Control())


def _entries(ranking: Ranking) -> list[Entry]:
    return [(entry.utility, entry.choices, entry.roles) for entry in ranking.alternatives]


def _expected_status(truth: Ranking) -> str:
    return "exact" if truth.alternatives else "infeasible"


def exact_faults(case: Case, truth: Ranking) -> Iterator[tuple[str, str]]:
    """As it comes, and with prices from the first candidate on, which small trees would seldom need."""
    for name, settings in (("exact", ExactKBest()), ("exact by bounds", ExactKBest(patience=0))):
        result = run(settings, case, case.k)
        if _entries(result) != _entries(truth)[: case.k]:
            yield "mismatch", f"{name} lists {_entries(result)}, the oracle {_entries(truth)[: case.k]}"
        if result.status != _expected_status(truth):
            yield "mismatch", f"{name} says {result.status}"
        yield from _false_claims(name, case, result, truth)


def _pruned_faults(case: Case, truth: Ranking, as_printed: bool) -> Iterator[tuple[str, str]]:
    name = "pruned as printed" if as_printed else "pruned"
    result = run(Pruned(as_printed=as_printed), case, case.k)
    expected = _entries(truth)[: case.k]
    if not couples(case.flat):
        if (_entries(result), result.status) != (expected, _expected_status(truth)):
            yield "mismatch", f"{name} lists {_entries(result)} ({result.status}), the oracle {expected}"
    elif any(entry.utility > best[0] for entry, best in zip(result.alternatives, expected, strict=False)):
        yield "mismatch", f"{name} is better than the best"
    position = {entry: rank for rank, entry in enumerate(_entries(truth))}
    ranks = [position.get(entry, -1) for entry in _entries(result)]
    if -1 in ranks or ranks != sorted(ranks):
        yield "mismatch", f"{name} lists what is not feasible, or out of order"
    yield from _false_claims(name, case, result, truth)


def _limited_faults(case: Case, truth: Ranking) -> Iterator[tuple[str, str]]:
    """What is claimed and listed when the search is cut short, or packing is."""
    few = case.k % 7
    for settings in (
        ExactKBest(max_examined=few),
        ExactKBest(packing_steps=0),
        ExactKBest(packing_steps=3),
        ExactKBest(patience=0, max_nodes=(few, few)),
        ExactKBest(patience=few, max_nodes=(10 * few, 10 * few), packing_steps=3),
    ):
        result = run(settings, case, case.k)
        yield from _false_claims(str(settings), case, result, truth)
        yield from _order_faults(str(settings), result, truth)


def _order_faults(name: str, result: Ranking, truth: Ranking) -> Iterator[tuple[str, str]]:
    """Feasible alternatives stand in the order of the oracle."""
    position = {entry: rank for rank, entry in enumerate(_entries(truth))}
    ranks = [position[entry] for entry in _entries(result) if entry in position]
    if ranks != sorted(set(ranks)):
        yield "mismatch", f"{name} lists {ranks}, which is out of order"


def _false_claims(name: str, case: Case, result: Ranking, truth: Ranking) -> Iterator[tuple[str, str]]:
    true_list, listed = _entries(truth), _entries(result)
    if result.status == "infeasible" and true_list:
        yield "false proof", f"{name} says infeasible"
    if result.status == "exact" and listed != true_list[: case.k]:
        yield "false proof", f"{name} says exact"
    missing = [entry[0] for entry in true_list if entry not in listed]
    certificate = result.certificate
    if (
        certificate.claim != "unproven"
        and certificate.bound is not None
        and max(missing, default=certificate.bound) > (certificate.bound)
    ):
        yield "false proof", f"{name}: {max(missing)} is missing, the bound is {certificate.bound}"
    for rank, entry in enumerate(result.alternatives):
        if entry.certificate.claim == "proven" and true_list[rank : rank + 1] != [listed[rank]]:
            yield "false proof", f"{name} claims rank {rank + 1}"
        own_bound = entry.certificate.bound
        if entry.certificate.claim == "bounded" and (own_bound is None or max(missing, default=own_bound) > own_bound):
            yield "false proof", f"{name}: better than the bound of rank {rank + 1} is missing"
        if entry.certificate.claim != "unproven" and listed[rank] not in true_list:
            yield "false proof", f"{name} lists what is not feasible at rank {rank + 1}"
        if entry.witness and (broken := broken_rule(case, entry)):
            yield "false proof", f"{name}: the witness of rank {rank + 1} breaks {broken}"


def broken_rule(case: Case, alternative: Alternative) -> str:
    """A rule that the witness breaks, read off the tree and the fleet as they came in; empty if none."""
    tree, fleet = case.tree, case.fleet
    robot_of = {entry.role: entry.robot for entry in alternative.witness}
    if any(fleet.type_of[robot_of[entry.role]].id != entry.robot_type for entry in alternative.roles):
        return "robot type"
    mates = [(tree.roles[role].team, robot) for role, robot in robot_of.items() if tree.roles[role].team is not None]
    if len(set(mates)) < len(mates):
        return "team"
    nodes, leaves = set(selected_nodes(tree, alternative.choices)), selected_leaves(tree, alternative.choices)
    for link in tree.links:
        if link.first in nodes and link.second in nodes:
            first, second = (
                {robot_of[tree.action(leaf).role] for leaf in leaves if _stands_below(case, end, leaf)}
                for end in (link.first, link.second)
            )
            if link.kind == "same_robot" and len(first | second) > 1:
                return "same_robot"
            if link.kind == "different_robot" and first & second:
                return "different_robot"
    return _broken_term(case, leaves, robot_of) or _broken_budget(case, leaves, robot_of)


def _broken_term(case: Case, leaves: tuple[int, ...], robot_of: dict[int, str]) -> str:
    busy = set(robot_of.values())
    busy_types = {case.fleet.type_of[robot].id for robot in busy}
    if busy & set(case.terms.without):
        return "without"
    if not set(case.terms.require) <= busy | busy_types:
        return "require"
    for kind in case.fleet.types:
        if kind.max_in_use is not None and len(busy & {robot.id for robot in kind.members}) > kind.max_in_use:
            return "max_in_use"
    for name in {*case.fleet.total_limits, *case.terms.stock}:
        used = sum(case.tree.action(leaf).uses_at_least.get(name, 0.0) for leaf in leaves)
        limit = min(case.fleet.total_limits.get(name, used), case.terms.stock.get(name, used))
        if used > limit + 1e-6:
            return f"{name} of the mission"
    return ""


def _stands_below(case: Case, outer: int, inner: int) -> bool:
    while inner > outer:
        inner = case.tree.nodes[inner].parent
    return inner == outer


def _broken_budget(case: Case, leaves: tuple[int, ...], robot_of: dict[int, str]) -> str:
    spent: dict[tuple[str, str], float] = {}
    for leaf in leaves:
        action = case.tree.action(leaf)
        for name, used in action.uses_at_least.items():
            for whose in (robot_of[action.role], action.robot_type):
                spent[whose, name] = spent.get((whose, name), 0.0) + used
    for (whose, name), used in spent.items():
        if whose in case.fleet.by_id:
            limit = case.fleet.by_id[whose].total_limits.get(name)
        else:
            limit = case.fleet.type_of[whose].budget(case.fleet.robots[whose], name)
        if limit is not None and used > limit + 1e-6:
            return name
    return ""


if __name__ == "__main__":
    main()
