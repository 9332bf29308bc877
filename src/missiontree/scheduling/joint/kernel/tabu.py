"""
Tabu search over machines and sequences of a flexible job shop.

An item of a critical path is taken out and put in elsewhere, on any machine able to do it. Where it may go without closing a circle, and
what the longest path through it would then be, is told by heads and tails alone (Mastrolilli and Gambardella, Journal of Scheduling 3,
2000). The way it left is tabu for as many iterations as the path has items, and a few by chance. Where nothing better is found for long,
the search goes back to the best and away from it by a few steps at random.
"""

from __future__ import annotations

from missiontree.scheduling.joint.kernel.shop import (
    BEST,
    CHANCE,
    ITERATION,
    MAKESPAN,
    SINCE,
    Shop,
    State,
    duration_of,
    keep,
    link,
    measure,
    restore,
    unlink,
)

LONG = 1 << 60
PATIENCE = 3000
STEPS = 12


def chance(state: State, below: int) -> int:
    """A whole number from 0 to ``below`` - 1 (the multiplicative generator of Lehmer with the constants of Park and Miller)."""
    drawn = state.numbers[CHANCE] * 48271 % 2147483647
    state.numbers[CHANCE] = drawn
    return int(drawn % below)


def continues(shop: Shop, state: State, item: int, length: int) -> bool:
    """Whether an item continues a critical path that is so long by now."""
    whole = length + duration_of(shop, state, item) + state.tail[item]
    return bool(state.head[item] == length and whole == state.numbers[MAKESPAN])


def critical_path(shop: Shop, state: State) -> int:
    """A path as long as the makespan, drawn by chance, without events; how many items it has."""
    makespan, count, length = state.numbers[MAKESPAN], 0, 0
    item, seen = -1, 0
    for other in range(len(state.way)):
        if state.head[other] == 0 and duration_of(shop, state, other) + state.tail[other] == makespan:
            seen += 1
            if chance(state, seen) == 0:
                item = other
    while item >= 0:
        if state.way[item] >= 0:
            state.critical[count] = item
            count += 1
        length = state.head[item] + duration_of(shop, state, item)
        follow, seen = -1, 0
        other = state.following[item]
        if other >= 0 and continues(shop, state, other, length):
            follow, seen = other, 1
        for entry in range(shop.after[item], shop.after[item + 1]):
            other = shop.afters[entry]
            if continues(shop, state, other, length):
                seen += 1
                if chance(state, seen) == 0:
                    follow = other
        item = follow
    return count


def improve(shop: Shop, state: State, iterations: int, target: int) -> int:
    """Search for so many iterations, or until the best is no longer than the target; the best makespan."""
    for _ in range(iterations):
        if state.numbers[BEST] <= target:
            break
        state.numbers[ITERATION] += 1
        state.numbers[SINCE] += 1
        if state.numbers[SINCE] % PATIENCE == 0:
            restore(state)
            measure(shop, state)
            for _ in range(STEPS):
                step(shop, state, True)
        step(shop, state, False)
        if state.numbers[MAKESPAN] < state.numbers[BEST]:
            keep(state)
            state.numbers[SINCE] = 0
    return int(state.numbers[BEST])


def step(shop: Shop, state: State, at_random: bool) -> None:
    """Make one move: the best that is not tabu, or any."""
    length = critical_path(shop, state)
    now = state.numbers[ITERATION]
    best, ties, moved, new_way, new_before = LONG, 0, -1, -1, -1
    free, any_item, any_way, any_before = 0, -1, -1, -1
    for place in range(length):
        item = state.critical[place]
        ready, rest = 0, 0
        for entry in range(shop.before[item], shop.before[item + 1]):
            other = shop.befores[entry]
            ready = max(ready, state.head[other] + duration_of(shop, state, other))
        for entry in range(shop.after[item], shop.after[item + 1]):
            other = shop.afters[entry]
            rest = max(rest, state.tail[other] + duration_of(shop, state, other))
        for way in range(shop.ways[item], shop.ways[item + 1]):
            # Those that are to stay before it, then those that are to stay after it; between them it may stand anywhere.
            early, late, number, early_at, late_at = -1, -1, 0, 0, 0
            other, before = state.first[shop.machine[way]], -1
            while other >= 0:
                if other != item:
                    number += 1
                    took = duration_of(shop, state, other)
                    if state.tail[other] + took > rest:
                        early, early_at = other, number
                    if late == -1 and state.head[other] + took > ready:
                        late, late_at = before, number - 1
                        late = late if late >= 0 else -2
                    before = other
                other = state.following[other]
            if late == -1:
                late, late_at = before, number
            elif late == -2:
                late = -1
            spot, last, at = (early, late, early_at) if early_at <= late_at else (late, early, late_at)
            while True:
                other = state.following[spot] if spot >= 0 else state.first[shop.machine[way]]
                if other == item:
                    other = state.following[item]
                same = way == state.way[item] and state.leading[item] == spot
                if not same:
                    begin, left = ready, rest
                    if spot >= 0:
                        begin = max(begin, state.head[spot] + duration_of(shop, state, spot))
                    if other >= 0:
                        left = max(left, state.tail[other] + duration_of(shop, state, other))
                    through = begin + shop.length[way] + left
                    free += 1
                    if chance(state, free) == 0:
                        any_item, any_way, any_before = item, way, spot
                    if state.closed[way] <= now or through < state.numbers[BEST]:
                        if through < best:
                            best, ties, moved, new_way, new_before = through, 1, item, way, spot
                        elif through == best:
                            ties += 1
                            if chance(state, ties) == 0:
                                moved, new_way, new_before = item, way, spot
                if spot == last:
                    break
                spot = other
                at += 1
    if moved < 0 or at_random:
        moved, new_way, new_before = any_item, any_way, any_before
    if moved < 0:
        return
    old_way, old_before = state.way[moved], state.leading[moved]
    unlink(shop, state, moved)
    link(shop, state, moved, new_way, new_before)
    state.closed[old_way] = now + length + chance(state, 1 + length // 2 + shop.ways[moved + 1] - shop.ways[moved])
    if measure(shop, state) < len(state.way):  # items that take no time can hide a circle from heads and tails
        unlink(shop, state, moved)
        link(shop, state, moved, old_way, old_before)
        measure(shop, state)
