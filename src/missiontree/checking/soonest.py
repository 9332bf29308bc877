"""
How soon the actions of an alternative can end by what allocation knows: nobody is short of robots, and approaches take no time.

Written out plainly: every action is pushed back by its role, by links, by joint work and by its release time, again and again, until
nothing moves. What waits for itself would be pushed for ever; it stops a tick after the last deadline, which is late enough.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.clock import ticks_needed
from missiontree.checking.staffing import Staffing
from missiontree.checking.windows import windows
from missiontree.mission.tree import IN_ORDER


class TooLate(NamedTuple):
    """An action that cannot end by its deadline, in ticks."""

    leaf: int
    deadline: int


def too_late(case: Case, staffing: Staffing) -> TooLate | None:
    """The first action that cannot end in time; None if all can, as far as that can be told without a schedule."""
    due = {leaf: one for leaf, one in windows(case, staffing).items() if one.deadline is not None}
    if not due:
        return None
    release = {leaf: one.release for leaf, one in windows(case, staffing).items()}
    last = max(one.deadline for one in due.values() if one.deadline is not None) + 1
    end = _ends(staffing, release, last)
    late = (TooLate(leaf, one.deadline) for leaf, one in due.items() if one.deadline is not None)
    return next((one for one in late if end[one.leaf] > one.deadline), None)


def soonest_end(case: Case, staffing: Staffing) -> int:
    """Ticks before which no schedule of an alternative ends, by what allocation knows; 0 if something waits for itself."""
    release = {leaf: one.release for leaf, one in windows(case, staffing).items()}
    lengths = (max(action.duration_s, action.travel_at_least_s) for action in staffing.actions.values())
    last = max(release.values(), default=0) + sum(ticks_needed(length) * 2 for length in lengths) + 1
    end = max(_ends(staffing, release, last).values(), default=0)
    return 0 if end >= last else end


def _ends(staffing: Staffing, release: dict[int, int], last: int) -> dict[int, int]:
    actions = staffing.actions
    start = {leaf: release.get(leaf, 0) for leaf in actions}
    end = dict(start)
    until: dict[int, list[int]] = {}
    for bond in staffing.bonds:
        if bond.kind == "until":
            for leaf in bond.first_leaves:
                if actions[leaf].open_ended:
                    until.setdefault(leaf, []).extend(bond.second_leaves)
    length, wait = {}, {}
    for leaf, action in actions.items():
        travel = ticks_needed(action.travel_at_least_s)
        length[leaf] = 0 if leaf in until else travel if action.moves else ticks_needed(action.duration_s)
        wait[leaf] = 0 if action.moves else travel
    moved = True
    while moved:
        before = dict(start), dict(end)
        for leaves in staffing.leaves_of_role.values():
            for earlier, later in pairwise(leaves):
                start[later] = max(start[later], end[earlier] + wait[later])
        for bond in staffing.bonds:
            if bond.kind in IN_ORDER:
                over = max(end[leaf] for leaf in bond.first_leaves)
                start.update((leaf, max(start[leaf], over)) for leaf in bond.second_leaves)
        for leaf in actions:
            with_it = [end[other] for other in until.get(leaf, ())]
            end[leaf] = max(end[leaf], start[leaf] + length[leaf], *with_it)
        for leaves in staffing.joint.values():
            start.update(dict.fromkeys(leaves, max(start[leaf] for leaf in leaves)))
            end.update(dict.fromkeys(leaves, max(end[leaf] for leaf in leaves)))
        start = {leaf: min(time, last) for leaf, time in start.items()}
        end = {leaf: min(time, last) for leaf, time in end.items()}
        moved = (start, end) != before
    return end
