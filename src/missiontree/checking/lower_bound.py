"""
A bound of the checker's own: no schedule of an alternative can be shorter, by design alone and by the checker's own distances.

Three plain arguments. *Critical path*: actions of a role, of a precedence and of an until link follow each other, with the travel
that is certain between them, and none starts before its release time, or before the nearest robot of its type can be there; where robots
return, the way home follows. *Load*: robots take one role at a time, so the roles of a type, with the ways to places that robots come
to for nothing else (:mod:`footing`), fill at least their sum shared among its robots, after the earliest start and before the least that
must still follow. *Resource load*: the same of what holds a shared resource, and its capacity. *Refill load*,
for schedules that claim it: what the actions of a type use beyond what its robots hold is taken in before one role or other, which
takes the robots time, and the chargers; ways count as nothing there.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from itertools import pairwise

from missiontree.checking.case import Case
from missiontree.checking.clock import ticks_needed
from missiontree.checking.footing import Footing
from missiontree.checking.haunts import Haunts
from missiontree.checking.journeys import Spot
from missiontree.checking.load import Piece, shared
from missiontree.checking.refills import refill_load
from missiontree.checking.timetable import Timetable
from missiontree.checking.windows import windows
from missiontree.mission.fleet import RobotType
from missiontree.mission.grounded import Action
from missiontree.mission.tree import IN_ORDER

MOST_WAYS = 2500
"""Pairs of points between which the least way is sought for one action, beyond which travel is counted as nothing."""


def least_makespan(case: Case, timetable: Timetable) -> int | None:
    """
    Ticks below which no schedule of the timetable's alternative can be, 0 if its order is circular; None if a type is unknown.

    Refills count if the schedule claims that they do.
    """
    if any(action.robot_type not in case.fleet.by_id for action in timetable.staffing.actions.values()):
        return None
    return _Bound(case, timetable).ticks(refills=timetable.schedule.certificate.method == "refill_load")


class _Bound:
    """Events are the starts and ends of groups of joint actions, and gates between two nodes of a link."""

    def __init__(self, case: Case, timetable: Timetable) -> None:
        self._case, self._staffing = case, timetable.staffing
        self._actions = timetable.staffing.actions
        self._haunts, self._footing = case.once(Haunts, timetable), case.once(Footing, timetable)
        self._group = {leaf: ("alone", leaf) for leaf in self._actions}
        for sync, leaves in self._staffing.joint.items():
            self._group |= dict.fromkeys(leaves, ("joint", sync))
        self._stretched = {
            leaf
            for bond in self._staffing.bonds
            if bond.kind == "until"
            for leaf in bond.first_leaves
            if self._actions[leaf].open_ended
        }
        self._before = {
            later: earlier for leaves in self._staffing.leaves_of_role.values() for earlier, later in pairwise(leaves)
        }
        self._after: dict[object, list[tuple[object, int]]] = {}
        self._release: dict[object, int] = {}
        self._wait = {leaf: self._travel(leaf) for leaf in self._actions}
        self._length = self._lengths()
        self._draw()

    def ticks(self, refills: bool) -> int:
        """The largest of the bounds."""
        order = self._order()
        if order is None:
            return 0
        heads = {event: self._release.get(event, 0) for event in order}
        for event in order:
            for later, weight in self._after[event]:
                heads[later] = max(heads[later], heads[event] + weight)
        tails = dict.fromkeys(order, 0)
        for event in reversed(order):
            tails[event] = max((weight + tails[later] for later, weight in self._after[event]), default=0)
        least = max(max(heads.values(), default=0), self._load(heads, tails), self._resource_load(heads, tails))
        return (
            max(least, refill_load(self._case, self._actions.values(), self._pieces(heads, tails)))
            if refills
            else least
        )

    def _start(self, leaf: int) -> object:
        return ("start", self._group[leaf])

    def _end(self, leaf: int) -> object:
        return ("end", self._group[leaf])

    def _add(self, event: object, later: object, weight: int = 0) -> None:
        self._after.setdefault(event, []).append((later, weight))
        self._after.setdefault(later, [])

    def _draw(self) -> None:
        for leaf, action in self._actions.items():
            self._add(self._start(leaf), self._end(leaf), self._length[self._group[leaf]])
            there = self._end(leaf) if action.moves else self._start(leaf)
            since = self._since(action.robot_type)
            begin = since + self._arrival(action, leaf) + self._standing(leaf)
            self._release[there] = max(self._release.get(there, 0), begin)
            self._release[self._start(leaf)] = max(self._release.get(self._start(leaf), 0), since)
        for leaf, window in windows(self._case, self._staffing).items():
            self._release[self._start(leaf)] = max(self._release.get(self._start(leaf), 0), window.release)
        if self._case.plan.brief.return_home:
            for leaves in self._staffing.leaves_of_role.values():
                self._add(self._end(leaves[-1]), ("home", leaves[-1]), self._way_home(leaves))
        for later, earlier in self._before.items():
            weight = 0 if self._actions[later].moves else self._wait[later]
            self._add(self._end(earlier), self._start(later), weight)
        for number, bond in enumerate(self._staffing.bonds):
            gate = ("gate", number)
            if bond.kind in IN_ORDER:
                for leaf in bond.first_leaves:
                    self._add(self._end(leaf), gate)
                for leaf in bond.second_leaves:
                    self._add(gate, self._start(leaf))
            elif bond.kind == "until":
                for leaf in bond.second_leaves:
                    self._add(self._end(leaf), gate)
                for leaf in self._stretched.intersection(bond.first_leaves):
                    self._add(gate, self._end(leaf))

    def _lengths(self) -> dict[tuple[str, int], int]:
        """Least ticks of every group of joint actions: the longest of its actions."""
        lengths: dict[tuple[str, int], int] = {}
        for leaf, action in self._actions.items():
            own = self._wait[leaf] if action.moves else ticks_needed(action.duration_s)
            own = 1 if leaf in self._stretched else own
            lengths[self._group[leaf]] = max(lengths.get(self._group[leaf], 0), own)
        return lengths

    def _travel(self, leaf: int) -> int:
        """Least ticks of a move, or of the way to an action from where its role was before."""
        action, there = self._actions[leaf], self._haunts.of_leaf(leaf)
        here = self._here(leaf)
        if here is None and action.moves:
            here = self._footing.before(action.role)
        if there == {None}:
            return self._nominal(action)
        if here is None or len(here) * len(there) > MOST_WAYS:  # the robot may have got there before, or be anywhere
            return 0
        return min((self._way(action, origin, goal) for origin in here for goal in there), default=0)

    def _here(self, leaf: int) -> frozenset[Spot] | None:
        """Where a robot may be after what its role did before an action; None if its role did nothing anywhere yet."""
        earlier = self._before.get(leaf)
        while earlier is not None:
            if self._actions[earlier].at is not None or self._actions[earlier].moves:
                return self._haunts.of_leaf(earlier)
            earlier = self._before.get(earlier)
        return None

    def _standing(self, leaf: int) -> int:
        """Least ticks of what a role does before its first place: a robot stands still meanwhile, wherever it came from."""
        if self._actions[leaf].at is None or self._here(leaf) is not None:
            return 0
        ticks, earlier = 0, self._before.get(leaf)
        while earlier is not None:
            ticks += self._length[self._group[earlier]]
            earlier = self._before.get(earlier)
        return ticks

    def _way(self, action: Action, origin: Spot, goal: Spot) -> int:
        kind = self._case.fleet.by_id[action.robot_type]
        speed = _speed(self._case, kind, action)
        if origin is None or goal is None or speed is None:
            return self._nominal(action)
        seconds = self._case.ways.quickest_s(kind, origin, goal, speed)
        return ticks_needed(seconds) if math.isfinite(seconds) else 0

    def _nominal(self, action: Action) -> int:
        return ticks_needed(action.duration_s) if action.moves else 0

    def _arrival(self, action: Action, leaf: int) -> int:
        """Ticks before which no robot of the type can be where an action is; 0 if a robot of it may be anywhere."""
        kind = self._case.fleet.by_id[action.robot_type]
        speed = kind.limits.get("max_speed_mps")
        starts, there = self._haunts.starts(kind.id), self._haunts.of_leaf(leaf)
        if (
            action.at is None
            or speed is None
            or None in self._haunts.of_type(kind.id) | there
            or len(starts) * len(there) > MOST_WAYS
        ):
            return 0
        seconds = [
            self._case.ways.quickest_s(kind, origin, goal, speed)
            for origin in starts
            for goal in there
            if origin is not None and goal is not None
        ]
        least = min(seconds, default=0.0)
        return ticks_needed(least) if math.isfinite(least) else 0

    def _way_home(self, leaves: Sequence[int]) -> int:
        """Least ticks from the last place of a role to any start of its type; 0 if a robot of it may be anywhere."""
        last = next((leaf for leaf in reversed(leaves) if self._actions[leaf].at is not None), None)
        kind = self._case.fleet.by_id[self._actions[leaves[0]].robot_type]
        speed, starts = kind.limits.get("max_speed_mps"), self._haunts.starts(kind.id)
        if last is None or speed is None or None in self._haunts.of_type(kind.id):
            return 0
        there = self._haunts.of_leaf(last)
        if len(starts) * len(there) > MOST_WAYS:
            return 0
        seconds = [
            self._case.ways.quickest_s(kind, spot, home, speed)
            for spot in there
            for home in starts
            if spot is not None and home is not None
        ]
        least = min(seconds, default=0.0)
        return ticks_needed(least) if math.isfinite(least) else 0

    def _since(self, type_id: str) -> int:
        """Ticks before which no robot of a type is there."""
        kind = self._case.fleet.by_id[type_id]
        own = [kind.available_from_s if one.available_from_s is None else one.available_from_s for one in kind.members]
        return ticks_needed(min((since or 0.0 for since in own), default=0.0))

    def _order(self) -> list[object] | None:
        missing = Counter(later for successors in self._after.values() for later, _ in successors)
        order = [event for event in self._after if not missing[event]]
        for event in order:
            for later, _ in self._after[event]:
                missing[later] -= 1
                if not missing[later]:
                    order.append(later)
        return order if len(order) == len(self._after) else None

    def _load(self, heads: dict[object, int], tails: dict[object, int]) -> int:
        """The largest, over robot types and over earliest starts, of start + work of the roles not before it, shared + what follows."""
        forms = (self._pieces(heads, tails), self._pieces(heads, tails, entered=True))
        types = ((own, self._case.most_in_use(type_id)) for form in forms for type_id, own in form.items())
        return max((shared(own, robots) for own, robots in types), default=0)

    def _pieces(
        self, heads: dict[object, int], tails: dict[object, int], entered: bool = False
    ) -> dict[str, list[Piece]]:
        """Roles as pieces of work by type; if ``entered``, with the way to where they begin, for which nobody need set out sooner."""
        pieces: dict[str, list[Piece]] = {}
        for role, leaves in self._staffing.leaves_of_role.items():
            lag = sum(self._wait[leaf] for leaf in leaves[1:] if not self._actions[leaf].moves)
            work = lag + sum(self._length[self._group[leaf]] for leaf in leaves)
            head, first = heads[self._start(leaves[0])], leaves[0]
            entry = self._footing.entry(role) if entered and first not in self._stretched else 0
            if self._actions[first].moves:  # the way is the action itself
                work += max(0, entry - self._length[self._group[first]])
            else:
                head, work = max(0, head - entry), work + entry
            piece = (head, work, tails[self._end(leaves[-1])])
            pieces.setdefault(self._staffing.type_of_role[role], []).append(piece)
        return pieces

    def _resource_load(self, heads: dict[object, int], tails: dict[object, int]) -> int:
        """The same of every shared resource: each robot that holds it takes one of its places for that long."""
        least = 0
        for resource in self._case.scene.resources:
            pieces = [
                (heads[self._start(leaf)], self._length[self._group[leaf]], tails[self._end(leaf)])
                for leaf, action in self._actions.items()
                if resource.id in action.holds
            ]
            least = max(least, shared(pieces, resource.capacity))
        return least


def _speed(case: Case, kind: RobotType, action: Action) -> float | None:
    own = kind.limits.get("max_speed_mps")
    if own is None:
        return None
    brought = (case.scene.by_id.get(name) for name in action.brings)
    return min([own, *(one.max_speed_mps for one in brought if one is not None and one.max_speed_mps is not None)])
