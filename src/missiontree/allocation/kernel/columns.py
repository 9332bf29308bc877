"""What the inner loops work on, as columns, and the numbers they share."""

from __future__ import annotations

from typing import NamedTuple

SUM, PICK = 0, 1
NEG = -(1 << 62)  # no way; every real sum is far from it
HALF_NEG = -(1 << 61)

# Places in Room.numbers, which survives from one call to the next.
PHASE, DEPTH, NODES, TRAIL, ACTIVE, BOUND, CANDIDATE, MARGIN, TOUCHED, TOPS, BASE, LEVEL, BEST_MENDED = range(13)
LOWEST, FOUND, HALVINGS, IDLE, FRESH, SETTLED = range(13, 19)  # where the search for prices stands
DESCENTS = 19  # passes of pairs after each way that keeps the purses, in :mod:`oscillating`
NUMBERS = 20
EVALUATE, SHRINK, BACKTRACK = 0, 1, 2
FINISHED, MET, LAST, PAUSED = 0, 1, 2, 3

FEW = 40  # open picks of a corner that is tried out
FEW_PURSES = 48
TRIES = 3_000

CHAIN = 6  # picks that make room for one another
CHAIN_TRIES = 200


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
    active, tops
        Parts of what is still open, children first, and the picks at its top, each of them open and reached by every way left.
    base_used
        By purse: what every way left uses beside what is open.
    level_first, level_top, level_value, level_used
        By level of the search: where its lists of parts and of tops begin, and what is settled beside them; see :func:`reach`.
    kept, kept_tops
        Those lists, one behind the other.
    on_way, over, user_head, user_next, user_pick
        What exchanges of two picks need: which parts are on the way, the uppermost pick over each, and the picks that use a purse.
    seen, way, other_way, used, drift, touched, listed
        Scratch.
    frame_edge, frame_open, frame_trail, frame_bound, frame_level, frame_prices
        By depth: the option taken first, whether the others are still to be searched, the trail before, a bound, the level, the prices.
    chain_pick, chain_was, chain_entry, chain_option, chain_purse, chain_gain
        The chain of exchanges that is tried: by depth, who was changed and from which option, whom and which option to try next, which
        purse is overdrawn, and what is gained so far.
    end_edge, end_slack, end_used, end_least, end_most
        What trying out the last picks needs, by pick or by pick and purse.
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
    active: list[int]
    tops: list[int]
    base_used: list[int]
    level_first: list[int]
    level_top: list[int]
    level_value: list[int]
    level_used: list[int]
    kept: list[int]
    kept_tops: list[int]
    on_way: list[int]
    over: list[int]
    user_head: list[int]
    user_next: list[int]
    user_pick: list[int]
    seen: list[int]
    way: list[int]
    other_way: list[int]
    used: list[int]
    drift: list[int]
    touched: list[int]
    listed: list[int]
    frame_edge: list[int]
    frame_open: list[int]
    frame_trail: list[int]
    frame_bound: list[int]
    frame_level: list[int]
    frame_prices: list[int]
    chain_pick: list[int]
    chain_was: list[int]
    chain_entry: list[int]
    chain_option: list[int]
    chain_purse: list[int]
    chain_gain: list[int]
    end_edge: list[int]
    end_slack: list[int]
    end_used: list[int]
    end_least: list[int]
    end_most: list[int]
    trail: list[int]
    remembered: list[int]
    numbers: list[int]
