"""Whether the roles that nobody has begun find room in what is left of their robots' time."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence

from missiontree.scheduling.bounds import NEVER
from missiontree.scheduling.enumeration.approaches import Approaches
from missiontree.scheduling.enumeration.state import State
from missiontree.scheduling.load import pieces_of
from missiontree.scheduling.problem import Problem


class Load:
    """
    The load bound (see :mod:`missiontree.scheduling.load`) of a schedule under trial.

    A robot that is held has first to end its role. The roles of a type that nobody has begun, with the way into each and all that must
    follow it, then need no more time than its robots have left until the limit; nor do those of them that must be followed by the most.

    Parameters
    ----------
    problem
        The alternative.
    of_kind
        Numbers of the robots of each type.
    until
        When robots leave, by number; None if they stay.
    """

    def __init__(self, problem: Problem, of_kind: Mapping[str, Sequence[int]], until: Sequence[int | None]) -> None:
        graph, bounds = problem.graph, problem.bounds
        self._until = [NEVER if end is None else end for end in until]
        self._rest = {
            role: [
                (graph.activity_of[leaf], bounds.duration[graph.activity_of[leaf]] + bounds.lag.get(leaf, 0))
                for leaf in leaves
            ]
            for role, leaves in graph.roles.items()
        }
        pieces = pieces_of(graph, problem.staffing, bounds.duration, bounds.lag, bounds.heads, bounds.tails)
        self._hold = {piece.role: piece.hold for piece in pieces}
        self._tail = {piece.role: piece.tail for piece in pieces}
        by_type: dict[str, list[int]] = {}
        for piece in sorted(pieces, key=lambda one: (-one.tail, one.role)):
            by_type.setdefault(piece.type_id, []).append(piece.role)
        self._shares = [
            (of_kind[kind], problem.fleet.by_id[kind].usable, roles, Approaches(problem, kind, roles))
            for kind, roles in by_type.items()
        ]

    def too_much(self, state: State, limit: int, early: Container[int]) -> bool:
        """Whether what is left cannot be over by the limit; some activities (``early``) may start before the key."""
        for robots, usable, roles, approaches in self._shares:
            left = [role for role in roles if self._rest[role][0][0] not in state.starts]
            if not left:
                continue
            free = [self._free(state, robot) for robot in robots]
            inside, before = approaches.least(left, [(state.role[robot], state.spot[robot]) for robot in robots])
            # No role begins before the key, unless it may; but a robot may be on its way to one by then.
            key = 0 if any(self._rest[role][0][0] in early for role in left) else state.key
            later = [max(one, key) for one in free]
            if self._exceeded(robots, usable, later, left, inside, limit):
                return True
            if before is not None and self._exceeded(robots, usable, free, left, before, limit):
                return True
        return False

    def _free(self, state: State, robot: int) -> int:
        """Ticks before which a robot can begin no other role, nor set out for one."""
        role = state.role[robot]
        left = sum(ticks for activity, ticks in self._rest[role] if activity not in state.starts) if role >= 0 else 0
        return state.free[robot] + left

    def _exceeded(
        self,
        robots: Sequence[int],
        usable: int,
        free: Sequence[int],
        roles: Sequence[int],
        ways: Sequence[int],
        limit: int,
    ) -> bool:
        """Whether roles, each with a way into it, need more than robots have until the limit, from when they are free on."""
        need, until = 0, self._until
        for role, way in zip(roles, ways, strict=True):
            need += self._hold[role] + way
            end = limit - self._tail[role]
            spans = [max(0, min(end, until[robot]) - since) for robot, since in zip(robots, free, strict=True)]
            if need > sum(spans if len(spans) <= usable else sorted(spans)[-usable:]):
                return True
        return False
