"""
The inner loops of branch and bound, in the part of Python that can be compiled: plain loops over columns of integers.

One source serves two speeds. Handed lists, these functions are the reference; handed arrays and compiled
(:mod:`missiontree.allocation.compiled`), they take the same steps on the same numbers. Whatever decides is an integer; floats only
propose the next prices, by the same operations in the same order.
"""

from __future__ import annotations

from typing import NamedTuple

SUM, PICK = 0, 1
NEG = -(1 << 62)  # no way; every real sum is far from it
HALF_NEG = -(1 << 61)
DRIFT_BITS = 20  # behind the point of a purse's drift
ROOT_IDLE = 10  # steps without progress before strides are halved, where there is no target; elsewhere 3
KEPT = 4  # eighths of the drift that each step keeps

# Places in Room.numbers, which survives from one call to the next.
PHASE, DEPTH, NODES, TRAIL, ACTIVE, BOUND, CANDIDATE, MARGIN, TOUCHED = 0, 1, 2, 3, 4, 5, 6, 7, 8
EVALUATE, SHRINK, BACKTRACK = 0, 1, 2
FINISHED, MET, LAST, PAUSED = 0, 1, 2, 3


class Tree(NamedTuple):
    """
    What is searched: columns over parts, children before parents; the last part is the whole mission.

    The children of part p are ``below[first[p]:first[p + 1]]``. Places in ``below`` are called edges; the edges of a pick are its
    options, in the order of choices.

    Parameters
    ----------
    kind
        ``SUM`` or ``PICK``; a settled part is a sum without children.
    value
        What a sum earns beside its children, in scaled utility.
    first, below
        Children.
    use_first, use_purse, use_amount
        What a sum takes from the purses beside its children: entries ``use_first[p]`` to ``use_first[p + 1]``.
    limits
        What each purse holds.
    caps
        No price is higher, so that no product of prices and amounts leaves 63 bits.
    priority
        Of each pick: the higher, the earlier in the order of choices.
    marks
        By edge, a number of 60 bits that looks random.
    """

    kind: list[int]
    value: list[int]
    first: list[int]
    below: list[int]
    use_first: list[int]
    use_purse: list[int]
    use_amount: list[int]
    limits: list[int]
    caps: list[int]
    priority: list[int]
    marks: list[int]


class Room(NamedTuple):
    """
    Where the search works; all of it is changed in place.

    Parameters
    ----------
    alive
        By edge: 1 while an option is left. 1 for all other edges.
    prices, trial
        By purse: the best prices known, and those being tried.
    most, taken
        By part: the most it earns after prices; by pick: the edge taken for it.
    candidate
        By pick: the edges of the way that is told.
    outside
        By part: the most that the rest of a way through it earns.
    seen, active, stack, other_stack, used, drift, touched, listed
        Scratch.
    frame_edge, frame_open, frame_trail, frame_bound, frame_prices
        By depth: the option taken first, whether the others are still to be searched, the trail before, a bound, the prices.
    trail
        Edges in the order in which they were taken away.
    remembered
        Fingerprints of ways that were told.
    numbers
        Counters; see the constants above.
    """

    alive: list[int]
    prices: list[int]
    trial: list[int]
    most: list[int]
    taken: list[int]
    candidate: list[int]
    outside: list[int]
    seen: list[int]
    active: list[int]
    stack: list[int]
    other_stack: list[int]
    used: list[int]
    drift: list[int]
    touched: list[int]
    listed: list[int]
    frame_edge: list[int]
    frame_open: list[int]
    frame_trail: list[int]
    frame_bound: list[int]
    frame_prices: list[int]
    trail: list[int]
    remembered: list[int]
    numbers: list[int]


def reach(tree: Tree, room: Room) -> int:
    """List the parts that some way of the options left may reach, in ascending order; how many there are."""
    kind, first, below = tree.kind, tree.first, tree.below
    alive, seen, active = room.alive, room.seen, room.active
    parts = len(kind)
    for part in range(parts):
        seen[part] = 0
    seen[parts - 1] = 1
    for part in range(parts - 1, -1, -1):
        if seen[part]:
            for edge in range(first[part], first[part + 1]):
                if kind[part] != PICK or alive[edge]:
                    seen[below[edge]] = 1
    count = 0
    for part in range(parts):
        if seen[part]:
            active[count] = part
            count += 1
    room.numbers[ACTIVE] = count
    return count


