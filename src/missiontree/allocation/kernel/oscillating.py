"""To and fro over the limits of the purses, and a descent wherever a way keeps them."""

from __future__ import annotations

from missiontree.allocation.kernel.columns import BEST_MENDED, DESCENTS, MARGIN, NEG, Room, Tree
from missiontree.allocation.kernel.mending import exchange
from missiontree.allocation.kernel.pairing import pair_up
from missiontree.allocation.kernel.pricing import fits, follow, reach, sweep, tell


def mend(tree: Tree, room: Room, passes: int, fresh: bool) -> int:
    """
    Look for good ways within the purses near the one that the prices advise, by exchanges under fines for overdrawn purses.

    Fines rise while a purse is overdrawn, and all fall when nothing more is to be gained within the purses, so that the search goes
    back and forth over their limits (strategic oscillation: Glover, "Heuristics for integer programming using surrogate constraints",
    1977). A way that keeps the purses is bettered by exchanges first. Not fresh, it goes on where it stopped. Returns the scaled
    utility of the best way, which becomes the candidate; ``NEG`` if none is better than what was found before.
    """
    limits, prices, fines, used, caps = tree.limits, room.prices, room.trial, room.used, tree.caps
    purses = len(limits)
    reach(tree, room)
    if fresh:
        sweep(tree, room, prices)
        for purse in range(purses):
            fines[purse] = prices[purse]
        room.numbers[BEST_MENDED] = NEG
    follow(tree, room)
    before = room.numbers[BEST_MENDED]
    for _ in range(passes):
        changed = exchange(tree, room)
        earned = follow(tree, room)
        if fits(tree, room):
            for _ in range(room.numbers[DESCENTS]):
                if pair_up(tree, room) == 0:
                    break
            earned = follow(tree, room)
            if earned > room.numbers[BEST_MENDED]:
                room.numbers[BEST_MENDED] = earned
                tell(tree, room)
            if changed == 0:
                for purse in range(purses):
                    fines[purse] = max(prices[purse] // 2, fines[purse] * 3 // 4)
        else:
            for purse in range(purses):
                if used[purse] > limits[purse]:
                    fines[purse] = min(caps[purse], fines[purse] + fines[purse] // 4 + room.numbers[MARGIN])
    return room.numbers[BEST_MENDED] if room.numbers[BEST_MENDED] > before else NEG
