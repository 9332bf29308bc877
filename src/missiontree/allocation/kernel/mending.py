"""Exchanges on one way, weighed and fined: how ways within the purses are found near the one that prices advise."""

from __future__ import annotations

from missiontree.allocation.kernel.columns import PICK, TOUCHED, Room, Tree
from missiontree.allocation.kernel.pricing import walk


def weigh(tree: Tree, room: Room, top: int, sign: int) -> int:
    """What a part earns as its picks are taken now; what it uses goes into ``drift``, with that sign, and which purses into ``touched``."""
    value, use_first, use_purse, use_amount = tree.value, tree.use_first, tree.use_purse, tree.use_amount
    way, drift, touched, listed = room.other_way, room.drift, room.touched, room.listed
    length = room.numbers[TOUCHED]
    earned = 0
    way[0] = top
    for place in range(walk(tree, room.taken, way, 1)):
        part = way[place]
        earned += value[part]
        for entry in range(use_first[part], use_first[part + 1]):
            purse = use_purse[entry]
            if listed[purse] == 0:
                listed[purse] = 1
                drift[purse] = 0
                touched[length] = purse
                length += 1
            drift[purse] += sign * use_amount[entry]
    room.numbers[TOUCHED] = length
    return earned


def forget(room: Room) -> None:
    """Empty what :func:`weigh` put down."""
    for place in range(room.numbers[TOUCHED]):
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
    alive, taken, way, used, touched = room.alive, room.taken, room.way, room.used, room.touched
    changed = 0
    way[0] = len(kind) - 1
    count, visited = 1, 0
    while visited < count:
        part = way[visited]
        visited += 1
        if kind[part] != PICK:
            for edge in range(first[part], first[part + 1]):
                way[count] = below[edge]
                count += 1
            continue
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
                used[touched[place]] += room.drift[touched[place]]
            forget(room)
            taken[part] = at
        way[count] = below[at]
        count += 1
    return changed
