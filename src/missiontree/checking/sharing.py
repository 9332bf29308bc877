"""Does no shared resource of the scene have more robots at one time than it has room for?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown
from missiontree.checking.fault import Fault, named
from missiontree.checking.timetable import Deed, Timetable


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
        for resource in case.scene.resources:
            crowd = _largest_crowd(timetable, resource.id)
            if len(crowd) > resource.capacity:
                last = max(crowd, key=lambda deed: (deed.start, deed.leaf))
                who = ", ".join(f"{deed.robot} in {named(timetable.tree, deed.leaf)}" for deed in crowd)
                yield Fault(
                    f"schedule {timetable.schedule.rank}: at {shown(last.start)} {resource.id} is held by {who}; it has room for "
                    f"{resource.capacity}.",
                    node=named(timetable.tree, last.leaf),
                    robot=last.robot,
                    found=f"{len(crowd)} at once",
                    needed=f"at most {resource.capacity}",
                )


def _largest_crowd(timetable: Timetable, resource: str) -> list[Deed]:
    """The most deeds that hold a resource at one time: some deed of them starts last, and all others are under way by then."""
    holders = [deed for deed in timetable.deeds.values() if resource in deed.action.holds]
    crowds = (
        [other for other in holders if other is last or (other.start <= last.start and _clash(other, last))]
        for last in holders
    )
    return max(crowds, key=len, default=[])


def _clash(one: Deed, other: Deed) -> bool:
    """Whether two deeds overlap by more than two clocks may differ; one that takes no time does so strictly inside another."""
    return one.start < other.end - TOLERANCE and other.start < one.end - TOLERANCE
