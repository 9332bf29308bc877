"""
The ways of doing the mission within all purses, best first, drawn from the states of its parts.

Every part in every state is a stream. A pick merges its options through a heap, a pair keeps a frontier of ranks for every two
states that make up its own: the lazy k-best of Huang and Chiang, "Better k-best parsing", 2005, algorithm 3. Since worths are
unique, the heaps never compare anything else, and since :mod:`states` knows the best worth everywhere, a stream is made only
when somebody asks for it.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator

from missiontree.allocation.core import Way
from missiontree.allocation.states import Tables


class StateStream:
    """
    The ways of doing one part with just one state of use, best first.

    An entry is (-worth, first state, rank, second state, rank) for a pair and (-worth, option, rank, state, 0) for a pick, so
    that a heap has the best on top.
    """

    __slots__ = ("_drawer", "_heap", "_open", "entries", "exhausted", "part", "state")

    def __init__(self, drawer: Drawer, part: int, state: int) -> None:
        self._drawer, self.part, self.state = drawer, part, state
        self.entries: list[tuple[int, int, int, int, int]] = []
        self._heap = drawer.first_entries(part, state)
        heapq.heapify(self._heap)
        self._open = False  # whether what follows the last entry must still be put into the heap
        self.exhausted = False

    def ends_before(self, rank: int) -> bool | None:
        """Whether there is no entry of that rank; None if that is not known before the stream is advanced."""
        if len(self.entries) > rank:
            return False
        return True if self.exhausted else None

    def wants(self) -> StateStream | None:
        """A stream below that must be advanced before this one can be; None if this one can."""
        if self._open:
            for below, rank in self._drawer.after(self):
                if below.ends_before(rank) is None:
                    return below
        return None

    def extend(self) -> None:
        """Draw one more entry, or find that there is none."""
        if self._open:
            for entry in self._drawer.next_entries(self):
                heapq.heappush(self._heap, entry)
        self._open = bool(self._heap)
        if self._heap:
            self.entries.append(heapq.heappop(self._heap))
        else:
            self.exhausted = True


class Drawer:
    """Makes and keeps the streams of one problem."""

    def __init__(self, tables: Tables) -> None:
        self._tables, self._core = tables.tables, tables.problem.core
        self._problem, self._least = tables.problem, tables.least
        self._streams: dict[tuple[int, int], StateStream] = {}

    def stream(self, part: int, state: int) -> StateStream:
        """The stream of a part in a state."""
        if (part, state) not in self._streams:
            self._streams[part, state] = StateStream(self, part, state)
        return self._streams[part, state]

    def first_entries(self, part: int, state: int) -> list[tuple[int, int, int, int, int]]:
        """The best of every two states that make up the state, or of every option that has it."""
        pair = self._core.pair[part]
        if pair is not None:
            first, second = self._tables[pair[0]], self._tables[pair[1]]
            if len(first) < len(second):
                found = [
                    (-worth - second[state - one], one, 0, state - one, 0)
                    for one, worth in first.items()
                    if state - one in second
                ]
            else:
                found = [
                    (-worth - first[state - two], state - two, 0, two, 0)
                    for two, worth in second.items()
                    if state - two in first
                ]
        else:
            offsets = self._problem.order.offsets
            found = [
                (offsets[option.child] - self._tables[option.part][state], index, 0, state, 0)
                for index, option in enumerate(self._core.options[part])
                if state in self._tables[option.part]
            ]
            if not self._core.options[part]:
                return [(-self._tables[part][state], 0, 0, 0, 0)]
        return [entry for entry in found if self._wanted(part, -entry[0])]

    def _wanted(self, part: int, worth: int) -> bool:
        return self._least is None or worth >= self._least[part]

    def after(self, stream: StateStream) -> list[tuple[StateStream, int]]:
        """Which ranks of which streams below follow the last entry."""
        _, one, rank, two, other_rank = stream.entries[-1]
        pair = self._core.pair[stream.part]
        if pair is None:
            options = self._core.options[stream.part]
            return [(self.stream(options[one].part, two), rank + 1)] if options else []
        following = [(self.stream(pair[1], two), other_rank + 1)]
        if other_rank == 0:
            following.append((self.stream(pair[0], one), rank + 1))
        return following

    def next_entries(self, stream: StateStream) -> Iterator[tuple[int, int, int, int, int]]:
        """The entries that follow the last one."""
        _, one, rank, two, _ = stream.entries[-1]
        pair = self._core.pair[stream.part]
        for below, next_rank in self.after(stream):
            if below.ends_before(next_rank):
                continue
            negative = below.entries[next_rank][0]
            if pair is None:
                option = self._core.options[stream.part][one]
                entry = (negative + self._problem.order.offsets[option.child], one, next_rank, two, 0)
            elif below.part == pair[1]:
                entry = (negative + self._worth(pair[0], one, rank), one, rank, two, next_rank)
            else:
                entry = (negative + self._worth(pair[1], two, 0), one, next_rank, two, 0)
            if self._wanted(stream.part, -entry[0]):
                yield entry

    def _worth(self, part: int, state: int, rank: int) -> int:
        """The negative worth; rank 0 is known without a stream."""
        return -self._tables[part][state] if rank == 0 else self.stream(part, state).entries[rank][0]

    def way(self, stream: StateStream, rank: int) -> Way:
        """The options taken by an entry of a stream."""
        way, stack = Way(), [(stream, rank)]
        while stack:
            current, at = stack.pop()
            if not current.entries:
                current.extend()  # its best, which wants nothing from below
            _, one, first_rank, two, second_rank = current.entries[at]
            pair, options = self._core.pair[current.part], self._core.options[current.part]
            if pair is not None:
                stack += [(self.stream(pair[0], one), first_rank), (self.stream(pair[1], two), second_rank)]
            elif options:
                way[current.part] = one
                stack.append((self.stream(options[one].part, two), first_rank))
        return way


def advance(stream: StateStream) -> None:
    """Draw one more entry of a stream, after whatever it needs from the streams below it."""
    waiting = [stream]
    while waiting:
        below = waiting[-1].wants()
        if below is not None:
            waiting.append(below)
        else:
            waiting.pop().extend()


def best_first(tables: Tables) -> Iterator[tuple[int, Way]]:
    """
    All whole ways within the purses, best first, each with its score.

    Where a utility was wanted, all that reach it come; some that miss it may come, too.
    """
    drawer, problem = Drawer(tables), tables.problem
    top = len(problem.core) - 1
    # scores are unique, so the heap compares nothing else
    heap = [(-problem.score(state, worth), state, 0) for state, worth in tables.tables[top].items()]
    heapq.heapify(heap)
    while heap:
        negative, state, rank = heapq.heappop(heap)
        stream = drawer.stream(top, state)
        if not stream.entries:
            advance(stream)
        yield -negative, drawer.way(stream, rank)
        if stream.ends_before(rank + 1) is None:
            advance(stream)
        if not stream.ends_before(rank + 1):
            worth = -stream.entries[rank + 1][0]
            heapq.heappush(heap, (-problem.score(state, worth), state, rank + 1))
