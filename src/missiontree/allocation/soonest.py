"""
Which nodes cannot meet their deadline whatever is chosen below them, by one sweep from the leaves up.

For each node two least times are kept: when it can end, and how long it is from its start to its end. At an XOR each is the minimum
over the children; at an AND the maximum, where children that a precedence or a role puts in a row add up. Only what lies within the
node itself counts, so nothing is refused that some selection could meet by what :mod:`lateness` knows.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from missiontree.allocation.flat import Flat
from missiontree.allocation.lateness import RULE, owner, shown
from missiontree.allocation.timing import Timing
from missiontree.mission.reason import Reason, Severity

Row = tuple[int, int, int]
"""Two children of an AND of which the first ends before the second starts, and the travel between that is certain."""


@dataclass(frozen=True, slots=True)
class TooLate:
    """A node that ends too late, whatever is chosen below it, in ticks."""

    node: int
    end: int
    due_to: int
    deadline: int


def strike_late(flat: Flat, possible: list[bool]) -> list[TooLate]:
    """Take out of ``possible`` what cannot meet its deadline, and what then cannot be done. The answer lists children before parents."""
    if flat.timing is None:
        return []
    sweep = _Sweep(flat, flat.timing, possible)
    for node in range(len(flat.kind) - 1, -1, -1):
        sweep.visit(node)
    return sweep.struck


def soonest_end(flat: Flat, possible: list[bool]) -> int:
    """
    A tick before which the mission does not end, whatever is chosen; 0 where nothing is known of time.

    Parameters
    ----------
    flat
        The problem.
    possible
        Which nodes can be done; it is left as it is.
    """
    if flat.timing is None:
        return 0
    sweep = _Sweep(flat, flat.timing, list(possible), strikes=False)
    for node in range(len(flat.kind) - 1, -1, -1):
        sweep.visit(node)
    return sweep.end[0]


class _Sweep:
    """The least times of the nodes below, as far as the sweep has come."""

    def __init__(self, flat: Flat, timing: Timing, possible: list[bool], strikes: bool = True) -> None:
        self._flat, self._timing, self._possible = flat, timing, possible
        self.end, self._length = [0] * len(flat.kind), [0] * len(flat.kind)
        self._strikes = strikes
        self._filled = [False] * len(flat.kind)  # something is done there, whatever is chosen
        self._ends_with_others = _ends_with_others(flat, timing)
        self._ordered: dict[int, list[Row]] = {}
        for first, second in timing.precedence:
            if flat.parent[first] == flat.parent[second]:
                self._ordered.setdefault(flat.parent[first], []).append((first, second, 0))
        self.struck: list[TooLate] = []

    def visit(self, node: int) -> None:
        """Take up a node, of which all children were visited."""
        {"action": self._leaf, "xor": self._xor, "and": self._and}[self._flat.kind[node]](node)
        window = self._timing.windows[node]
        late = window.deadline is not None and self.end[node] > window.deadline
        if self._strikes and self._possible[node] and late:
            assert window.deadline is not None
            self._possible[node] = False
            self.struck.append(TooLate(node, self.end[node], window.due_to, window.deadline))

    def _leaf(self, leaf: int) -> None:
        self._filled[leaf] = True
        self._length[leaf] = 0 if leaf in self._ends_with_others else self._timing.length[leaf]
        self.end[leaf] = self._timing.windows[leaf].release + self._length[leaf]

    def _xor(self, node: int) -> None:
        alive = [child for child in self._flat.children[node] if self._possible[child]]
        self._possible[node] = bool(alive)
        self._filled[node] = all(self._filled[child] for child in alive)
        self.end[node] = min((self.end[child] for child in alive), default=0)
        self._length[node] = min((self._length[child] for child in alive), default=0)

    def _and(self, node: int) -> None:
        below = self._flat.children[node]
        self._possible[node] = all(self._possible[child] for child in below)
        self._filled[node] = any(self._filled[child] for child in below)
        if not self._possible[node]:
            return
        rows = [row for row in self._rows(node) if self._filled[row[0]] and self._filled[row[1]]]
        end = {child: self.end[child] for child in below}
        length = {child: self._length[child] for child in below}
        for _ in below if rows else ():
            if not self._lengthen(rows, end, length):
                break
        self.end[node] = max(end.values(), default=0)
        self._length[node] = max(length.values(), default=0)

    def _rows(self, node: int) -> Iterable[Row]:
        rows, last = list(self._ordered.get(node, ())), dict[int, int]()
        for child in self._flat.children[node]:
            role = self._flat.role[child]
            if role >= 0:
                if role in last:
                    rows.append((last[role], child, self._timing.lag[child]))
                last[role] = child
        return rows

    def _lengthen(self, rows: Iterable[Row], end: dict[int, int], length: dict[int, int]) -> bool:
        """Put every row's second behind its first; whether that changed anything."""
        changed = False
        for first, second, lag in rows:
            for times in (end, length):
                least = times[first] + lag + self._length[second]
                if least > times[second]:
                    times[second], changed = least, True
        return changed


def _ends_with_others(flat: Flat, timing: Timing) -> frozenset[int]:
    """Leaves that an until link may let end at any time."""
    ends = {first for first, _ in timing.until}
    found = set()
    for leaf in timing.open_ended if ends else ():
        node = leaf
        while node >= 0 and node not in ends:
            node = flat.parent[node]
        if node >= 0:
            found.add(leaf)
    return frozenset(found)


def reasons_of_lateness(flat: Flat, struck: Sequence[TooLate], severity: Severity) -> Iterator[Reason]:
    """The refusals in words: for each node that sets a deadline, what it takes at least; if only some ways are too long, one of them."""
    if flat.timing is None or not struck:
        return
    free = _Sweep(flat, flat.timing, [True] * len(flat.kind), strikes=False)
    for node in range(len(flat.kind) - 1, -1, -1):
        free.visit(node)
    told: set[int] = set()
    for late in reversed(struck):
        if late.due_to in told:
            continue
        told.add(late.due_to)
        due, end = shown(late.deadline), free.end[late.due_to]
        which = "whatever is chosen, it"
        if end <= late.deadline:
            end, which = late.end, f'"{_way(flat, late.node)}"'
        yield Reason(
            rule=RULE,
            severity=severity,
            message=f"{owner(flat, late.due_to)} must end by {due}, and {which} takes until {shown(end)} at least.",
            node=flat.label[late.due_to],
            found=f"{shown(end)} or later",
            needed=f"by {due}",
            hint="Move the deadline, or give the task a quicker way of being done.",
        )


def _way(flat: Flat, node: int) -> str:
    """What people call the choice that a node belongs to."""
    while flat.parent[node] >= 0 and flat.kind[flat.parent[node]] != "xor":
        node = flat.parent[node]
    return flat.label[node]
