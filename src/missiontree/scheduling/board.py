"""What one run has decided so far: which roles have begun and by whom, which actions stand where, when events are."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from missiontree.mission.grounded import Action
from missiontree.mission.reason import Reason
from missiontree.scheduling.precedence import indegrees
from missiontree.scheduling.problem import Done, Draft, Homeward, Problem, Refill, Rule
from missiontree.scheduling.room import Hold
from missiontree.scheduling.world_state import RobotState, WorldState


class Board:
    """
    The state that the parts of a run share.

    Parameters
    ----------
    problem
        The alternative.
    rule
        How to decide.
    """

    def __init__(self, problem: Problem, rule: Rule) -> None:
        self.problem, self.rule, self.graph, self.staffing = problem, rule, problem.graph, problem.staffing
        self.world = WorldState(problem.fleet, problem.trips)
        self.totals = {kind.id: dict(kind.total_limits) for kind in problem.fleet.types}
        self.shared = dict(problem.shared)
        self.time = [0] * len(self.graph.successors)
        for activity, release in self.graph.release.items():
            self.time[2 * activity] = release
        self.missing = indegrees(self.graph.successors)
        self.least_end: dict[int, int] = {}  # of activities that others must be under way for
        self.begun = dict.fromkeys(self.graph.roles, 0)  # actions of each role that are placed
        self.robot_of_group: dict[int, RobotState] = {}
        self.crew_of = problem.bundles.of_role if rule.crew == "bundle" else problem.crews
        self.crews: dict[int, list[int]] = {}
        for role, crew in sorted(self.crew_of.items()):
            self.crews.setdefault(crew, []).append(role)
        self.placed: dict[int, list[tuple[int, RobotState]]] = {}  # by activity: its leaves and who does them
        self.done: dict[int, Done] = {}
        self.held: dict[str, dict[int, Hold]] = {name: {} for name in problem.sharing.capacity}
        self.returns: list[Homeward] = []
        self.wanted: dict[int, dict[str, int]] = {}  # by activity: what it holds
        self.waiting: list[int] = []  # activities that end with a hand-over, and wait for their taker
        self.refills: list[Refill] = []
        self.plugged: dict[str, list[Hold]] = {}  # by charger: who refills there
        self.open_roles = Counter(self.staffing.type_of[role] for role in self.graph.roles)  # not begun, by type
        self.metres = 0.0

    def actions(self, activity: int) -> list[tuple[int, Action]]:
        """Leaves of an activity, with their actions."""
        return [(leaf, self.graph.tree.action(leaf)) for leaf in self.graph.activities[activity]]

    def role(self, activity: int) -> int:
        """Role of an activity's first leaf."""
        return self.graph.tree.action(self.graph.activities[activity][0]).role

    def opening(self, activity: int) -> list[int]:
        """Roles that begin with this activity."""
        roles = (self.graph.tree.action(leaf).role for leaf in self.graph.activities[activity])
        return [role for role in roles if not self.begun[role]]

    def first(self, role: int) -> int:
        """Activity that a role begins with."""
        return self.graph.activity_of[self.graph.roles[role][0]]

    def robot(self, role: int) -> RobotState | None:
        """The robot of a role's group, once it has one."""
        return self.robot_of_group.get(self.staffing.group_of[role])

    def bound(self, role: int) -> RobotState | None:
        """The robot that a role must take, if that is settled."""
        group = self.staffing.group_of[role]
        if group in self.robot_of_group:
            return self.robot_of_group[group]
        return self.world.robots[self.rule.binding[group]] if group in self.rule.binding else None

    def hold(self, activity: int, start: int, end: int | None) -> None:
        """An activity holds what it holds, until nobody knows when if ``end`` is None."""
        for name, robots in self.wanted.get(activity, {}).items():
            self.held[name][activity] = Hold(start, end, robots)

    def awaits(self, activity: int) -> bool:
        """Whether an activity touches what is still to be handed over to another, or takes away the place where that is to be."""
        taker = self.problem.hand_overs.taker
        return any(taker[giver] != activity and self._disturbs(activity, giver) for giver in self.waiting)

    def _disturbs(self, activity: int, giver: int) -> bool:
        given = [action for _, action in self.actions(giver)]
        brought, there = {name for action in given for name in action.brings}, {action.at for action in given}
        return any(
            action.at in brought or (brought | there).intersection(action.brings)
            for _, action in self.actions(activity)
        )

    def bring(self, activity: int, start: int, end: int, wanted: dict[str, int]) -> None:
        """An activity is put down: it holds what it wants, and waits for its taker if it ends with a hand-over."""
        gives = activity in self.problem.hand_overs.taker
        if wanted:
            self.wanted[activity] = wanted
        self.hold(activity, start, None if gives or activity in self.graph.until else end)
        if gives:
            self.waiting.append(activity)

    def hand_over(self, giver: int, moment: int) -> None:
        """The taker has come: the giver's action is put off until it ends just then, and its robot stays until then."""
        start = end = moment
        for leaf, robot in self.placed[giver]:
            one, action = self.done[leaf], self.graph.tree.action(leaf)
            later, start = moment - one.end, moment - (one.end - one.start)
            own = later if action.moves else 0  # the way of a move is the move itself
            self.done[leaf] = replace(
                one, start=start, end=moment, leaves_at=one.leaves_at + own, arrives_at=one.arrives_at + own
            )
            robot.free_at = max(robot.free_at, moment)
            if action.at is not None:
                self.world.needed(action.at, moment)
            for name in action.brings:
                self.world.brought(name, moment)
        self.hold(giver, start, end)
        self.time[2 * giver + 1] = end
        self.waiting.remove(giver)

    def secured(self, role: int) -> bool:
        """Whether a role has begun, or its robot is kept for it."""
        robot = self.robot(role)
        return self.begun[role] > 0 or (robot is not None and robot.promised == self.crew_of[role])

    def draft(self, reasons: tuple[Reason, ...]) -> Draft:
        """What the run came to."""
        done = sorted(self.done.values(), key=lambda one: (one.start, one.leaf))
        robot_of = {
            role: self.robot_of_group[group].id
            for role, group in sorted(self.staffing.group_of.items())
            if group in self.robot_of_group
        }
        makespan = max([*(one.end for one in done), *(one.end for one in self.returns)], default=0)
        return Draft(done, robot_of, makespan, self.metres, reasons, self.returns, self.refills)
