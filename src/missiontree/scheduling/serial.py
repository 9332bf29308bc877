"""
One run of serial schedule generation (Kelley 1963; Kolisch 1996), for robots that are held in roles and travel.

Of all actions that may begin, the one that can begin earliest is put at the end of its robots' timelines; of equals the one with
the longest way still to go; of those the first leaf. Lazy heaps keep the choice cheap: an entry's time can only be too early, and is
put right when it comes up. Roles that are about to begin stand in a queue per robot type, which comes up when a robot of the
type is free, so that ten thousand of them cost no more than one.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from missiontree.estimation.travel import Blocked
from missiontree.mission.grounded import Action
from missiontree.mission.reason import Reason
from missiontree.scheduling.impossible import TOLERANCE, missing
from missiontree.scheduling.matching import match
from missiontree.scheduling.precedence import indegrees
from missiontree.scheduling.problem import Done, Draft, Problem, Rule
from missiontree.scheduling.ticks import ticks
from missiontree.scheduling.trips import Spot, Trip
from missiontree.scheduling.world_state import RobotState, WorldState

_LOOK = 16  # roles of a queue that are compared where travel makes a difference


class _StuckError(Exception):
    """This run cannot go on."""

    def __init__(self, reason: Reason) -> None:
        super().__init__(reason.message)
        self.reason = reason


@dataclass(slots=True)
class _Queue:
    """Roles that may begin with any robot of a type, or with one robot: ``later`` by ready time, ``now`` by remaining path."""

    number: int
    type_id: str
    robot: RobotState | None
    later: list[tuple[int, int]] = field(default_factory=list)
    now: list[tuple[int, int, int]] = field(default_factory=list)
    key: int | None = None


@dataclass(slots=True)
class _Offer:
    start: int
    robots: dict[int, RobotState]  # by role, of the activity
    mates: dict[int, RobotState]  # by role, taken at once for later


class Run:
    """
    One run over one problem.

    Parameters
    ----------
    problem
        The alternative.
    rule
        How to decide.
    """

    def __init__(self, problem: Problem, rule: Rule) -> None:
        self._p, self._rule, self._graph = problem, rule, problem.graph
        self._world = WorldState(problem.fleet, problem.trips)
        self._active: dict[str, list[RobotState]] = {kind.id: [] for kind in problem.fleet.types}
        self._fresh: dict[str, dict[object, list[RobotState]]] = {kind.id: {} for kind in problem.fleet.types}
        for robot in self._world.robots.values():
            look = (robot.spot, tuple(sorted(robot.left.items())))
            self._fresh[robot.type_id].setdefault(look, []).append(robot)
        self._totals = {kind.id: dict(kind.total_limits) for kind in problem.fleet.types}
        self._time = [0] * len(self._graph.successors)
        self._missing = indegrees(self._graph.successors)
        self._next = dict.fromkeys(self._graph.roles, 0)
        self._robot_of_group: dict[int, RobotState] = {}
        self._heap: list[tuple[int, int, int]] = []  # time, 0 and an activity under way in its roles, or 1 and a queue
        self._queues: dict[str, _Queue] = {}
        self._queue_list: list[_Queue] = []
        self._aside: dict[str, dict[int, None]] = {}  # by type: roles that found not all the robots they need
        self._bundle_missing = indegrees(problem.bundles.after)
        self._bundle_left = list(problem.bundles.leaves)
        self._gated: dict[int, list[int]] = {}
        self._crew_of = problem.bundles.of_role if rule.crew == "bundle" else problem.crews
        self._crews: dict[int, list[int]] = {}
        for role, crew in sorted(self._crew_of.items()):
            self._crews.setdefault(crew, []).append(role)
        self._ends: dict[int, tuple[int, list[tuple[int, RobotState]]]] = {}
        self._done: dict[int, Done] = {}
        self._metres = 0.0

    def __call__(self, ended: Callable[[], bool]) -> Draft | None:
        """Run to the end; None if told to stop before."""
        try:
            self._open_bundles([bundle for bundle, count in enumerate(self._bundle_missing) if not count])
            self._settle([event for event, count in enumerate(self._missing) if not count])
            commits = 0
            while self._heap:
                time, which, number = heapq.heappop(self._heap)
                if self._go_on(time, number) if which == 0 else self._open(time, self._queue_list[number]):
                    commits += 1
                    if commits % 256 == 0 and ended():
                        return None
            if len(self._done) < len(self._graph.activity_of):
                raise _StuckError(self._deadlock())
        except _StuckError as stuck:
            return self._draft((stuck.reason,))
        return self._draft(())

    def _draft(self, reasons: tuple[Reason, ...]) -> Draft:
        done = sorted(self._done.values(), key=lambda one: (one.start, one.leaf))
        robot_of = {
            role: self._robot_of_group[group].id
            for role, group in sorted(self._p.staffing.group_of.items())
            if group in self._robot_of_group
        }
        return Draft(done, robot_of, max((one.end for one in done), default=0), self._metres, reasons)

    # --- what may begin ---------------------------------------------------------------------------------------------

    def _settle(self, events: Sequence[int]) -> None:
        """Events whose time is known by now: pass it on, and begin or end what waited for it."""
        stack = list(events)[::-1]
        activities = 2 * len(self._graph.activities)
        while stack:
            event = stack.pop()
            if event < activities and event % 2 == 0 and event // 2 not in self._ends:
                self._may_begin(event // 2)
                continue
            if event < activities and event % 2 == 1:
                self._finish(event // 2)
            for after in self._graph.successors[event]:
                self._time[after] = max(self._time[after], self._time[event])
                self._missing[after] -= 1
                if not self._missing[after]:
                    stack.append(after)

    def _may_begin(self, activity: int) -> None:
        crew = self._crew_of[self._role(activity)]
        if self._rule.crew == "bundle" and self._bundle_missing[crew]:
            self._gated.setdefault(crew, []).append(activity)
            return
        if self._opening(activity):
            self._line_up(activity)
        else:
            heapq.heappush(self._heap, (self._time[2 * activity], 0, activity))

    def _open_bundles(self, bundles: list[int]) -> None:
        stack = list(bundles)
        while stack:
            bundle = stack.pop()
            for activity in self._gated.pop(bundle, ()):
                self._may_begin(activity)
            if not self._bundle_left[bundle]:
                for after in self._p.bundles.after[bundle]:
                    self._bundle_missing[after] -= 1
                    if not self._bundle_missing[after]:
                        stack.append(after)

    def _role(self, activity: int) -> int:
        return self._graph.tree.action(self._graph.activities[activity][0]).role

    def _opening(self, activity: int) -> list[int]:
        """Roles that begin with this activity."""
        roles = (self._graph.tree.action(leaf).role for leaf in self._graph.activities[activity])
        return [role for role in roles if not self._next[role]]

    def _queue_of(self, activity: int) -> _Queue:
        role = self._opening(activity)[0]
        robot, type_id = self._bound(role), self._p.staffing.type_of[role]
        name = type_id if robot is None else f"{type_id}/{robot.id}"
        queue = self._queues.get(name)
        if queue is None:
            queue = self._queues[name] = _Queue(len(self._queue_list), type_id, robot)
            self._queue_list.append(queue)
        return queue

    def _bound(self, role: int) -> RobotState | None:
        """The robot that a role must take, if that is settled."""
        group = self._p.staffing.group_of[role]
        if group in self._robot_of_group:
            return self._robot_of_group[group]
        return self._world.robots[self._rule.binding[group]] if group in self._rule.binding else None

    def _line_up(self, activity: int) -> None:
        queue = self._queue_of(activity)
        heapq.heappush(queue.later, (self._time[2 * activity], activity))
        self._call(queue)

    def _call(self, queue: _Queue) -> None:
        """Let a queue come up when its first role could begin, if a robot is free at all."""
        free = self._free_from(queue)
        if free is None or not (queue.now or queue.later):
            return
        time = free if queue.now else max(free, queue.later[0][0])
        if queue.key is None or time < queue.key:
            queue.key = time
            heapq.heappush(self._heap, (time, 1, queue.number))

    def _free_from(self, queue: _Queue) -> int | None:
        if queue.robot is not None:
            return queue.robot.free_at if queue.robot.role is None else None
        if any(self._fresh[queue.type_id].values()):
            return 0
        free = (r.free_at for r in self._active[queue.type_id] if r.role is None and r.promised is None)
        return min(free, default=None)

    def _wake(self, robot: RobotState) -> None:
        """A robot is free again: queues for it come up, and roles that were put aside line up anew."""
        for activity in self._aside.pop(robot.type_id, {}):
            if activity not in self._ends:
                self._line_up(activity)
        for name in (robot.type_id, f"{robot.type_id}/{robot.id}"):
            if name in self._queues:
                self._call(self._queues[name])

    # --- what comes next --------------------------------------------------------------------------------------------

    def _go_on(self, time: int, activity: int) -> bool:
        """Put the next activity of roles under way into the schedule, or put its time right."""
        offer = self._offer(activity)
        assert offer is not None, "robots in their roles are there"
        if offer.start > time:
            heapq.heappush(self._heap, (offer.start, 0, activity))
            return False
        self._commit(activity, offer)
        return True

    def _open(self, time: int, queue: _Queue) -> bool:
        """Begin the role of a queue that can begin earliest, or put the queue's time right."""
        if queue.key != time:
            return False
        queue.key = None
        free = self._free_from(queue)
        if free is None or free > time:
            self._call(queue)
            return False
        limit = time + self._rule.patience
        looked, best = self._look(queue, limit)
        for entry in looked:
            if best is None or entry[-1] != best[0] or best[1].start > limit:
                heapq.heappush(queue.now, entry)
        if best is None:
            self._call(queue)
        elif best[1].start > limit:
            queue.key = best[1].start
            heapq.heappush(self._heap, (queue.key, 1, queue.number))
        else:
            self._commit(*best)
            self._call(queue)
            return True
        return False

    def _look(self, queue: _Queue, limit: int) -> tuple[list[tuple[int, int, int]], tuple[int, _Offer] | None]:
        """The first few roles of a queue, those with the longest way to go, and the one of them that can begin earliest."""
        while queue.later and queue.later[0][0] <= limit:
            activity = heapq.heappop(queue.later)[1]
            tail = self._p.bounds.tails[2 * activity] + self._rule.jitter.get(activity, 0)
            heapq.heappush(queue.now, (-tail, self._graph.activities[activity][0], activity))
        looked: list[tuple[int, int, int]] = []
        best: tuple[int, _Offer] | None = None
        while queue.now and len(looked) < _LOOK and (best is None or best[1].start > limit):
            entry = heapq.heappop(queue.now)
            activity = entry[-1]
            if activity in self._ends:
                continue
            if self._queue_of(activity) is not queue:
                self._line_up(activity)
                continue
            offer = self._offer(activity)
            if offer is None:
                for mate in self._crews[self._crew_of[self._role(activity)]]:
                    self._aside.setdefault(self._p.staffing.type_of[mate], {})[activity] = None
                continue
            looked.append(entry)
            if best is None or offer.start < best[1].start:
                best = activity, offer
        return looked, best

    # --- who could do it, and when ----------------------------------------------------------------------------------

    def _offer(self, activity: int) -> _Offer | None:
        """The earliest start with robots that are free; None if some robot is held elsewhere."""
        ready = self._time[2 * activity]
        robots: dict[int, RobotState] = {}
        opening: list[int] = []
        for leaf in self._graph.activities[activity]:
            role = self._graph.tree.action(leaf).role
            if self._next[role]:
                robots[role] = self._robot_of_group[self._p.staffing.group_of[role]]
            else:
                opening.append(role)
        mates: list[int] = []
        if opening and self._rule.crew != "none":
            crew = self._crew_of[opening[0]]
            mates = [role for role in self._crews[crew] if role not in opening and not self._secured(role)]
        chosen = self._choose(opening, mates, ready)
        if chosen is None:
            return None
        robots |= {role: chosen[role] for role in opening}
        start = ready
        for leaf in self._graph.activities[activity]:
            action = self._graph.tree.action(leaf)
            arrival = self._arrival(robots[action.role], action, ready)
            start = max(start, arrival, self._world.not_before(action))
        return _Offer(start, robots, {role: chosen[role] for role in mates})

    def _secured(self, role: int) -> bool:
        """Whether a role has begun, or its robot is kept for it."""
        robot = self._robot_of_group.get(self._p.staffing.group_of[role])
        return self._next[role] > 0 or (robot is not None and robot.promised == self._crew_of[role])

    def _trip(self, robot: RobotState, action: Action) -> Trip | Blocked | None:
        """The way to an action; None if it can be done anywhere."""
        if action.at is None and not action.moves:
            return None
        destination = self._world.spot(action)
        if destination is None and not action.moves:
            return None
        return self._p.trips.trip(action, robot.spot, destination)

    def _arrival(self, robot: RobotState, action: Action, ready: int) -> int:
        """When the robot can begin the action."""
        trip = self._trip(robot, action)
        if isinstance(trip, Blocked):
            raise _StuckError(trip.reason)
        return max(ready, robot.free_at + (trip.ticks if trip is not None and not action.moves else 0))

    def _choose(self, opening: Sequence[int], mates: Sequence[int], ready: int) -> dict[int, RobotState] | None:
        """Different free robots for all groups of these roles, the best first; None if there are not enough."""
        wanted: dict[int, int] = {}  # group -> its first role here
        for role in (*opening, *mates):
            wanted.setdefault(self._p.staffing.group_of[role], role)
        ranked = {group: self._candidates(role, ready if role in opening else 0) for group, role in wanted.items()}
        taken = match(ranked)
        if taken is None:
            return None
        return {role: taken[self._p.staffing.group_of[role]] for role in (*opening, *mates)}

    def _candidates(self, role: int, ready: int) -> list[RobotState]:
        """Free robots that may fill a role: the earliest to begin first, then the least idle, then the nearest."""
        group, bound = self._p.staffing.group_of[role], self._bound(role)
        action = self._graph.tree.action(self._graph.roles[role][0])
        ranked: list[tuple[int, int, float, int, RobotState]] = []
        for robot in [bound] if bound is not None else self._pool(role):
            if robot.role is not None or robot.promised not in (None, self._crew_of[role]):
                continue
            if group not in self._robot_of_group and self._p.staffing.avoids[group] & robot.wears:
                continue
            trip = self._trip(robot, action)
            if isinstance(trip, Blocked) or (bound is None and not self._affords(robot, role, trip)):
                continue
            way = 0 if trip is None else trip.ticks
            begin = max(ready, robot.free_at + way)
            if action.moves:
                begin = max(ready, robot.free_at) + way
            ranked.append((begin, -robot.free_at, 0.0 if trip is None else trip.metres, robot.index, robot))
        return [entry[-1] for entry in sorted(ranked, key=lambda entry: entry[:-1])]

    def _pool(self, role: int) -> list[RobotState]:
        """Robots of the type; of those that are alike and unused, as many as could be taken at once."""
        type_id = self._p.staffing.type_of[role]
        first = self._graph.activity_of[self._graph.roles[role][0]]
        together = 1 if self._rule.crew == "none" else len(self._crews[self._crew_of[role]])
        many = max(together, len(self._graph.activities[first]))
        return self._active[type_id] + [robot for alike in self._fresh[type_id].values() for robot in alike[:many]]

    def _affords(self, robot: RobotState, role: int, trip: Trip | None) -> bool:
        """Whether the robot's budgets last for its group of roles, as far as can be foreseen."""
        if not robot.left and not self._totals[robot.type_id]:
            return True
        needs = dict(self._p.needs[self._p.staffing.group_of[role]])
        per_m = self._p.fleet.by_id[robot.type_id].uses_per_m
        if per_m:
            metres = max(self._metres_of(robot, role), 0.0 if trip is None else trip.metres)
            uses = self._uses_of(role)
            for name, amount in per_m.items():
                needs[name] = max(needs.get(name, 0.0), uses.get(name, 0.0) + amount * metres)
        return missing(needs, robot.left) is None and missing(needs, self._totals[robot.type_id]) is None

    def _uses_of(self, role: int) -> dict[str, float]:
        uses: dict[str, float] = {}
        for leaf in self._graph.roles[role]:
            for name, amount in self._graph.tree.action(leaf).uses.items():
                uses[name] = uses.get(name, 0.0) + amount
        return uses

    def _metres_of(self, robot: RobotState, role: int) -> float:
        """Metres of a whole role if everything that it does not move itself stays where it is."""
        metres, here = 0.0, robot.spot
        moved: dict[str, Spot] = {}
        for leaf in self._graph.roles[role]:
            action = self._graph.tree.action(leaf)
            there = moved[action.at] if action.at in moved else self._world.spot(action)
            if action.moves or there is not None:
                trip = self._p.trips.trip(action, here, there)
                metres += 0.0 if isinstance(trip, Blocked) else trip.metres
                here = there
            moved |= dict.fromkeys(action.brings, there)
        return metres

    # --- doing it ---------------------------------------------------------------------------------------------------

    def _commit(self, activity: int, offer: _Offer) -> None:
        graph, start = self._graph, offer.start
        actions = [(leaf, graph.tree.action(leaf)) for leaf in graph.activities[activity]]
        trips = {leaf: self._trip(offer.robots[action.role], action) for leaf, action in actions}
        length = 0
        for leaf, action in actions:
            trip = trips[leaf]
            own = trip.ticks if action.moves and isinstance(trip, Trip) else ticks(action.duration_s)
            length = max(length, 0 if activity in graph.until else own)
        for role, robot in offer.mates.items():
            self._bind(role, robot)
            robot.promised = self._crew_of[role]
        done: list[tuple[int, RobotState]] = []
        for leaf, action in actions:
            robot, trip = offer.robots[action.role], trips[leaf]
            assert not isinstance(trip, Blocked)
            if not self._next[action.role]:
                self._bind(action.role, robot)
                robot.role = action.role
            self._next[action.role] += 1
            self._charge(robot, action, trip)
            departs = start if action.moves else robot.free_at
            arrives = start + length if action.moves else departs + (trip.ticks if trip is not None else 0)
            self._done[leaf] = Done(leaf, robot.id, start, start + length, trip, departs, arrives)
            done.append((leaf, robot))
        for _, action in actions:
            self._world.do(offer.robots[action.role], action, start, start + length)
        self._ends[activity] = (length, done)
        self._time[2 * activity] = start
        self._time[2 * activity + 1] = max(self._time[2 * activity + 1], start + length)
        for role in offer.mates:
            first = self._graph.activity_of[self._graph.roles[role][0]]
            if not self._missing[2 * first] and first not in self._ends:
                self._line_up(first)  # now in the queue of its own robot
        self._settle([2 * activity])

    def _bind(self, role: int, robot: RobotState) -> None:
        self._robot_of_group[self._p.staffing.group_of[role]] = robot
        robot.wears |= self._p.staffing.wears[self._p.staffing.group_of[role]]
        if not robot.used:
            robot.used = True
            look = (robot.spot, tuple(sorted(robot.left.items())))
            self._fresh[robot.type_id][look].remove(robot)
            self._active[robot.type_id].append(robot)

    def _charge(self, robot: RobotState, action: Action, trip: Trip | None) -> None:
        kind = self._p.fleet.by_id[robot.type_id]
        use = dict(action.uses)
        if trip is not None:
            self._metres += trip.metres
            for name, amount in kind.uses_per_m.items():
                use[name] = use.get(name, 0.0) + amount * trip.metres
        for whose, left in ((robot.id, robot.left), (kind.id, self._totals[kind.id])):
            for name, amount in use.items():
                if name in left:
                    left[name] -= amount
                    if left[name] < -TOLERANCE:
                        raise _StuckError(
                            Reason(
                                rule="budget_exceeded",
                                message=f"{whose} runs out of {name} at {action.text!r}, {-left[name]:g} short.",
                                node=action.text,
                                robot=whose,
                            )
                        )

    def _finish(self, activity: int) -> None:
        """The end of an activity is known: its robots are there from then on, and free if the role is over."""
        end = self._time[2 * activity + 1]
        released: list[RobotState] = []
        bundles: list[int] = []
        for leaf, robot in self._ends[activity][1]:
            role = self._graph.tree.action(leaf).role
            done = self._done[leaf]
            if done.end != end:
                self._done[leaf] = Done(leaf, robot.id, done.start, end, done.trip, done.leaves_at, done.arrives_at)
            robot.free_at = end
            if self._next[role] == len(self._graph.roles[role]) and leaf == self._graph.roles[role][-1]:
                if len(self._graph.roles[role]) > 1 or robot.promised is not None or activity in self._graph.until:
                    released.append(robot)  # else nobody has met it held
                self._release(role, robot)
            bundle = self._p.bundles.of_role[role]
            self._bundle_left[bundle] -= 1
            if not self._bundle_left[bundle]:
                bundles.append(bundle)
        for robot in released:
            self._wake(robot)
        self._open_bundles(bundles)

    def _release(self, role: int, robot: RobotState) -> None:
        robot.role = None
        if robot.promised is not None:
            rest = (mate for mate in self._crews[robot.promised] if not self._next[mate])
            if not any(self._robot_of_group.get(self._p.staffing.group_of[mate]) is robot for mate in rest):
                robot.promised = None

    # --- why not ----------------------------------------------------------------------------------------------------

    def _deadlock(self) -> Reason:
        held = [robot for robot in self._world.robots.values() if robot.role is not None]
        roles = self._graph.tree.roles
        waits = [activity for activity in range(len(self._graph.activities)) if activity not in self._ends]
        waits = [activity for activity in waits if not self._missing[2 * activity]] or waits
        what = self._graph.name(self._graph.activities[waits[0]][0])
        who = ", ".join(f"{robot.id} in {roles[robot.role].label!r}" for robot in held[:4] if robot.role is not None)
        return Reason(
            rule="deadlock",
            message=f"{what!r} finds no robot"
            + (f" while {who} {'is' if len(held) == 1 else 'are'} held, waiting." if held else " that may do it."),
            node=what,
            robot=self._graph.tree.action(self._graph.activities[waits[0]][0]).robot_type,
            hint="Another robot of that type, or another order, may resolve it.",
        )
