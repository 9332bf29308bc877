"""What every part earns after prices, the bound that this proves, and what the bound rules out."""

from __future__ import annotations

from missiontree.allocation.kernel.columns import (
    ACTIVE,
    BASE,
    FOUND,
    FRESH,
    HALF_NEG,
    HALVINGS,
    IDLE,
    LEVEL,
    LOWEST,
    MARGIN,
    NEG,
    PICK,
    SETTLED,
    TOPS,
    TRAIL,
    Room,
    Tree,
)

DRIFT_BITS = 20  # behind the point of a purse's drift
MOST_HALVINGS = 6
ROOT_IDLE = 10  # steps without progress before strides are halved, where there is no target; elsewhere 3
KEPT = 4  # eighths of the drift that each step keeps


def settle(tree: Tree, room: Room) -> int:
    """
    Go down from the tops of the level as far as no choice is left, and put what is settled on the way into the base.

    The picks at which that ends become the new tops, and are marked as seen; how many there are.
    """
    kind, value, first, below = tree.kind, tree.value, tree.first, tree.below
    alive, taken, tops, stack, seen = room.alive, room.taken, room.tops, room.way, room.seen
    level, purses = room.numbers[LEVEL], len(tree.limits)
    base = room.level_value[level]
    for purse in range(purses):
        room.base_used[purse] = room.level_used[level * purses + purse]
    length, count = 0, 0
    for place in range(room.level_top[level], room.level_top[level + 1]):
        stack[length] = room.kept_tops[place]
        length += 1
    while length:
        length -= 1
        part = stack[length]
        if kind[part] == PICK:
            left, only = 0, -1
            for edge in range(first[part], first[part + 1]):
                if alive[edge]:
                    left += 1
                    only = edge
            if left == 1:
                taken[part] = only
                stack[length] = below[only]
                length += 1
            else:
                seen[part] = 1
                tops[count] = part
                count += 1
        else:
            base += value[part]
            for entry in range(tree.use_first[part], tree.use_first[part + 1]):
                room.base_used[tree.use_purse[entry]] += tree.use_amount[entry]
            for edge in range(first[part], first[part + 1]):
                stack[length] = below[edge]
                length += 1
    room.numbers[BASE] = base
    room.numbers[TOPS] = count
    return count


def reach(tree: Tree, room: Room) -> int:
    """
    List what is still open: the parts below picks with several options left, as far as some way of those left may reach them.

    What every way has in common becomes the base, so that prices are tried on what is open alone. Looks through the list of the level
    that the search is on, and begins a new level when much of it is settled. How many parts there are.
    """
    kind, first, below = tree.kind, tree.first, tree.below
    alive, seen, active, kept, numbers = room.alive, room.seen, room.active, room.kept, room.numbers
    level = numbers[LEVEL]
    begin, end = room.level_first[level], room.level_first[level + 1]
    for place in range(begin, end):
        seen[kept[place]] = 0
    tops = settle(tree, room)
    for place in range(end - 1, begin - 1, -1):
        part = kept[place]
        if seen[part]:
            for edge in range(first[part], first[part + 1]):
                if kind[part] != PICK or alive[edge]:
                    seen[below[edge]] = 1
    count = 0
    for place in range(begin, end):
        if seen[kept[place]]:
            active[count] = kept[place]
            count += 1
    numbers[ACTIVE] = count
    if level + 2 < len(room.level_first) and 4 * count <= 3 * (end - begin):
        raise_level(room, count, tops, len(tree.limits))
    return count


def raise_level(room: Room, count: int, tops: int, purses: int) -> None:
    """Begin a new level with what is open now."""
    level = room.numbers[LEVEL] + 1
    begin, top = room.level_first[level], room.level_top[level]
    for place in range(count):
        room.kept[begin + place] = room.active[place]
    for place in range(tops):
        room.kept_tops[top + place] = room.tops[place]
    for purse in range(purses):
        room.level_used[level * purses + purse] = room.base_used[purse]
    room.level_value[level] = room.numbers[BASE]
    room.level_first[level + 1] = begin + count
    room.level_top[level + 1] = top + tops
    room.numbers[LEVEL] = level


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
    whole = room.numbers[BASE]
    for purse in range(len(prices)):
        whole -= prices[purse] * room.base_used[purse]
    for place in range(room.numbers[TOPS]):
        if most[room.tops[place]] < HALF_NEG:
            return NEG
        whole += most[room.tops[place]]
    return whole


