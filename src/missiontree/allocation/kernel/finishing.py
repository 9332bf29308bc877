"""The last few picks of a corner, tried out one after the other at the prices as they are."""

from __future__ import annotations

from missiontree.allocation.kernel.columns import FEW, FEW_PURSES, NEG, PICK, TOPS, TOUCHED, TRIES, Room, Tree
from missiontree.allocation.kernel.mending import forget


def may_hold(tree: Tree, room: Room, slack: int) -> bool:
    """
    Whether a way within the purses is left that stays below the bound by no more than the slack, as far as some tries tell.

    Only corners with few open picks are tried, whose options are all settled and use few purses; of others the answer is yes. What a
    way loses is known exactly: every option loses what it earns less than its pick's best after prices, and what is left over in
    a purse loses its price. Expects what every part earns as :func:`~missiontree.allocation.kernel.pricing.shrink` leaves it.
    """
    if room.numbers[TOPS] == 0 or room.numbers[TOPS] > FEW:
        return True
    answer = not few_purses(tree, room) or try_out(tree, room, slack)
    forget(room)
    return answer


def few_purses(tree: Tree, room: Room) -> bool:
    """List the purses that open options use; whether they are few, and every option is settled."""
    first, below, use_purse = tree.first, tree.below, tree.use_purse
    touched, listed = room.touched, room.listed
    room.numbers[TOUCHED] = 0
    for place in range(room.numbers[TOPS]):
        part = room.tops[place]
        for edge in range(first[part], first[part + 1]):
            if room.alive[edge] == 0:
                continue
            child = below[edge]
            if tree.kind[child] == PICK or first[child] != first[child + 1]:
                return False
            for entry in range(tree.use_first[child], tree.use_first[child + 1]):
                purse = use_purse[entry]
                if listed[purse] == 0:
                    count = room.numbers[TOUCHED]
                    if count == FEW_PURSES:
                        return False
                    touched[count] = purse
                    listed[purse] = count + 1
                    room.numbers[TOUCHED] = count + 1
    return True


def foresee(tree: Tree, room: Room) -> None:
    """What the picks from each on use of every listed purse, at least and at most."""
    first, below, alive, listed, spare = tree.first, tree.below, room.alive, room.listed, room.drift
    least, most = room.end_least, room.end_most
    picks, purses = room.numbers[TOPS], room.numbers[TOUCHED]
    for place in range(purses):
        least[picks * purses + place] = 0
        most[picks * purses + place] = 0
    for pick in range(picks - 1, -1, -1):
        part, here, behind = room.tops[pick], pick * purses, (pick + 1) * purses
        for place in range(purses):
            least[here + place] = -NEG
            most[here + place] = 0
        for edge in range(first[part], first[part + 1]):
            if alive[edge]:
                for place in range(purses):
                    spare[place] = 0
                for entry in range(tree.use_first[below[edge]], tree.use_first[below[edge] + 1]):
                    spare[listed[tree.use_purse[entry]] - 1] += tree.use_amount[entry]
                for place in range(purses):
                    least[here + place] = min(least[here + place], spare[place])
                    most[here + place] = max(most[here + place], spare[place])
        for place in range(purses):
            least[here + place] += least[behind + place]
            most[here + place] += most[behind + place]


def sort_picks(tree: Tree, room: Room) -> None:
    """Put those picks first whose options differ most in what they use: the less is open after them, the more is known."""
    first, below, tops, weight = tree.first, tree.below, room.tops, room.end_slack
    for pick in range(room.numbers[TOPS]):
        part = tops[pick]
        least, most = -NEG, 0
        for edge in range(first[part], first[part + 1]):
            if room.alive[edge]:
                spent = 0
                for entry in range(tree.use_first[below[edge]], tree.use_first[below[edge] + 1]):
                    spent += room.prices[tree.use_purse[entry]] * tree.use_amount[entry]
                least, most = min(least, spent), max(most, spent)
        place = pick
        while place > 0 and weight[place - 1] < most - least:
            weight[place] = weight[place - 1]
            tops[place] = tops[place - 1]
            place -= 1
        weight[place] = most - least
        tops[place] = part


def untouched(tree: Tree, room: Room) -> int:
    """The price of what is left over in purses that no open option uses; ``-NEG`` if one of them does not suffice."""
    lost = 0
    for purse in range(len(tree.limits)):
        if room.listed[purse] == 0:
            left = tree.limits[purse] - room.base_used[purse]
            if left < 0:
                return -NEG
            lost += room.prices[purse] * left
    return lost


def lost_at_least(tree: Tree, room: Room, picks: int) -> int:
    """The price of what will be left over once so many picks are made; ``-NEG`` if a purse will not suffice."""
    purses, lost = room.numbers[TOUCHED], 0
    here = picks * purses
    for place in range(purses):
        left = tree.limits[room.touched[place]] - room.end_used[here + place]
        if left < room.end_least[here + place]:
            return -NEG
        if left > room.end_most[here + place]:
            lost += room.prices[room.touched[place]] * (left - room.end_most[here + place])
    return lost


def try_out(tree: Tree, room: Room, slack: int) -> bool:
    """Whether some way loses no more than the slack and keeps the purses, depth first; also if that takes too many tries."""
    first, below, tops = tree.first, tree.below, room.tops
    used, edges, rests = room.end_used, room.end_edge, room.end_slack
    sort_picks(tree, room)
    foresee(tree, room)
    picks, purses = room.numbers[TOPS], room.numbers[TOUCHED]
    for place in range(purses):
        used[place] = room.base_used[room.touched[place]]
    rests[0] = slack - untouched(tree, room)
    edges[0] = first[tops[0]]
    made, tries = 0, 0
    while made >= 0:
        part, edge = tops[made], edges[made]
        if edge == first[part + 1]:
            made -= 1
            continue
        edges[made] = edge + 1
        if room.alive[edge] == 0:
            continue
        tries += 1
        if tries > TRIES:
            return True
        child = below[edge]
        rest = rests[made] - (room.most[part] - room.most[child])
        if rest < 0:
            continue
        here, behind = made * purses, (made + 1) * purses
        for place in range(purses):
            used[behind + place] = used[here + place]
        for entry in range(tree.use_first[child], tree.use_first[child + 1]):
            used[behind + room.listed[tree.use_purse[entry]] - 1] += tree.use_amount[entry]
        if lost_at_least(tree, room, made + 1) > rest:
            continue
        made += 1
        if made == picks:
            return True
        rests[made] = rest
        edges[made] = first[tops[made]]
    return False
