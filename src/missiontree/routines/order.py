"""
The order among routine nodes: what is given, and what must be added since one moves an entity that another uses.

All added orders follow one line through the routine nodes that keeps every given order and, where those leave it free, the
order of the tree. So they can never close a cycle, with each other or with what is given. Nodes joined by an until link are
meant to overlap: nothing is added between them, nor between what they contain.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property

from missiontree.errors import InputError
from missiontree.mission.precedence import end_of, event_graph, start_of
from missiontree.mission.reason import Reason
from missiontree.mission.tree import Link, MissionTree
from missiontree.routines.calls import Call
from missiontree.routines.selection import CoSelection, Turns


class RoutineOrder:
    """
    The event graph of a mission tree, with the line through its routine nodes.

    Parameters
    ----------
    tree
        The mission tree.

    Raises
    ------
    InputError
        If its links contradict each other.
    """

    def __init__(self, tree: MissionTree) -> None:
        self._tree = tree
        self._graph = event_graph(tree)
        self.selection = CoSelection(tree)
        self.leaves = [index for index, node in enumerate(tree.nodes) if node.routine is not None]
        self._predecessors: list[list[int]] = [[] for _ in self._graph.successors]
        for before, successors in enumerate(self._graph.successors):
            for after in successors:
                self._predecessors[after].append(before)
        self._place = self._line()

    def _line(self) -> list[int]:
        """Place of each event on the line: first what must come before it, depth first."""
        place = [-1] * len(self._predecessors)
        open_now: set[int] = set()
        count = 0
        roots = [end_of(leaf) for leaf in self.leaves] + list(range(len(place)))
        for root in roots:
            stack = [root]
            while stack:
                event = stack[-1]
                if place[event] >= 0:
                    stack.pop()
                    continue
                waiting = [before for before in self._predecessors[event] if place[before] < 0]
                if waiting:
                    if event in open_now:
                        self._refuse_cycle()
                    open_now.add(event)
                    stack += sorted(waiting, key=lambda before: self._urgency(before, event), reverse=True)
                    continue
                place[event] = count
                count += 1
                stack.pop()
        return place

    @staticmethod
    def _urgency(before: int, event: int) -> tuple[int, int]:
        """
        What to place first of all that an event waits for. An end waits for other starts only by an until link; they come last, so
        that what lasts until another ends begins as late on the line as it may, and what that other waits for stands before it.
        """
        late = event % 2 and not before % 2
        return (1 + (before != event - 1) if late else 0), before

    def _refuse_cycle(self) -> None:
        names = [self._tree.nodes[index].id for index in self._graph.cycle() or ()]
        raise InputError(
            f"these nodes wait for each other: {' > '.join([*names, *names[:1]])}.",
            where="links",
            hint="Drop one of the links between them.",
        )

    def in_line(self, leaves: Iterable[int]) -> list[int]:
        """Leaves in the order of the line."""
        return sorted(leaves, key=lambda leaf: self._place[end_of(leaf)])

    def precedes(self, first: int, second: int) -> bool:
        """Whether the first ends before the second starts in every plan that has both; see :meth:`_reached`."""
        target = start_of(second)
        allowed = self.selection.turns[first] | self.selection.turns[second]
        if self._place[end_of(first)] > self._place[target]:
            return False
        return any(event == target for event in self._reached(end_of(first), allowed, self._graph.successors, target))

    def leaves_before(self, leaf: int) -> set[int]:
        """Nodes that end before the leaf starts and are selected whenever it is."""
        back = self._reached(start_of(leaf), self.selection.turns[leaf], self._predecessors, None)
        return {event // 2 for event in back if event % 2 and event != end_of(leaf)}

    def _reached(self, source: int, allowed: Turns, neighbours: list[list[int]], target: int | None) -> Iterator[int]:
        """Events on ways from the source, by nodes that are selected for sure; a way through others may not be there."""
        seen = {source}
        stack = [source]
        while stack:
            event = stack.pop()
            yield event
            for after in neighbours[event]:
                if after in seen or not self.selection.turns[after // 2] <= allowed:
                    continue
                if target is not None and self._place[after] > self._place[target]:
                    continue
                seen.add(after)
                stack.append(after)

    def add(self, first: int, second: int) -> bool:
        """
        Add a precedence; False, and nothing is added, if it would close a cycle.

        Along the line it never does. Against it (two that overlap on the line, since an until link is there) the line is laid anew.
        """
        along = self._place[end_of(first)] < self._place[start_of(second)]
        if not along and self._graph.closing_cycle(first, second) is not None:
            return False
        self._graph.add_link(first, second)
        self._predecessors[start_of(second)].append(end_of(first))
        if not along:
            self._place = self._line()
        return True

    def overlap(self, first: int, second: int) -> bool:
        """Whether an until link joins the two, or nodes that contain them."""
        return any(
            (one in self._above[first] and other in self._above[second])
            or (one in self._above[second] and other in self._above[first])
            for one, other in self._untils
        )

    @cached_property
    def _untils(self) -> tuple[tuple[str, str], ...]:
        return tuple((link.first, link.second) for link in self._tree.links if link.kind == "until")

    @cached_property
    def _above(self) -> dict[int, set[str]]:
        """Each routine node and all that contain it."""
        names = {leaf: self._tree.nodes[leaf].id for leaf in self.leaves}
        return {leaf: {name, *self._tree.ancestors(name)} for leaf, name in names.items()}


def order_moved(tree: MissionTree, calls: Mapping[str, Call], order: RoutineOrder) -> tuple[list[Link], list[Reason]]:
    """
    Precedences to add, so that it is always clear where an entity is that is moved; each with its notice.

    Two routine nodes are put in order if one moves an entity that the other uses, nothing orders them yet, and both can be
    selected.
    """
    users: dict[str, list[int]] = {}
    movers: dict[str, set[int]] = {}
    for leaf in order.leaves:
        touch = calls[tree.nodes[leaf].id].touch
        for entity in touch.uses:
            users.setdefault(entity, []).append(leaf)
        for entity in touch.moves:
            movers.setdefault(entity, set()).add(leaf)
    links: list[Link] = []
    notices: list[Reason] = []
    for entity, moving in movers.items():
        for earlier, later in _unordered(order.in_line(users[entity]), moving, order):
            first, second = earlier, later
            if not order.add(first, second):
                first, second = later, earlier
                if not order.add(first, second):
                    continue  # whatever comes first, until links keep both under way at once
            ends = tree.nodes[first], tree.nodes[second]
            links.append(Link(ends[0].id, ends[1].id))
            mover = ends[0] if first in moving else ends[1]
            label = next(each.label for each in calls[mover.id].entities.values() if each.id == entity)
            notices.append(
                Reason(
                    rule="order_added",
                    severity="notice",
                    message=f"{ends[0].label} is done before {ends[1].label}: {mover.label} moves {label}, which the other "
                    "uses, and nothing ordered the two.",
                    node=ends[0].id,
                    found="no order",
                    needed=f"{ends[0].id} before {ends[1].id}",
                    hint="Add a precedence of your own if the order shall be another one.",
                )
            )
    return links, notices


def _unordered(line: list[int], moving: set[int], order: RoutineOrder) -> Iterator[tuple[int, int]]:
    """Pairs to order. Going back from each user, whatever stands before a mover that is surely there is ordered by it."""
    for position, second in enumerate(line):
        for first in reversed(line[:position]):
            if first not in moving and second not in moving:
                continue
            if order.selection.exclusive(first, second):
                continue
            if order.overlap(first, second):
                continue
            ordered = order.precedes(first, second)
            if not ordered and not order.precedes(second, first):
                yield first, second
                ordered = order.precedes(first, second)
            if ordered and first in moving and order.selection.implies(second, first):
                break
