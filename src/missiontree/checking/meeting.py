"""Do those who hand over and those who take over meet: at one moment, at one place, with one action of each?"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown
from missiontree.checking.fault import Fault, named
from missiontree.checking.staffing import Bond, Staffing
from missiontree.checking.timetable import Timetable


class _Meeting(NamedTuple):
    """Actions that end with a hand-over, and those that start with it: several where they are done jointly."""

    last: tuple[int, ...]
    first: tuple[int, ...]


def hand_over_missed(case: Case) -> Iterator[Fault]:
    """The last action of who hands over does not end when the first action of who takes over starts."""
    for timetable in case.timetables:
        for bond, meeting in _meetings(timetable.staffing):
            ends = [timetable.deeds[leaf] for leaf in meeting.last if leaf in timetable.deeds]
            starts = [timetable.deeds[leaf] for leaf in meeting.first if leaf in timetable.deeds]
            for giver in ends:
                for taker in starts:
                    if abs(giver.end - taker.start) > TOLERANCE:
                        yield Fault(
                            f"schedule {timetable.schedule.rank}: {named(timetable.tree, bond.first)} hands over to "
                            f"{named(timetable.tree, bond.second)}, and ends at {shown(giver.end)} with "
                            f"{named(timetable.tree, giver.leaf)}, while {named(timetable.tree, taker.leaf)} starts at "
                            f"{shown(taker.start)}.",
                            node=named(timetable.tree, taker.leaf),
                            robot=taker.robot,
                            found=shown(taker.start),
                            needed=shown(giver.end),
                        )


def hand_over_unfit(case: Case) -> Iterator[Fault]:
    """A hand-over of something scheduled can never be: no one action on a side, no place, or none in common, no end, or both at once."""
    for timetable in case.timetables:
        meetings = list(_meetings(timetable.staffing))
        givers = {leaf for _, meeting in meetings for leaf in meeting.last}
        for bond, meeting in meetings:
            why = _unfit(timetable, meeting) or ("it takes over itself" if givers.intersection(meeting.first) else "")
            if why:
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {named(timetable.tree, bond.first)} cannot hand over to "
                    f"{named(timetable.tree, bond.second)}: {why}.",
                    node=named(timetable.tree, bond.second),
                )


def _meetings(staffing: Staffing) -> Iterator[tuple[Bond, _Meeting]]:
    for bond in staffing.bonds:
        if bond.kind == "hand_over":
            lasts = (staffing.leaves_of_role[role][-1] for role in staffing.roles_below(bond.first_leaves))
            firsts = (staffing.leaves_of_role[role][0] for role in staffing.roles_below(bond.second_leaves))
            yield bond, _Meeting(tuple(sorted(lasts)), tuple(sorted(firsts)))


def _unfit(timetable: Timetable, meeting: _Meeting) -> str:
    actions = timetable.staffing.actions
    for side in meeting:
        if len(side) > 1 and (actions[side[0]].sync is None or len({actions[leaf].sync for leaf in side}) > 1):
            return "several robots would meet, and do not act jointly"
    together = {actions[leaf].sync for leaf in meeting.last} & {actions[leaf].sync for leaf in meeting.first}
    if set(meeting.last) & set(meeting.first) or together - {None}:
        return "they act jointly"
    for last in meeting.last:
        for first in meeting.first:
            giver, taker = actions[last], actions[first]
            if giver.open_ended:
                return f"{named(timetable.tree, last)} has no end of its own"
            if taker.moves or taker.at is None:
                return f"{named(timetable.tree, first)} is done at no place"
            if taker.at not in _left_at(timetable.staffing, giver.role):
                return f"{named(timetable.tree, first)} is not done where {named(timetable.tree, last)} ends"
    return ""


def _left_at(staffing: Staffing, role: int) -> set[str]:
    """Entities and places at which a role ends: those of its last place, and what its last move there brought."""
    there: set[str] = set()
    for leaf in staffing.leaves_of_role[role]:
        action = staffing.actions[leaf]
        if action.moves:
            there = {name for name in (action.at, *action.brings) if name}
        elif action.at and action.at not in there:
            there = {action.at}
    return there
