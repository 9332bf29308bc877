"""
A shop as columns of integers, and the longest paths through it as its machines are sequenced now.

Items are actions with ways (a machine and a duration each), or mere events without. *Head*: longest path before an item; *tail*: after.
"""

from __future__ import annotations

from typing import Any, NamedTuple

MAKESPAN, BEST, CHANCE, ITERATION, SINCE = range(5)
"""Places in ``numbers``: makespan now, best ever, state of the random numbers, iterations, and those since the best."""


class Shop(NamedTuple):
    """
    What does not change.

    Attributes
    ----------
    ways
        First way of each item; one more at the end. Items without any are events.
    machine, length
        Of each way.
    after, afters, before, befores
        Items that start after each item ended, and items that end before it starts: first entry of each item, and the entries.
    """

    ways: Any
    machine: Any
    length: Any
    after: Any
    afters: Any
    before: Any
    befores: Any


class State(NamedTuple):
    """
    What does.

    Attributes
    ----------
    way
        Way taken by each item; -1 for an event.
    following, leading
        Next and previous item on the machine; -1 if none.
    first
        First item of each machine; -1 if none.
    head, tail, order, waiting
        Longest paths, an order of the items that keeps all arcs, and room to find it in.
    closed
        Iteration until which each way is tabu.
    best_way, best_following, best_first
        The best sequences ever.
    critical
        Room for the items of a critical path.
    numbers
        See ``MAKESPAN`` and so on.
    """

    way: Any
    following: Any
    leading: Any
    first: Any
    head: Any
    tail: Any
    order: Any
    waiting: Any
    closed: Any
    best_way: Any
    best_following: Any
    best_first: Any
    critical: Any
    numbers: Any


def duration_of(shop: Shop, state: State, item: int) -> int:
    """How long an item takes as things stand."""
    way = state.way[item]
    return shop.length[way] if way >= 0 else 0


def measure(shop: Shop, state: State) -> int:
    """Compute all heads and tails; how many items were reached, which is fewer than there are if the arcs run in a circle."""
    items = len(state.way)
    order, waiting, head, tail = state.order, state.waiting, state.head, state.tail
    count = 0
    for item in range(items):
        waiting[item] = shop.before[item + 1] - shop.before[item]
        if state.leading[item] >= 0:
            waiting[item] += 1
        head[item] = 0
        tail[item] = 0
        if waiting[item] == 0:
            order[count] = item
            count += 1
    reached, makespan = 0, 0
    while reached < count:
        item = order[reached]
        reached += 1
        end = head[item] + duration_of(shop, state, item)
        makespan = max(makespan, end)
        for entry in range(shop.after[item], shop.after[item + 1]):
            other = shop.afters[entry]
            head[other] = max(head[other], end)
            waiting[other] -= 1
            if waiting[other] == 0:
                order[count] = other
                count += 1
        other = state.following[item]
        if other >= 0:
            head[other] = max(head[other], end)
            waiting[other] -= 1
            if waiting[other] == 0:
                order[count] = other
                count += 1
    for place in range(reached - 1, -1, -1):
        item = order[place]
        longest = 0
        for entry in range(shop.after[item], shop.after[item + 1]):
            other = shop.afters[entry]
            longest = max(longest, tail[other] + duration_of(shop, state, other))
        other = state.following[item]
        if other >= 0:
            longest = max(longest, tail[other] + duration_of(shop, state, other))
        tail[item] = longest
    state.numbers[MAKESPAN] = makespan
    return reached


def unlink(shop: Shop, state: State, item: int) -> None:
    """Take an item off its machine."""
    before, after = state.leading[item], state.following[item]
    if before >= 0:
        state.following[before] = after
    else:
        state.first[shop.machine[state.way[item]]] = after
    if after >= 0:
        state.leading[after] = before
    state.leading[item] = -1
    state.following[item] = -1


def link(shop: Shop, state: State, item: int, way: int, before: int) -> None:
    """Put an item on the machine of a way, right after ``before`` (-1: as its first)."""
    machine = shop.machine[way]
    after = state.following[before] if before >= 0 else state.first[machine]
    if before >= 0:
        state.following[before] = item
    else:
        state.first[machine] = item
    state.leading[item] = before
    state.following[item] = after
    if after >= 0:
        state.leading[after] = item
    state.way[item] = way


def keep(state: State) -> None:
    """Remember the sequences as the best."""
    for item in range(len(state.way)):
        state.best_way[item] = state.way[item]
        state.best_following[item] = state.following[item]
    for machine in range(len(state.first)):
        state.best_first[machine] = state.first[machine]
    state.numbers[BEST] = state.numbers[MAKESPAN]


def restore(state: State) -> None:
    """Go back to the best sequences."""
    for item in range(len(state.way)):
        state.way[item] = state.best_way[item]
        state.following[item] = state.best_following[item]
        state.leading[item] = -1
    for item in range(len(state.way)):
        if state.following[item] >= 0:
            state.leading[state.following[item]] = item
    for machine in range(len(state.first)):
        state.first[machine] = state.best_first[machine]