def walk(tree: Tree, taken: list[int], way: list[int], count: int) -> int:
    """List, behind the parts already listed, what a way takes below them if every pick takes that edge; how many parts in all."""
    kind, first, below = tree.kind, tree.first, tree.below
    place = 0
    while place < count:
        part = way[place]
        place += 1
        if kind[part] == PICK:
            way[count] = below[taken[part]]
            count += 1
        else:
            for edge in range(first[part], first[part + 1]):
                way[count] = below[edge]
                count += 1
    return count


def walk_open(tree: Tree, room: Room) -> int:
    """List in ``way`` what is open of the way that the picks take; how many parts."""
    tops = room.numbers[TOPS]
    for place in range(tops):
        room.way[place] = room.tops[place]
    return walk(tree, room.taken, room.way, tops)


def follow(tree: Tree, room: Room) -> int:
    """Scaled utility of the way that the picks take; what it uses is left in ``used``."""
    value, use_first, use_purse, use_amount = tree.value, tree.use_first, tree.use_purse, tree.use_amount
    way, used = room.way, room.used
    for purse in range(len(tree.limits)):
        used[purse] = room.base_used[purse]
    earned = room.numbers[BASE]
    for place in range(walk_open(tree, room)):
        part = way[place]
        earned += value[part]
        for entry in range(use_first[part], use_first[part + 1]):
            used[use_purse[entry]] += use_amount[entry]
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
    room.way[0] = len(tree.kind) - 1
    for place in range(walk(tree, room.taken, room.way, 1)):
        room.candidate[room.way[place]] = room.taken[room.way[place]]


def begin(room: Room) -> None:
    """Nothing is known yet but the prices to start from."""
    numbers = room.numbers
    for purse in range(len(room.prices)):
        room.trial[purse] = room.prices[purse]
    numbers[LOWEST], numbers[FOUND] = -NEG, NEG
    numbers[HALVINGS], numbers[IDLE], numbers[FRESH] = 0, 0, 1


def lower(tree: Tree, room: Room, steps: int, target: int, aim: float, again: bool) -> tuple[int, int]:
    """
    Look for prices with a low bound, by subgradient steps (Polyak, "Minimization of unsmooth functionals", 1969).

    Starts from ``prices`` and leaves the best there; ``again``, it goes on where it stopped. A step aims a margin below the target, or,
    if ``aim`` is above 0, at that share of the bound below it; it goes along what is lacking in the purses, smoothed over the last
    steps. Below the target it stops. Returns the best bound, and the scaled utility of the best way met that keeps the purses, which
    becomes the candidate; ``NEG`` if there is none. More steps are of use unless ``numbers`` say that it is settled.
    """
    limits, caps, prices, trial, used = tree.limits, tree.caps, room.prices, room.trial, room.used
    drift = room.drift
    purses, numbers = len(limits), room.numbers
    if not again:
        begin(room)
    best, found = numbers[LOWEST], numbers[FOUND]
    halvings, idle, fresh = numbers[HALVINGS], numbers[IDLE], numbers[FRESH] == 1
    numbers[SETTLED] = 1
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
            halvings += 1
            idle = 0
            if halvings > MOST_HALVINGS:
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
        step = gap / float(1 << halvings) / length * float(1 << DRIFT_BITS)
        for purse in range(purses):
            holds = float(max(1, limits[purse]))
            moved = float(trial[purse]) + step * float(drift[purse]) / holds
            trial[purse] = min(caps[purse], int(max(0.0, min(moved, 4e18))))
    else:
        numbers[SETTLED] = 0
    numbers[LOWEST], numbers[FOUND] = best, found
    numbers[HALVINGS], numbers[IDLE], numbers[FRESH] = halvings, idle, 1 if fresh else 0
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
    for place in range(room.numbers[TOPS]):
        outside[room.tops[place]] = hold + top - most[room.tops[place]]
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