def sweep(tree: Tree, room: Room, prices: list[int]) -> int:
    """What every active part earns at most after prices, and the edge that each pick takes for it; that of the whole."""
    kind, value, first, below = tree.kind, tree.value, tree.first, tree.below
    use_first, use_purse, use_amount = tree.use_first, tree.use_purse, tree.use_amount
    alive, most, taken, active = room.alive, room.most, room.taken, room.active
    for place in range(room.numbers[ACTIVE]):
        part = active[place]
        if kind[part] == PICK:
            best, at = NEG, -1
            for edge in range(first[part], first[part + 1]):
                if alive[edge] and most[below[edge]] > best:
                    best = most[below[edge]]
                    at = edge
            most[part] = best
            taken[part] = at
        else:
            earned = value[part]
            for entry in range(use_first[part], use_first[part + 1]):
                earned -= prices[use_purse[entry]] * use_amount[entry]
            for edge in range(first[part], first[part + 1]):
                if most[below[edge]] < HALF_NEG:
                    earned = NEG
                    break
                earned += most[below[edge]]
            most[part] = earned
    return most[len(kind) - 1]


def follow(tree: Tree, room: Room) -> int:
    """Scaled utility of the way that the picks take; what it uses is left in ``used``."""
    kind, value, first, below = tree.kind, tree.value, tree.first, tree.below
    use_first, use_purse, use_amount = tree.use_first, tree.use_purse, tree.use_amount
    taken, stack, used = room.taken, room.stack, room.used
    for purse in range(len(used)):
        used[purse] = 0
    earned = 0
    stack[0] = len(kind) - 1
    height = 1
    while height:
        height -= 1
        part = stack[height]
        if kind[part] == PICK:
            stack[height] = below[taken[part]]
            height += 1
        else:
            earned += value[part]
            for entry in range(use_first[part], use_first[part + 1]):
                used[use_purse[entry]] += use_amount[entry]
            for edge in range(first[part], first[part + 1]):
                stack[height] = below[edge]
                height += 1
    return earned


def fits(tree: Tree, room: Room) -> bool:
    """Whether every purse suffices for what is used."""
    limits, used = tree.limits, room.used
    for purse in range(len(limits)):
        if used[purse] > limits[purse]:
            return False
    return True


def held(tree: Tree, prices: list[int]) -> int:
    """The price of all that the purses hold."""
    limits = tree.limits
    total = 0
    for purse in range(len(limits)):
        total += prices[purse] * limits[purse]
    return total


def tell(tree: Tree, room: Room) -> None:
    """Make the way that the picks take the candidate."""
    active, taken, candidate = room.active, room.taken, room.candidate
    for place in range(room.numbers[ACTIVE]):
        candidate[active[place]] = taken[active[place]]


def lower(tree: Tree, room: Room, steps: int, target: int, aim: float) -> tuple[int, int]:
    """
    Look for prices with a low bound, by subgradient steps (Polyak, "Minimization of unsmooth functionals", 1969).

    Starts from ``prices`` and leaves the best there. A step aims a margin below the target, or, if ``aim`` is above 0, at that share of
    the bound below it; it goes along what is lacking in the purses, smoothed over the last steps. Below the target it
    stops. Returns the best bound, and the scaled utility of the best way met that keeps the purses, which becomes the candidate;
    ``NEG`` if there is none.
    """
    limits, caps, prices, trial, used = tree.limits, tree.caps, room.prices, room.trial, room.used
    drift = room.drift
    purses = len(limits)
    for purse in range(purses):
        trial[purse] = prices[purse]
    best, found = -NEG, NEG
    stride, idle, fresh = 1.0, 0, True
    for _ in range(steps):
        top = sweep(tree, room, trial)
        if top < HALF_NEG:
            return NEG, found
        bound = top + held(tree, trial)
        earned = follow(tree, room)
        if earned > found and fits(tree, room):
            found = earned
            tell(tree, room)
        if bound < best:
            idle = idle + 1 if best < -NEG and 1000 * float(best - bound) < float(best - target) else 0
            best = bound
            for purse in range(purses):
                prices[purse] = trial[purse]
        else:
            idle += 1
        if best < target:
            break
        if idle >= (ROOT_IDLE if aim > 0.0 else 3):
            stride /= 2
            idle = 0
            if stride < 0.01:
                break
            for purse in range(purses):
                trial[purse] = prices[purse]
            fresh = True
            continue
        length, last = 0.0, 0.0
        for purse in range(purses):
            over = ((used[purse] - limits[purse]) << DRIFT_BITS) // max(1, limits[purse])
            if over <= 0 and trial[purse] == 0:
                over = 0
            last += abs(float(over))
            drift[purse] = over if fresh else (drift[purse] * KEPT + over * (8 - KEPT)) // 8
            length += float(drift[purse]) * float(drift[purse])
        fresh = False
        if last == 0.0 or length == 0.0:
            break
        gap = aim * abs(float(bound)) if aim > 0.0 else float(bound - target + room.numbers[MARGIN])
        step = stride * gap / length * float(1 << DRIFT_BITS)
        for purse in range(purses):
            holds = float(max(1, limits[purse]))
            moved = float(trial[purse]) + step * float(drift[purse]) / holds
            trial[purse] = min(caps[purse], int(max(0.0, min(moved, 4e18))))
    return best, found


