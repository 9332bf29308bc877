"""Branch and bound: one option of a pick first, the others later, and prices at every node."""

from __future__ import annotations

from missiontree.allocation.kernel.columns import (
    ACTIVE,
    BACKTRACK,
    BOUND,
    CANDIDATE,
    DEPTH,
    EVALUATE,
    FINISHED,
    HALF_NEG,
    LAST,
    LEVEL,
    MET,
    NEG,
    NODES,
    PAUSED,
    PHASE,
    PICK,
    SHRINK,
    TOPS,
    TOUCHED,
    TRAIL,
    Room,
    Tree,
)
from missiontree.allocation.kernel.finishing import may_hold
from missiontree.allocation.kernel.mending import forget, weigh
from missiontree.allocation.kernel.pricing import fits, follow, lower, reach, shrink, tell, walk, walk_open


def starve(tree: Tree, room: Room) -> bool:
    """
    Take away every option that leaves too little in a purse, whatever else is chosen; whether any way is left.

    Prices find that out, too, but only step by step; where many ways are equal that is too slow.
    """
    kind, first, below = tree.kind, tree.first, tree.below
    use_first, use_purse, use_amount = tree.use_first, tree.use_purse, tree.use_amount
    alive, least, outside, active, trail = room.alive, room.most, room.outside, room.active, room.trail
    count, tops = room.numbers[ACTIVE], room.numbers[TOPS]
    for purse in range(len(tree.limits)):
        for place in range(count):
            part = active[place]
            if kind[part] == PICK:
                needed = -NEG
                for edge in range(first[part], first[part + 1]):
                    if alive[edge]:
                        needed = min(needed, least[below[edge]])
            else:
                needed = 0
                for entry in range(use_first[part], use_first[part + 1]):
                    if use_purse[entry] == purse:
                        needed += use_amount[entry]
                for edge in range(first[part], first[part + 1]):
                    if least[below[edge]] > -HALF_NEG:
                        needed = -NEG
                        break
                    needed += least[below[edge]]
            least[part] = needed
            outside[part] = -NEG
        whole = room.base_used[purse]
        for place in range(tops):
            if least[room.tops[place]] > -HALF_NEG:
                return False
            whole += least[room.tops[place]]
        if whole > tree.limits[purse]:
            return False
        for place in range(tops):
            outside[room.tops[place]] = whole - least[room.tops[place]]
        for place in range(count - 1, -1, -1):
            part = active[place]
            rest = outside[part]
            if rest > -HALF_NEG:
                continue
            for edge in range(first[part], first[part + 1]):
                child = below[edge]
                if kind[part] != PICK:
                    outside[child] = rest + least[part] - least[child]
                elif alive[edge]:
                    if least[child] > -HALF_NEG or rest + least[child] > tree.limits[purse]:
                        alive[edge] = 0
                        trail[room.numbers[TRAIL]] = edge
                        room.numbers[TRAIL] += 1
                    else:
                        outside[child] = rest
    return True


def swing(tree: Tree, room: Room, one: int, other: int) -> int:
    """How much the prices of what two parts use, each done its best way, differ, purse by purse."""
    weigh(tree, room, one, 1)
    weigh(tree, room, other, -1)
    total = 0
    for place in range(room.numbers[TOUCHED]):
        purse = room.touched[place]
        total += abs(room.drift[purse]) * room.prices[purse]
    forget(room)
    return total


def open_pick(tree: Tree, room: Room, slack: int, in_order: bool) -> int:
    """
    The pick on the best way to branch on; -1 if there is no other way.

    In order: the first in the order of choices. Else the one whose two best options differ most in what they use for what they differ
    in worth: there the prices say least, and a decision tells most.
    """
    first, below = tree.first, tree.below
    alive, most, taken, way = room.alive, room.most, room.taken, room.way
    chosen, best = -1, -1.0
    for place in range(walk_open(tree, room)):
        part = way[place]
        if tree.kind[part] != PICK:
            continue
        second, at = NEG, -1
        for edge in range(first[part], first[part + 1]):
            if alive[edge] and edge != taken[part] and (at < 0 or most[below[edge]] > second):
                second = most[below[edge]]
                at = edge
        if at < 0:
            continue
        if in_order:
            score = float(tree.priority[part])
        else:
            moved = swing(tree, room, below[taken[part]], below[at])
            score = float(moved)
        if score > best:
            best = score
            chosen = part
    return chosen


def is_news(tree: Tree, room: Room) -> bool:
    """Whether the candidate was not told before, as far as that is remembered."""
    way, remembered = room.way, room.remembered
    mixed = 0
    way[0] = len(tree.kind) - 1
    for place in range(walk(tree, room.candidate, way, 1)):
        if tree.kind[way[place]] == PICK:
            mixed ^= tree.marks[room.candidate[way[place]]]
    slot = mixed % len(remembered)
    if remembered[slot] == mixed:
        return False
    remembered[slot] = mixed
    return True


