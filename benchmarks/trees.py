"""
Seeded mission trees with a budget per robot, as JSON: the instances that allocation is measured on.

::

    python -m benchmarks.trees mission 1000 8 3 > mission_1000_8_3.json
    python -m benchmarks.trees FAMILY LEAVES ROBOTS SEED [TIGHTNESS]

*mission*: an AND of groups of four tasks. A task is given to one of three able robots, each a chain of three actions; half of the
tasks can be done in two ways, each of one or two such parts. *uniform*: AND and XOR alternate, two to four children each. Same
arguments, same bytes. :mod:`missiontree.formats.importers.tree_json` tells what the keys mean and reads them.

A robot that does more than the average in the best selection without budgets may use TIGHTNESS times that (default 0.8), any other
robot the average, and every robot 10 at least.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable
from itertools import pairwise
from random import Random
from typing import Any

LEAF, AND, XOR = range(3)
TIGHTNESS = 0.8
TASKS_OF_A_GROUP, ABLE, ACTIONS = 4, 3, 3


class Growing:
    """
    A tree that grows node by node.

    Parameters
    ----------
    robots
        How many robots there are.
    luck
        Source of everything random. The order of the draws is part of the format: another order makes other trees.
    """

    def __init__(self, robots: int, luck: Random) -> None:
        self.robots, self.luck, self.leaves = robots, luck, 0
        self.kind: list[int] = []
        self.parent: list[int] = []
        self.robot: list[int] = []
        self.utility: list[int] = []
        self.duration: list[int] = []
        self.consumption: list[int] = []
        self.precedence: list[tuple[int, int]] = []
        self.disjoint: list[int] = []

    def gate(self, kind: int, parent: int) -> int:
        """A further AND or XOR."""
        return self._node(kind, parent, robot=0, utility=0, duration=0, consumption=0)

    def action(self, parent: int, robot: int) -> int:
        """A further leaf with luck in its numbers."""
        duration, consumption = self.luck.randint(1, 10), self.luck.randint(1, 10)
        tens, ones = self.luck.randint(1, 100), self.luck.randint(0, 9)
        self.leaves += 1
        return self._node(LEAF, parent, robot, 10 * tens + ones, duration, consumption)

    def _node(self, kind: int, parent: int, robot: int, utility: int, duration: int, consumption: int) -> int:
        self.kind.append(kind)
        self.parent.append(parent)
        self.robot.append(robot)
        self.utility.append(utility)
        self.duration.append(duration)
        self.consumption.append(consumption)
        return len(self.kind) - 1

    def happens(self, chance: float) -> bool:
        """A draw."""
        return self.luck.random() < chance

    def one_after_another(self, nodes: list[int]) -> None:
        """Each node ends before the next begins."""
        self.precedence += pairwise(nodes)


def mission(leaves: int, robots: int, luck: Random) -> Growing:
    """A tree like those that missions give; at least that many leaves."""
    tree = Growing(robots, luck)
    root = tree.gate(AND, -1)
    last: int | None = None
    while tree.leaves < leaves:
        group = tree.gate(AND, root)
        if last is not None and tree.happens(0.5):
            tree.one_after_another([last, group])
        last = group
        _tasks(tree, group)
        if tree.happens(0.3):
            tree.disjoint.append(group)
    return tree


def _tasks(tree: Growing, group: int) -> None:
    last: int | None = None
    for _ in range(TASKS_OF_A_GROUP):
        task = _two_ways(tree, group) if tree.happens(0.5) else _staffed(tree, group)
        if last is not None and tree.happens(0.6):
            tree.one_after_another([last, task])
        last = task


def _two_ways(tree: Growing, group: int) -> int:
    task = tree.gate(XOR, group)
    for _ in range(2):
        way = tree.gate(AND, task)
        parts = tree.luck.randint(1, 2)
        tree.one_after_another([_staffed(tree, way) for _ in range(parts)])
    return task


def _staffed(tree: Growing, parent: int) -> int:
    """One of some able robots does a chain of actions."""
    choice = tree.gate(XOR, parent)
    for robot in tree.luck.sample(range(tree.robots), min(ABLE, tree.robots)):
        chain = tree.gate(AND, choice)
        tree.one_after_another([tree.action(chain, robot) for _ in range(ACTIONS)])
    return choice


def uniform(leaves: int, robots: int, luck: Random) -> Growing:
    """AND and XOR by turns; exactly that many leaves."""
    tree = Growing(robots, luck)
    open_gates = [(tree.gate(AND, -1), leaves)]
    while open_gates:
        gate, share = open_gates.pop()
        is_and = tree.kind[gate] == AND
        last: int | None = None
        for part in _parts(share, luck):
            if part > 1:
                child = tree.gate(XOR if is_and else AND, gate)
                open_gates.append((child, part))
            else:
                child = tree.action(gate, luck.randrange(robots))
            if is_and and last is not None and tree.happens(0.5):
                tree.one_after_another([last, child])
            last = child
    return tree


def _parts(share: int, luck: Random) -> list[int]:
    """Split a number of leaves among two to four children."""
    count = min(share, luck.randint(2, 4))
    inner = sorted(luck.sample(range(1, share), count - 1)) if count < share else list(range(1, count))
    return [end - start for start, end in pairwise([0, *inner, share])]


FAMILIES: dict[str, Callable[[int, int, Random], Growing]] = {"mission": mission, "uniform": uniform}


def budgets(tree: Growing, tightness: float) -> list[int]:
    """What each robot may use, from what it uses in the best selection without budgets."""
    used = [0] * tree.robots
    for leaf in _best_leaves(tree):
        used[tree.robot[leaf]] += tree.consumption[leaf]
    average = sum(used) / len(used)
    return [int(max(10, tightness * own if own > average else average)) for own in used]


def _best_leaves(tree: Growing) -> list[int]:
    below: list[list[int]] = [[] for _ in tree.kind]
    for node, parent in enumerate(tree.parent[1:], start=1):
        below[parent].append(node)
    value = tree.utility.copy()
    for node in range(len(value) - 1, -1, -1):
        if tree.kind[node] == XOR:
            below[node] = [max(below[node], key=value.__getitem__)]  # of equals the first
        if tree.kind[node] != LEAF:
            value[node] = sum(value[child] for child in below[node])
    leaves, reached = [], [0]
    while reached:
        node = reached.pop()
        reached += below[node]
        if tree.kind[node] == LEAF:
            leaves.append(node)
    return leaves


def instance(family: str, leaves: int, robots: int, seed: int, tightness: float = TIGHTNESS) -> dict[str, Any]:
    """A tree in its JSON form, as plain data."""
    tree = FAMILIES[family](leaves, robots, Random(seed))  # noqa: S311 - luck for instances, not for secrets
    keys = ("kind", "parent", "robot", "utility", "duration", "consumption", "precedence", "disjoint", "robots")
    return {**{key: getattr(tree, key) for key in keys}, "budget": budgets(tree, tightness)}


def text_of(plain: dict[str, Any]) -> str:
    """The bytes of the file; there is no line end."""
    return json.dumps(plain)


def main() -> None:
    """Write one tree."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("family", choices=tuple(FAMILIES))
    for name in ("leaves", "robots", "seed"):
        parser.add_argument(name, type=int)
    parser.add_argument("tightness", type=float, nargs="?", default=TIGHTNESS)
    given = parser.parse_args()
    if given.leaves < 1 or given.robots < 1:
        parser.error("a tree has at least one leaf and one robot")
    sys.stdout.write(text_of(instance(given.family, given.leaves, given.robots, given.seed, given.tightness)))


if __name__ == "__main__":
    main()
