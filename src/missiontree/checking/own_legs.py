"""Does every robot that travels for its own sake get where it must, as far as it is and no faster than it can?"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown, tick, ticks_needed
from missiontree.checking.errands import Run, errands, returns, runs
from missiontree.checking.fault import Fault
from missiontree.checking.journeys import NEAR_M, same_spot
from missiontree.checking.travel import least_gap
from missiontree.checking.windows import mission_deadline
from missiontree.mission.position import Position


def own_leg_missing(case: Case) -> Iterator[Fault]:
    """A robot must be somewhere else than where it is, for its own sake, and no leg takes it there."""
    for timetable in case.timetables:
        for errand in errands(case, timetable):
            gap = least_gap(errand.origins, (errand.goal,))
            if errand.leg is None and gap is not None and gap > NEAR_M:
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {errand.robot} is {gap:g} m away, and {errand.what} is not planned.",
                    robot=errand.robot,
                    found="no leg",
                    needed=f"a leg of at least {gap:g} m",
                )


def return_extra(case: Case) -> Iterator[Fault]:
    """A way home that nobody asks for, of a robot that does nothing, from or to where nobody knows, or a second one."""
    for timetable in case.timetables:
        asked = {
            errand.robot
            for errand in (returns(case, timetable) if case.plan.brief.return_home else ())
            if any(origin is not None for origin in errand.origins) and errand.goal is not None
        }
        counts = Counter(leg.robot for leg in timetable.schedule.returns)
        for robot, count in sorted(counts.items()):
            if count > 1 or robot not in asked:
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {robot} goes home {count} times.",
                    robot=robot,
                    found=f"{count} ways home",
                    needed="1 way home" if robot in asked else "no way home",
                )


def return_late(case: Case) -> Iterator[Fault]:
    """A robot is home after the mission's deadline."""
    deadline = mission_deadline(case)
    for timetable in case.timetables if deadline is not None else ():
        for leg in timetable.schedule.returns:
            if tick(leg.end_s) > (deadline or 0) + TOLERANCE:
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {leg.robot} is home at {leg.end_s:g} s; the mission must have ended by "
                    f"{shown(deadline or 0)}.",
                    robot=leg.robot,
                    found=f"{leg.end_s:g} s",
                    needed=f"at most {shown(deadline or 0)}",
                )


def own_leg_misplaced(case: Case) -> Iterator[Fault]:
    """A leg starts somewhere else than where its robot is, ends somewhere else than where it must be, or is another robot's."""
    for run in runs(case):
        if run.leg.robot != run.errand.robot:
            yield _fault(run, f"is needed by {run.errand.robot}", run.leg.robot, run.errand.robot)
        for verb, found, spots in (
            ("starts at", run.leg.origin, run.errand.origins),
            ("ends at", run.leg.destination, (run.errand.goal,)),
        ):
            needed = [spot for spot in spots if spot is not None]
            if needed and not any(same_spot(spot, found) for spot in needed):
                yield _fault(run, f"{verb} {_point(found)}, not {_point(needed[0])}", _point(found), _point(needed[0]))


def own_leg_without_way(case: Case) -> Iterator[Fault]:
    """A leg leads where its robot cannot or may not go."""
    for run in runs(case):
        if math.isinf(case.ways.shortest_m(run.robot_type, run.leg.origin, run.leg.destination)):
            yield _fault(
                run,
                f"leads from {_point(run.leg.origin)} to {_point(run.leg.destination)}; no way open to it does",
                "no way",
                "a way",
            )


def own_leg_understated(case: Case) -> Iterator[Fault]:
    """A leg is shorter than the shortest way that its robot may take."""
    for run in runs(case):
        needed = case.ways.shortest_m(run.robot_type, run.leg.origin, run.leg.destination)
        if math.isfinite(needed) and run.leg.distance_m < needed - NEAR_M:
            found = f"{run.leg.distance_m:g} m"
            yield _fault(run, f"claims {found}; the shortest way is {needed:g} m", found, f"at least {needed:g} m")


def own_leg_too_fast(case: Case) -> Iterator[Fault]:
    """A leg takes less time than the quickest way, the way it names, or its metres at the robot's speed."""
    for run in runs(case):
        speed = run.robot_type.limits.get("max_speed_mps")
        if speed is None:
            continue
        quickest = case.ways.quickest_s(run.robot_type, run.leg.origin, run.leg.destination, speed)
        named_s = case.ways.named_s(run.robot_type, run.leg, speed)
        seconds = max(quickest if math.isfinite(quickest) else 0.0, named_s, run.leg.distance_m / speed)
        found = tick(run.leg.end_s) - tick(run.leg.start_s)
        if found < ticks_needed(seconds) - TOLERANCE:
            needed = shown(ticks_needed(seconds))
            yield _fault(run, f"takes {shown(found)}; it needs {needed}", shown(found), f"at least {needed}")


def own_leg_at_wrong_time(case: Case) -> Iterator[Fault]:
    """A leg starts before its robot is free, or ends after it must be there."""
    for run in runs(case):
        start, end, until = tick(run.leg.start_s), tick(run.leg.end_s), run.errand.until
        if start < run.errand.free_from - TOLERANCE or end < start or (until is not None and end > until + TOLERANCE):
            found = f"{shown(start)} to {shown(end)}"
            needed = f"from {shown(run.errand.free_from)}" + ("" if until is None else f" to {shown(until)}")
            yield _fault(run, f"lasts from {found}; needed: {needed}", found, needed)


def own_leg_via_broken(case: Case) -> Iterator[Fault]:
    """The road nodes that a leg names are none where it needs some, no way open to its robot, or a longer one than the leg claims."""
    for run in runs(case):
        problem = case.ways.via_problem(run.robot_type, run.leg)
        if problem:
            yield _fault(run, problem, " - ".join(run.leg.via) or "no road node", "roads and lifts open to the robot")


def _point(position: Position) -> str:
    return f"({position.x_m:g}, {position.y_m:g}) on floor {position.floor}"


def _fault(run: Run, what: str, found: str, needed: str) -> Fault:
    return Fault(
        f"schedule {run.timetable.schedule.rank}: {run.leg.robot}, {run.errand.what}: the leg {what}.",
        robot=run.leg.robot,
        found=found,
        needed=needed,
    )