def descend(tree: Tree, room: Room, part: int, bound: int, in_order: bool) -> None:
    """Open a frame: one option of the pick first, the others later."""
    first, alive, prices, trail, numbers = tree.first, room.alive, room.prices, room.trail, room.numbers
    edge = room.taken[part]
    if in_order:
        edge = first[part]
        while not alive[edge]:
            edge += 1
    depth, purses = numbers[DEPTH], len(prices)
    room.frame_edge[depth] = edge
    room.frame_open[depth] = 1
    room.frame_trail[depth] = numbers[TRAIL]
    room.frame_bound[depth] = bound
    room.frame_level[depth] = numbers[LEVEL]
    for purse in range(purses):
        room.frame_prices[depth * purses + purse] = prices[purse]
    numbers[DEPTH] = depth + 1
    for other in range(first[part], first[part + 1]):
        if alive[other] and other != edge:
            alive[other] = 0
            trail[numbers[TRAIL]] = other
            numbers[TRAIL] += 1


def retreat(room: Room, target: int) -> bool:
    """Go back to the nearest frame whose other options may reach the target, and take these up; whether there is one."""
    alive, prices, trail, numbers = room.alive, room.prices, room.trail, room.numbers
    purses = len(prices)
    while numbers[DEPTH]:
        depth = numbers[DEPTH] - 1
        while numbers[TRAIL] > room.frame_trail[depth]:
            numbers[TRAIL] -= 1
            alive[trail[numbers[TRAIL]]] = 1
        if room.frame_open[depth] and room.frame_bound[depth] >= target:
            room.frame_open[depth] = 0
            numbers[LEVEL] = room.frame_level[depth]
            alive[room.frame_edge[depth]] = 0
            trail[numbers[TRAIL]] = room.frame_edge[depth]
            numbers[TRAIL] += 1
            for purse in range(purses):
                prices[purse] = room.frame_prices[depth * purses + purse]
            return True
        numbers[DEPTH] = depth
    return False


def open_bound(room: Room) -> int:
    """No way in a corner that is still to be searched has more scaled utility; ``NEG`` if none is left."""
    numbers = room.numbers
    bound = NEG
    for depth in range(numbers[DEPTH]):
        if room.frame_open[depth] and room.frame_bound[depth] > bound:
            bound = room.frame_bound[depth]
    if numbers[PHASE] != BACKTRACK and numbers[DEPTH]:
        bound = max(bound, room.frame_bound[numbers[DEPTH] - 1])
    return bound


def branch(tree: Tree, room: Room, target: int, steps: int, in_order: bool, nodes: int) -> int:
    """
    Go on with the search until there is something to tell.

    Parameters
    ----------
    tree, room
        The problem, and the search so far.
    target
        Ways with less scaled utility are of no interest; it may rise from call to call.
    steps
        Steps of prices at each node.
    in_order
        Whether ways are to be found in the order of choices; then only the last ones are told.
    nodes
        How many nodes to look at before pausing.

    Returns
    -------
    int
        ``FINISHED``; ``MET``, a way that keeps the purses, in ``candidate``; ``LAST``, the same, and the only one in a corner of the
        search that is done with; ``PAUSED``.
    """
    numbers = room.numbers
    until = numbers[NODES] + nodes
    while True:
        if numbers[PHASE] == EVALUATE:
            if numbers[NODES] >= until:
                return PAUSED
            numbers[NODES] += 1
            reach(tree, room)
            if in_order and not starve(tree, room):
                numbers[PHASE] = BACKTRACK
                continue
            bound, found = lower(tree, room, steps, target, 0.0, False)
            numbers[BOUND] = bound
            if bound < target:
                numbers[PHASE] = BACKTRACK
            else:
                numbers[PHASE] = SHRINK
                if found >= target and not in_order and is_news(tree, room):
                    numbers[CANDIDATE] = found
                    return MET
        if numbers[PHASE] == SHRINK:
            numbers[PHASE] = BACKTRACK
            tight = shrink(tree, room, target)
            bound = min(tight, numbers[BOUND])
            if bound >= target and may_hold(tree, room, tight - target):
                part = open_pick(tree, room, (bound - target) // 2, in_order)
                if part >= 0:
                    descend(tree, room, part, bound, in_order)
                    numbers[PHASE] = EVALUATE
                    continue
                found = follow(tree, room)
                if found >= target and fits(tree, room):
                    tell(tree, room)
                    numbers[CANDIDATE] = found
                    return LAST
        if numbers[PHASE] == BACKTRACK:
            if not retreat(room, target):
                return FINISHED
            numbers[PHASE] = EVALUATE
