"""Where a robot may be when a role begins, and what it takes to get to the role's place: of the checker's own."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

from missiontree.checking.case import Case
from missiontree.checking.clock import ticks_needed
from missiontree.checking.haunts import Haunts
from missiontree.checking.journeys import Spot
from missiontree.checking.timetable import Timetable
from missiontree.mission.fleet import RobotType

MOST_SPOTS = 50
"""Of a type, beyond which it may come from anywhere, and its ways are counted as nothing."""


@dataclass(frozen=True)
class _Ground:
    """
    The spots of a type.

    Parameters
    ----------
    idle
        Where its robots are without having done anything: at their starts and at chargers.
    left
        By spot: how many roles leave their robots there, those that do not take it anywhere left out.
    legs
        Least ticks to each spot that is not idle and that only one role visits, from any other; none if there are too many spots.
    """

    idle: frozenset[Spot]
    left: Mapping[Spot, int]
    legs: Mapping[Spot, int]


class Footing:
    """
    Where robots stand before roles.

    Parameters
    ----------
    case
        Scene, fleet and ways.
    timetable
        Its alternative counts, and not its times.
    """

    def __init__(self, case: Case, timetable: Timetable) -> None:
        self._case, self._staffing = case, timetable.staffing
        self._haunts = case.once(Haunts, timetable)
        self._grounds: dict[str, _Ground | None] = {}

    def before(self, role: int) -> frozenset[Spot] | None:
        """Where a robot may be when a role begins: at its start, at a charger, or where another role of its type ends; None: anywhere."""
        ground = self._ground(self._staffing.type_of_role[role])
        if ground is None:
            return None
        own = self._last(role)
        only_here = {spot for spot in own if ground.left[spot] == 1 and spot not in ground.idle}
        return (ground.idle | ground.left.keys()) - only_here

    def entry(self, role: int) -> int:
        """Least ticks of the way to where a role begins, for a place that robots come to for nothing else; 0 for others."""
        ground = self._ground(self._staffing.type_of_role[role])
        first = self._staffing.leaves_of_role[role][0]
        if ground is None or self._staffing.actions[first].at is None:
            return 0
        return min((ground.legs.get(spot, 0) for spot in self._haunts.of_leaf(first)), default=0)

    def _last(self, role: int) -> frozenset[Spot]:
        """Where a role leaves its robot; nowhere if it takes it nowhere."""
        for leaf in reversed(self._staffing.leaves_of_role[role]):
            if self._staffing.actions[leaf].at is not None or self._staffing.actions[leaf].moves:
                return self._haunts.of_leaf(leaf)
        return frozenset()

    def _ground(self, type_id: str) -> _Ground | None:
        if type_id not in self._grounds:
            self._grounds[type_id] = self._surveyed(self._case.fleet.by_id[type_id])
        return self._grounds[type_id]

    def _surveyed(self, kind: RobotType) -> _Ground | None:
        spots = self._case.scene.charger_spots
        plugs = {spots.get(one.id) for one in self._case.scene.chargers if one.serves(kind.id)}
        idle = self._haunts.starts(kind.id) | plugs
        left, visits = Counter[Spot](), Counter[Spot]()
        for role, type_id in self._staffing.type_of_role.items():
            if type_id == kind.id:
                left.update(self._last(role))
                visits.update(self._visited(role))
            if len(idle) + len(left) > MOST_SPOTS:
                return None
        everywhere = idle | visits.keys()
        if None in everywhere or len(everywhere) > MOST_SPOTS:
            return _Ground(idle, left, {})
        alone = [spot for spot, roles in visits.items() if roles == 1 and spot not in idle]
        return _Ground(idle, left, {spot: self._least_leg(kind, everywhere, spot) for spot in alone})

    def _visited(self, role: int) -> frozenset[Spot]:
        actions = ((leaf, self._staffing.actions[leaf]) for leaf in self._staffing.leaves_of_role[role])
        placed = (self._haunts.of_leaf(leaf) for leaf, action in actions if action.at is not None or action.moves)
        return frozenset[Spot]().union(*placed)

    def _least_leg(self, kind: RobotType, origins: frozenset[Spot], goal: Spot) -> int:
        """Least ticks to a spot from any other; 0 if there is no way, or if nobody knows how fast they are."""
        speed = kind.limits.get("max_speed_mps")
        if speed is None or goal is None:
            return 0
        others = (origin for origin in origins if origin is not None and origin != goal)
        least = min((self._case.ways.quickest_s(kind, origin, goal, speed) for origin in others), default=0.0)
        return ticks_needed(least) if math.isfinite(least) else 0
