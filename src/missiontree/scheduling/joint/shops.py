"""A selection as a shop: its actions with the ways left open right above them, for the search over machines and sequences."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from missiontree.mission.columns import LEAF, XOR
from missiontree.scheduling.joint.compiled import Engine
from missiontree.scheduling.joint.kernel.shop import BEST, SINCE, Shop, State
from missiontree.scheduling.joint.listing import Listed
from missiontree.scheduling.joint.problem import JointProblem

USUAL = 10_000
"""Pairs of actions on a machine up to which a move takes no longer than the slices of moves are made for."""


@dataclass
class Workshop:
    """
    A shop, the state of the search in it, and what its items and ways are in the tree.

    Parameters
    ----------
    problem
        The tree; each of its types is a single robot.
    shop, state
        As the kernel takes them.
    leaf
        Leaf of the tree that each way is.
    engine
        Functions of the kernel.
    outer
        Choices that stay as they are: those at XORs above others than leaves.
    """

    problem: JointProblem
    shop: Shop
    state: State
    leaf: list[int]
    engine: Engine
    outer: dict[int, int]

    @property
    def items(self) -> int:
        """How many actions and events there are."""
        return len(self.state.way)

    @property
    def in_vain(self) -> int:
        """Moves since the best was found."""
        return int(self.state.numbers[SINCE])

    @property
    def makespan(self) -> int:
        """Of the best."""
        return int(self.state.numbers[BEST])

    def improved(self, target: int, ended: Callable[[bool], bool]) -> None:
        """Search until the best reaches the target or ``ended``, told now and then whether there is a new best, answers true."""
        best, moves = int(self.state.numbers[BEST]), self._moves_at_once()
        better = True
        while not ended(better):
            now = int(self.engine.improve(self.shop, self.state, moves, target))
            better, best = now < best, now
            if best <= target:
                return

    def _moves_at_once(self) -> int:
        """Moves between two looks at the clock: a move looks, for each action of a longest path, at all others of its machines."""
        on_each = len(self.state.way) // max(1, len(self.state.first)) + 1
        return max(1, min(self.engine.slice, self.engine.slice * USUAL // (on_each * on_each)))

    def best(self) -> Listed:
        """The best schedule ever."""
        state, problem = self.state, self.problem
        taken = [int(way) for way in state.best_way]
        for item, way in enumerate(taken):
            state.way[item] = way
            state.following[item] = state.best_following[item]
            state.leading[item] = -1
        for item in range(len(taken)):
            if state.following[item] >= 0:
                state.leading[state.following[item]] = item
        for machine in range(len(state.first)):
            state.first[machine] = state.best_first[machine]
        self.engine.measure(self.shop, state)
        start = {self.leaf[way]: int(state.head[item]) for item, way in enumerate(taken) if way >= 0}
        chosen = dict(self.outer)
        for leaf in start:
            above = problem.parent[leaf]
            if above >= 0 and problem.kind[above] == XOR:
                chosen[above] = leaf
        makespan = max((begun + problem.duration[leaf] for leaf, begun in start.items()), default=0)
        return Listed(makespan, start, dict.fromkeys(start, 0), chosen)


def workshop_of(
    problem: JointProblem, listed: Listed, engine: Engine, seed: int, *, closed: Callable[[int], bool]
) -> Workshop:
    """
    The shop of the selection of a schedule, in the order of that schedule.

    Parameters
    ----------
    problem
        A tree whose types are single robots.
    listed
        A schedule of it.
    engine
        Functions of the kernel.
    seed
        Of the search.
    closed
        Whether a leaf would be too late in any case, so that it is no way worth having.
    """
    items, events, outer = _Items(), _Arcs(), dict[int, int]()
    stack = [0]
    while stack:
        node = stack.pop()
        children = problem.children[node]
        if problem.kind[node] == LEAF:
            items.add(node, [node])
        elif problem.kind[node] == XOR and all(problem.kind[child] == LEAF for child in children):
            taken = listed.chosen[node]
            items.add(
                node, [child for child in children if child == taken or not (closed(child) or _linked(problem, child))]
            )
        else:
            if problem.kind[node] == XOR:
                outer[node] = listed.chosen[node]
                children = [outer[node]]
            items.add_gate(node)
            stack.extend(children)
    _relate(problem, items, events)
    ways, machine, length, leaf = [0], list[int](), list[int](), list[int]()
    for open_ways in items.ways:
        leaf += open_ways
        machine += [problem.robot[way] for way in open_ways]
        length += [problem.duration[way] for way in open_ways]
        ways.append(len(leaf))
    column = engine.column
    shop = Shop(column(ways), column(machine), column(length), *map(column, events.columns(len(items.ways))))
    state = _state(problem, listed, items, leaf, ways, engine, seed)
    engine.measure(shop, state)
    engine.keep(state)
    return Workshop(problem, shop, state, leaf, engine, outer)


def _linked(problem: JointProblem, node: int) -> bool:
    return bool(problem.before[node] or problem.after[node])


class _Items:
    """Items by node: an action has one, a gate one for its start and one for its end."""

    def __init__(self) -> None:
        self.start: dict[int, int] = {}
        self.end: dict[int, int] = {}
        self.ways: list[list[int]] = []

    def add(self, node: int, ways: list[int]) -> None:
        self.start[node] = self.end[node] = len(self.ways)
        for way in ways:
            self.start[way] = self.end[way] = len(self.ways)
        self.ways.append(ways)

    def add_gate(self, node: int) -> None:
        self.start[node], self.end[node] = len(self.ways), len(self.ways) + 1
        self.ways += [[], []]


class _Arcs:
    """Which item ends before which starts."""

    def __init__(self) -> None:
        self.pairs: dict[tuple[int, int], None] = {}

    def add(self, first: int, second: int) -> None:
        if first != second:
            self.pairs[first, second] = None

    def columns(self, items: int) -> tuple[list[int], list[int], list[int], list[int]]:
        after: list[list[int]] = [[] for _ in range(items)]
        before: list[list[int]] = [[] for _ in range(items)]
        for first, second in self.pairs:
            after[first].append(second)
            before[second].append(first)
        return (*_packed(after), *_packed(before))


def _packed(lists: list[list[int]]) -> tuple[list[int], list[int]]:
    first, entries = [0], list[int]()
    for part in lists:
        entries += part
        first.append(len(entries))
    return first, entries


def _relate(problem: JointProblem, items: _Items, arcs: _Arcs) -> None:
    """Containment and precedence among what is selected."""
    for node, start in items.start.items():
        above = problem.parent[node]
        if above >= 0 and items.start[above] != start:
            arcs.add(items.start[above], start)
            arcs.add(items.end[node], items.end[above])
        if items.end[node] != start:
            arcs.add(start, items.end[node])
        for other in problem.after[node]:
            if other in items.start:
                arcs.add(items.end[node], items.start[other])


def _state(
    problem: JointProblem, listed: Listed, items: _Items, leaf: list[int], ways: list[int], engine: Engine, seed: int
) -> State:
    count, machines = len(items.ways), len(problem.count)
    way, following, leading, first = [-1] * count, [-1] * count, [-1] * count, [-1] * machines
    number = {node: at for at, node in enumerate(leaf)}
    place = problem.place
    for node in sorted(listed.start, key=lambda node: (listed.start[node], problem.duration[node] > 0, place[node])):
        item = items.start[node]
        way[item] = number[node]
        robot = problem.robot[node]
        leading[item] = first[robot]  # for now, ``first`` holds the last one
        if first[robot] >= 0:
            following[first[robot]] = item
        first[robot] = item
    for item in range(count):
        if way[item] >= 0 and leading[item] < 0:
            first[problem.robot[leaf[way[item]]]] = item
    numbers = [0, 1 << 60, 1 + seed % 2147483645, 0, 0]
    zeros = [0] * count
    columns = (
        way,
        following,
        leading,
        first,
        zeros,
        zeros,
        zeros,
        zeros,
        [0] * len(leaf),
        way,
        following,
        first,
        zeros,
        numbers,
    )
    return State(*[engine.column(list(column)) for column in columns])
