"""A schedule read beside the alternative it belongs to, in ticks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from functools import cached_property
from heapq import heappop, heappush
from itertools import pairwise
from typing import NamedTuple

from missiontree.checking.clock import tick
from missiontree.checking.staffing import Staffing
from missiontree.mission.grounded import Action, GroundedTree
from missiontree.mission.schedule import Recharge, Schedule, TravelLeg
from missiontree.mission.tree import IN_ORDER


class Deed(NamedTuple):
    """One scheduled action."""

    leaf: int
    action: Action
    robot: str
    start: int
    end: int


class Timetable:
    """
    One schedule that claims to work.

    Parameters
    ----------
    staffing
        Its alternative.
    schedule
        The schedule; what it says of actions that are not selected is left to the rules on references.
    """

    def __init__(self, staffing: Staffing, schedule: Schedule) -> None:
        self.staffing = staffing
        self.schedule = schedule

    @property
    def tree(self) -> GroundedTree:
        """The grounded tree."""
        return self.staffing.tree

    @cached_property
    def deeds(self) -> dict[int, Deed]:
        """Scheduled actions by selected leaf; the first counts where one stands twice."""
        deeds: dict[int, Deed] = {}
        for done in self.schedule.actions:
            action = self.staffing.actions.get(done.leaf)
            if action is not None and done.leaf not in deeds:
                deeds[done.leaf] = Deed(done.leaf, action, done.robot, tick(done.start_s), tick(done.end_s))
        return deeds

    @cached_property
    def robot_of_role(self) -> dict[int, str]:
        """Robot by reached role; the first counts where a role is filled twice."""
        robots: dict[int, str] = {}
        for assignment in self.schedule.assignments:
            if assignment.role in self.staffing.leaves_of_role:
                robots.setdefault(assignment.role, assignment.robot)
        return robots

    @cached_property
    def by_robot(self) -> dict[str, tuple[Deed, ...]]:
        """
        What every robot does, in order of time.

        Actions that take no time stand, at one moment, after what ends a role there and before what begins a longer one, since a robot
        is held from the first to the last action of a role; and else in an order that precedence allows.
        """
        place, held = self._place_in_order, self._held
        robots: dict[str, list[Deed]] = {}

        def when(deed: Deed) -> tuple[int, int, int, int, int]:
            return (deed.start, deed.end, *held[deed.robot, deed.action.role], place[deed.leaf])

        for deed in sorted(self.deeds.values(), key=when):
            robots.setdefault(deed.robot, []).append(deed)
        return {robot: tuple(deeds) for robot, deeds in sorted(robots.items())}

    def turns(self, robot: str) -> Iterator[Deed | Recharge]:
        """What a robot does and its visits to chargers, in order of time."""
        visits = [visit for visit in self.schedule.recharges if visit.robot == robot]
        visits.sort(key=lambda visit: (visit.start_s, visit.end_s))
        for deed in self.by_robot.get(robot, ()):
            while visits and tick(visits[0].start_s) < deed.start:
                yield visits.pop(0)
            yield deed
        yield from visits

    @cached_property
    def _held(self) -> dict[tuple[str, int], tuple[int, int]]:
        """From when to when each robot does something of each role."""
        held: dict[tuple[str, int], tuple[int, int]] = {}
        for deed in self.deeds.values():
            start, end = held.get((deed.robot, deed.action.role), (deed.start, deed.end))
            held[deed.robot, deed.action.role] = min(start, deed.start), max(end, deed.end)
        return held

    def surely_before(self, first: int, second: int) -> bool:
        """Whether precedence and roles put one selected leaf before another; what is done jointly starts and ends together."""
        seen, stack = set(self._together(first)), [*self._together(first)]
        goals = {*self._together(second)}
        while stack:
            later = [node for node in self._after[stack.pop()] if node not in seen]
            if goals.intersection(later):
                return True
            for node in later:
                group = self._together(node)
                seen.update(group)
                stack.extend(group)
        return False

    def _together(self, node: int) -> tuple[int, ...]:
        """A leaf and those that are joint with it; a gate alone."""
        action = self.staffing.actions.get(node)
        return (
            (node,) if action is None or action.sync is None else tuple(self.staffing.joint.get(action.sync, (node,)))
        )

    @cached_property
    def _after(self) -> dict[int, list[int]]:
        """What comes right after every selected leaf; a negative number is a gate between two nodes of a precedence."""
        after: dict[int, list[int]] = {leaf: [] for leaf in self.staffing.actions}
        for number, bond in enumerate(bond for bond in self.staffing.bonds if bond.kind in IN_ORDER):
            gate = -1 - number
            after[gate] = list(bond.second_leaves)
            for leaf in bond.first_leaves:
                after[leaf].append(gate)
        for leaves in self.staffing.leaves_of_role.values():
            for earlier, later in pairwise(leaves):
                after[earlier].append(later)
        return after

    @cached_property
    def _place_in_order(self) -> dict[int, int]:
        """Rank of every selected leaf in an order that keeps precedence, smallest leaf first."""
        missing = Counter(later for successors in self._after.values() for later in successors)
        ready = [node for node in sorted(self._after) if not missing[node]]
        place: dict[int, int] = {}
        while ready:
            node = heappop(ready)
            place[node] = len(place)
            for later in self._after[node]:
                missing[later] -= 1
                if not missing[later]:
                    heappush(ready, later)
        return place | {leaf: len(place) + leaf for leaf in self.staffing.actions if leaf not in place}

    @cached_property
    def by_role(self) -> dict[int, tuple[Deed, ...]]:
        """Scheduled actions of every reached role, in tree order."""
        return {
            role: tuple(self.deeds[leaf] for leaf in leaves if leaf in self.deeds)
            for role, leaves in self.staffing.leaves_of_role.items()
        }

    def span(self, leaves: tuple[int, ...]) -> tuple[int, int] | None:
        """Earliest start and latest end of some leaves; None if none of them is scheduled."""
        deeds = [self.deeds[leaf] for leaf in leaves if leaf in self.deeds]
        return (min(deed.start for deed in deeds), max(deed.end for deed in deeds)) if deeds else None

    @cached_property
    def legs(self) -> dict[tuple[str, int], TravelLeg]:
        """Travel by robot and leaf; the first counts where one stands twice."""
        legs: dict[tuple[str, int], TravelLeg] = {}
        for leg in self.schedule.legs:
            legs.setdefault((leg.robot, leg.leaf), leg)
        return legs
