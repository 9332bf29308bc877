"""
The agenda of a run: activities of roles under way, and queues of roles that are about to begin.

Lazy heaps keep the choice cheap: an entry's time can only be too early, and is put right when it comes up. Roles that may begin
with any robot of a type stand in one queue, which comes up when a robot of the type is free, so that ten thousand of them cost no
more than one.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable
from dataclasses import dataclass, field

from missiontree.scheduling.board import Board
from missiontree.scheduling.placing import Offer, Placing
from missiontree.scheduling.pool import Pool
from missiontree.scheduling.world_state import RobotState

_LOOK = 16  # roles of a queue that are compared where travel makes a difference


@dataclass(slots=True)
class Queue:
    """Roles that may begin with any robot of a type, or with one robot: ``later`` by ready time, ``now`` by when they are due."""

    number: int
    type_id: str
    robot: RobotState | None
    later: list[tuple[int, int]] = field(default_factory=list)
    now: list[tuple[int, int, int]] = field(default_factory=list)
    key: int | None = None


class Queues:
    """
    What may come next.

    Parameters
    ----------
    board, pool, placing
        The run, its robots, and where activities could be placed.
    """

    def __init__(self, board: Board, pool: Pool, placing: Placing) -> None:
        self._board, self._pool, self._placing = board, pool, placing
        self._heap: list[tuple[int, int, int]] = []  # time, 0 and an activity under way in its roles, or 1 and a queue
        self._queues: dict[str, Queue] = {}
        self._list: list[Queue] = []
        self._aside: dict[str, dict[int, None]] = {}  # by type: roles that found not all the robots they need
        self._blocked: dict[int, None] = {}  # activities that wait for a shared resource or for a hand-over
        self._may_be_blocked = bool(board.problem.sharing or board.problem.hand_overs)

    def __bool__(self) -> bool:
        return bool(self._heap)

    def advance(self, place: Callable[[int, Offer], None]) -> None:
        """Take what comes up first: place its activity, or put its time right."""
        time, which, number = heapq.heappop(self._heap)
        if which == 0:
            self._go_on(time, number, place)
        else:
            self._open(time, self._list[number], place)

    def under_way(self, activity: int) -> None:
        """An activity whose roles have all begun may start."""
        heapq.heappush(self._heap, (self._board.time[2 * activity], 0, activity))

    def line_up(self, activity: int) -> None:
        """An activity that begins roles may start."""
        queue = self._queue_of(activity)
        heapq.heappush(queue.later, (self._board.time[2 * activity], activity))
        self.call(queue)

    def call(self, queue: Queue) -> None:
        """Let a queue come up when its first role could begin, if a robot is free at all."""
        free = self._free_from(queue)
        if free is None or not (queue.now or queue.later):
            return
        time = free if queue.now else max(free, queue.later[0][0])
        if queue.key is None or time < queue.key:
            queue.key = time
            heapq.heappush(self._heap, (time, 1, queue.number))

    def wake(self, robot: RobotState) -> None:
        """A robot is free again: queues for it come up, and roles that were put aside line up anew."""
        for activity in self._aside.pop(robot.type_id, {}):
            if activity not in self._board.placed:
                self.line_up(activity)
        for name in (robot.type_id, f"{robot.type_id}/{robot.id}"):
            if name in self._queues:
                self.call(self._queues[name])

    def make_room(self) -> None:
        """A shared resource is known to be free again, or a thing is handed over: what waited for that comes up anew."""
        blocked, self._blocked = self._blocked, {}
        for activity in blocked:
            if activity in self._board.placed:
                continue
            if self._board.opening(activity):
                self.line_up(activity)
            else:
                self.under_way(activity)

    def _queue_of(self, activity: int) -> Queue:
        role = self._board.opening(activity)[0]
        robot, type_id = self._board.bound(role), self._board.staffing.type_of[role]
        name = type_id if robot is None else f"{type_id}/{robot.id}"
        queue = self._queues.get(name)
        if queue is None:
            queue = self._queues[name] = Queue(len(self._list), type_id, robot)
            self._list.append(queue)
        return queue

    def _free_from(self, queue: Queue) -> int | None:
        if queue.robot is not None:
            return queue.robot.free_at if queue.robot.role is None else None
        return self._pool.free_from(queue.type_id)

    def _go_on(self, time: int, activity: int, place: Callable[[int, Offer], None]) -> None:
        if activity in self._board.placed:
            return
        offer = self._placing.offer(activity)
        if offer is None:
            assert self._may_be_blocked, "robots in their roles are there"
            self._blocked[activity] = None
        elif offer.start > time:
            heapq.heappush(self._heap, (offer.start, 0, activity))
        else:
            place(activity, offer)

    def _open(self, time: int, queue: Queue, place: Callable[[int, Offer], None]) -> None:
        if queue.key != time:
            return
        queue.key = None
        free = self._free_from(queue)
        if free is None or free > time:
            self.call(queue)
            return
        limit = time + self._board.rule.patience
        looked, best = self._look(queue, limit, free)
        for entry in looked:
            if best is None or entry[-1] != best[0] or best[1].start > limit:
                heapq.heappush(queue.now, entry)
        if best is not None and best[1].start > limit:
            queue.key = best[1].start
            heapq.heappush(self._heap, (queue.key, 1, queue.number))
            return
        if best is not None:
            place(*best)
        self.call(queue)

    def _look(self, queue: Queue, limit: int, free: int) -> tuple[list[tuple[int, int, int]], tuple[int, Offer] | None]:
        """The first few roles of a queue, those that are due first, and the one of them that can begin earliest."""
        self._ripen(queue, limit)
        looked: list[tuple[int, int, int]] = []
        best: tuple[int, Offer] | None = None
        seen: dict[
            object, bool
        ] = {}  # whether there was an offer: a second role like the first is never the earlier one
        while queue.now and len(looked) < _LOOK and (best is None or best[1].start > limit):
            entry = heapq.heappop(queue.now)
            activity = entry[-1]
            if activity in self._board.placed:
                continue
            if self._queue_of(activity) is not queue:
                self.line_up(activity)
                continue
            like = self._placing.stand_in(activity, free) if queue.robot is None else None
            offer = self._placing.offer(activity) if like not in seen else None
            found = seen.setdefault(like, offer is not None) if like is not None else offer is not None
            if not found:
                self._put_aside(activity)
                continue
            looked.append(entry)
            if offer is not None and (best is None or offer.start < best[1].start):
                best = activity, offer
        return looked, best

    def _ripen(self, queue: Queue, limit: int) -> None:
        """Roles that are ready by now are compared by how soon they are due."""
        board = self._board
        while queue.later and queue.later[0][0] <= limit:
            activity = heapq.heappop(queue.later)[1]
            due = board.problem.bounds.due[2 * activity] - board.rule.jitter.get(activity, 0)
            heapq.heappush(queue.now, (due, board.graph.activities[activity][0], activity))

    def _put_aside(self, activity: int) -> None:
        board = self._board
        if self._may_be_blocked:
            self._blocked[activity] = None
        for mate in board.crews[board.crew_of[board.role(activity)]]:
            self._aside.setdefault(board.staffing.type_of[mate], {})[activity] = None
