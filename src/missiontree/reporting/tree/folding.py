"""A tree too large to be drawn, made smaller: subtrees become one card each, the deepest first, the chosen alternative last."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from missiontree.reporting.tree.shape import Shape, ShapeNode, State

STATES: tuple[State, ...] = ("lit", "plain", "quiet")
LEAST_SHOWN = 8
"""A node shows some of its children only if it can show so many; else it is folded."""


def folded(shape: Shape, most: int) -> Shape:
    """
    The tree with at most so many nodes.

    Nodes are unfolded from the root down, a whole depth at a time, those of the chosen alternative before all others. If there is
    no room for everything beside what is chosen, one card stands for it at each choice. Where a depth has too many parts, those with
    few are unfolded; those with many show an equal number of them and a card for the rest, or stay folded if that number were
    small. Links of nodes that are not shown are left out.

    Parameters
    ----------
    shape
        The tree.
    most
        How many nodes there may be, at least 1.
    """
    if len(shape.nodes) <= most:
        return shape
    chosen = [node for node, drawn in enumerate(shape.nodes) if drawn.state == "lit"]
    is_tight = 1 + sum(len(shape.children[node]) for node in chosen) > most
    unfolding = _Unfolding(shape, most - 1)
    unfolding.unfold(lambda node: shape.nodes[node].state == "lit", is_tight)
    unfolding.unfold(lambda node: True)
    return _smaller(shape, unfolding.shown)


@dataclass(slots=True)
class _Unfolding:
    """
    A folded tree on its way to being unfolded.

    Parameters
    ----------
    shape
        The tree.
    left
        How many more nodes may be shown.
    shown
        Children shown of each unfolded node; those that are missing stand behind a card.
    """

    shape: Shape
    left: int
    shown: dict[int, tuple[int, ...]] = field(default_factory=dict)

    def unfold(self, counts: Callable[[int], bool], is_tight: bool = False) -> None:
        """
        Unfold what there is room for.

        Parameters
        ----------
        counts
            Whether a node is to be unfolded at all.
        is_tight
            Show of each node's children only the chosen ones.
        """
        depth = [0]
        while depth:
            group = [node for node in depth if node not in self.shown and self.shape.children[node] and counts(node)]
            offers = {node: self._chosen(node) if is_tight else self.shape.children[node] for node in group}
            self._unfold_depth(offers)
            for node in group if is_tight else ():  # one by one: more of what is chosen than an equal share allows
                if node not in self.shown and self._cost(node, offers[node]) <= self.left:
                    self._show(node, offers[node])
            if not is_tight and any(node not in self.shown for node in group):
                return
            depth = [child for node in depth if node in self.shown for child in self.shown[node]]

    def _unfold_depth(self, offers: Mapping[int, tuple[int, ...]]) -> None:
        """Unfold those with few children, all that have equally many or none of them; then, if shares are large enough, the others."""
        by_cost: dict[int, list[int]] = defaultdict(list)
        for node, offer in offers.items():
            by_cost[self._cost(node, offer)].append(node)
        for cost, nodes in sorted(by_cost.items()):
            if cost * len(nodes) > self.left:
                break
            for node in nodes:
                self._show(node, offers[node])
        others = [node for node in offers if node not in self.shown]
        if others and (share := self.left // len(others)) >= LEAST_SHOWN:
            for node in others:
                self._show(node, self._some(offers[node], share))

    def _cost(self, node: int, offer: tuple[int, ...]) -> int:
        """Cards that a node's children take, the one for the rest included."""
        return len(offer) + (len(offer) < len(self.shape.children[node]))

    def _show(self, node: int, offer: tuple[int, ...]) -> None:
        self.shown[node] = offer
        self.left -= self._cost(node, offer)

    def _chosen(self, node: int) -> tuple[int, ...]:
        """The children that are chosen; all of them if only one is not."""
        children = self.shape.children[node]
        chosen = tuple(child for child in children if self.shape.nodes[child].state == "lit")
        return chosen if len(chosen) + 1 < len(children) else children

    def _some(self, offer: tuple[int, ...], share: int) -> tuple[int, ...]:
        """As many as the share allows beside a card for the rest: the chosen ones first, in their order."""
        preferred = sorted(offer, key=lambda child: self.shape.nodes[child].state != "lit")[: share - 1]
        kept = frozenset(preferred)
        return tuple(child for child in offer if child in kept)


def _smaller(shape: Shape, shown: dict[int, tuple[int, ...]]) -> Shape:
    """The tree of the nodes that are shown, and of the cards that stand for the others."""
    sizes = shape.sizes
    nodes: list[ShapeNode] = []
    children: list[list[int]] = []
    number: dict[int, int] = {}  # of the nodes that are shown
    stack: list[tuple[int, tuple[int, ...]]] = [(-1, (0,))]
    while stack:
        parent, tops = stack.pop()
        first = tops[0]
        is_open = len(tops) == 1 and (first in shown or not shape.children[first])
        if parent >= 0:
            children[parent].append(len(nodes))
        if len(tops) == 1:
            number[first] = len(nodes)
        if is_open:
            stack += reversed([(len(nodes), part) for part in _parts(shape, first, shown.get(first, ()))])
            nodes.append(shape.nodes[first])
        else:
            nodes.append(_card(shape, tops, sizes))
        children.append([])
    return Shape(
        tuple(nodes),
        tuple(map(tuple, children)),
        tuple(
            (number[first], number[second], kind)
            for first, second, kind in shape.links
            if first in number and second in number
        ),
        tuple(number[node] for node in shape.frames if node in shown),
    )


def _parts(shape: Shape, node: int, shown: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
    """Children that are shown, one by one, then those that one card stands for."""
    yield from ((child,) for child in shown)
    kept = frozenset(shown)
    if rest := tuple(child for child in shape.children[node] if child not in kept):
        yield rest


def _card(shape: Shape, tops: Sequence[int], sizes: Sequence[int]) -> ShapeNode:
    """The card of a folded subtree, or of siblings that are not shown."""
    hidden = sum(sizes[node] for node in tops)
    if len(tops) == 1 and shape.children[tops[0]]:
        return replace(shape.nodes[tops[0]], gate=None, hidden=hidden - 1)
    states = {shape.nodes[node].state for node in tops}
    state = next(one for one in STATES if one in states)  # lit if any of them is
    return ShapeNode("", f"and {len(tops):,} more", "", "more", None, state=state, hidden=hidden)
