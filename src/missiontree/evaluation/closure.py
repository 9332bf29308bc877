"""What follows from an order by way of others."""

from __future__ import annotations


def closure(pairs: set[tuple[int, int]]) -> set[tuple[int, int]]:
    """The pairs, and all that follow by way of others."""
    after: dict[int, set[int]] = {}
    for first, second in pairs:
        after.setdefault(first, set()).add(second)
    closed: set[tuple[int, int]] = set()
    for start, next_ones in after.items():
        waiting, seen = list(next_ones), set(next_ones)
        while waiting:
            further = after.get(waiting.pop(), set()) - seen
            seen |= further
            waiting += further
        closed |= {(start, end) for end in seen}
    return closed
