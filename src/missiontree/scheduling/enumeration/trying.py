"""
The shortest schedule of a small mission, and the proof that none is shorter, by trying everything that could be.

Activities are put down one after the other, each as early as it can be after what stands there; every order and every choice of robots
is tried, but for what cannot beat the best and for what only repeats another trial: equal robots that have done nothing yet, and orders
in which a later choice starts earlier. That loses nothing. Of the best schedules take one with the least sum of starts, and put its
activities down in order of their starts (one that must wait for an open-ended action to have begun, after that action): each comes to
stand where it stood, or the sum was not the least. Shared resources change nothing of this: what starts a little earlier takes room there
only before the starts of all that is put down later. What takes no time is an exception at the same tick; it may be put down first.
Nor does it lose anything to put down in one order what starts at once and has nothing to do with each other: of all orders in which the
best schedule can be put down, take the one whose numbers of activities come first.

What robots can refill is taken to last for ever: what is found may have to be made longer by visits to chargers, and what is not found
is not there. Where robots may refill while they wait, nothing is tried.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

from missiontree.estimation.travel import Blocked
from missiontree.mission.ticks import ticks, ticks_within
from missiontree.scheduling.bounds import NEVER
from missiontree.scheduling.course import Course, passings
from missiontree.scheduling.enumeration.load import Load
from missiontree.scheduling.enumeration.relations import Relations
from missiontree.scheduling.enumeration.state import State
from missiontree.scheduling.impossible import TOLERANCE
from missiontree.scheduling.precedence import indegrees
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.recharging import may_wait_at_chargers
from missiontree.scheduling.room import Hold, order_of_events, room_for, turns
from missiontree.scheduling.trips import Spot, Trip

MOST_CHOICES = 64
"""Ways in which open-ended actions may come to be under way, beyond which nothing is tried."""
MOST_ACTIVITIES = 80
"""The same, of activities."""


@dataclass(frozen=True, slots=True)
class Tried:
    """
    What trying came to.

    Parameters
    ----------
    complete
        Whether everything was tried, so that nothing is shorter than the course, or than what was to be beaten.
    course
        The shortest that beats what was to be beaten; None if none does.
    steps
        How many steps it took.
    makespan
        Of the course, in ticks; 0 if there is none.
    """

    complete: bool
    course: Course | None
    steps: int
    makespan: int = 0


def too_many(problem: Problem) -> bool:
    """Whether there is so much that nothing is tried."""
    number = 1
    for ends in problem.graph.until.values():
        number *= max(1, len(ends))
    return number > MOST_CHOICES or len(problem.graph.activities) > MOST_ACTIVITIES


class _Option(NamedTuple):
    """A way of putting down an activity: robots by role, the key (see :class:`State`), start and length, and trips by leaf."""

    robots: dict[int, int]
    key: int
    start: int
    length: int
    trips: dict[int, Trip | None]


class _EnoughError(Exception):
    """The steps are used up, or somebody asks to stop."""


class Trying:
    """
    Tries everything.

    Parameters
    ----------
    problem
        The alternative.
    limit
        Ticks by which a schedule must be over to be of interest.
    most_steps
        Steps after which to give up.
    ended
        Asked now and then whether to stop.
    """

    def __init__(self, problem: Problem, limit: int, most_steps: int, ended: Callable[[], bool]) -> None:
        self._problem, self._limit, self._most, self._ended = problem, limit, most_steps, ended
        self._graph, self._bounds, self._staffing = problem.graph, problem.bounds, problem.staffing
        self._actions = [
            [(leaf, self._graph.tree.action(leaf)) for leaf in leaves] for leaves in self._graph.activities
        ]
        self._names: list[str] = []
        self._kind: list[str] = []
        self._alike: list[object] = []
        self._homes: list[Spot] = []
        self._since: list[int] = []
        self._until: list[int | None] = []
        for kind in problem.fleet.types:
            for robot, start in zip(kind.members, problem.trips.starts(kind.id), strict=True):
                named = robot.id if robot.id in problem.required else ""
                self._names.append(robot.id)
                self._kind.append(kind.id)
                self._homes.append(start)
                self._alike.append(
                    (kind.id, start, tuple(sorted(robot.remaining.items())), named, kind.availability(robot))
                )
                since_s, until_s = kind.availability(robot)
                self._since.append(ticks(since_s))
                self._until.append(None if until_s is None else ticks_within(until_s))
        self._of_kind: dict[str, list[int]] = {}
        for number, kind_id in enumerate(self._kind):
            self._of_kind.setdefault(kind_id, []).append(number)
        self._first = {role: self._graph.activity_of[leaves[0]] for role, leaves in self._graph.roles.items()}
        self._last = {role: leaves[-1] for role, leaves in self._graph.roles.items()}
        self._takers = problem.hand_overs.taker
        self._roles_of: dict[str, list[int]] = {}
        for role in self._graph.roles:
            self._roles_of.setdefault(self._staffing.type_of[role], []).append(role)
        self._ending = {one for ends in self._graph.until.values() for one in ends}
        self._steps = 0
        self._best: Course | None = None
        self._makespan = 0
        self._under_way: dict[int, int] = {}
        self._waits: dict[int, list[int]] = {}

    def __call__(self) -> Tried:
        """Try."""
        opened = sorted(self._graph.until)
        ways = [sorted(self._graph.until[one]) for one in opened]
        if too_many(self._problem) or self._out_of_turn() or may_wait_at_chargers(self._problem):
            return Tried(False, None, 0)
        # Not before it is known that the mission is small:
        self._relations, self._load = Relations(self._graph), Load(self._problem, self._of_kind, self._until)
        try:
            for chosen in product(*(way or [-1] for way in ways)):
                self._under_way = {one: last for one, last in zip(opened, chosen, strict=True) if last >= 0}
                self._waits = {}
                for one, last in self._under_way.items():
                    self._waits.setdefault(last, []).append(one)
                state = self._begin()
                self._settle(state, [event for event, count in enumerate(state.missing) if not count])
                self._go_on(state)
        except _EnoughError:
            return Tried(False, self._best, self._steps, self._makespan)
        return Tried(True, self._best, self._steps, self._makespan)

    def _out_of_turn(self) -> bool:
        """
        Whether an order of starts may not do: what sets the end of an open-ended action may be put down after what starts later, which
        matters if it holds a shared resource, or if anything is handed over. And what takes no time may hold a shared resource at the very
        moment at which one hands over and another takes over what they hold: of that no course can tell the order.
        """
        sharing = self._problem.sharing
        if sharing.on_ways:  # nor does an order of starts tell who sets out first
            return True
        if self._problem.hand_overs and (
            self._graph.until or any(not self._bounds.duration[one] for one in sharing.demand)
        ):
            return True
        return any(one in sharing.demand for ends in self._graph.until.values() for one in ends)

    def _awaits(self, state: State, activity: int) -> bool:
        """Whether an activity touches what is still to be handed over to another, or takes away the place where that is to be."""
        for giver, taker in self._takers.items():
            if giver in state.starts and taker not in state.starts and taker != activity:
                brought = {name for _, action in self._actions[giver] for name in action.brings}
                kept = brought | {action.at for _, action in self._actions[giver]}
                if any(action.at in brought or kept & {*action.brings} for _, action in self._actions[activity]):
                    return True
        return False

    def _begin(self) -> State:
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
        return State(
            time=time,
            missing=indegrees(self._graph.successors),
            robot_of={},
            spot=[start for kind in problem.fleet.types for start in problem.trips.starts(kind.id)],
            free=self._since[:],
            role=[-1] * len(self._names),
            things={},
            left=left,
        )

    # --- one step ---------------------------------------------------------------------------------------------------

    def _go_on(self, state: State) -> None:
        self._steps += 1
        if self._steps > self._most or (self._steps % 16 == 0 and self._ended()):
            raise _EnoughError
        if len(state.placed) == len(self._actions):
            self._finish(state)
            return
        if self._hopeless(state):
            return
        ready = [activity for activity in range(len(self._actions)) if self._ready(state, activity)]
        options = {activity: self._options(state, activity) for activity in ready}
        latest = self._latest(state, options)
        for activity, own in options.items():
            for option in own:
                if state.key <= option.key <= latest and not self._repeats(state, activity, option):
                    after = self._put(state, activity, option)
                    if after is not None:
                        self._go_on(after)

    def _ready(self, state: State, activity: int) -> bool:
        """Whether an activity can be put down next, as far as order tells."""
        if activity in state.starts or state.missing[2 * activity]:
            return False
        return not any(one not in state.starts for one in self._waits.get(activity, ())) and not self._awaits(
            state, activity
        )

    def _options(self, state: State, activity: int) -> list[_Option]:
        """The ways of putting down an activity next."""
        options: list[_Option] = []
        waits = [state.starts[one] for one in self._waits.get(activity, ())]
        for robots in self._staffings(state, activity):
            start, length, trips = self._earliest(state, activity, robots)
            if trips is not None:
                options.append(_Option(robots, max([start, *waits]), start, length, trips))
        return options

    def _repeats(self, state: State, activity: int, option: _Option) -> bool:
        """Whether an activity of a smaller number could as well have been put down before the last one, at the same key as that."""
        if self._takers or option.key > state.key or not state.placed or activity > state.placed[-1]:
            return False
        last = state.placed[-1]
        if last in self._relations.earlier[activity] or last in self._relations.rivals[activity]:
            return False
        if last in self._ending:  # robots that were under way until then are free since
            return False
        if last in self._waits.get(activity, ()) or {last, activity} <= self._problem.sharing.demand.keys():
            return False
        return not any(
            state.robot_of[self._staffing.group_of[action.role]] in option.robots.values()
            for _, action in self._actions[last]
        )

    def _latest(self, state: State, options: Mapping[int, Sequence[_Option]]) -> int:
        """
        The key beyond which nothing may be put down next; -1 if nothing may.

        The next action of a robot that is held starts at a time that nothing else can change, unless it touches what others may still
        move or hold. So does the next role of a type of which no robot is held, if all roles that are left could be it, at one of the
        times at which they could. What starts later than that would have to be put down after it.
        """
        latest, opening = NEVER, dict[str, list[int]]()
        if self._takers:
            return latest
        for activity, own in options.items():
            if activity in self._problem.sharing.demand or any(
                one not in state.starts for one in self._relations.rivals[activity]
            ):
                continue
            robots = [
                state.robot_of.get(self._staffing.group_of[action.role], -1) for _, action in self._actions[activity]
            ]
            roles = [action.role for _, action in self._actions[activity]]
            if all(robot >= 0 and state.role[robot] == role for robot, role in zip(robots, roles, strict=True)):
                latest = min(latest, own[0].key if own else -1)
            elif len(roles) == 1:
                opening.setdefault(self._staffing.type_of[roles[0]], []).append(activity)
        for kind, activities in opening.items():
            left = sum(self._first[role] not in state.starts for role in self._roles_of[kind])
            if left == len(activities) and all(state.role[robot] < 0 for robot in self._of_kind[kind]):
                keys = [option.key for activity in activities for option in options[activity]]
                latest = min(latest, max(keys, default=-1))
        return latest

    def _finish(self, state: State) -> None:
        end = max(state.time[1 : 2 * len(self._actions) : 2], default=0)
        used = set(state.robot_of.values())
        if self._problem.returning:
            state = state.copy()
            if not all(self._go_home(state, robot) for robot in used):
                return
            end = max([end, *(state.free[robot] for robot in used)])
        if end > self._limit or any(state.missing) or not self._in_time(state):
            return
        if not {*self._problem.required} <= {self._names[robot] for robot in used}:
            return
        self._best, self._makespan, self._limit = self._course(state), end, end - 1

    def _go_home(self, state: State, robot: int) -> bool:
        """Whether a robot gets home; it is there afterwards."""
        trip = self._problem.trips.approach(self._kind[robot], state.spot[robot], self._homes[robot])
        if isinstance(trip, Blocked) or not self._spend(state, {}, robot, trip):
            return False
        state.free[robot] += trip.ticks
        return self._problem.home_by is None or state.free[robot] <= self._problem.home_by

    def _in_time(self, state: State) -> bool:
        """Whether deadlines are kept, and nobody is kept longer than it stays."""
        if any(state.time[2 * activity + 1] > deadline for activity, deadline in self._graph.deadline.items()):
            return False
        return all(
            until is None or state.free[robot] <= until or robot not in state.robot_of.values()
            for robot, until in enumerate(self._until)
        )

    def _hopeless(self, state: State) -> bool:
        """Whether what is left cannot be over in time."""
        heads, tails, limit = self._bounds.heads, self._bounds.tails, self._limit
        for activity in range(len(self._actions)):
            if activity not in state.starts:
                begin = (
                    state.time[2 * activity] if activity in self._waits else max(state.time[2 * activity], state.key)
                )
                if max(begin, heads[2 * activity]) + tails[2 * activity] > limit:
                    return True
        return self._load.too_much(state, limit, self._waits)

    def _staffings(self, state: State, activity: int) -> Iterator[dict[int, int]]:
        """Robots by role, for all roles of an activity."""
        options: list[list[tuple[int, int]]] = []
        for _, action in self._actions[activity]:
            role = action.role
            group = self._staffing.group_of[role]
            robot = state.robot_of.get(group)
            if robot is None:
                options.append([(role, one) for one in self._free(state, group, action.robot_type)])
            elif state.role[robot] in {-1, role}:
                options.append([(role, robot)])
            else:
                return
        for chosen in product(*options):
            taken = dict(chosen)
            if len(set(taken.values())) == len(taken) and self._apart(state, taken):
                yield taken

    def _free(self, state: State, group: int, type_id: str) -> Iterator[int]:
        """Robots that a group may take, of equal ones that have done nothing the first few only."""
        used = set(state.robot_of.values())
        many = max(len(actions) for actions in self._actions)
        fresh: dict[object, int] = {}
        in_use = sum(self._kind[robot] == type_id for robot in used)
        full = in_use >= self._problem.fleet.by_id[type_id].usable
        for robot in self._of_kind[type_id]:
            if state.role[robot] >= 0 or (robot not in used and full):
                continue
            if robot not in used:
                seen = fresh[self._alike[robot]] = fresh.get(self._alike[robot], 0) + 1
                if seen > many:
                    continue
            if self._avoids(state, group, robot):
                continue
            yield robot

    def _avoids(self, state: State, group: int, robot: int) -> bool:
        avoided, worn = self._staffing.avoids[group], self._staffing.wears[group]
        return bool(avoided or worn) and any(
            avoided & self._staffing.wears[other] or worn & self._staffing.avoids[other]
            for other, its in state.robot_of.items()
            if its == robot and other != group
        )

    def _apart(self, state: State, taken: dict[int, int]) -> bool:
        """Joint roles of one activity take their robots at once; together they must not be too many, nor the wrong ones."""
        if len(taken) == 1:
            return True
        used = {*state.robot_of.values(), *taken.values()}
        kinds = self._problem.fleet.types
        return all(sum(self._kind[robot] == kind.id for robot in used) <= kind.usable for kind in kinds)

    def _put(self, state: State, activity: int, option: _Option) -> State | None:
        """The state with an activity put down; None if that cannot be, or is over too late."""
        robots, key, start, length, trips = option
        if start + self._bounds.tails[2 * activity] > self._limit:
            return None
        if start + length > self._graph.deadline.get(activity, start + length):
            return None
        after, end = state.copy(), start + length
        after.key, after.placed = key, (*state.placed, activity)
        after.starts[activity] = start
        for leaf, action in self._actions[activity]:
            robot = robots[action.role]
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

    def _earliest(
        self, state: State, activity: int, robots: dict[int, int]
    ) -> tuple[int, int, dict[int, Trip | None] | None]:
        start, length = state.time[2 * activity], 0
        trips: dict[int, Trip | None] = {}
        for leaf, action in self._actions[activity]:
            robot, trip = robots[action.role], None
            if action.moves or action.at is not None:
                goal = None if action.at is None else self._thing(state, action.at)[0]
                if action.moves or goal is not None:
                    found = self._problem.trips.trip(action, state.spot[robot], goal)
                    if isinstance(found, Blocked):
                        return 0, 0, None
                    trip = found
            trips[leaf] = trip
            way = trip.ticks if trip is not None else 0
            start = max(start, state.free[robot] + (0 if action.moves else way))
            length = max(length, way if action.moves else ticks(action.duration_s))
            if action.at is not None:
                start = max(start, self._thing(state, action.at)[1])
            for name in action.brings:
                start = max(start, *self._thing(state, name)[1:])
        if activity in self._graph.until:
            length = 0
        for one in self._waits.get(activity, ()):
            start = max(start, state.starts[one] + 1 - length)
        lasting = activity in self._graph.until or activity in self._takers
        room = self._room(state, activity, start, None if lasting else length)
        return (0, 0, None) if room is None else (room, length, trips)

    def _room(self, state: State, activity: int, start: int, length: int | None) -> int | None:
        """When there is room in what it holds; None if that is not known before something else is over."""
        sharing = self._problem.sharing
        if activity not in sharing.demand:
            return start

        givers = self._problem.hand_overs.givers(activity)  # they let go when it starts

        def held(name: str) -> list[Hold]:
            there = ((one, robots) for one, robots in sharing.holders(name).items() if one in state.starts)
            taken = [(one, robots) for one, robots in there if one not in givers]
            return [Hold(state.starts[one], self._known_end(state, one), robots) for one, robots in taken]

        return room_for(sharing, sharing.demand[activity], held, start, length)

    def _known_end(self, state: State, activity: int) -> int | None:
        if activity in self._takers:  # held until it is handed over
            return state.starts.get(self._takers[activity])
        event = 2 * activity + 1
        return None if state.missing[event] else state.time[event]

    def _thing(self, state: State, name: str) -> tuple[Spot, int, int]:
        found = state.things.get(name)
        return (self._problem.trips.spot(name), 0, 0) if found is None else found

    def _spend(self, state: State, uses: Mapping[str, float], robot: int, trip: Trip | None) -> bool:
        kind = self._problem.fleet.by_id[self._kind[robot]]
        use = dict(uses)
        if trip is not None:
            for name, amount in kind.uses_per_m.items():
                use[name] = use.get(name, 0.0) + amount * trip.metres
        for name, amount in use.items():
            for whose in (self._names[robot], kind.id, ""):
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
        if action.moves or action.at is not None:
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

    # --- what it came to --------------------------------------------------------------------------------------------

    def _course(self, state: State) -> Course:
        robots = {role: self._names[state.robot_of[group]] for role, group in self._staffing.group_of.items()}
        tours: dict[str, list[int]] = {}
        for activity in state.placed:
            for leaf, action in self._actions[activity]:
                if self._graph.roles[action.role][0] == leaf:
                    tours.setdefault(robots[action.role], []).append(action.role)
        after_end: list[tuple[int, int]] = []
        after_start: list[tuple[int, int]] = []
        for place, second in enumerate(state.placed):
            for first in state.placed[:place]:
                begun = self._begun_is_enough(first, second)
                if begun is not None:
                    (after_start if begun else after_end).append((first, second))
        if self._problem.sharing:
            spans = {one: (state.starts[one], state.time[2 * one + 1]) for one in state.placed}
            order = order_of_events(self._graph, spans, [*after_end, *passings(self._graph, tours)])
            after_end += turns(self._problem.sharing, spans, order)
        return Course(robots, tours, after_end, after_start, dict(self._under_way))

    def _begun_is_enough(self, first: int, second: int) -> bool | None:
        """Whether the second need only wait for the first to begin, for the sake of what they move; None if not even that."""
        waits: bool | None = None
        for _, earlier in self._actions[first]:
            for _, later in self._actions[second]:
                if {*earlier.brings} & {*later.brings, later.at}:
                    return False
                if earlier.at is not None and earlier.at in later.brings:
                    if not earlier.open_ended:
                        return False
                    waits = True
        return waits
