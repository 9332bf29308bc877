"""
Where the nodes of a drawn tree stand: a tidy layout.

Nodes of one depth share a level; siblings keep their order; parents stand over the middle between their first and last child;
boxes of one level do not overlap; equal subtrees look equal wherever they stand. These are the rules of Wetherell and Shannon
(1979) and of Reingold and Tilford (1981), for boxes of any width. A small subtree between large ones stands in the middle
of the room it has: children are packed once to the left and once to the right, and the mean of both is taken, which keeps every
distance that both keep.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass

Children = Sequence[Sequence[int]]


@dataclass(frozen=True, slots=True)
class Layout:
    """
    A laid out tree.

    Parameters
    ----------
    x
        Middle of every node, the leftmost edge of all at 0.
    level
        Depth of every node, the root's is 0.
    width
        From the leftmost edge to the rightmost.
    spans
        Left and right edge of the subtree below and including each framed node, padding included.
    """

    x: tuple[float, ...]
    level: tuple[int, ...]
    width: float
    spans: dict[int, tuple[float, float]]


@dataclass(slots=True)
class _Contour:
    """
    Outline of a subtree, relative to its root: edges per level, the deepest level first.

    Every entry counts from ``shift``, so that a whole outline moves in one step.
    """

    left: list[float]
    right: list[float]
    shift: float = 0.0

    @property
    def height(self) -> int:
        return len(self.left)

    def lefts(self, levels: int) -> list[float]:
        """Left edges of the upper levels, from the root down."""
        return [self.shift + edge for edge in self.left[: -levels - 1 : -1]]

    def rights(self, levels: int) -> list[float]:
        """Right edges of the upper levels, from the root down."""
        return [self.shift + edge for edge in self.right[: -levels - 1 : -1]]


def tidy_layout(
    children: Children,
    widths: Sequence[float],
    gap: float,
    framed: Collection[int] = (),
    padding: float = 0.0,
    straight: float = 0.0,
) -> Layout:
    """
    Lay a tree out, in time and memory linear in its nodes.

    Outlines are merged small into large: laying out the children of a node costs as much as all of them but the tallest are high,
    and those heights add up to at most the number of nodes. Frames cost as much again as they are high.

    Parameters
    ----------
    children
        Children of each node, in order. Node 0 is the root, parents come before children.
    widths
        Width of each node.
    gap
        Room between neighbours on a level, at least 0.
    framed
        Nodes whose subtrees are kept apart from everything else as whole rectangles; none within another.
    padding
        Room between a framed subtree and its frame.
    straight
        A child that would stand no further from below its parent than this stands exactly below it, for an edge without a kink;
        those at the nearer side give way. Default 0: none.
    """
    contours: dict[int, _Contour] = {}
    offsets = [0.0] * len(widths)
    spans: dict[int, tuple[float, float]] = {}
    inside = frozenset(framed)
    for node in reversed(range(len(widths))):
        below = children[node]
        for child, offset in zip(below, _spread([contours[child] for child in below], gap, straight), strict=True):
            offsets[child] = offset
        contour = _merged([(contours.pop(child), offsets[child]) for child in below])
        contour.left.append(-widths[node] / 2 - contour.shift)
        contour.right.append(widths[node] / 2 - contour.shift)
        if node in inside:
            spans[node] = _frame(contour, padding)
        contours[node] = contour
    return _placed(children, offsets, contours[0], spans)


def _spread(contours: Sequence[_Contour], gap: float, straight: float) -> list[float]:
    """Where siblings stand relative to their parent."""
    if len(contours) < 2:
        return [0.0] * len(contours)
    shared = sorted(contour.height for contour in contours)[-2]  # below it no two siblings meet
    lefts = [contour.lefts(shared) for contour in contours]
    rights = [contour.rights(shared) for contour in contours]
    packed = _packed(lefts, rights, gap)
    mirrored = _packed(
        [[-edge for edge in edges] for edges in reversed(rights)],
        [[-edge for edge in edges] for edges in reversed(lefts)],
        gap,
    )
    other = [packed[-1] - place for place in reversed(mirrored)]
    places = _straightened([(one + two) / 2 for one, two in zip(packed, other, strict=True)], straight)
    middle = (places[0] + places[-1]) / 2
    return [place - middle for place in places]


def _straightened(places: list[float], straight: float) -> list[float]:
    """Siblings moved outward at one side, so that one that stands nearly in the middle of all stands there."""
    middle = (places[0] + places[-1]) / 2
    inner = [(at, place - middle) for at, place in enumerate(places)][1:-1]
    near, aside = min(inner, key=lambda one: abs(one[1]), default=(0, 0.0))
    if not 0 < abs(aside) <= straight:
        return places
    if aside < 0:
        return [place + 2 * aside if at < near else place for at, place in enumerate(places)]
    return [place + 2 * aside if at > near else place for at, place in enumerate(places)]


def _packed(lefts: Sequence[Sequence[float]], rights: Sequence[Sequence[float]], gap: float) -> list[float]:
    """Places of siblings, the first at 0, each as far left as those before it let it."""
    front: list[float] = []
    places = []
    for left, right in zip(lefts, rights, strict=True):
        place = max((reached + gap - edge for reached, edge in zip(front, left, strict=False)), default=0.0)
        front[: len(right)] = [place + edge for edge in right]
        places.append(place)
    return places


def _merged(parts: Sequence[tuple[_Contour, float]]) -> _Contour:
    """One outline of several subtrees, made from that of the tallest."""
    if not parts:
        return _Contour([], [])
    for contour, offset in parts:
        contour.shift += offset
    tallest = max((contour for contour, _ in parts), key=lambda contour: contour.height)
    shared = max((contour.height for contour, _ in parts if contour is not tallest), default=0)
    lefts, rights = tallest.lefts(shared), tallest.rights(shared)
    for contour, _ in parts:
        for level, (left, right) in enumerate(zip(contour.lefts(shared), contour.rights(shared), strict=True)):
            lefts[level], rights[level] = min(lefts[level], left), max(rights[level], right)
    for level in range(shared):
        tallest.left[-1 - level] = lefts[level] - tallest.shift
        tallest.right[-1 - level] = rights[level] - tallest.shift
    return tallest


def _frame(contour: _Contour, padding: float) -> tuple[float, float]:
    """Make an outline a rectangle; its edges."""
    low, high = min(contour.left) - padding, max(contour.right) + padding
    contour.left, contour.right = [low] * contour.height, [high] * contour.height
    return low + contour.shift, high + contour.shift


def _placed(
    children: Children, offsets: Sequence[float], whole: _Contour, spans: dict[int, tuple[float, float]]
) -> Layout:
    x = [0.0] * len(offsets)
    level = [0] * len(offsets)
    edge = min(whole.left) + whole.shift
    x[0] = -edge
    for node, below in enumerate(children):
        for child in below:
            x[child] = x[node] + offsets[child]
            level[child] = level[node] + 1
    framed = {node: (x[node] + low, x[node] + high) for node, (low, high) in sorted(spans.items())}
    width = max(whole.right) + whole.shift - edge
    assert math.isfinite(width), "widths are finite"
    return Layout(tuple(x), tuple(level), width, framed)
