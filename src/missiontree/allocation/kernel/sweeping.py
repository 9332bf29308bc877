"""What the best way through an AND/XOR tree is, what each other option costs, and which of equals come first in the order of choices.

A tree is three columns over nodes, parents before children and siblings in order: ``kind`` (``LEAF``, ``AND``, ``XOR``), ``parent``
and ``utility``. An option is the child of an XOR, and is named by it. The best way takes at every XOR the first of its best children.
"""

from __future__ import annotations

from missiontree.mission.columns import AND, XOR

NOTHING = -1  # no node; no way
BLOCKED = -2  # stands in ``taken`` for an AND with a child that has no way


def best_below(
    kind: list[int],
    parent: list[int],
    value: list[int],
    taken: list[int],
    child: list[int],
    sibling: list[int],
) -> int:
    """
    One sweep up.

    ``value`` comes with the leaves' utilities and leaves with the best of every node; ``taken`` then holds the option taken at each
    XOR, ``child`` and ``sibling`` the first child and the next sibling. All three come filled with ``NOTHING``. 1 if there is a way
    through the tree, else 0.
    """
    for node in range(len(kind) - 1, 0, -1):
        above = parent[node]
        sibling[node] = child[above]
        child[above] = node
        able = taken[node] >= 0 if kind[node] == XOR else taken[node] != BLOCKED
        if kind[above] == AND:
            if able:
                value[above] += value[node]
            else:
                taken[above] = BLOCKED
        elif able and (taken[above] < 0 or value[node] >= value[above]):
            value[above] = value[node]
            taken[above] = node
    return int(taken[0] >= 0 if kind[0] == XOR else taken[0] != BLOCKED)


def losses(
    kind: list[int],
    parent: list[int],
    value: list[int],
    taken: list[int],
    loss: list[int],
    option: list[int],
    lost: list[int],
) -> int:
    """
    One sweep down.

    ``loss`` comes filled with ``NOTHING`` and leaves with what the best way through each node that has a way earns less than the best
    of all. Options that are not taken are listed in ``option`` with their losses in ``lost``; how many there are.
    """
    count = 0
    loss[0] = 0
    for node in range(1, len(kind)):
        above = parent[node]
        here = loss[above]
        if here < 0:
            continue
        if kind[above] == AND:
            loss[node] = here
        elif taken[node] >= 0 if kind[node] == XOR else taken[node] != BLOCKED:
            here += value[above] - value[node]
            loss[node] = here
            if taken[above] != node:
                option[count] = node
                lost[count] = here
                count += 1
    return count


def follow_best(
    kind: list[int],
    parent: list[int],
    taken: list[int],
    child: list[int],
    sibling: list[int],
    top: int,
    choices: int,
    found: int,
    xors: list[int],
    until: list[int],
    leaf_from: list[int],
    leaf_until: list[int],
    leaves: list[int],
    at: list[int],
) -> tuple[int, int]:
    """
    Follow the best way below a node.

    Its XORs in preorder go to ``xors``, behind ``choices`` entries that are there already, and its leaves to ``leaves`` behind
    ``found``; both counts come back. For each XOR: ``at`` says where it stands, ``until`` where its last choice below stands, plus one;
    ``leaf_from`` and ``leaf_until`` the same of its leaves.
    """
    node = top
    while True:
        if kind[node] == XOR:
            xors[choices] = node
            leaf_from[choices] = found
            at[node] = choices
            choices += 1
            below = taken[node]
        elif kind[node] == AND:
            below = child[node]
        else:
            leaves[found] = node
            found += 1
            below = NOTHING
        while below < 0:
            if kind[node] == XOR:
                place = at[node]
                until[place] = choices
                leaf_until[place] = found
            if node == top:
                return choices, found
            if kind[parent[node]] == AND:
                below = sibling[node]
            if below < 0:
                node = parent[node]
        node = below


def first_in_order(
    kind: list[int],
    parent: list[int],
    taken: list[int],
    child: list[int],
    sibling: list[int],
    loss: list[int],
    most: int,
    wanted: int,
    stack: list[int],
    low: list[int],
    xors: list[int],
    until: list[int],
    leaf_from: list[int],
    leaf_until: list[int],
    leaves: list[int],
    at: list[int],
    first: list[int],
) -> int:
    """
    Options that cost exactly ``most``, in the order of the best ways through them; how many were put into ``first``.

    The best way through an option differs from the best of all at the options on its path that are not taken. So the ways through
    options below a given one share its path, and differ from its own way at one further XOR. There a child before the taken one
    makes the way earlier, and the more so the earlier the XOR; a child behind it makes it later, and the less so the later the XOR.
    """
    size, count = 1, 0
    stack[0] = 0
    while size > 0 and count < wanted:
        size -= 1
        top = stack[size]
        if top < 0:
            if loss[-1 - top] == most:
                first[count] = -1 - top
                count += 1
            continue
        choices, _ = follow_best(
            kind, parent, taken, child, sibling, top, 0, 0, xors, until, leaf_from, leaf_until, leaves, at
        )
        lower = 0
        for place in range(choices):
            xor = xors[place]
            before, start = True, size
            option = child[xor]
            while option >= 0:
                if option == taken[xor]:
                    before = False
                elif 0 <= loss[option] <= most:
                    if before:
                        low[lower] = option
                        lower += 1
                    else:
                        stack[size] = option
                        size += 1
                option = sibling[option]
            end = size - 1
            while start < end:  # what lies on top of the stack comes first
                stack[start], stack[end] = stack[end], stack[start]
                start += 1
                end -= 1
        if top > 0:
            stack[size] = -1 - top
            size += 1
        for place in range(lower - 1, -1, -1):
            stack[size] = low[place]
            size += 1
    return count
