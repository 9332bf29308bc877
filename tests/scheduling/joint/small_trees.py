"""Small trees in columns, drawn by chance, and the least makespan of each by trying everything."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations, product
from random import Random

from missiontree.mission.columns import AND, LEAF, XOR, TreeColumns
from missiontree.mission.precedence import EventGraph
from missiontree.scheduling.joint.problem import JointProblem


def columns(
    kind: Sequence[int],
    parent: Sequence[int],
    robot: Sequence[int],
    duration: Sequence[int],
    precedence: Sequence[tuple[int, int]] = (),
    robots: int = 2,
    count: Sequence[int] | None = None,
) -> TreeColumns:
    """A tree without utility and budgets."""
    nothing = [0] * len(kind)
    return TreeColumns(kind, parent, robot, nothing, duration, nothing, precedence, [], robots, None, count)


def drawn(seed: int, leaves: int = 8) -> TreeColumns:
    """A tree of at most that many leaves, with links between any nodes, and with actions that take no time."""
    luck = Random(seed)  # noqa: S311 - luck for tests, not for secrets
    robots = luck.randint(1, 3)
    kind, parent, robot, duration = [luck.choice((AND, AND, XOR))], [-1], [0], [0]
    gates, made = [0], 0
    while made < leaves and len(kind) < 24:
        above = luck.choice(gates)
        if luck.random() < 0.4 and len(gates) < 8:
            gates.append(len(kind))
            kind.append(luck.choice((AND, XOR)))
            robot.append(0)
            duration.append(0)
        else:
            kind.append(LEAF)
            robot.append(luck.randrange(robots))
            duration.append(luck.choice((0, 1, 2, 3, 5, 7)))
            made += 1
        parent.append(above)
    for gate in gates:
        if kind[gate] == AND and gate not in parent:
            kind[gate], robot[gate], duration[gate] = LEAF, luck.randrange(robots), luck.randint(0, 4)
    pairs: list[tuple[int, int]] = []
    for _ in range(luck.choice((0, 2, 6))):
        pair = (luck.randrange(len(kind)), luck.randrange(len(kind)))
        if not _nested(parent, *pair):
            links = [(first, second, "precedence") for first, second in (*pairs, pair)]
            if EventGraph(parent, links).cycle() is None:  # type: ignore[arg-type]
                pairs.append(pair)
    count = [luck.randint(1, 2) for _ in range(robots)] if luck.random() < 0.3 else None
    return columns(kind, parent, robot, duration, pairs, robots, count)


def chosen_by_chance(problem: JointProblem, luck: Random) -> dict[int, int] | None:
    """A child of every XOR; None if one has none."""
    xors = [node for node, kind in enumerate(problem.kind) if kind == XOR]
    if not all(problem.children[node] for node in xors):
        return None
    return {node: luck.choice(problem.children[node]) for node in xors}


def _nested(parent: Sequence[int], one: int, other: int) -> bool:
    return one in _above(parent, other) or other in _above(parent, one)


def _above(parent: Sequence[int], node: int) -> list[int]:
    found = [node]
    while parent[found[-1]] >= 0:
        found.append(parent[found[-1]])
    return found


def selections(tree: TreeColumns) -> Iterator[frozenset[int]]:
    """Every set of nodes that is a selection."""
    children: list[list[int]] = [[] for _ in tree.kind]
    for node, parent in enumerate(tree.parent):
        if parent >= 0:
            children[parent].append(node)

    def below(node: int) -> Iterator[frozenset[int]]:
        if tree.kind[node] == LEAF:
            yield frozenset({node})
        elif tree.kind[node] == XOR:
            for child in children[node]:
                for part in below(child):
                    yield part | {node}
        else:
            for parts in product(*(list(below(child)) for child in children[node])):
                yield frozenset({node}).union(*parts)

    return below(0)


def least_makespan(tree: TreeColumns) -> int | None:
    """The optimum: every selection, every order of its actions, each as early as possible in turn; None if there is no selection."""
    best: int | None = None
    for selection in selections(tree):
        leaves = [node for node in selection if tree.kind[node] == LEAF]
        waits = {leaf: _waits(tree, selection, leaf) for leaf in leaves}
        for order in permutations(leaves):
            makespan = _in_turn(tree, order, waits)
            if makespan is not None and (best is None or makespan < best):
                best = makespan
    return best


def _waits(tree: TreeColumns, selection: frozenset[int], leaf: int) -> set[int]:
    """Selected actions that end before a selected action starts."""
    above = _above(tree.parent, leaf)
    before = {first for first, second in tree.precedence if second in above and first in selection}
    return {
        other
        for other in selection
        if tree.kind[other] == LEAF and any(node in before for node in _above(tree.parent, other))
    }


def _in_turn(tree: TreeColumns, order: Sequence[int], waits: dict[int, set[int]]) -> int | None:
    ends: dict[int, int] = {}
    free = [[0] * (1 if tree.count is None else tree.count[kind]) for kind in range(tree.robots)]
    for leaf in order:
        if not waits[leaf] <= ends.keys():
            return None
        ready = max([ends[other] for other in waits[leaf]], default=0)
        if not tree.duration[leaf]:
            ends[leaf] = ready
            continue
        robots = free[tree.robot[leaf]]
        earliest = robots.index(min(robots))
        robots[earliest] = max(ready, robots[earliest]) + tree.duration[leaf]
        ends[leaf] = robots[earliest]
    return max(ends.values(), default=0)
