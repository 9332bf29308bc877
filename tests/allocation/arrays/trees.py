"""Bare trees for tests: random ones, degenerate ones, and all their ways by plain counting."""

from __future__ import annotations

from itertools import chain, product
from random import Random

from missiontree.allocation.arrays import TreeArrays, Ways
from missiontree.mission.columns import AND, LEAF, XOR

Told = tuple[int, tuple[int, ...], tuple[int, ...]]  # utility, chosen children, leaves


def told(ways: Ways) -> list[Told]:
    """The ways as plain integers."""
    return [(way.utility, tuple(map(int, way.chosen)), tuple(map(int, way.leaves))) for way in ways.ways]


_Counted = tuple[int, tuple[int, ...], tuple[int, ...], tuple[int, ...]]  # utility, choice indices, chosen, leaves


def _together(parts: tuple[_Counted, ...]) -> _Counted:
    utilities, indices, chosen, leaves = zip(*parts, strict=True) if parts else ((), (), (), ())
    return sum(utilities), tuple(chain(*indices)), tuple(chain(*chosen)), tuple(chain(*leaves))


def every_way(tree: TreeArrays) -> list[Told]:
    """All ways in the order of alternatives, by counting and sorting."""
    below: list[list[int]] = [[] for _ in range(len(tree))]
    for node in range(1, len(tree)):
        below[tree.parent[node]].append(node)

    def ways(node: int) -> list[_Counted]:
        if tree.kind[node] == LEAF:
            return [(int(tree.utility[node]), (), (), (node,))]
        parts = [ways(child) for child in below[node]]
        if tree.kind[node] == XOR:
            return [
                (utility, (place, *indices), (child, *chosen), leaves)
                for place, (child, part) in enumerate(zip(below[node], parts, strict=True))
                for utility, indices, chosen, leaves in part
            ]
        return [_together(combination) for combination in product(*parts)]

    ordered = sorted(ways(0), key=lambda way: (-way[0], way[1]))
    return [(utility, chosen, leaves) for utility, _, chosen, leaves in ordered]


def count_of_ways(tree: TreeArrays) -> int:
    """How many there are."""
    count: list[int] = [1 if kind != XOR else 0 for kind in tree.kind]
    for node in range(len(tree) - 1, 0, -1):
        above = tree.parent[node]
        count[above] = count[above] * count[node] if tree.kind[above] == AND else count[above] + count[node]
    return count[0]


def random_tree(seed: int, most_ways: int = 3_000) -> TreeArrays:
    """Up to 40 nodes in any order, gates without children, few different utilities so that ties are many, negative ones among them."""
    luck = Random(seed)  # noqa: S311 - luck for tests, not for secrets
    while True:
        span = luck.choice((0, 1, 2, 20))
        leaves, same = luck.choice((0.3, 0.6)), luck.choice((0.1, 0.5))
        kind, parent = [luck.choice((AND, XOR))], [-1]
        for node in range(1, luck.randint(1, 40)):
            gates = [above for above in range(node) if kind[above] != LEAF][-luck.choice((1, 2, 8)) :]
            above = luck.choice(gates)
            gate = kind[above] if luck.random() < same else AND + XOR - kind[above]
            parent.append(above)
            kind.append(LEAF if luck.random() < leaves else gate)
        if luck.random() < 0.8:  # else most trees would have gates without children, and few ways
            gates = [node for node, gate in enumerate(kind) if gate != LEAF and node not in parent]
            for gate in gates:
                kind[gate] = LEAF
        utility = [0 if gate else luck.randint(-span, span) for gate in kind]
        tree = TreeArrays(kind, parent, utility)
        if count_of_ways(tree) <= most_ways:
            return tree


def levels(depth: int) -> TreeArrays:
    """An XOR of a leaf and an XOR of a leaf and so on; the leaf at depth d earns d % 3."""
    kind, parent, utility = [XOR], [-1], [0]
    for level in range(depth):
        gate = 2 * level
        kind += [LEAF, XOR]
        parent += [gate, gate]
        utility += [level % 3, 0]
    kind[-1] = LEAF
    return TreeArrays(kind, parent, utility)


def wide(gate: int, children: int, utility: int = 1) -> TreeArrays:
    """A gate over that many equal leaves."""
    return TreeArrays([gate] + [LEAF] * children, [-1] + [0] * children, [0] + [utility] * children)


def tied(groups: int, able: int = 3) -> TreeArrays:
    """An AND of XORs of equal leaves."""
    kind, parent, utility = [AND], [-1], [0]
    for _ in range(groups):
        gate = len(kind)
        kind += [XOR] + [LEAF] * able
        parent += [0] + [gate] * able
        utility += [0] + [7] * able
    return TreeArrays(kind, parent, utility)
