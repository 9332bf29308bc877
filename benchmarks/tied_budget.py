"""
One budget and many equal tasks: how long until the k best are proven?

::

    python -m benchmarks.tied_budget

A mission is an AND of n tasks. Robots of type a do each task with quality 1 and use 1 of a budget that holds a few; type b does it
with quality 0.9 and, in the second family, uses 1 of a budget of its own, while a type c with quality 0.8 has no limit. The best
that the budgets leave out are countless ties, so whoever draws candidates best first and asks the budgets afterwards never ends.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Mapping

from benchmarks.machine import machine_line
from missiontree.allocation import ALLOCATORS
from missiontree.mission.control import Control
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import Action, GroundedNode, GroundedTree, Role

QUALITIES = {"a": 1.0, "b": 0.9, "c": 0.8}
ROWS = ((16, {"a": 3}), (20, {"a": 3}), (30, {"a": 3}), (100, {"a": 30}), (60, {"a": 20, "b": 25}))


def tied_mission(tasks: int, budgets: Mapping[str, int]) -> tuple[GroundedTree, Fleet]:
    """That many tasks, each for every type with a budget and for one without; one robot per type."""
    types = "abc"[: len(budgets) + 1]
    nodes = [GroundedNode(parent=-1, kind="and", label="mission")]
    for task in range(tasks):
        nodes.append(GroundedNode(parent=0, kind="xor", label=f"task {task}"))
        choice = len(nodes) - 1
        for name in types:
            uses = {"energy_j": 1.0} if name in budgets else {}
            action = Action(
                name="act",
                text="Act",
                role=task,
                robot_type=name,
                capability="act",
                estimate=Estimate(QUALITIES[name]),
                uses=uses,
                uses_at_least=uses,
            )
            nodes.append(GroundedNode(parent=choice, kind="action", label=f"task {task} by {name}", action=action))
    limits = {name: {"energy_j": float(budgets[name])} if name in budgets else {} for name in types}
    fleet = Fleet(tuple(RobotType(id=name, limits=limits[name], count=1) for name in types))
    roles = tuple(Role(label=f"task {task}") for task in range(tasks))
    return GroundedTree(objective="tied", nodes=tuple(nodes), roles=roles), fleet


def main() -> None:
    """Measure and print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limit", type=float, default=15.0, help="seconds for each search (default 15)")
    limit = parser.parse_args().limit
    print(machine_line(), end="\n\n")
    print("| tasks | budgets | k | allocator | status | found | best | worst listed | bound | s |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for tasks, budgets in ROWS:
        tree, fleet = tied_mission(tasks, budgets)
        held = ", ".join(f"{name} {held}" for name, held in budgets.items())
        for k in (4, 10):
            for name in ("exact", "pruned"):
                began = time.perf_counter()
                ranking = ALLOCATORS[name](tree, fleet, Weights(), k, Control(time_limit_s=limit))
                elapsed = time.perf_counter() - began
                found = [alternative.utility for alternative in ranking.alternatives]
                values = f"{max(found):g} | {min(found):g}" if found else "- | -"
                bound = ranking.certificate.bound
                known = "-" if bound is None else f"{bound:g}"
                print(
                    f"| {tasks} | {held} | {k} | {name} | {ranking.status} | {len(found)} | {values} | {known} | {elapsed:.3f} |"
                )


if __name__ == "__main__":
    main()
