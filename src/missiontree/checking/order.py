"""Does everything happen in the order that roles, precedence and until links ask for?"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown
from missiontree.checking.fault import Fault, named
from missiontree.mission.tree import IN_ORDER


def role_out_of_order(case: Case) -> Iterator[Fault]:
    """An action starts before the action that stands before it in its role has ended."""
    for timetable in case.timetables:
        for deeds in timetable.by_role.values():
            for earlier, later in pairwise(deeds):
                if later.start < earlier.end - TOLERANCE:
                    yield Fault(
                        f"schedule {timetable.schedule.rank}: {named(timetable.tree, later.leaf)} starts at {shown(later.start)}, "
                        f"before {named(timetable.tree, earlier.leaf)} of the same role ends at {shown(earlier.end)}.",
                        node=named(timetable.tree, later.leaf),
                        robot=later.robot,
                        found=shown(later.start),
                        needed=f"at least {shown(earlier.end)}",
                    )


def precedence_broken(case: Case) -> Iterator[Fault]:
    """The second node of a precedence starts before the first has ended."""
    for timetable in case.timetables:
        for bond in timetable.staffing.bonds:
            first, second = timetable.span(bond.first_leaves), timetable.span(bond.second_leaves)
            if bond.kind in IN_ORDER and first and second and second[0] < first[1] - TOLERANCE:
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {named(timetable.tree, bond.second)} starts at {shown(second[0])}, "
                    f"before {named(timetable.tree, bond.first)} ends at {shown(first[1])}.",
                    node=named(timetable.tree, bond.second),
                    found=shown(second[0]),
                    needed=f"at least {shown(first[1])}",
                )


def until_broken(case: Case) -> Iterator[Fault]:
    """An open-ended action is not under way when the nodes that its until links name end, or does not end with the last of them."""
    for timetable in case.timetables:
        until: dict[int, int] = {}
        for bond in timetable.staffing.bonds:
            if bond.kind == "until" and (second := timetable.span(bond.second_leaves)):
                for leaf in bond.first_leaves:
                    until[leaf] = max(until.get(leaf, 0), second[1])
        for leaf, end in until.items():
            deed = timetable.deeds.get(leaf)
            if deed is None or not deed.action.open_ended:
                continue
            if abs(deed.end - end) > TOLERANCE or deed.start >= min(end, deed.end):
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {named(timetable.tree, leaf)} lasts from {shown(deed.start)} to "
                    f"{shown(deed.end)}; it starts before {shown(end)} and lasts until then.",
                    node=named(timetable.tree, leaf),
                    robot=deed.robot,
                    found=f"{shown(deed.start)} to {shown(deed.end)}",
                    needed=f"before {shown(end)}, until {shown(end)}",
                )
