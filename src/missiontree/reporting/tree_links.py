"""The ways of the arrows in a drawn tree: through the room between boxes, never over one."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from missiontree.mission.tree import LinkKind
from missiontree.reporting.tree_cards import SIBLING_GAP, Card, Rows
from missiontree.reporting.tree_layout import Layout
from missiontree.reporting.tree_shape import Shape

LANE = 13.0
LANES_FROM = 26.0
"""Where the first lane runs below a row: the marks of the gates are above it."""

Point = tuple[float, float]
Port = Callable[[int, bool, bool], float]


@dataclass(frozen=True, slots=True)
class Arrow:
    """
    A link as a line.

    Parameters
    ----------
    kind
        Kind of the link.
    points
        Corners of the line, from the first node to the second.
    label_at
        Index of the stretch that a label stands on.
    """

    kind: LinkKind
    points: tuple[Point, ...]
    label_at: int


@dataclass(frozen=True, slots=True)
class Route:
    """
    The way of one link, before rows have their places.

    Parameters
    ----------
    first, second
        Nodes it joins.
    kind
        Kind of the link.
    turns
        Lane (level above it, number) and then the node to the left of which it passes that level; the last leads to the second
        node itself. Empty if it goes straight from neighbour to neighbour.
    """

    first: int
    second: int
    kind: LinkKind
    turns: tuple[tuple[int, int, int], ...]


@dataclass(slots=True)
class Router:
    """
    Finds the ways of links.

    Between neighbours on a row a precedence goes straight. Everything else leaves a box downwards or upwards, runs in a lane of its own
    between two rows, and passes further rows to the left of the box that stands above (or, upwards, below) its end's branch.

    Parameters
    ----------
    shape
        The tree.
    layout
        Levels, and places from left to right.
    """

    shape: Shape
    layout: Layout
    lanes: Counter[int] = field(default_factory=Counter)

    def routes(self) -> list[Route]:
        """The ways of all links, in their order; ``lanes`` then counts the lanes below each level."""
        neighbours, straight = self._neighbours(), set()
        parents = {child: node for node, below in enumerate(self.shape.children) for child in below}
        found = []
        for first, second, kind in self.shape.links:
            pair = (min(first, second), max(first, second))
            near = neighbours.get(first) == second or neighbours.get(second) == first
            if kind == "precedence" and near and pair not in straight:
                straight.add(pair)
                found.append(Route(first, second, kind, ()))
            else:
                found.append(Route(first, second, kind, self._turns(first, second, parents)))
        return found

    def _neighbours(self) -> dict[int, int]:
        """The next box to the right on the same row."""
        rows: dict[int, list[int]] = defaultdict(list)
        for node in sorted(range(len(self.layout.x)), key=lambda node: self.layout.x[node]):
            rows[self.layout.level[node]].append(node)
        return {left: right for row in rows.values() for left, right in pairwise(row)}

    def _turns(self, first: int, second: int, parents: dict[int, int]) -> tuple[tuple[int, int, int], ...]:
        above, below = self.layout.level[first], self.layout.level[second]
        if above == below:
            return (self._turn(above, second),)
        if above < below:
            passed = [second]
            while self.layout.level[passed[-1]] > above + 1:
                passed.append(parents[passed[-1]])
            return tuple(self._turn(self.layout.level[node] - 1, node) for node in reversed(passed))
        passed = [parents[first]]
        while self.layout.level[passed[-1]] > below:
            passed.append(parents[passed[-1]])
        passed[-1] = second
        return tuple(self._turn(self.layout.level[node], node) for node in passed)

    def _turn(self, gap: int, node: int) -> tuple[int, int, int]:
        number = self.lanes[gap]
        self.lanes[gap] += 1
        return gap, number, node


def draw(routes: Sequence[Route], rows: Rows, cards: Sequence[Card]) -> list[Arrow]:
    """Lines on the page for routes."""
    ports: Counter[tuple[int, bool, bool]] = Counter()

    def port(node: int, right: bool, down: bool) -> float:
        """How far aside of a node's middle a line meets it; lines that share an edge get places of their own."""
        number = ports[node, right, down]
        ports[node, right, down] += 1
        aside = min(cards[node].width / 4 + 7 * number, cards[node].width / 2 - 8)
        return aside if right else -aside

    return [
        _straight(route, rows, cards) if not route.turns else _winding(route, rows, cards, port) for route in routes
    ]


def _straight(route: Route, rows: Rows, cards: Sequence[Card]) -> Arrow:
    ahead = 1 if rows.x[route.first] < rows.x[route.second] else -1
    start = rows.x[route.first] + ahead * cards[route.first].width / 2
    end = rows.x[route.second] - ahead * cards[route.second].width / 2
    y = rows.y[route.first]
    return Arrow(route.kind, ((start, y), (end, y)), 0)


def _winding(route: Route, rows: Rows, cards: Sequence[Card], port: Port) -> Arrow:
    first, second = route.first, route.second
    goes_right = rows.x[second] >= rows.x[first]
    leaves_down = rows.level[first] <= rows.level[second]
    enters_below = rows.level[first] >= rows.level[second]
    aside = port(first, goes_right, leaves_down)
    x = rows.x[first] + aside
    points = [(x, rows.y[first] + (1 if leaves_down else -1) * cards[first].reach(aside))]
    for gap, number, node in route.turns:
        y = rows.bottoms[gap] + LANES_FROM + LANE * number
        points.append((x, y))
        if node == second:
            aside = port(second, not goes_right, enters_below)
            x = rows.x[second] + aside
        else:
            x = rows.x[node] - cards[node].width / 2 - SIBLING_GAP / 2
        points.append((x, y))
    points.append((x, rows.y[second] + (1 if enters_below else -1) * cards[second].reach(aside)))
    longest = max(range(1, len(points) - 1, 2), key=lambda index: abs(points[index][0] - points[index + 1][0]))
    return Arrow(route.kind, tuple(points), longest)
