"""Whether a schedule of coalitions keeps its rules: skills, presence, ways, order, arrival, and no claim above what is shown."""

from __future__ import annotations

from collections.abc import Iterator
from math import dist

from missiontree.checking.fault import Fault
from missiontree.checking.instance_claims import claim_faults
from missiontree.mission.coalitions import CoalitionMission, CoalitionSchedule, Visit

TOLERANCE_S = 1e-6
"""Of floating-point noise; times are on the grid of 1 ms and rounded up, so that none is too short."""
LOOSE_S = 0.0021
"""By how much a task may last longer, or the makespan exceed the last arrival's true time, for the rounding up."""


def check_coalitions(mission: CoalitionMission, schedule: CoalitionSchedule) -> tuple[Fault, ...]:
    """Every fault of a schedule; none for one that nothing was scheduled in."""
    if schedule.status in {"infeasible", "unknown"}:
        if schedule.visits or schedule.makespan_s:
            return (Fault(f"the status is {schedule.status}, and yet something is scheduled."),)
        return ()
    faults = list(_tasks(mission, schedule))
    if not faults:
        faults += _routes(mission, schedule)
        faults += _order(mission, schedule)
        faults += _claims(schedule)
    return tuple(faults)


def _tasks(mission: CoalitionMission, schedule: CoalitionSchedule) -> Iterator[Fault]:
    """Every task is done once, for as long as it takes, by robots that have its skills together."""
    done = [visit.task for visit in schedule.visits]
    for task in range(len(mission.tasks)):
        if done.count(task) != 1:
            yield Fault(f"task {task + 1} is done {done.count(task)} times.", f"task {task + 1}")
    for visit in schedule.visits:
        if visit.task >= len(mission.tasks) or not all(robot < len(mission.skills) for robot in visit.robots):
            yield Fault(f"task {visit.task + 1} or one of the robots {visit.robots} does not exist.")
            continue
        asked = mission.tasks[visit.task]
        lasts = visit.end_s - visit.start_s
        if not asked.duration_s - TOLERANCE_S <= lasts <= asked.duration_s + LOOSE_S:
            yield Fault(
                f"task {visit.task + 1} lasts {lasts:g} s.", f"task {visit.task + 1}", needed=f"{asked.duration_s:g} s"
            )
        skills = {skill for robot in visit.robots for skill in mission.skills[robot]}
        missing = sorted(set(asked.needs) - skills)
        if missing or not visit.robots or len(set(visit.robots)) < len(visit.robots):
            yield Fault(
                f"task {visit.task + 1} is done by robots {visit.robots}, who lack skills {missing}.",
                f"task {visit.task + 1}",
            )


def _routes(mission: CoalitionMission, schedule: CoalitionSchedule) -> Iterator[Fault]:
    """A robot has the time to come from where it was, and gets to the end."""
    if len(schedule.arrivals_s) != len(mission.skills):
        yield Fault(
            "not every robot arrives at the end.", found=str(len(schedule.arrivals_s)), needed=str(len(mission.skills))
        )
        return
    for robot, arrival in enumerate(schedule.arrivals_s):
        place, free = mission.start, 0.0
        own = sorted(
            (visit for visit in schedule.visits if robot in visit.robots),
            key=lambda visit: (visit.start_s, visit.end_s),
        )
        for visit in own:
            task = mission.tasks[visit.task]
            there = free + dist(place, (task.x_m, task.y_m))
            if visit.start_s < there - TOLERANCE_S:
                yield Fault(
                    f"task {visit.task + 1} starts at {visit.start_s:g} s, and robot {robot} cannot be there before {there:.3f} s.",
                    f"task {visit.task + 1}",
                    f"robot {robot}",
                    f"{visit.start_s:g} s",
                    f"at least {there:.3f} s",
                )
            place, free = (task.x_m, task.y_m), visit.end_s
        there = free + dist(place, mission.end)
        if arrival < there - TOLERANCE_S:
            yield Fault(
                f"robot {robot} is at the end at {arrival:g} s, and cannot be before {there:.3f} s.",
                robot=f"robot {robot}",
            )


def _order(mission: CoalitionMission, schedule: CoalitionSchedule) -> Iterator[Fault]:
    visit_of: dict[int, Visit] = {visit.task: visit for visit in schedule.visits}
    for before, after in mission.precedence:
        if visit_of[after].start_s < visit_of[before].end_s - TOLERANCE_S:
            yield Fault(f"task {after + 1} starts before task {before + 1} ends.", f"task {after + 1}")


def _claims(schedule: CoalitionSchedule) -> Iterator[Fault]:
    last = max(schedule.arrivals_s)
    if abs(last - schedule.makespan_s) > TOLERANCE_S:
        yield Fault("the makespan is not the last arrival.", found=f"{schedule.makespan_s:g} s", needed=f"{last:g} s")
    bound = schedule.certificate.bound
    if bound is not None and bound > schedule.makespan_s + TOLERANCE_S:
        yield Fault(
            "the bound lies above the makespan.", found=f"{bound:g} s", needed=f"at most {schedule.makespan_s:g} s"
        )
    if schedule.status == "optimal" and (bound is None or bound < schedule.makespan_s - TOLERANCE_S):
        yield Fault("the schedule is called optimal, and its bound is another.", found=f"{bound} s")
    yield from claim_faults(schedule.status, schedule.certificate)
