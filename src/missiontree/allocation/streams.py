"""
Best-first streams over the AND/XOR tree.

Every subtree is a stream of its ways of being done, best first, drawn only as far as somebody asks. An XOR merges the streams
of its children through a heap. An AND of two keeps a frontier of pairs: after the pair (i, j) come (i, j + 1) and, if j is 0,
(i + 1, 0); both are no better, so the frontier's best is the next. A wider AND is a balanced tree of such pairs over
neighbouring children, which leaves the order of choices as it is. No product is ever formed. The idea is that of k-best
parsing: Huang and Chiang, "Better k-best parsing", 2005, algorithm 3.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Sequence

from missiontree.allocation.flat import Flat
from missiontree.allocation.item import Item


class Stream:
    """The ways of doing a subtree; ``items`` are those drawn so far, never none. This one has no choice in it."""

    __slots__ = ("exhausted", "items")

    def __init__(self, best: Item) -> None:
        self.items: list[Item] = []
        self.exhausted = False
        self._append(best)

    def _append(self, item: Item) -> None:
        item.rank = len(self.items)
        self.items.append(item)

    def ends_before(self, rank: int) -> bool | None:
        """Whether there is no item of that rank; None if that is not known before the stream is advanced."""
        if len(self.items) > rank:
            return False
        return True if self.exhausted else None

    def wants(self) -> Stream | None:
        """A stream below that must be advanced before this one can be; None if this one can."""
        return None

    def extend(self) -> None:
        """Draw one more item, or find that there is none."""
        self.exhausted = True


class Either(Stream):
    """An XOR with several possible children."""

    __slots__ = ("_heap", "_source", "_xor")

    def __init__(self, xor: int, branches: Sequence[tuple[int, Stream]]) -> None:
        # Utility decides, then the branch; a branch never has two entries, so nothing after its position is compared.
        self._heap = [(-below.items[0].utility, place, 0, below) for place, below in branches]
        heapq.heapify(self._heap)
        self._xor = xor
        super().__init__(self._pop())

    def _pop(self) -> Item:
        self._source = heapq.heappop(self._heap)
        _, place, rank, below = self._source
        part = below.items[rank]
        return Item(part.utility, part, xor=self._xor, place=place)

    def wants(self) -> Stream | None:
        _, _, rank, below = self._source
        return below if below.ends_before(rank + 1) is None else None

    def extend(self) -> None:
        _, place, rank, below = self._source
        if not below.ends_before(rank + 1):
            heapq.heappush(self._heap, (-below.items[rank + 1].utility, place, rank + 1, below))
        if self._heap:
            self._append(self._pop())
        else:
            self.exhausted = True


class Both(Stream):
    """An AND of two neighbouring parts."""

    __slots__ = ("_frontier", "_left", "_ranks", "_right")

    def __init__(self, left: Stream, right: Stream) -> None:
        self._left, self._right = left, right
        self._frontier: list[tuple[Item, int, int]] = []
        self._ranks = (0, 0)
        super().__init__(self._pair(0, 0))

    def _pair(self, left: int, right: int) -> Item:
        first, second = self._left.items[left], self._right.items[right]
        return Item(first.utility + second.utility, first, second)

    def wants(self) -> Stream | None:
        left, right = self._ranks
        if self._right.ends_before(right + 1) is None:
            return self._right
        if right == 0 and self._left.ends_before(left + 1) is None:
            return self._left
        return None

    def extend(self) -> None:
        left, right = self._ranks
        if not self._right.ends_before(right + 1):
            heapq.heappush(self._frontier, (self._pair(left, right + 1), left, right + 1))
        if right == 0 and not self._left.ends_before(left + 1):
            heapq.heappush(self._frontier, (self._pair(left + 1, 0), left + 1, 0))
        if self._frontier:
            item, *ranks = heapq.heappop(self._frontier)
            self._ranks = (ranks[0], ranks[1])
            self._append(item)
        else:
            self.exhausted = True


def advance(stream: Stream) -> None:
    """Draw one more item of a stream, after whatever it needs from the streams below it."""
    waiting = [stream]
    while waiting:
        below = waiting[-1].wants()
        if below is not None:
            waiting.append(below)
        else:
            waiting.pop().extend()


def stream_of(flat: Flat, possible: Sequence[bool]) -> Stream | None:
    """The stream of the whole tree; None if it cannot be done. Settled subtrees shrink to one number on the way."""
    streams: dict[int, Stream] = {}
    for node in range(len(flat.kind) - 1, -1, -1):
        if not possible[node]:
            for child in flat.children[node]:
                streams.pop(child, None)
        elif flat.kind[node] == "action":
            streams[node] = Stream(Item(flat.utility[node]))
        elif flat.kind[node] == "and":
            streams[node] = _all_of([streams.pop(child) for child in flat.children[node]])
        else:
            below = [(place, streams.pop(child)) for place, child in enumerate(flat.children[node]) if possible[child]]
            streams[node] = below[0][1] if len(below) == 1 else Either(node, below)
    return streams.get(0)


def _all_of(parts: list[Stream]) -> Stream:
    settled = sum(part.items[0].utility for part in parts if type(part) is Stream)
    return joined(settled, [part for part in parts if type(part) is not Stream])


def joined(settled: int, parts: list[Stream]) -> Stream:
    """The stream of an AND: parts with a choice, in order, and what the rest earns."""
    level = [*parts, Stream(Item(settled))] if settled or not parts else parts
    while len(level) > 1:
        paired: list[Stream] = [Both(left, right) for left, right in zip(level[::2], level[1::2], strict=False)]
        level = paired + level[len(level) & ~1 :]
    return level[0]


def best_first(stream: Stream) -> Iterator[Item]:
    """All items of a stream, best first."""
    rank = 0
    while True:
        if rank == len(stream.items):
            advance(stream)
        if stream.ends_before(rank):
            return
        yield stream.items[rank]
        rank += 1
