"""Does every action take its time, joint ones together?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, on_grid, shown, ticks_needed
from missiontree.checking.fault import Fault, named
from missiontree.checking.timetable import Deed, Timetable
from missiontree.mission.schedule import OwnLeg, Recharge, ScheduledAction, TravelLeg


def time_off_grid(case: Case) -> Iterator[Fault]:
    """A time of a schedule is no whole number of milliseconds."""
    for timetable in case.timetables:
        schedule = timetable.schedule
        entries: tuple[ScheduledAction | TravelLeg, ...] = (*schedule.actions, *schedule.legs)
        for entry in entries:
            for time_s in (entry.start_s, entry.end_s):
                if not on_grid(time_s):
                    yield Fault(
                        f"schedule {schedule.rank}: {named(timetable.tree, entry.leaf)} has time {time_s!r} s, off the grid of 1 ms.",
                        node=named(timetable.tree, entry.leaf),
                        robot=entry.robot,
                        found=f"{time_s!r} s",
                        needed="a whole number of milliseconds",
                    )
        others: list[OwnLeg | Recharge] = [*schedule.returns, *schedule.recharges]
        others += [visit.leg for visit in schedule.recharges if visit.leg is not None]
        for one in others:
            for time_s in (one.start_s, one.end_s):
                if not on_grid(time_s):
                    yield Fault(
                        f"schedule {schedule.rank}: {one.robot} has time {time_s!r} s on a way of its own, off the grid of 1 ms.",
                        robot=one.robot,
                        found=f"{time_s!r} s",
                        needed="a whole number of milliseconds",
                    )


def duration_wrong(case: Case) -> Iterator[Fault]:
    """An action that is no move takes less, or more, than its duration; a joint one than the longest of its group."""
    for timetable in case.timetables:
        stretched = _open_until(timetable)
        for deed in timetable.deeds.values():
            if deed.action.moves or deed.leaf in stretched:
                continue
            group = _group(timetable, deed)
            needed = max(ticks_needed(other.action.duration_s) for other in group if not other.action.moves)
            found = deed.end - deed.start
            moving = any(other.action.moves for other in group)
            if found < needed - TOLERANCE or (found > needed + TOLERANCE and not moving):
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {named(timetable.tree, deed.leaf)} takes {shown(found)}; "
                    f"its duration is {shown(needed)}.",
                    node=named(timetable.tree, deed.leaf),
                    robot=deed.robot,
                    found=shown(found),
                    needed=shown(needed),
                )


def _open_until(timetable: Timetable) -> set[int]:
    """Open-ended actions whose end an until link sets."""
    return {
        leaf
        for bond in timetable.staffing.bonds
        if bond.kind == "until" and timetable.span(bond.second_leaves)
        for leaf in bond.first_leaves
        if timetable.staffing.actions[leaf].open_ended
    }


def _group(timetable: Timetable, deed: Deed) -> list[Deed]:
    if deed.action.sync is None:
        return [deed]
    leaves = timetable.staffing.joint[deed.action.sync]
    return [timetable.deeds[leaf] for leaf in leaves if leaf in timetable.deeds]


def joint_broken(case: Case) -> Iterator[Fault]:
    """Joint actions do not start and end together."""
    for timetable in case.timetables:
        for leaves in timetable.staffing.joint.values():
            deeds = [timetable.deeds[leaf] for leaf in leaves if leaf in timetable.deeds]
            for deed in deeds[1:]:
                if max(abs(deed.start - deeds[0].start), abs(deed.end - deeds[0].end)) > TOLERANCE:
                    yield Fault(
                        f"schedule {timetable.schedule.rank}: {named(timetable.tree, deed.leaf)} and "
                        f"{named(timetable.tree, deeds[0].leaf)} are joint and do not start and end together.",
                        node=named(timetable.tree, deed.leaf),
                        robot=deed.robot,
                        found=f"{shown(deed.start)} to {shown(deed.end)}",
                        needed=f"{shown(deeds[0].start)} to {shown(deeds[0].end)}",
                    )


def schedule_unsorted(case: Case) -> Iterator[Fault]:
    """Actions or legs of a schedule are not listed by start, then leaf, then robot."""
    for timetable in case.timetables:
        schedule = timetable.schedule
        for what, entries in (("actions", schedule.actions), ("legs", schedule.legs)):
            keys = [(entry.start_s, entry.leaf, entry.robot) for entry in entries]
            if keys != sorted(keys):
                yield Fault(f"the {what} of schedule {schedule.rank} are not listed by start.")
        homeward = [(leg.start_s, leg.robot) for leg in schedule.returns]
        visits = [(visit.start_s, visit.robot) for visit in schedule.recharges]
        for what, listed in (("ways home", homeward), ("visits to chargers", visits)):
            if listed != sorted(listed):
                yield Fault(f"the {what} of schedule {schedule.rank} are not listed by start.")
