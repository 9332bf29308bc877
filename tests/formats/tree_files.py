"""Trees in columns for tests: one made by hand, and random ones."""

from __future__ import annotations

from random import Random
from typing import Any

from missiontree.formats.importers.tree_json import columns_of
from missiontree.formats.parsed import Parsed
from missiontree.mission.columns import TreeColumns


def small() -> dict[str, Any]:
    """
    An AND of an XOR (leaf 3 by robot 0, leaf 4 by robot 1) and of leaf 2 by robot 0, which comes first.

    Leaf 3 gives 9 and uses 5, leaf 4 gives 7 and uses 1, leaf 2 gives 10 and uses 4; robots may use 8 and 3.
    """
    return {
        "kind": [1, 2, 0, 0, 0],
        "parent": [-1, 0, 0, 1, 1],
        "robot": [0, 0, 0, 0, 1],
        "utility": [0, 0, 10, 9, 7],
        "duration": [0, 0, 3, 2, 1],
        "consumption": [0, 0, 4, 5, 1],
        "precedence": [[2, 1]],
        "disjoint": [0],
        "robots": 2,
        "budget": [8, 3],
    }


def read(data: dict[str, Any]) -> TreeColumns:
    """The tree that plain data describes."""
    return columns_of(Parsed(data, "tree.json", lambda path: 1))


def random_tree(seed: int) -> dict[str, Any]:
    """A tree of up to 60 nodes: any order of nodes, gates without children, negative utilities, robots without work, some keys left out."""
    luck = Random(seed)  # noqa: S311 - luck for tests, not for secrets
    kind, parent = [luck.choice((0, 1, 2))], [-1]
    for node in range(1, luck.randint(1, 60)):
        gates = [above for above in range(node) if kind[above]]
        if not gates:
            break
        parent.append(luck.choice(gates))
        kind.append(luck.choice((0, 0, 1, 2)))
    robots = luck.randint(1, 4)

    def at_leaves(low: int, high: int) -> list[int]:
        return [0 if gate else luck.randint(low, high) for gate in kind]

    data: dict[str, Any] = {"kind": kind, "parent": parent, "robot": at_leaves(0, robots - 1), "robots": robots}
    data |= {"utility": at_leaves(-20, 20), "duration": at_leaves(0, 9)}
    siblings = [(a, b) for a in range(1, len(kind)) for b in range(a + 1, len(kind)) if parent[a] == parent[b]]
    data["precedence"] = [list(pair) for pair in siblings if luck.random() < 0.3]
    data["disjoint"] = [node for node, gate in enumerate(kind) if gate == 1 and luck.random() < 0.3]
    if luck.random() < 0.8:
        data["consumption"] = at_leaves(0, 3)
    if luck.random() < 0.8:
        data["budget"] = [luck.randint(0, 12) for _ in range(robots)]
    return data
