"""Which robots may fill the roles of an activity that is put down next."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from missiontree.scheduling.enumeration.robots import Robots
from missiontree.scheduling.enumeration.state import State
from missiontree.scheduling.problem import Problem


class Staffings:
    """
    The choices of robots, but for those that only repeat others.

    Parameters
    ----------
    problem
        The alternative.
    robots
        Its robots.
    """

    def __init__(self, problem: Problem, robots: Robots) -> None:
        self._problem, self._robots, self._staffing = problem, robots, problem.staffing
        graph = problem.graph
        self._actions = [[graph.tree.action(leaf) for leaf in leaves] for leaves in graph.activities]
        self._many = max(map(len, self._actions), default=1)

    def __call__(self, state: State, activity: int) -> Iterator[dict[int, int]]:
        """Robots by role, for all roles of an activity."""
        options: list[list[tuple[int, int]]] = []
        for action in self._actions[activity]:
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
        fresh: dict[object, int] = {}
        in_use = sum(self._robots.kind[robot] == type_id for robot in used)
        full = in_use >= self._problem.fleet.by_id[type_id].usable
        for robot in self._robots.of_kind[type_id]:
            if state.role[robot] >= 0 or (robot not in used and full):
                continue
            if robot not in used:
                seen = fresh[self._robots.alike[robot]] = fresh.get(self._robots.alike[robot], 0) + 1
                if seen > self._many:
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
        return all(sum(self._robots.kind[robot] == kind.id for robot in used) <= kind.usable for kind in kinds)
