"""Does no shared resource of the scene have more robots at one time than it has room for?"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown, tick
from missiontree.checking.fault import Fault, named
from missiontree.checking.timetable import Timetable
from missiontree.mission.schedule import Leg


def held_unknown(case: Case) -> Iterator[Fault]:
    """An action holds what is no shared resource of the scene."""
    there = {resource.id for resource in case.scene.resources}
    for leaf, node in enumerate(case.tree.nodes if case.tree is not None else ()):
        for name in node.action.holds if node.action is not None and case.tree is not None else ():
            if name not in there:
                assert case.tree is not None
                yield Fault(
                    f"{named(case.tree, leaf)} holds {name}, which is no shared resource of the scene.",
                    node=named(case.tree, leaf),
                    found=name,
                    needed=", ".join(sorted(there)) or "no shared resource",
                )


def resource_overfull(case: Case) -> Iterator[Fault]:
    """More robots hold a shared resource at one time than it has room for."""
    for timetable in case.timetables:
        held = _held(case, timetable)
        for resource in case.scene.resources:
            crowd = _largest_crowd(held.get(resource.id, []))
            if len(crowd) > resource.capacity:
                last = max(crowd, key=lambda hold: (hold.start, hold.doing))
                who = ", ".join(f"{hold.robot} in {hold.doing}" for hold in crowd)
                yield Fault(
                    f"schedule {timetable.schedule.rank}: at {shown(last.start)} {resource.id} is held by {who}; it has room for "
                    f"{resource.capacity}.",
                    node=last.doing,
                    robot=last.robot,
                    found=f"{len(crowd)} at once",
                    needed=f"at most {resource.capacity}",
                )


class _Hold(NamedTuple):
    """A robot that holds a resource, in ticks, and what it does meanwhile."""

    start: int
    end: int
    robot: str
    doing: str


def _held(case: Case, timetable: Timetable) -> dict[str, list[_Hold]]:
    """Who holds what: by actions that name it, and on ways along roads and by lifts that do. A move and its way are one."""
    found: dict[str, dict[object, _Hold]] = {}
    for deed in timetable.deeds.values():
        for name in deed.action.holds:
            hold = _Hold(deed.start, deed.end, deed.robot, named(timetable.tree, deed.leaf))
            found.setdefault(name, {})[deed.leaf, True] = hold
    for way in timetable.schedule.legs:
        deed_of = timetable.deeds.get(way.leaf)
        is_move = deed_of is not None and deed_of.action.moves
        for name in _passed(case, way):
            hold = _Hold(tick(way.start_s), tick(way.end_s), way.robot, f"the way to {named(timetable.tree, way.leaf)}")
            found.setdefault(name, {}).setdefault((way.leaf, is_move), hold)
    for home in timetable.schedule.returns:
        for name in _passed(case, home):
            found.setdefault(name, {})[home.robot] = _Hold(
                tick(home.start_s), tick(home.end_s), home.robot, "the way home"
            )
    for number, visit in enumerate(timetable.schedule.recharges):
        leg = visit.leg
        for name in _passed(case, leg) if leg is not None else ():
            assert leg is not None
            hold = _Hold(tick(leg.start_s), tick(leg.end_s), visit.robot, f"the way to {visit.charger}")
            found.setdefault(name, {})[visit.robot, number] = hold
    return {name: list(holds.values()) for name, holds in found.items()}


def _passed(case: Case, leg: Leg) -> list[str]:
    """Shared resources of all roads and lifts that join two nodes which a way names one after the other."""
    roads = case.scene.roads
    neighbours = {frozenset(pair) for pair in pairwise(leg.via)}
    names = [road.resource for road in (roads.roads if roads else ()) if frozenset(road.ends) in neighbours]
    for lift in roads.lifts if roads else ():
        names += [lift.resource for pair in neighbours if pair <= {*lift.stops} and len(pair) == 2]
    return list(dict.fromkeys(name for name in names if name is not None))


def _largest_crowd(holds: list[_Hold]) -> list[_Hold]:
    """The most that hold a resource at one time: some one of them starts last, and all others are under way by then."""
    crowds = (
        [other for other in holds if other is last or (other.start <= last.start and _clash(other, last))]
        for last in holds
    )
    return max(crowds, key=len, default=[])


def _clash(one: _Hold, other: _Hold) -> bool:
    """Whether two overlap by more than two clocks may differ; what takes no time does so strictly inside another."""
    return one.start < other.end - TOLERANCE and other.start < one.end - TOLERANCE
