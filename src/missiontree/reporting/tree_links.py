"""The ways of the arrows in a drawn tree: through the room between boxes, never over one."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from missiontree.mission.tree import LinkKind
from missiontree.reporting.tree_cards import SIBLING_GAP, Card, Rows
from missiontree.reporting.tree_layout import Layout
from missiontree.reporting.tree_shape import Shape

LANE = 13.0
PORT, PASS, MOST_ASIDE = 7.0, 4.0, 8.0
LANES_FROM = 26.0
"""Where the first lane runs below a row: the marks of the gates are above it."""

Point = tuple[float, float]


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


@dataclass(slots=True)
class _Pen:
    """
    Draws routes on the page; lines that share an edge of a box, or the room beside one, get places of their own.

    Parameters
    ----------
    rows
        Where everything stands.
    cards
        The boxes.
    """

    rows: Rows
    cards: Sequence[Card]
    ports: Counter[tuple[int, bool, bool]] = field(default_factory=Counter)
    passes: Counter[int] = field(default_factory=Counter)

    def port(self, node: int, right: bool, down: bool) -> Point:
        """Where a line meets the lower or upper edge of a box, right or left of its middle."""
        width, number = self.cards[node].width, self.ports[node, right, down]
        self.ports[node, right, down] += 1
        aside = min(width / 4 + PORT * number, width / 2 - PORT)
        reach = self.cards[node].reach(aside)
        return self.rows.x[node] + (aside if right else -aside), self.rows.y[node] + (reach if down else -reach)

    def beside(self, node: int) -> float:
        """Where a line passes to the left of a box: in the middle of the room there, or close to that."""
        number = self.passes[node]
        self.passes[node] += 1
        aside = (number + 1) // 2 * PASS * (1 if number % 2 else -1)
        middle = self.rows.x[node] - self.cards[node].width / 2 - SIBLING_GAP / 2
        return middle + max(-MOST_ASIDE, min(MOST_ASIDE, aside))

    def arrow(self, route: Route) -> Arrow:
        """The line of a route."""
        return self._winding(route) if route.turns else self._straight(route)

    def _straight(self, route: Route) -> Arrow:
        x, first, second = self.rows.x, route.first, route.second
        ahead = 1 if x[first] < x[second] else -1
        start = x[first] + ahead * self.cards[first].width / 2
        end = x[second] - ahead * self.cards[second].width / 2
        return Arrow(route.kind, ((start, self.rows.y[first]), (end, self.rows.y[first])), 0)

    def _winding(self, route: Route) -> Arrow:
        rows, first, second = self.rows, route.first, route.second
        goes_right = rows.x[second] >= rows.x[first]
        points = [self.port(first, goes_right, rows.level[first] <= rows.level[second])]
        end = self.port(second, not goes_right, rows.level[first] >= rows.level[second])
        for gap, number, node in route.turns:
            y = rows.bottoms[gap] + LANES_FROM + LANE * number
            points += [(points[-1][0], y), (end[0] if node == second else self.beside(node), y)]
        points.append(end)
        longest = max(range(1, len(points) - 1, 2), key=lambda index: abs(points[index][0] - points[index + 1][0]))
        return Arrow(route.kind, tuple(points), longest)


def draw(routes: Sequence[Route], rows: Rows, cards: Sequence[Card]) -> list[Arrow]:
    """Lines on the page for routes."""
    pen = _Pen(rows, cards)
    return [pen.arrow(route) for route in routes]