def shrink(tree: Tree, room: Room, target: int) -> int:
    """
    Take away every option through which no way reaches the target; the bound.

    What the rest of a way earns beside a part is found on the way down; an option is kept if that and its own most reach the target.
    """
    kind, first, below = tree.kind, tree.first, tree.below
    alive, most, outside, active, trail = room.alive, room.most, room.outside, room.active, room.trail
    top = sweep(tree, room, room.prices)
    if top < HALF_NEG:
        return NEG
    count, length, hold = room.numbers[ACTIVE], room.numbers[TRAIL], held(tree, room.prices)
    for place in range(count):
        outside[active[place]] = NEG
    outside[active[count - 1]] = hold
    for place in range(count - 1, -1, -1):
        part = active[place]
        rest = outside[part]
        if rest < HALF_NEG:
            continue
        for edge in range(first[part], first[part + 1]):
            child = below[edge]
            if kind[part] != PICK:
                outside[child] = rest + most[part] - most[child]
            elif alive[edge]:
                if most[child] < HALF_NEG or rest + most[child] < target:
                    alive[edge] = 0
                    trail[length] = edge
                    length += 1
                else:
                    outside[child] = rest
    room.numbers[TRAIL] = length
    return top + hold


def weigh(tree: Tree, room: Room, top: int, sign: int) -> int:
    """What a part earns as its picks are taken now; what it uses goes into ``drift``, with that sign, and which purses into ``touched``."""
    kind, value, first, below = tree.kind, tree.value, tree.first, tree.below
    use_first, use_purse, use_amount = tree.use_first, tree.use_purse, tree.use_amount
    taken, stack, drift = room.taken, room.other_stack, room.drift
    touched, listed = room.touched, room.listed
    length = room.numbers[TOUCHED]
    earned = 0
    stack[0] = top
    height = 1
    while height:
        height -= 1
        part = stack[height]
        if kind[part] == PICK:
            stack[height] = below[taken[part]]
            height += 1
        else:
            earned += value[part]
            for entry in range(use_first[part], use_first[part + 1]):
                purse = use_purse[entry]
                if listed[purse] == 0:
                    listed[purse] = 1
                    touched[length] = purse
                    length += 1
                drift[purse] += sign * use_amount[entry]
            for edge in range(first[part], first[part + 1]):
                stack[height] = below[edge]
                height += 1
    room.numbers[TOUCHED] = length
    return earned


def forget(room: Room) -> None:
    """Empty what :func:`weigh` put down."""
    for place in range(room.numbers[TOUCHED]):
        room.drift[room.touched[place]] = 0
        room.listed[room.touched[place]] = 0
    room.numbers[TOUCHED] = 0


def fined(tree: Tree, room: Room) -> int:
    """How much the fines of overdrawn purses rise if what is in ``drift`` is used besides."""
    limits, used, drift, fines = tree.limits, room.used, room.drift, room.trial
    total = 0
    for place in range(room.numbers[TOUCHED]):
        purse = room.touched[place]
        if drift[purse]:
            before = max(0, used[purse] - limits[purse])
            after = max(0, used[purse] + drift[purse] - limits[purse])
            total += fines[purse] * (after - before)
    return total


def exchange(tree: Tree, room: Room) -> int:
    """Go through the picks of the way once, from the whole down, and take the option that earns most after fines; how many changed."""
    kind, first, below = tree.kind, tree.first, tree.below
    alive, taken, stack, used, drift, touched = room.alive, room.taken, room.stack, room.used, room.drift, room.touched
    changed = 0
    stack[0] = len(kind) - 1
    height = 1
    while height:
        height -= 1
        part = stack[height]
        if kind[part] == PICK:
            now = taken[part]
            best, at = 0, now
            for edge in range(first[part], first[part + 1]):
                if alive[edge] and edge != now:
                    gain = weigh(tree, room, below[edge], 1) - weigh(tree, room, below[now], -1) - fined(tree, room)
                    forget(room)
                    if gain > best:
                        best = gain
                        at = edge
            if at != now:
                changed += 1
                weigh(tree, room, below[now], -1)
                weigh(tree, room, below[at], 1)
                for place in range(room.numbers[TOUCHED]):
                    used[touched[place]] += drift[touched[place]]
                forget(room)
                taken[part] = at
            stack[height] = below[at]
            height += 1
        else:
            for edge in range(first[part], first[part + 1]):
                stack[height] = below[edge]
                height += 1
    return changed


