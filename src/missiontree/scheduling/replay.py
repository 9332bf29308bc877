"""
From a course to a draft: everything as early as the course allows, with the ways, the budgets and the world of every other scheduler.

This is where what a solver says becomes a schedule of ours. A course that cannot be kept gives none.
"""

from __future__ import annotations

import heapq
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise, permutations

from missiontree.estimation.travel import Blocked
from missiontree.mission.reason import Reason
from missiontree.scheduling.availability import away
from missiontree.scheduling.board import Board
from missiontree.scheduling.charging import charge
from missiontree.scheduling.course import Course
from missiontree.scheduling.deadlines import deadlines_missed
from missiontree.scheduling.demand import Demands
from missiontree.scheduling.detours import Detours
from missiontree.scheduling.homing import go_home
from missiontree.scheduling.meeting import apart
from missiontree.scheduling.mission_terms import terms_broken
from missiontree.scheduling.passage import find_passage, hold_ways, wanted_by
from missiontree.scheduling.placing import length
from missiontree.scheduling.precedence import indegrees
from missiontree.scheduling.problem import FILLINGS, Done, Draft, Filling, Problem, Rule
from missiontree.scheduling.room import peak
from missiontree.scheduling.stuck import StuckError
from missiontree.scheduling.trips import Trip


def replay(problem: Problem, course: Course, refills: Sequence[Filling] = FILLINGS) -> Draft | None:
    """
    The draft of a course; None if it contradicts itself, leads nowhere, uses more than there is, or comes too late.

    Parameters
    ----------
    problem, course
        What is decided of what.
    refills
        Where robots refill: how much at a visit, each of which is tried for the best. Default: as much as is needed next, as the rest of
        the tour takes, or as they hold.
    """
    if not _may_fill(problem, course):
        return None
    rules = [Rule(refill=filling) for filling in refills] if problem.chargers else [Rule()]
    drafts = [draft for rule in rules if (draft := _played(problem, course, rule)) is not None]
    return min(drafts, key=lambda draft: draft.value, default=None)


def _played(problem: Problem, course: Course, rule: Rule) -> Draft | None:
    try:
        draft = _Replay(problem, course, rule).draft()
    except StuckError:
        return None
    if draft is None or apart(problem, draft) or terms_broken(problem, draft.robot_of) or away(problem, draft):
        return None
    return None if deadlines_missed(problem, draft) is not None else draft


def _may_fill(problem: Problem, course: Course) -> bool:
    """Whether every group of roles has one robot, of its type, and none that wears a mark it avoids."""
    staffing = problem.staffing
    groups_of: dict[str, list[int]] = {}
    for group, roles in staffing.members.items():
        robots = {course.robots.get(role) for role in roles}
        robot = next(iter(robots))
        if len(robots) > 1 or robot is None or problem.fleet.type_of[robot].id != staffing.type_of[group]:
            return False
        groups_of.setdefault(robot, []).append(group)
    return not any(
        staffing.avoids[one] & staffing.wears[other]
        for groups in groups_of.values()
        for one, other in permutations(groups, 2)
    )


