"""
The order that links and containment impose, as a graph over the starts and ends of nodes.

A node starts with its earliest selected leaf and ends with its latest, so a precedence between inner nodes reaches every leaf
below them. Events make this plain: ``start(parent) <= start(child)``, ``end(child) <= end(parent)``, ``end(a) <= start(b)`` for a
precedence or a hand-over (a, b); and for "a until b" both ``start(a) <= end(b)``, since a must be under way when b ends, and
``end(b) <= end(a)``.
A cycle among events that passes a precedence, a hand-over or an until cannot be kept.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from missiontree.mission.tree import IN_ORDER, LinkKind, MissionTree

IndexedLink = tuple[int, int, LinkKind]


def start_of(node: int) -> int:
    """Event at which a node starts."""
    return 2 * node


def end_of(node: int) -> int:
    """Event at which a node ends."""
    return 2 * node + 1


class EventGraph:
    """
    Events of all nodes, and which comes no later than which, with all nodes taken as selected.

    Parameters
    ----------
    parents
        Parent of each node by index; -1 for the root.
    links
        Links as (first, second, kind); same-robot and different-robot links impose no order.
    """

    def __init__(self, parents: Sequence[int], links: Iterable[IndexedLink] = ()) -> None:
        self.successors: list[list[int]] = [[] for _ in range(2 * len(parents))]
        for node, parent in enumerate(parents):
            self._add(start_of(node), end_of(node))
            if parent >= 0:
                self._add(start_of(parent), start_of(node))
                self._add(end_of(node), end_of(parent))
        for first, second, kind in links:
            self.add_link(first, second, kind)

    def add_link(self, first: int, second: int, kind: LinkKind = "precedence") -> None:
        """Add one link between node indices."""
        if kind in IN_ORDER:
            self._add(end_of(first), start_of(second))
        elif kind == "until":
            self._add(start_of(first), end_of(second))
            self._add(end_of(second), end_of(first))

    def _add(self, before: int, after: int) -> None:
        self.successors[before].append(after)

    def path(self, source: int, target: int) -> list[int] | None:
        """Events along some way from source to target, both included; None if there is no way."""
        came_from = {source: source}
        stack = [source]
        while stack:
            event = stack.pop()
            if event == target:
                way = [event]
                while way[-1] != source:
                    way.append(came_from[way[-1]])
                return way[::-1]
            for after in self.successors[event]:
                if after not in came_from:
                    came_from[after] = event
                    stack.append(after)
        return None

    def precedes(self, first: int, second: int) -> bool:
        """Whether the first node must end before the second starts."""
        return self.path(end_of(first), start_of(second)) is not None

    def closing_cycle(self, first: int, second: int, kind: LinkKind = "precedence") -> list[int] | None:
        """Nodes of the cycle that a further link would close, in order; None if it would close none."""
        if kind in IN_ORDER:
            way = self.path(start_of(second), end_of(first))
        elif kind == "until":
            # Either b waits for a's end, and neither could ever end; or a waits for b's end, and could not be under way by then.
            # A circle through both new orders would need a's end before a's start, and stand already.
            way = self.path(end_of(first), end_of(second)) or self.path(end_of(second), start_of(first))
        else:
            way = None
        return None if way is None else list(dict.fromkeys(event // 2 for event in way))

    def cycle(self) -> list[int] | None:
        """Nodes of some cycle, in order; None if there is none. Iterative depth-first search."""
        colour = bytearray(len(self.successors))  # 0 new, 1 on the path, 2 done
        for root in range(len(self.successors)):
            if colour[root]:
                continue
            path, cursors = [root], [0]
            colour[root] = 1
            while path:
                event = path[-1]
                if cursors[-1] == len(self.successors[event]):
                    colour[event] = 2
                    path.pop()
                    cursors.pop()
                    continue
                after = self.successors[event][cursors[-1]]
                cursors[-1] += 1
                if colour[after] == 1:
                    return list(dict.fromkeys(event // 2 for event in path[path.index(after) :]))
                if colour[after] == 0:
                    colour[after] = 1
                    path.append(after)
                    cursors.append(0)
        return None


def event_graph(tree: MissionTree) -> EventGraph:
    """The event graph of a mission tree; nodes are numbered as in ``tree.nodes``."""
    number = {node.id: index for index, node in enumerate(tree.nodes)}
    parents = [number.get(tree.parent.get(node.id, ""), -1) for node in tree.nodes]
    return EventGraph(parents, ((number[link.first], number[link.second], link.kind) for link in tree.links))
