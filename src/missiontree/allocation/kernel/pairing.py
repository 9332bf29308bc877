"""Exchanges of two picks at once: one takes a better option for which another one makes room."""

from __future__ import annotations

from missiontree.allocation.kernel.columns import CHAIN, CHAIN_TRIES, PICK, TOUCHED, Room, Tree
from missiontree.allocation.kernel.mending import forget, weigh
from missiontree.allocation.kernel.pricing import walk


def list_users(tree: Tree, room: Room) -> None:
    """List, by purse, the picks of the way whose option uses it, and under which pick of the root each part stands."""
    kind, first, below = tree.kind, tree.first, tree.below
    on_way, over, head, behind, user = room.on_way, room.over, room.user_head, room.user_next, room.user_pick
    parts = len(kind)
    over[parts - 1] = -1
    for part in range(parts - 1, -1, -1):
        on_way[part] = 0
        mine = over[part] if over[part] >= 0 or kind[part] != PICK else part
        for edge in range(first[part], first[part + 1]):
            over[below[edge]] = mine
        over[part] = mine
    for purse in range(len(head)):
        head[purse] = -1
    room.way[0] = parts - 1
    count = walk(tree, room.taken, room.way, 1)
    for place in range(count):
        on_way[room.way[place]] = 1
    entries = 0
    for place in range(count):
        part = room.way[place]
        if kind[part] != PICK and over[part] >= 0:
            for entry in range(tree.use_first[part], tree.use_first[part + 1]):
                purse = tree.use_purse[entry]
                user[entries] = over[part]
                behind[entries] = head[purse]
                head[purse] = entries
                entries += 1


def lacking(tree: Tree, room: Room) -> int:
    """A purse that would be overdrawn if what is in ``drift`` is used besides; -1 if there is none, -2 if there are several."""
    found = -1
    for place in range(room.numbers[TOUCHED]):
        purse = room.touched[place]
        if room.drift[purse] > 0 and room.used[purse] + room.drift[purse] > tree.limits[purse]:
            if found >= 0:
                return -2
            found = purse
    return found


def take(tree: Tree, room: Room, pick: int, edge: int) -> None:
    """Let a pick of the way take another option."""
    way, on_way = room.other_way, room.on_way
    way[0] = tree.below[room.taken[pick]]
    for place in range(walk(tree, room.taken, way, 1)):
        on_way[way[place]] = 0
    room.taken[pick] = edge
    way[0] = tree.below[edge]
    for place in range(walk(tree, room.taken, way, 1)):
        on_way[way[place]] = 1


def settle_use(room: Room) -> None:
    """Use what is in ``drift``."""
    for place in range(room.numbers[TOUCHED]):
        room.used[room.touched[place]] += room.drift[room.touched[place]]
    forget(room)


def swap(tree: Tree, room: Room, pick: int, edge: int) -> int:
    """Let a pick of the way take another option, and use what that uses; what is earned by it."""
    earned = weigh(tree, room, tree.below[edge], 1) - weigh(tree, room, tree.below[room.taken[pick]], -1)
    take(tree, room, pick, edge)
    settle_use(room)
    return earned


def engaged(room: Room, pick: int, first: int, depth: int) -> bool:
    """Whether a pick stands under the same pick of the root as one that the chain has changed already."""
    if room.over[pick] == room.over[first]:
        return True
    for place in range(depth):
        if room.over[pick] == room.over[room.chain_pick[place]]:
            return True
    return False


def make_room(tree: Tree, room: Room, pick: int, purse: int, gain: int) -> bool:
    """
    Mend an overdrawn purse by a chain: another pick leaves it, a third one the purse that this overdraws, and so on, at a smaller loss.

    Depth first, with so many tries; if they are in vain, everything is as it was.
    """
    first, below, taken, limits = tree.first, tree.below, room.taken, tree.limits
    cursor, options = room.chain_entry, room.chain_option
    depth, tries = 0, 0
    room.chain_purse[0], room.chain_gain[0] = purse, gain
    cursor[0], options[0] = room.user_head[purse], -1
    while True:
        purse, entry = room.chain_purse[depth], cursor[depth]
        if entry < 0 or tries > CHAIN_TRIES:
            if depth == 0:
                return False
            depth -= 1
            swap(tree, room, room.chain_pick[depth], room.chain_was[depth])
            continue
        other = room.user_pick[entry]
        if options[depth] < 0:
            options[depth] = first[other]
        edge = options[depth]
        if edge == first[other + 1] or room.on_way[other] == 0 or engaged(room, other, pick, depth):
            cursor[depth], options[depth] = room.user_next[entry], -1
            continue
        options[depth] = edge + 1
        if room.alive[edge] == 0 or edge == taken[other]:
            continue
        tries += 1
        left = room.chain_gain[depth]
        left += weigh(tree, room, below[edge], 1) - weigh(tree, room, below[taken[other]], -1)
        enough = left > 0 and room.listed[purse] and room.used[purse] + room.drift[purse] <= limits[purse]
        lack = lacking(tree, room) if enough else -2
        if lack == -2 or (lack >= 0 and depth + 1 == CHAIN):
            forget(room)
            continue
        room.chain_pick[depth], room.chain_was[depth] = other, taken[other]
        take(tree, room, other, edge)
        settle_use(room)
        if lack == -1:
            return True
        depth += 1
        room.chain_purse[depth], room.chain_gain[depth] = lack, left
        cursor[depth], options[depth] = room.user_head[lack], -1


def pair_up(tree: Tree, room: Room) -> int:
    """
    Go through the picks of a way that keeps the purses once, and take options that earn more: those that fit, and those for which a
    chain of others can make room at a smaller loss (as in generalised assignment: Yagiura, Ibaraki and Glover, "An ejection chain
    approach for the generalized assignment problem", 2004). Expects the use of the way in ``used``; how many were taken.
    """
    kind, first, below, alive, taken = tree.kind, tree.first, tree.below, room.alive, room.taken
    list_users(tree, room)
    changed = 0
    for pick in range(len(kind)):
        if kind[pick] != PICK or room.on_way[pick] == 0:
            continue
        for edge in range(first[pick], first[pick + 1]):
            if alive[edge] == 0 or edge == taken[pick]:
                continue
            gain = weigh(tree, room, below[edge], 1) - weigh(tree, room, below[taken[pick]], -1)
            purse = lacking(tree, room) if gain > 0 else -2
            forget(room)
            if purse == -2:
                continue
            was = taken[pick]
            swap(tree, room, pick, edge)
            if purse == -1 or make_room(tree, room, pick, purse, gain):
                changed += 1
            else:
                swap(tree, room, pick, was)
    return changed
