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

Where robots may hand over to each other in a circle, at one moment, not everything is tried, and nothing is proven.

What robots can refill is taken to last for ever: what is found may have to be made longer by visits to chargers, and what is not found
is not there. Where robots may refill while they wait, nothing is tried.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from itertools import product

from missiontree.scheduling.bounds import NEVER
from missiontree.scheduling.course import Course
from missiontree.scheduling.enumeration.courses import course_of
from missiontree.scheduling.enumeration.load import Load
from missiontree.scheduling.enumeration.putting import Option, Putting
from missiontree.scheduling.enumeration.robots import Robots
from missiontree.scheduling.enumeration.staffings import Staffings
from missiontree.scheduling.enumeration.state import State
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.recharging import may_wait_at_chargers

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
    anyway
        Whether to try also where an order of starts may not do, so that what is found is good but nothing is proven. Default false.
    """

    def __init__(
        self, problem: Problem, limit: int, most_steps: int, ended: Callable[[], bool], anyway: bool = False
    ) -> None:
        self._problem, self._limit, self._most, self._ended = problem, limit, most_steps, ended
        self._anyway = anyway
        self._graph, self._bounds, self._staffing = problem.graph, problem.bounds, problem.staffing
        self._actions = [
            [(leaf, self._graph.tree.action(leaf)) for leaf in leaves] for leaves in self._graph.activities
        ]
        self._robots = Robots(problem)
        self._staffings, self._putting = Staffings(problem, self._robots), Putting(problem, self._robots)
        self._first = {role: self._graph.activity_of[leaves[0]] for role, leaves in self._graph.roles.items()}
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
        if too_many(self._problem) or self._problem.sharing.on_ways or may_wait_at_chargers(self._problem):
            return Tried(
                False, None, 0
            )  # of ways without room for all, an order of starts does not tell who sets out first
        in_turn = not self._out_of_turn()
        if not in_turn and not self._anyway:
            return Tried(False, None, 0)
        # Not before it is known that the mission is small:
        self._relations = self._putting.relations
        self._load = Load(self._problem, self._robots.of_kind, self._robots.until)
        try:
            for chosen in product(*(way or [-1] for way in ways)):
                self._under_way = {one: last for one, last in zip(opened, chosen, strict=True) if last >= 0}
                self._waits = {}
                for one, last in self._under_way.items():
                    self._waits.setdefault(last, []).append(one)
                self._go_on(self._putting.begin())
        except _EnoughError:
            return Tried(False, self._best, self._steps, self._makespan)
        return Tried(in_turn and not self._may_exchange(), self._best, self._steps, self._makespan)

    def _may_exchange(self) -> bool:
        """
        Whether robots may hand over to each other in a circle, all at one moment: that is never tried, as each would have to be first.

        So it may be if, for each hand-over of a circle, the robot that takes over may be the giver of the next.
        """

        def types(activity: int) -> set[str]:
            return {action.robot_type for _, action in self._actions[activity]}

        def roles(activity: int) -> set[int]:
            return {action.role for _, action in self._actions[activity]}

        following = {
            giver: {
                other
                for other in self._takers
                if types(taker) & types(other)
                and not roles(taker) & roles(other)
                and taker not in self._relations.earlier[other]
                and other != giver
            }
            for giver, taker in self._takers.items()
        }
        try:
            TopologicalSorter(following).prepare()
        except CycleError:
            return True
        return False

    def _out_of_turn(self) -> bool:
        """
        Whether an order of starts may not do: what sets the end of an open-ended action may be put down after what starts later, which
        matters if it holds a shared resource, or if anything is handed over. And what takes no time may hold a shared resource at the very
        moment at which one hands over and another takes over what they hold: of that no course can tell the order.
        """
        sharing = self._problem.sharing
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
                in_turn = state.key <= option.key <= latest and not self._repeats(state, activity, option)
                if in_turn and not self._late(activity, option):
                    after = self._putting.put(state, activity, option)
                    if after is not None:
                        self._go_on(after)

    def _ready(self, state: State, activity: int) -> bool:
        """Whether an activity can be put down next, as far as order tells."""
        if activity in state.starts or state.missing[2 * activity]:
            return False
        return not any(one not in state.starts for one in self._waits.get(activity, ())) and not self._awaits(
            state, activity
        )

    def _options(self, state: State, activity: int) -> list[Option]:
        """The ways of putting down an activity next."""
        options: list[Option] = []
        waits = [state.starts[one] for one in self._waits.get(activity, ())]
        for robots in self._staffings(state, activity):
            start, length, trips = self._putting.earliest(state, activity, robots, waits)
            if trips is not None:
                options.append(Option(robots, max([start, *waits]), start, length, trips))
        return options

    def _repeats(self, state: State, activity: int, option: Option) -> bool:
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

    def _late(self, activity: int, option: Option) -> bool:
        """Whether an activity put down like that, or what must follow it, is not over in time."""
        end = option.start + option.length
        late = end > self._graph.deadline.get(activity, end)
        return late or option.start + self._bounds.tails[2 * activity] > self._limit

    def _latest(self, state: State, options: Mapping[int, Sequence[Option]]) -> int:
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
            if left == len(activities) and all(state.role[robot] < 0 for robot in self._robots.of_kind[kind]):
                keys = [option.key for activity in activities for option in options[activity]]
                latest = min(latest, max(keys, default=-1))
        return latest

    def _finish(self, state: State) -> None:
        end = max(state.time[1 : 2 * len(self._actions) : 2], default=0)
        used = set(state.robot_of.values())
        if self._problem.returning:
            state = state.copy()
            if not all(self._putting.go_home(state, robot) for robot in used):
                return
            end = max([end, *(state.free[robot] for robot in used)])
        if end > self._limit or any(state.missing) or not self._in_time(state):
            return
        if not {*self._problem.required} <= {self._robots.names[robot] for robot in used}:
            return
        self._best = course_of(self._problem, self._robots.names, state, self._under_way)
        self._makespan, self._limit = end, end - 1

    def _in_time(self, state: State) -> bool:
        """Whether deadlines are kept, and nobody is kept longer than it stays."""
        if any(state.time[2 * activity + 1] > deadline for activity, deadline in self._graph.deadline.items()):
            return False
        return all(
            until is None or state.free[robot] <= until or robot not in state.robot_of.values()
            for robot, until in enumerate(self._robots.until)
        )

    def _hopeless(self, state: State) -> bool:
        """Whether what is left cannot be over by the limit, or what is under way or left not by a deadline."""
        heads, tails, limit, latest = self._bounds.heads, self._bounds.tails, self._limit, self._bounds.latest
        if latest and any(time > by for time, by in zip(state.time, latest, strict=True)):
            return True
        for activity in range(len(self._actions)):
            if activity not in state.starts:
                begin = (
                    state.time[2 * activity] if activity in self._waits else max(state.time[2 * activity], state.key)
                )
                begin = max(begin, heads[2 * activity])
                if begin + tails[2 * activity] > limit or (latest and begin > latest[2 * activity]):
                    return True
        return self._load.too_much(state, limit, self._waits)
