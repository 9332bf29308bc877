"""
One run of serial schedule generation (Kelley 1963; Kolisch 1996), for robots that are held in roles and travel.

Of all actions that may begin, the one that can begin earliest is put at the end of its robots' timelines; of equals the one that is
due first, by deadlines and by the way still to go; of those the first leaf. What may come next is in
:mod:`missiontree.scheduling.queues`, who would do it in :mod:`missiontree.scheduling.casting`, and when in
:mod:`missiontree.scheduling.placing`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from missiontree.estimation.travel import Blocked
from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.grounded import Action, GroundedTree
from missiontree.scheduling.board import Board
from missiontree.scheduling.casting import Casting
from missiontree.scheduling.charging import charge
from missiontree.scheduling.deadlock import deadlock_reason
from missiontree.scheduling.demand import Demands
from missiontree.scheduling.detours import Detours
from missiontree.scheduling.homing import go_home
from missiontree.scheduling.passage import hold_ways, wanted_by
from missiontree.scheduling.placing import Offer, Placing, length
from missiontree.scheduling.pool import Pool
from missiontree.scheduling.precedence import indegrees
from missiontree.scheduling.problem import Done, Draft, Problem, Rule
from missiontree.scheduling.queues import Queues
from missiontree.scheduling.stuck import StuckError
from missiontree.scheduling.trips import Trip
from missiontree.scheduling.under_way import UnderWay
from missiontree.scheduling.world_state import RobotState

SMALL = 32
"""Leaves of a mission that is scheduled once even if time is up."""


def few_leaves(tree: GroundedTree, alternative: Alternative) -> bool:
    """Whether an alternative is so small that it is scheduled once even if time is up."""
    return len(selected_leaves(tree, alternative.choices)) <= SMALL


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
        self._bundles, self._rule, self._graph = problem.bundles, rule, problem.graph
        self._board = board = Board(problem, rule)
        pool, self._demands = Pool(problem.fleet, board.world), Demands(board)
        self._detours = Detours(board, self._demands)
        self._casting = Casting(board, pool, self._demands, self._detours)
        self._queues = Queues(board, pool, Placing(board, self._casting, self._demands, self._detours))
        self._bundle_missing = indegrees(problem.bundles.after)
        self._bundle_left = list(problem.bundles.leaves)
        self._under_way = UnderWay(board)
        self._gated: dict[int, list[int]] = {}

    @property
    def looked(self) -> int:
        """How many robots were looked at for roles: what the run cost, whatever the machine."""
        return self._casting.looked

    def __call__(self, ended: Callable[[], bool]) -> Draft | None:
        """Run to the end; None if told to stop before, which a mission of a few leaves never is."""
        small = len(self._graph.activity_of) <= SMALL
        try:
            self._open_bundles([bundle for bundle, count in enumerate(self._bundle_missing) if not count])
            self._settle([event for event, count in enumerate(self._board.missing) if not count])
            while self._queues:
                if not small and ended():
                    return None
                self._queues.advance(self._commit)
            if len(self._board.done) < len(self._graph.activity_of):
                raise StuckError(deadlock_reason(self._board))
            go_home(self._board, self._detours)
        except StuckError as stuck:
            return self._board.draft((stuck.reason,))
        return self._board.draft(())

    # --- what may begin ---------------------------------------------------------------------------------------------

    def _settle(self, events: Sequence[int]) -> None:
        """Events whose time is known by now: pass it on, and begin or end what waited for it."""
        board, stack = self._board, list(events)[::-1]
        activities = 2 * len(self._graph.activities)
        while stack:
            event = stack.pop()
            if event < activities and event % 2 == 0 and event // 2 not in board.placed:
                self._may_begin(event // 2)
                continue
            if event < activities and event % 2 == 1 and event // 2 not in board.problem.hand_overs.taker:
                self._finish(event // 2)  # who hands over is over when the taker starts
            for after in self._graph.successors[event]:
                board.time[after] = max(board.time[after], board.time[event])
                board.missing[after] -= 1
                if not board.missing[after]:
                    stack.append(after)

    def _may_begin(self, activity: int) -> None:
        crew = self._board.crew_of[self._board.role(activity)]
        if self._rule.crew == "bundle" and self._bundle_missing[crew]:
            self._gated.setdefault(crew, []).append(activity)
        elif not self._under_way.lets(activity):
            pass  # begins once all that must be under way by its end are
        elif self._board.opening(activity):
            self._queues.line_up(activity)
        else:
            self._queues.under_way(activity)

    def _open_bundles(self, bundles: list[int]) -> None:
        stack = list(bundles)
        while stack:
            bundle = stack.pop()
            for activity in self._gated.pop(bundle, ()):
                self._may_begin(activity)
            if not self._bundle_left[bundle]:
                for after in self._bundles.after[bundle]:
                    self._bundle_missing[after] -= 1
                    if not self._bundle_missing[after]:
                        stack.append(after)

    # --- doing it ---------------------------------------------------------------------------------------------------

    def _commit(self, activity: int, offer: Offer) -> None:
        """Put an activity into the schedule."""
        board, actions = self._board, self._board.actions(activity)
        for role, stance in offer.stances.items():
            self._detours.visit(offer.robots[role], stance.refills)
        trips = {leaf: self._demands.trip(offer.robots[action.role].spot, action) for leaf, action in actions}
        end = offer.start + length(board, activity, trips)
        for role, robot in offer.mates.items():
            self._casting.bind(role, robot)
            robot.promised = board.crew_of[role]
        for leaf, action in actions:
            trip = trips[leaf]
            assert not isinstance(trip, Blocked)
            self._do(leaf, action, offer.robots[action.role], trip, (offer.start, end, offer.departs.get(leaf)))
        board.world.do_jointly([(offer.robots[action.role], action) for _, action in actions], offer.start, end)
        board.placed[activity] = [(leaf, offer.robots[action.role]) for leaf, action in actions]
        board.time[2 * activity] = offer.start
        board.time[2 * activity + 1] = max(board.time[2 * activity + 1], end)
        board.bring(activity, offer.start, end, wanted_by(board, activity, trips) if board.held else {})
        hold_ways(board, trips, offer.departs)
        for role in offer.mates:
            first = board.first(role)
            if not board.missing[2 * first] and first not in board.placed and not self._under_way.holds(first):
                self._queues.line_up(first)  # now in the queue of its own robot
        for waiting in self._under_way.begun(activity):
            self._may_begin(waiting)
        for giver in board.problem.hand_overs.givers(activity):
            board.hand_over(giver, offer.start)
            self._finish(giver)
            self._queues.make_room()
        self._settle([2 * activity])

    def _do(
        self, leaf: int, action: Action, robot: RobotState, trip: Trip | None, times: tuple[int, int, int | None]
    ) -> None:
        board, role, (start, end, sets_out) = self._board, action.role, times
        if not board.begun[role]:
            self._casting.bind(role, robot)
            robot.role = role
            board.open_roles[robot.type_id] -= 1
        board.begun[role] += 1
        charge(board, robot, action, trip)
        departs = start if action.moves else robot.free_at if sets_out is None else sets_out
        arrives = end if action.moves else departs + (trip.ticks if trip is not None else 0)
        board.done[leaf] = Done(leaf, robot.id, start, end, trip, departs, arrives)

    def _finish(self, activity: int) -> None:
        """The end of an activity is known: its robots are there from then on, and free if the role is over."""
        board, end = self._board, self._board.time[2 * activity + 1]
        if activity in self._graph.until and activity in board.problem.sharing.demand:
            board.hold(activity, board.time[2 * activity], end)
            self._queues.make_room()
        released: list[RobotState] = []
        bundles: list[int] = []
        for leaf, robot in board.placed[activity]:
            role = self._graph.tree.action(leaf).role
            if board.done[leaf].end != end:
                board.done[leaf] = replace(board.done[leaf], end=end)
            robot.free_at = end
            leaves = self._graph.roles[role]
            if board.begun[role] == len(leaves) and leaf == leaves[-1]:
                if len(leaves) > 1 or robot.promised is not None or activity in self._graph.until:
                    released.append(robot)  # else nobody has met it held
                self._release(role, robot)
            bundle = self._bundles.of_role[role]
            self._bundle_left[bundle] -= 1
            if not self._bundle_left[bundle]:
                bundles.append(bundle)
        for robot in released:
            self._queues.wake(robot)
        self._open_bundles(bundles)

    def _release(self, role: int, robot: RobotState) -> None:
        board = self._board
        robot.role = None
        if robot.promised is not None:
            rest = (mate for mate in board.crews[robot.promised] if not board.begun[mate])
            if not any(board.robot(mate) is robot for mate in rest):
                robot.promised = None
