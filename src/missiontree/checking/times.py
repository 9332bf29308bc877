"""Does nothing start before its release time or end after its deadline, and can every alternative meet its deadlines at all?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown, tick, ticks_needed
from missiontree.checking.fault import Fault, named
from missiontree.checking.soonest import too_late
from missiontree.checking.windows import windows


def release_broken(case: Case) -> Iterator[Fault]:
    """An action starts before the release time of its node, or of a node above it."""
    for timetable in case.timetables:
        for leaf, window in windows(case, timetable.staffing).items():
            deed = timetable.deeds.get(leaf)
            if deed is not None and deed.start < window.release - TOLERANCE:
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {named(timetable.tree, leaf)} starts at {shown(deed.start)}; "
                    f"{window.released_by} may not start before {shown(window.release)}.",
                    node=named(timetable.tree, leaf),
                    robot=deed.robot,
                    found=shown(deed.start),
                    needed=f"at least {shown(window.release)}",
                )


def deadline_missed(case: Case) -> Iterator[Fault]:
    """An action ends after the deadline of its node, of a node above it, or of the mission."""
    for timetable in case.timetables:
        for leaf, window in windows(case, timetable.staffing).items():
            deed = timetable.deeds.get(leaf)
            if deed is not None and window.deadline is not None and deed.end > window.deadline + TOLERANCE:
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {named(timetable.tree, leaf)} ends at {shown(deed.end)}; "
                    f"{window.due_to} must have ended by {shown(window.deadline)}.",
                    node=named(timetable.tree, leaf),
                    robot=deed.robot,
                    found=shown(deed.end),
                    needed=f"at most {shown(window.deadline)}",
                )


def robot_away(case: Case) -> Iterator[Fault]:
    """A robot travels or acts before it comes, or after it has left."""
    for timetable in case.timetables:
        spans = [(deed.robot, deed.start, deed.end) for deed in timetable.deeds.values()]
        spans += [(leg.robot, tick(leg.start_s), tick(leg.end_s)) for leg in timetable.schedule.ways]
        spans += [(visit.robot, tick(visit.start_s), tick(visit.end_s)) for visit in timetable.schedule.recharges]
        for robot, start, end in spans:
            kind = case.fleet.type_of.get(robot)
            if kind is None:
                continue
            own = case.fleet.robots[robot]
            since = kind.available_from_s if own.available_from_s is None else own.available_from_s
            until = kind.available_until_s if own.available_until_s is None else own.available_until_s
            early = since is not None and start < ticks_needed(since) - TOLERANCE
            if early or (until is not None and end > tick(until) + TOLERANCE):
                yield Fault(
                    f"schedule {timetable.schedule.rank} has {robot} at work from {shown(start)} to {shown(end)}; it is available "
                    f"from {since or 0:g} s{'' if until is None else f' until {until:g} s'}.",
                    robot=robot,
                    found=f"{shown(start)} to {shown(end)}",
                    needed=f"from {since or 0:g} s" + ("" if until is None else f" until {until:g} s"),
                )


def alternative_late(case: Case) -> Iterator[Fault]:
    """An alternative cannot meet a deadline, however fast its actions follow each other."""
    for staffing in case.staffings:
        late = too_late(case, staffing)
        if late is not None:
            yield Fault(
                f"alternative {staffing.alternative.rank} cannot end {named(staffing.tree, late.leaf)} by "
                f"{shown(late.deadline)}: what comes before it takes longer.",
                node=named(staffing.tree, late.leaf),
                needed=f"an end by {shown(late.deadline)}",
            )
