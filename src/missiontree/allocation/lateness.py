"""
Can a selection meet its deadlines, as far as that can be told without a schedule?

Every action takes its least time, an approach none, and robots are not scarce: what remains is the critical path. Actions of a role
follow each other, a precedence orders all below one node before all below another, joint actions start and end together, what lasts
until another node ends does not end before it, and nothing starts before its release time. The earliest end of an action by all that
is a lower bound of its end in any schedule, so that a selection refused for it has none.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Sequence
from dataclasses import dataclass, field

from missiontree.allocation.flat import Flat
from missiontree.allocation.selection import Selection
from missiontree.allocation.timing import Timing
from missiontree.mission.reason import Reason
from missiontree.mission.ticks import seconds

RULE = "deadline_missed"
NEVER = 1 << 62
"""A tick that never comes."""
_MOST_NAMED = 6

Arc = tuple[int, int]
"""A later event and the least time until then."""


def late(flat: Flat, selection: Selection) -> Reason | None:
    """Why a selection misses a deadline in every schedule; None if nothing shows that. The worst is told."""
    timing = flat.timing
    if timing is None:
        return None
    events = _events(flat, timing, selection)
    heads = events.heads()
    worst, by = -1, 0
    for leaf in selection.leaves:
        deadline = timing.windows[leaf].deadline
        if deadline is not None and heads[events.end[leaf]] - deadline > by:
            worst, by = leaf, heads[events.end[leaf]] - deadline
    if worst < 0:
        return None
    end = heads[events.end[worst]]
    chain = events.chain(heads, worst) if end < NEVER else None
    return _reason(flat, timing, worst, end, chain)


@dataclass(slots=True)
class _Events:
    """Starts and ends of what is selected, and what comes how long after what."""

    release: list[int] = field(default_factory=list)
    after: list[list[Arc]] = field(default_factory=list)
    start: dict[int, int] = field(default_factory=dict)
    end: dict[int, int] = field(default_factory=dict)
    leaf_of_end: dict[int, int] = field(default_factory=dict)

    def new(self, release: int = 0) -> int:
        self.release.append(release)
        self.after.append([])
        return len(self.after) - 1

    def heads(self) -> list[int]:
        """Earliest time of each event; what waits for itself, and so never comes, is put at ``NEVER``."""
        heads = list(self.release)
        missing = Counter(later for arcs in self.after for later, _ in arcs)
        ready = [event for event in range(len(heads)) if not missing[event]]
        for event in ready:
            for later, weight in self.after[event]:
                heads[later] = max(heads[later], heads[event] + weight)
                missing[later] -= 1
                if not missing[later]:
                    ready.append(later)
        if len(ready) < len(heads):
            self._settle(heads)
        return heads

    def _settle(self, heads: list[int]) -> None:
        """Relax again and again; whatever still rises after as many rounds as there are events rises for ever."""
        for number in range(2 * len(heads) + 2):
            risen = False
            for event, arcs in enumerate(self.after):
                for later, weight in arcs:
                    least = min(heads[event] + weight, NEVER)
                    if heads[later] < least:
                        heads[later], risen = least if number <= len(heads) else NEVER, True
            if not risen:
                return

    def chain(self, heads: list[int], leaf: int) -> list[int]:
        """Leaves that end one after the other, each as soon as the one before lets it, up to the given one."""
        before: dict[int, list[Arc]] = {}
        for event, arcs in enumerate(self.after):
            for later, weight in arcs:
                before.setdefault(later, []).append((event, weight))
        event, links = self.end[leaf], [leaf]
        while True:
            held_up = (one for one, weight in before.get(event, ()) if heads[one] + weight == heads[event])
            earlier = min(held_up, default=None)
            if earlier is None or not heads[earlier]:
                return links[::-1]
            event = earlier
            if event in self.leaf_of_end:
                links.append(self.leaf_of_end[event])


def _events(flat: Flat, timing: Timing, selection: Selection) -> _Events:
    events, bound = _Events(), _Bound(flat, selection)
    stretched = _stretched(timing, bound)
    _add_actions(events, flat, timing, selection, stretched)
    for first, second in timing.precedence:
        if first in bound and second in bound:
            gate = events.new()
            for leaf in bound.leaves(first):
                events.after[events.end[leaf]].append((gate, 0))
            events.after[gate] += [(events.start[leaf], 0) for leaf in bound.leaves(second)]
    for leaf, others in stretched.items():
        for one in (one for second in others for one in bound.leaves(second)):
            events.after[events.end[one]].append((events.end[leaf], 0))
    return events


def _stretched(timing: Timing, bound: _Bound) -> dict[int, list[int]]:
    """Leaves that last until others end, with the nodes that those are."""
    stretched: dict[int, list[int]] = {}
    for first, second in timing.until:
        if first in bound and second in bound and bound.leaves(second):
            for leaf in timing.open_ended.intersection(bound.leaves(first)):
                stretched.setdefault(leaf, []).append(second)
    return stretched


def _add_actions(events: _Events, flat: Flat, timing: Timing, selection: Selection, stretched: Container[int]) -> None:
    joint: dict[object, int] = {}
    for leaf in selection.leaves:
        key = ("joint", timing.sync[leaf]) if leaf in timing.sync else ("alone", leaf)
        if key not in joint:
            joint[key] = events.new()
            events.leaf_of_end[events.new()] = leaf
        start = events.start[leaf] = joint[key]
        end = events.end[leaf] = start + 1
        events.release[start] = max(events.release[start], timing.windows[leaf].release)
        events.after[start].append((end, 0 if leaf in stretched else timing.length[leaf]))
    last: dict[int, int] = {}
    for leaf in selection.leaves:
        role = flat.role[leaf]
        if role in last:
            events.after[events.end[last[role]]].append((events.start[leaf], timing.lag[leaf]))
        last[role] = leaf


class _Bound:
    """Selected nodes and the selected leaves below them, which stand together in preorder."""

    def __init__(self, flat: Flat, selection: Selection) -> None:
        self._nodes = selection.nodes
        self._place = {node: place for place, node in enumerate(selection.nodes)}
        self._leaves = frozenset(selection.leaves)
        self._size: dict[int, int] = {}
        self._parent = flat.parent

    def __contains__(self, node: int) -> bool:
        return node in self._place

    def leaves(self, node: int) -> list[int]:
        if not self._size:
            self._size = dict.fromkeys(self._nodes, 1)
            for below in reversed(self._nodes[1:]):
                self._size[self._parent[below]] += self._size[below]
        place = self._place[node]
        return [one for one in self._nodes[place : place + self._size[node]] if one in self._leaves]


def _reason(flat: Flat, timing: Timing, leaf: int, end: int, chain: Sequence[int] | None) -> Reason:
    window = timing.windows[leaf]
    assert window.deadline is not None
    due = shown(window.deadline)
    if chain is None:
        takes, found = "what it waits for waits for it", "never"
    else:
        links = [f"{flat.label[leaf]!r} {shown(timing.lag[leaf] + timing.length[leaf])}" for leaf in chain]
        if len(links) > _MOST_NAMED:
            half = _MOST_NAMED // 2
            links[half:-half] = [f"{len(links) - 2 * half} more"]
        begin = max(timing.windows[chain[0]].release, 0)
        links[:0] = [f"nothing before {shown(begin)}"] if begin else []
        takes, found = f"it takes until {shown(end)} at least: {', then '.join(links)}", f"{shown(end)} or later"
    return Reason(
        rule=RULE,
        message=f"{owner(flat, window.due_to)} must end by {due}, and {takes}.",
        node=flat.label[window.due_to],
        found=found,
        needed=f"by {due}",
        hint="Move the deadline, or give the task a quicker way of being done.",
    )


def owner(flat: Flat, node: int) -> str:
    """A node with a deadline, as people call it."""
    return "The mission" if node == 0 else f'"{flat.label[node]}"'


def shown(count: int) -> str:
    """Ticks as people read them: ``12.5 s``."""
    return f"{seconds(count):g} s"