class _Replay:
    def __init__(self, problem: Problem, course: Course, rule: Rule) -> None:
        self._graph = graph = problem.graph
        self._board = board = Board(problem, rule)
        self._demands = Demands(board)
        self._detours = Detours(board, self._demands)
        self._opens: dict[
            int, list[tuple[int, Sequence[int]]]
        ] = {}  # by activity: roles that begin, and what follows each
        for roles in course.tours.values():
            for place, role in enumerate(roles):
                first = graph.activity_of[graph.roles[role][0]]
                self._opens.setdefault(first, []).append((role, roles[place + 1 :]))
        for role, group in board.staffing.group_of.items():
            board.robot_of_group[group] = board.world.robots[course.robots[role]]
        self._later = [list(later) for later in graph.successors]
        for roles in course.tours.values():
            for earlier, later in pairwise(roles):
                last, first = graph.activity_of[graph.roles[earlier][-1]], graph.start(graph.roles[later][0])
                self._later[2 * last + 1].append(first)
                self._later[self._over(last)].append(first)
        for first, second in course.after_end:
            self._later[2 * first + 1].append(2 * second)
            if (over := self._over(first)) != 2 * second:
                self._later[over].append(2 * second)
        for first, second in course.after_start:
            self._later[2 * first].append(2 * second)
        self._under_way: dict[int, list[int]] = {}  # by open-ended activity: those that must end after it has started
        for open_ended, one in course.under_way.items():
            self._under_way.setdefault(open_ended, []).append(one)

    def _over(self, activity: int) -> int:
        """The event with which an activity is really over: who hands over waits for the taker's start."""
        taker = self._board.problem.hand_overs.taker.get(activity)
        return 2 * activity + 1 if taker is None else 2 * taker

    def draft(self) -> Draft | None:
        """Event by event, in an order that the course allows; None if there is none."""
        board, activities = self._board, 2 * len(self._graph.activities)
        missing = indegrees(self._later)
        for ones in self._under_way.values():
            for one in ones:
                missing[2 * one] += 1
        ready = [event for event, count in enumerate(missing) if not count]
        seen = 0
        while ready:
            event = heapq.heappop(ready)
            seen += 1
            if event < activities and event % 2 == 0:
                self._begin(event // 2)
            elif event < activities and event // 2 not in board.problem.hand_overs.taker:
                self._finish(event // 2)
            later = list(self._later[event])
            for after in later:
                board.time[after] = max(board.time[after], board.time[event])
            if event < activities and event % 2 == 0:
                later += [2 * one for one in self._under_way.get(event // 2, ())]
            for after in later:
                missing[after] -= 1
                if not missing[after]:
                    heapq.heappush(ready, after)
        if seen < len(missing):
            return None
        go_home(board, self._detours)
        return board.draft(()) if self._room_kept() else None

    def _room_kept(self) -> bool:
        """Whether shared resources have room for all who hold them."""
        return all(
            peak(list(held.values()), 0) <= self._board.problem.sharing.capacity[name]
            for name, held in self._board.held.items()
        )

    def _begin(self, activity: int) -> None:
        board, actions = self._board, self._board.actions(activity)
        robots = {leaf: board.robot_of_group[board.staffing.group_of[action.role]] for leaf, action in actions}
        for role, rest in self._opens.get(activity, ()):
            robot = board.robot_of_group[board.staffing.group_of[role]]
            if self._detours.refills(robot.type_id):
                later = rest if board.rule.refill == "rest" else ()
                stance = self._detours.before_role(role, robot, more=bool(rest), later=later)
                self._detours.visit(robot, stance.refills if stance is not None else ())
        trips = {leaf: self._demands.trip(robots[leaf].spot, action) for leaf, action in actions}
        start = board.time[2 * activity]
        for leaf, action in actions:
            trip = trips[leaf]
            if isinstance(trip, Blocked):
                raise StuckError(trip.reason)
            way = trip.ticks if trip is not None and not action.moves else 0
            start = max(start, robots[leaf].free_at + way, board.world.not_before(action))
        lasts = length(board, activity, trips)
        start = max(start, board.least_end.get(activity, 0) - lasts)
        departs: Mapping[int, int] = {}
        if board.problem.sharing.on_ways:  # else the course says who waits for whom
            lasting = activity in self._graph.until or activity in board.problem.hand_overs.taker
            free = {leaf: robot.free_at for leaf, robot in robots.items()}
            passage = find_passage(board, activity, free, trips, start, None if lasting else lasts)
            if passage is None:
                name = self._graph.name(self._graph.activities[activity][0])
                message = f"{name!r} finds no room in a shared resource."
                raise StuckError(Reason(rule="deadlock", message=message, node=name))
            start, departs = passage.start, passage.departs
        end = start + lasts
        for leaf, action in actions:
            trip, robot = trips[leaf], robots[leaf]
            assert not isinstance(trip, Blocked)
            charge(board, robot, action, trip)
            leaves_at = start if action.moves else departs.get(leaf, robot.free_at)
            arrives_at = end if action.moves else leaves_at + _ticks(trip)
            board.done[leaf] = Done(leaf, robot.id, start, end, trip, leaves_at, arrives_at)
        board.world.do_jointly([(robots[leaf], action) for leaf, action in actions], start, end)
        board.placed[activity] = [(leaf, robots[leaf]) for leaf, _ in actions]
        board.time[2 * activity] = start
        board.time[2 * activity + 1] = max(board.time[2 * activity + 1], end)
        board.bring(activity, start, end, wanted_by(board, activity, trips) if board.held else {})
        hold_ways(board, trips, departs)
        for giver in board.problem.hand_overs.givers(activity):
            board.hand_over(giver, start)
        for one in self._under_way.get(activity, ()):
            board.least_end[one] = max(board.least_end.get(one, 0), start + 1)

    def _finish(self, activity: int) -> None:
        board, end = self._board, self._board.time[2 * activity + 1]
        board.hold(activity, board.time[2 * activity], end)
        for leaf, robot in board.placed[activity]:
            if board.done[leaf].end != end:
                board.done[leaf] = replace(board.done[leaf], end=end)
            robot.free_at = max(robot.free_at, end)


def _ticks(trip: Trip | None) -> int:
    return 0 if trip is None else trip.ticks