def mend(tree: Tree, room: Room, passes: int) -> int:
    """
    Look for good ways within the purses near the one that the prices advise, by exchanges under fines for overdrawn purses.

    Fines rise while a purse is overdrawn, and all fall when nothing more is to be gained within the purses, so that the search goes
    back and forth over their limits (strategic oscillation: Glover, "Heuristics for integer programming using surrogate constraints",
    1977). Returns the scaled utility of the best way, which becomes the candidate; ``NEG`` if there is none.
    """
    limits, prices, fines, used, caps = tree.limits, room.prices, room.trial, room.used, tree.caps
    purses = len(limits)
    reach(tree, room)
    sweep(tree, room, prices)
    earned = follow(tree, room)
    room.numbers[TOUCHED] = 0
    for purse in range(purses):
        room.drift[purse] = 0
        room.listed[purse] = 0
        fines[purse] = prices[purse]
    best = NEG
    for _ in range(passes):
        changed = exchange(tree, room)
        earned = follow(tree, room)
        if fits(tree, room):
            if earned > best:
                best = earned
                tell(tree, room)
            if changed == 0:
                for purse in range(purses):
                    fines[purse] = max(prices[purse] // 2, fines[purse] * 3 // 4)
        else:
            for purse in range(purses):
                if used[purse] > limits[purse]:
                    fines[purse] = min(caps[purse], fines[purse] + fines[purse] // 4 + room.numbers[MARGIN])
    return best


def starve(tree: Tree, room: Room) -> bool:
    """
    Take away every option that leaves too little in a purse, whatever else is chosen; whether any way is left.

    Prices find that out, too, but only step by step; where many ways are equal that is too slow.
    """
    kind, first, below = tree.kind, tree.first, tree.below
    use_first, use_purse, use_amount = tree.use_first, tree.use_purse, tree.use_amount
    alive, least, outside, active, trail = room.alive, room.most, room.outside, room.active, room.trail
    count, root = room.numbers[ACTIVE], len(kind) - 1
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
        if least[root] > tree.limits[purse]:
            return False
        outside[root] = 0
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
    kind, first, below = tree.kind, tree.first, tree.below
    use_first, use_purse, use_amount = tree.use_first, tree.use_purse, tree.use_amount
    taken, stack, used, prices = room.taken, room.other_stack, room.used, room.prices
    for purse in range(len(used)):
        used[purse] = 0
    for sign in (1, -1):
        stack[0] = one if sign == 1 else other
        height = 1
        while height:
            height -= 1
            part = stack[height]
            if kind[part] == PICK:
                stack[height] = below[taken[part]]
                height += 1
            else:
                for entry in range(use_first[part], use_first[part + 1]):
                    used[use_purse[entry]] += sign * use_amount[entry]
                for edge in range(first[part], first[part + 1]):
                    stack[height] = below[edge]
                    height += 1
    total = 0
    for purse in range(len(used)):
        total += abs(used[purse]) * prices[purse]
    return total


def open_pick(tree: Tree, room: Room, slack: int, in_order: bool) -> int:
    """
    The pick on the best way to branch on; -1 if there is no other way.

    In order: the first in the order of choices. Else the one whose two best options differ most in what they use for what they differ
    in worth: there the prices say least, and a decision tells most.
    """
    kind, first, below = tree.kind, tree.first, tree.below
    alive, most, taken, stack = room.alive, room.most, room.taken, room.stack
    chosen, best = -1, -1.0
    stack[0] = len(kind) - 1
    height = 1
    while height:
        height -= 1
        part = stack[height]
        if kind[part] == PICK:
            second, at = NEG, -1
            for edge in range(first[part], first[part + 1]):
                if alive[edge] and edge != taken[part] and (at < 0 or most[below[edge]] > second):
                    second = most[below[edge]]
                    at = edge
            if at >= 0:
                if in_order:
                    score = float(tree.priority[part])
                else:
                    moved = swing(tree, room, below[taken[part]], below[at])
                    score = float(moved) / float(most[part] - second + slack + 1)
                if score > best:
                    best = score
                    chosen = part
            stack[height] = below[taken[part]]
            height += 1
        else:
            for edge in range(first[part], first[part + 1]):
                stack[height] = below[edge]
                height += 1
    return chosen


def is_news(tree: Tree, room: Room) -> bool:
    """Whether the candidate was not told before, as far as that is remembered."""
    kind, first, below, marks = tree.kind, tree.first, tree.below, tree.marks
    candidate, stack, remembered = room.candidate, room.stack, room.remembered
    mixed = 0
    stack[0] = len(kind) - 1
    height = 1
    while height:
        height -= 1
        part = stack[height]
        if kind[part] == PICK:
            mixed ^= marks[candidate[part]]
            stack[height] = below[candidate[part]]
            height += 1
        else:
            for edge in range(first[part], first[part + 1]):
                stack[height] = below[edge]
                height += 1
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
            bound, found = lower(tree, room, steps, target, 0.0)
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
            bound = min(shrink(tree, room, target), numbers[BOUND])
            if bound >= target:
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
