"""Does every robot travel where it must, as far as it is and no faster than it can?"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown, tick, ticks_needed
from missiontree.checking.fault import Fault, named
from missiontree.checking.journeys import NEAR_M, Journey, Spot, journeys, same_spot
from missiontree.checking.timetable import Timetable
from missiontree.checking.ways import apart_m
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.schedule import TravelLeg


class Travelled(NamedTuple):
    """A leg beside the journey that it must make."""

    timetable: Timetable
    journey: Journey
    leg: TravelLeg
    robot_type: RobotType


def leg_missing(case: Case) -> Iterator[Fault]:
    """A robot is needed somewhere else than where it is and no leg takes it there; or a move whose ends are known has no leg."""
    for timetable, journey in _journeys(case):
        deed = journey.deed
        gap = least_gap(journey.origins, journey.goals)
        if (deed.robot, deed.leaf) in timetable.legs or gap is None:
            continue
        if deed.action.moves or gap > NEAR_M:
            yield Fault(
                f"schedule {timetable.schedule.rank}: {deed.robot} is {gap:g} m from where it does "
                f"{named(timetable.tree, deed.leaf)} and no leg takes it there.",
                node=named(timetable.tree, deed.leaf),
                robot=deed.robot,
                found="no leg",
                needed=f"a leg of at least {gap:g} m",
            )


def least_gap(origins: tuple[Spot, ...], goals: tuple[Spot, ...]) -> float | None:
    """Metres between spots where a robot may be and spots where it must be, at least; None if one of them may be unknown."""
    known = [(origin, goal) for origin in origins for goal in goals if origin is not None and goal is not None]
    return min(apart_m(origin, goal) for origin, goal in known) if len(known) == len(origins) * len(goals) else None


def leg_extra(case: Case) -> Iterator[Fault]:
    """A leg leads to no action of its robot that has a known place, or stands twice."""
    for timetable in case.timetables:
        wanted = {
            (journey.deed.robot, journey.deed.leaf) for journey in journeys(case, timetable) if _may_be_known(journey)
        }
        counts = Counter((leg.robot, leg.leaf) for leg in timetable.schedule.legs)
        for (robot, leaf), count in sorted(counts.items()):
            if count > 1 or (robot, leaf) not in wanted:
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {robot} travels {count} times for {named(timetable.tree, leaf)}.",
                    node=named(timetable.tree, leaf),
                    robot=robot,
                    found=f"{count} legs",
                    needed="1 leg" if (robot, leaf) in wanted else "no leg",
                )


def leg_origin_wrong(case: Case) -> Iterator[Fault]:
    """A leg starts somewhere else than where its robot is."""
    for made in _travelled(case):
        origins = [origin for origin in made.journey.origins if origin is not None]
        if origins and not any(same_spot(origin, made.leg.origin) for origin in origins):
            yield _misplaced(made, "starts at", made.leg.origin, origins[0])


def leg_destination_wrong(case: Case) -> Iterator[Fault]:
    """A leg ends somewhere else than where its action is done at that time."""
    for made in _travelled(case):
        goals = [goal for goal in made.journey.goals if goal is not None]
        if goals and not any(same_spot(goal, made.leg.destination) for goal in goals):
            yield _misplaced(made, "ends at", made.leg.destination, goals[0])


def leg_understated(case: Case) -> Iterator[Fault]:
    """A leg is shorter than the shortest way that its robot may take."""
    for made in _travelled(case):
        needed = case.ways.shortest_m(made.robot_type, made.leg.origin, made.leg.destination)
        if math.isfinite(needed) and made.leg.distance_m < needed - NEAR_M:
            yield _fault(
                made,
                f"claims {made.leg.distance_m:g} m; the shortest way is {needed:g} m",
                f"{made.leg.distance_m:g} m",
                f"at least {needed:g} m",
            )


def leg_without_way(case: Case) -> Iterator[Fault]:
    """A leg leads where its robot cannot or may not go."""
    for made in _travelled(case):
        if math.isinf(case.ways.shortest_m(made.robot_type, made.leg.origin, made.leg.destination)):
            yield _fault(
                made,
                f"leads from {_point(made.leg.origin)} to {_point(made.leg.destination)}; no way open to it does",
                "no way",
                "a way",
            )


def leg_too_fast(case: Case) -> Iterator[Fault]:
    """A leg takes less time than the quickest way, the way it names, or its metres at the speed of the robot and of what it brings."""
    for made in _travelled(case):
        speed = _speed(case, made)
        found = tick(made.leg.end_s) - tick(made.leg.start_s)
        if speed is None:
            needed_s = made.journey.deed.action.duration_s if made.journey.deed.action.moves else 0.0
        else:
            quickest = case.ways.quickest_s(made.robot_type, made.leg.origin, made.leg.destination, speed)
            named_s = case.ways.named_s(made.robot_type, made.leg, speed)
            needed_s = max(quickest if math.isfinite(quickest) else 0.0, named_s, made.leg.distance_m / speed)
        if found < ticks_needed(needed_s) - TOLERANCE:
            needed = shown(ticks_needed(needed_s))
            yield _fault(made, f"takes {shown(found)}; it needs {needed}", shown(found), f"at least {needed}")


def leg_at_wrong_time(case: Case) -> Iterator[Fault]:
    """A leg starts before its robot is free, or ends after its action starts; or it is a move and differs from it in time."""
    for made in _travelled(case):
        deed, start, end = made.journey.deed, tick(made.leg.start_s), tick(made.leg.end_s)
        if deed.action.moves:
            wrong = max(abs(start - deed.start), abs(end - deed.end)) > TOLERANCE
            needed = f"{shown(deed.start)} to {shown(deed.end)}, the time of the move"
        else:
            wrong = start < made.journey.free_from - TOLERANCE or end > deed.start + TOLERANCE or end < start
            needed = f"within {shown(made.journey.free_from)} to {shown(deed.start)}"
        if wrong:
            found = f"{shown(start)} to {shown(end)}"
            yield _fault(made, f"lasts from {found}; needed: {needed}", found, needed)


def leg_via_broken(case: Case) -> Iterator[Fault]:
    """The road nodes that a leg names are none where it needs some, no way open to its robot, or a longer one than the leg claims."""
    for made in _travelled(case):
        problem = case.ways.via_problem(made.robot_type, made.leg)
        if problem:
            yield _fault(made, problem, " - ".join(made.leg.via) or "no road node", "roads and lifts open to the robot")


def move_too_short(case: Case) -> Iterator[Fault]:
    """A move whose ends are not both known takes less than its nominal duration."""
    for timetable, journey in _journeys(case):
        deed = journey.deed
        blind = (deed.robot, deed.leaf) not in timetable.legs and least_gap(journey.origins, journey.goals) is None
        needed = ticks_needed(deed.action.duration_s)
        if deed.action.moves and blind and deed.end - deed.start < needed - TOLERANCE:
            yield Fault(
                f"schedule {timetable.schedule.rank}: {named(timetable.tree, deed.leaf)} takes {shown(deed.end - deed.start)}; "
                f"where it leads is not known, so it takes its nominal {shown(needed)}.",
                node=named(timetable.tree, deed.leaf),
                robot=deed.robot,
                found=shown(deed.end - deed.start),
                needed=f"at least {shown(needed)}",
            )


def _may_be_known(journey: Journey) -> bool:
    """Whether where it begins and where it leads may both be known."""
    return any(origin is not None for origin in journey.origins) and any(goal is not None for goal in journey.goals)


def _journeys(case: Case) -> Iterator[tuple[Timetable, Journey]]:
    return ((timetable, journey) for timetable in case.timetables for journey in journeys(case, timetable))


def _travelled(case: Case) -> Iterator[Travelled]:
    """Legs that lead to an action with a place, of robots that there are."""
    for timetable in case.timetables:
        yield from case.once(_travelled_by, timetable)


def _travelled_by(case: Case, timetable: Timetable) -> list[Travelled]:
    found = []
    for journey in journeys(case, timetable):
        leg = timetable.legs.get((journey.deed.robot, journey.deed.leaf))
        kind = case.fleet.type_of.get(journey.deed.robot)
        if leg is not None and kind is not None:
            found.append(Travelled(timetable, journey, leg, kind))
    return found


def _speed(case: Case, made: Travelled) -> float | None:
    own = made.robot_type.limits.get("max_speed_mps")
    if own is None:
        return None
    brought = (case.scene.by_id.get(entity) for entity in made.journey.deed.action.brings)
    caps = (entity.max_speed_mps for entity in brought if entity is not None)
    return min([own, *(cap for cap in caps if cap is not None)])


def _point(position: Position) -> str:
    return f"({position.x_m:g}, {position.y_m:g}) on floor {position.floor}"


def _misplaced(made: Travelled, verb: str, found: Position, needed: Position) -> Fault:
    return _fault(made, f"{verb} {_point(found)}, not {_point(needed)}", _point(found), _point(needed))


def _fault(made: Travelled, what: str, found: str, needed: str) -> Fault:
    tree, leg = made.timetable.tree, made.leg
    return Fault(
        f"schedule {made.timetable.schedule.rank}: the leg of {leg.robot} for {named(tree, leg.leaf)} {what}.",
        node=named(tree, leg.leaf),
        robot=leg.robot,
        found=found,
        needed=needed,
    )
