"""Where the edges of a drawn tree run: from a box down to its fork, and on to each part."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.mission.tree import Gate
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.tree.blocks import Blocks
from missiontree.reporting.tree.cards import Card
from missiontree.reporting.tree.layout import Layout
from missiontree.reporting.tree.links import LANE, Point, lanes_from
from missiontree.reporting.tree.marks import MARK_BELOW, MARK_HEIGHT
from missiontree.reporting.tree.rows import FRAME_PADDING, Rows, half_width
from missiontree.reporting.tree.shape import Shape

UNMARKED = 4.0
MOST_ALIGNED = 30.0
"""Marks of a row stand on one line, but none further below its box than this."""
STEEPNESS, LEAST_DROP, MOST_DROP = 0.09, 26.0, 110.0
"""How far edges go down, in shares of how far they go aside, and its bounds."""


@dataclass(frozen=True, slots=True)
class Branch:
    """
    An edge from a fork to a node.

    Parameters
    ----------
    child
        The node.
    fork
        Where it begins.
    over
        Where it turns down to its box, or to the column that the box stands in.
    turn
        Where it turns aside to a box in a column; None if it comes from above.
    end
        Where it meets the box.
    before
        Where the edge to the box above, in a column, turned aside; None if there is none.
    """

    child: int
    fork: Point
    over: Point
    turn: Point | None
    end: Point
    before: Point | None = None

    def path(self, whole: bool = True) -> str:
        """The line: the whole way, or only what it does not share with the edge to the box above."""
        start = [self.before] if self.before is not None and not whole else [self.fork, self.over]
        return _path([*start, *((self.turn,) if self.turn else ()), self.end])

    @property
    def tick_at(self) -> Point:
        """Where the choice of this edge is marked."""
        return self.over if self.turn is None else ((self.turn[0] + self.end[0]) / 2 - 1, self.end[1])


@dataclass(frozen=True, slots=True)
class Fork:
    """
    The edges below a node.

    Parameters
    ----------
    node
        The node.
    gate
        Its gate.
    is_marked
        Whether the gate is written at the fork; over one part, AND says nothing.
    foot
        Where the edges leave the node's box.
    mark_top
        Upper edge of the mark.
    at
        Where the edges part.
    branches
        The edges, in order; what a robot does after something else has none.
    ways
        How many blocks they lead to.
    """

    node: int
    gate: Gate
    is_marked: bool
    foot: Point
    mark_top: float
    at: Point
    branches: tuple[Branch, ...]
    ways: int

    def stem(self) -> str:
        """The line from the box to the fork."""
        return _path([self.foot, self.at])


def is_marked(shape: Shape, node: int) -> bool:
    """Whether the gate of a node is written at its fork."""
    below = len(shape.children[node])
    return shape.nodes[node].gate is not None and below > 0 and (shape.nodes[node].gate == "xor" or below > 1)


def forks_of(shape: Shape, rows: Rows, cards: Sequence[Card]) -> list[Fork]:
    """All forks, in the order of their nodes."""
    marked = {rows.level[node] for node in range(len(shape.nodes)) if is_marked(shape, node)}
    return [
        _fork(shape, rows, cards, node, rows.level[node] in marked)
        for node, below in enumerate(shape.children)
        if below
    ]


def _fork(shape: Shape, rows: Rows, cards: Sequence[Card], node: int, has_marks: bool) -> Fork:
    x, bottom = rows.x[node], rows.bottoms[rows.level[node]]
    foot = (x, rows.y[node] + cards[node].height / 2)
    at = (x, bottom + (MARK_BELOW + MARK_HEIGHT if has_marks else UNMARKED))
    ends = [child for child in shape.children[node] if not _follows(rows.blocks, child)]
    branches = tuple(_branch(rows, cards, child, at) for child in ends)
    gate = shape.nodes[node].gate
    assert gate is not None, "what has parts has a gate"
    return Fork(
        node=node,
        gate=gate,
        is_marked=is_marked(shape, node),
        foot=foot,
        mark_top=(bottom if bottom - foot[1] <= MOST_ALIGNED else foot[1]) + MARK_BELOW,
        at=at,
        branches=branches,
        ways=len({rows.blocks.of[branch.child] for branch in branches}),
    )


def _follows(blocks: Blocks, child: int) -> bool:
    """Whether a node stands below another one of the same robot, which leads to it."""
    return blocks.ordered[blocks.of[child]] and blocks.above(child) is not None


def _branch(rows: Rows, cards: Sequence[Card], child: int, fork: Point) -> Branch:
    block = rows.blocks.of[child]
    rail, y = rows.rail(block), rows.y[child]
    over = (rail, rows.tops[rows.level[child]] - FRAME_PADDING)
    if not rows.blocks.hangs(block):
        return Branch(child, fork, over, None, (rail, y - cards[child].height / 2))
    above = rows.blocks.above(child)
    before = None if above is None else (rail, rows.y[above])
    return Branch(child, fork, over, (rail, y), (rows.x[child] - cards[child].width / 2, y), before)


def gaps(shape: Shape, blocks: Blocks, layout: Layout, cards: Sequence[Card], lanes: Counter[int]) -> list[float]:
    """Room below each level: for marks, edges, lanes and frames."""
    levels = max(layout.level[: len(blocks.members)]) + 1
    room, has_children = [FRAME_PADDING + 4.0] * levels, [False] * levels
    for need, level in _needs(shape, blocks, layout, cards):
        room[level], has_children[level] = max(room[level], need), True
    for level in range(levels):
        if count := lanes[level]:
            room[level] = max(room[level], lanes_from(has_children[level]) + LANE * count + 4 + FRAME_PADDING)
    return room


def _needs(shape: Shape, blocks: Blocks, layout: Layout, cards: Sequence[Card]) -> Iterator[tuple[float, int]]:
    """What each fork needs, and its level."""
    for block, below in enumerate(blocks.children):
        if below:
            node, aside = blocks.members[block][0], 0.0
            for child in below:
                rail = half_width(child, blocks, cards) if blocks.hangs(child) else 0.0
                aside = max(aside, abs(layout.x[child] - rail - layout.x[block]))
            fork = MARK_BELOW + MARK_HEIGHT if is_marked(shape, node) else UNMARKED
            drop = min(max(STEEPNESS * aside, LEAST_DROP), MOST_DROP) if aside > 1 else LEAST_DROP / 2
            yield fork + drop + FRAME_PADDING, layout.level[block]


def _path(points: Sequence[Point]) -> str:
    return "M" + " L".join(f"{n(x)} {n(y)}" for x, y in points)
