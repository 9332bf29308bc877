"""One step of trying everything: an activity is put down where it can be at the earliest, and the state that comes of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from missiontree.estimation.travel import Blocked
from missiontree.mission.ticks import ticks
from missiontree.scheduling.course import begun_is_enough
from missiontree.scheduling.enumeration.relations import Relations
from missiontree.scheduling.enumeration.robots import Robots
from missiontree.scheduling.enumeration.state import State
from missiontree.scheduling.impossible import TOLERANCE
from missiontree.scheduling.precedence import indegrees
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.room import Hold, room_for
from missiontree.scheduling.trips import Spot, Trip


class Option(NamedTuple):
    """A way of putting down an activity: robots by role, the key (see :class:`State`), start and length, and trips by leaf."""

    robots: dict[int, int]
    key: int
    start: int
    length: int
    trips: dict[int, Trip | None]


class Putting:
    """
    What holds when an activity is put down.

    Parameters
    ----------
    problem
        The alternative.
    robots
        Its robots.
    """

    def __init__(self, problem: Problem, robots: Robots) -> None:
        self._problem, self._robots = problem, robots
        self._graph, self._staffing, self._takers = problem.graph, problem.staffing, problem.hand_overs.taker
        tree = self._graph.tree
        self._actions = [[(leaf, tree.action(leaf)) for leaf in leaves] for leaves in self._graph.activities]
        self._ticks = {leaf: ticks(tree.action(leaf).duration_s) for leaf in self._graph.activity_of}
        self._last = {role: leaves[-1] for role, leaves in self._graph.roles.items()}

    @cached_property
    def relations(self) -> Relations:
        """Which activities come before others; only for missions so small that everything is tried."""
        return Relations(self._graph)

    def begin(self) -> State:
        """Nothing is put down, and what no activity comes before may be."""
        problem, left = self._problem, dict[tuple[str, str], float]()
        for kind in problem.fleet.types:
            left |= {(kind.id, name): amount for name, amount in kind.total_limits.items()}
            for robot in kind.members:
                for name, amount in (dict(kind.limits) | dict(robot.remaining)).items():
                    if name not in problem.chargers.of(kind):
                        left[robot.id, name] = amount
        left |= {("", name): amount for name, amount in problem.shared.items()}
        time = [0] * len(self._graph.successors)
        for activity, release in self._graph.release.items():
            time[2 * activity] = release
        state = State(
            time=time,
            missing=indegrees(self._graph.successors),
            robot_of={},
            spot=[start for kind in problem.fleet.types for start in problem.trips.starts(kind.id)],
            free=self._robots.since[:],
            role=[-1] * len(self._robots.names),
            things={},
            left=left,
        )
        self._settle(state, [event for event, count in enumerate(state.missing) if not count])
        return state

    def put(self, state: State, activity: int, option: Option) -> State | None:
        """The state with an activity put down; None if budgets do not allow it, or somebody leaves before its end."""
        robots, key, start, length, trips = option
        after, end = state.copy(), start + length
        after.key, after.placed = key, (*state.placed, activity)
        after.starts[activity] = start
        for leaf, action in self._actions[activity]:
            robot = robots[action.role]
            until = self._robots.until[robot]
            if until is not None and end > until:
                return None
            if not self._spend(after, action.uses, robot, trips[leaf]):
                return None
            after.robot_of[self._staffing.group_of[action.role]] = robot
            after.role[robot] = action.role
        goals = [
            None if action.at is None else self._thing(after, action.at)[0] for _, action in self._actions[activity]
        ]
        for (leaf, action), goal in zip(self._actions[activity], goals, strict=True):
            self._move(after, leaf, robots[action.role], goal, (start, end))
        after.time[2 * activity] = start
        after.time[2 * activity + 1] = max(after.time[2 * activity + 1], end)
        for giver in self._problem.hand_overs.givers(activity):
            self._hand_over(after, giver, start)
        self._settle(after, [2 * activity])
        return after

    def earliest(
        self, state: State, activity: int, robots: Mapping[int, int], waits: Sequence[int]
    ) -> tuple[int, int, dict[int, Trip | None] | None]:
        """
        When an activity can start at the earliest if these robots fill its roles, how long it lasts, and the ways by leaf.

        ``waits`` are the starts of what must be under way before its end. Its length is 0 where others set its end; the ways are None
        if it cannot be put down next.
        """
        start, length = state.time[2 * activity], 0
        trips: dict[int, Trip | None] = {}
        for leaf, action in self._actions[activity]:
            robot, trip = robots[action.role], None
            if action.is_somewhere:
                goal = None if action.at is None else self._thing(state, action.at)[0]
                if action.moves or goal is not None:
                    found = self._problem.trips.trip(action, state.spot[robot], goal)
                    if isinstance(found, Blocked):
                        return 0, 0, None
                    trip = found
            trips[leaf] = trip
            way = trip.ticks if trip is not None else 0
            start = max(start, state.free[robot] + (0 if action.moves else way))
            length = max(length, way if action.moves else self._ticks[leaf])
            if action.at is not None:
                start = max(start, self._thing(state, action.at)[1])
            for name in action.brings:
                start = max(start, *self._thing(state, name)[1:])
        if activity in self._graph.until:
            length = 0
        for begun in waits:
            start = max(start, begun + 1 - length)
        lasting = activity in self._graph.until or activity in self._takers
        room = self._room(state, activity, start, None if lasting else length)
        return (0, 0, None) if room is None else (room, length, trips)

    def _room(self, state: State, activity: int, start: int, length: int | None) -> int | None:
        """When there is room in what it holds; None if that is not known before something else is over."""
        sharing = self._problem.sharing
        if activity not in sharing.demand:
            return start

        givers = self._problem.hand_overs.givers(activity)  # they let go when it starts

        def since(one: int) -> int:
            """From when another holds it: what takes no time would stand before its start at one moment, but not if that comes first."""
            return state.starts[one] - (length == 0 and self._begins_first(one, activity))

        def held(name: str) -> list[Hold]:
            there = ((one, robots) for one, robots in sharing.holders(name).items() if one in state.starts)
            taken = [(one, robots) for one, robots in there if one not in givers]
            return [Hold(since(one), self._known_end(state, one), robots) for one, robots in taken]

        return room_for(sharing, sharing.demand[activity], held, start, length)

    def _begins_first(self, one: int, other: int) -> bool:
        """Whether an activity that is put down before another begins before it for a reason."""
        return one in self.relations.earlier[other] or begun_is_enough(self._graph, one, other) is not None

    def _known_end(self, state: State, activity: int) -> int | None:
        if activity in self._takers:  # held until it is handed over
            return state.starts.get(self._takers[activity])
        event = 2 * activity + 1
        return None if state.missing[event] else state.time[event]

    def _thing(self, state: State, name: str) -> tuple[Spot, int, int]:
        found = state.things.get(name)
        return (self._problem.trips.spot(name), 0, 0) if found is None else found

    def _spend(self, state: State, uses: Mapping[str, float], robot: int, trip: Trip | None) -> bool:
        kind = self._problem.fleet.by_id[self._robots.kind[robot]]
        use = dict(uses)
        if trip is not None:
            for name, amount in kind.uses_per_m.items():
                use[name] = use.get(name, 0.0) + amount * trip.metres
        for name, amount in use.items():
            for whose in (self._robots.names[robot], kind.id, ""):
                if (whose, name) in state.left:
                    left = state.left[whose, name] = state.left[whose, name] - amount
                    if left < -TOLERANCE:
                        return False
        return True

    def _move(self, state: State, leaf: int, robot: int, goal: Spot, span: tuple[int, int]) -> None:
        """Who and what is elsewhere afterwards."""
        action, (start, end) = self._graph.tree.action(leaf), span
        if action.at is not None:
            spot, since, needed = self._thing(state, action.at)
            state.things[action.at] = (spot, since, max(needed, start if action.open_ended else end))
        if action.is_somewhere:
            state.spot[robot] = goal
        for name in action.brings:
            state.things[name] = (goal, end, self._thing(state, name)[2])

    def _hand_over(self, state: State, giver: int, moment: int) -> None:
        """The taker has come: until then the giver was there, and what it brought was on the way."""
        state.time[2 * giver + 1] = moment
        self._over(state, giver)
        for _, action in self._actions[giver]:
            if action.at is not None:
                spot, since, needed = self._thing(state, action.at)
                state.things[action.at] = (spot, since, max(needed, moment))
            for name in action.brings:
                spot, since, needed = self._thing(state, name)
                state.things[name] = (spot, max(since, moment), needed)

    def _settle(self, state: State, events: list[int]) -> None:
        """Pass on the times of events that are known by now."""
        activities, stack = 2 * len(self._actions), events
        while stack:
            event = stack.pop()
            if event < activities and event % 2 == 0 and event // 2 not in state.starts:
                continue
            if event < activities and event % 2 and event // 2 not in self._takers:
                self._over(state, event // 2)
            for after in self._graph.successors[event]:
                state.time[after] = max(state.time[after], state.time[event])
                state.missing[after] -= 1
                if not state.missing[after]:
                    stack.append(after)

    def _over(self, state: State, activity: int) -> None:
        for leaf, action in self._actions[activity]:
            robot = state.robot_of[self._staffing.group_of[action.role]]
            state.free[robot] = max(state.free[robot], state.time[2 * activity + 1])
            if self._last[action.role] == leaf:
                state.role[robot] = -1

    def go_home(self, state: State, robot: int) -> bool:
        """Whether a robot gets home; it is there afterwards."""
        trip = self._problem.trips.approach(self._robots.kind[robot], state.spot[robot], self._robots.homes[robot])
        if isinstance(trip, Blocked) or not self._spend(state, {}, robot, trip):
            return False
        state.free[robot] += trip.ticks
        return self._problem.home_by is None or state.free[robot] <= self._problem.home_by
