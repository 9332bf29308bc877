"""Which robots take the roles that begin: the earliest to begin, then the least idle, then the nearest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.scheduling.board import Board
from missiontree.scheduling.chargers import NOBODY
from missiontree.scheduling.demand import Demand, Demands, lasts
from missiontree.scheduling.detours import Detours, Stance
from missiontree.scheduling.impossible import TOLERANCE
from missiontree.scheduling.matching import match
from missiontree.scheduling.pool import Pool
from missiontree.scheduling.world_state import RobotState

LOOKS_PER_DETOUR = 30
"""What it costs to see where a robot would refill, in robots looked at."""
_Ranked = tuple[bool, int, int, float, int, RobotState]


class Casting:
    """
    Binds robots to roles.

    Parameters
    ----------
    board, pool, demands, detours
        The run, its robots, what roles ask of them, and where they refill before.
    """

    def __init__(self, board: Board, pool: Pool, demands: Demands, detours: Detours) -> None:
        self._board, self._pool, self._demands, self._detours = board, pool, demands, detours
        self.looked = 0  # robots looked at: what a run costs, whatever the machine
        self._usable = {kind.id: kind.usable for kind in board.problem.fleet.types if kind.usable < len(kind.members)}
        self._in_use = dict.fromkeys(self._usable, 0)

    def choose(self, opening: Sequence[int], mates: Sequence[int], ready: int) -> dict[int, RobotState] | None:
        """Different free robots for all groups of these roles, the best first; None if there are not enough."""
        group_of = self._board.staffing.group_of
        wanted: dict[int, int] = {}  # group -> its first role here
        for role in (*opening, *mates):
            wanted.setdefault(group_of[role], role)
        if len(wanted) == 1:
            best = min(self._candidates(opening[0], ready, alone=True), default=None)
            return None if best is None else dict.fromkeys((*opening, *mates), best[-1])
        taken = match(
            {
                group: [one[-1] for one in sorted(self._candidates(role, ready if role in opening else 0))]
                for group, role in wanted.items()
            }
        )
        return None if taken is None else {role: taken[group_of[role]] for role in (*opening, *mates)}

    def bind(self, role: int, robot: RobotState) -> None:
        """From now on the robot is the one of the role's group."""
        group = self._board.staffing.group_of[role]
        self._board.robot_of_group[group] = robot
        if not robot.used and robot.type_id in self._in_use:
            self._in_use[robot.type_id] += 1
        robot.wears |= self._board.staffing.wears[group]
        self._pool.use(robot)

    def _candidates(self, role: int, ready: int, alone: bool = False) -> list[_Ranked]:
        """Free robots that may fill a role, and how well: by whether they are stranded then, begin, idleness, way, and number."""
        board, demands = self._board, self._demands
        group, bound, crew = board.staffing.group_of[role], board.bound(role), board.crew_of[role]
        avoids = board.staffing.avoids[group] if group not in board.robot_of_group else frozenset()
        moves = board.graph.tree.action(board.graph.roles[role][0]).moves
        type_id = board.staffing.type_of[role]
        pooled, known = (board.totals[type_id], board.shared), demands.of(role)
        refilled = board.problem.chargers.refilled.get(type_id, NOBODY)
        beginners = None if bound is not None else self._beginners(type_id, alone)
        ranked: list[_Ranked] = []
        for robot in self._pool.robots(type_id, self._together(role)) if bound is None else [bound]:
            self.looked += LOOKS_PER_DETOUR if refilled else 1
            if beginners is not None and not robot.used and robot.id not in beginners:
                continue
            if robot.role is not None or (robot.promised is not None and robot.promised != crew):
                continue
            if avoids and avoids & robot.wears:
                continue
            if robot.stand not in known:
                known[robot.stand] = demands.ask(role, robot.spot)
            demand, free_at, stranded = known[robot.stand], robot.free_at, False
            if refilled and demand is not None:
                stance = self._detours.before_role(role, robot)
                if stance is None and bound is None:
                    continue
                if stance is not None:
                    demand, free_at, stranded = self._from(role, stance), stance.free_at, stance.stranded
            if demand is not None and board.problem.returning:
                demand = demands.home(demand, robot)
            if demand is None or (
                bound is None and demand.needs and not lasts(demand, robot, pooled, TOLERANCE, refilled)
            ):
                continue
            begin = max(ready, free_at) + demand.way if moves else max(ready, free_at + demand.way)
            if robot.until is not None and begin + board.problem.holds[role] + demand.after > robot.until:
                continue
            ranked.append((stranded, begin, -robot.free_at, demand.metres, robot.index, robot))
        return ranked

    def _from(self, role: int, stance: Stance) -> Demand | None:
        """What a role asks of a robot that sets out after a detour, the detour's own metres included."""
        demand = self._detours.demand(role, stance.spot)
        if demand is None or not stance.refills:
            return demand
        metres = sum(one.trip.metres for one in stance.refills)
        per_m = self._board.problem.fleet.by_id[self._board.staffing.type_of[role]].uses_per_m
        needs = {name: amount + per_m.get(name, 0.0) * metres for name, amount in demand.needs.items()}
        return replace(demand, needs=needs, metres=demand.metres + metres)

    def _beginners(self, type_id: str, alone: bool) -> set[str] | None:
        """Robots that have done nothing yet and may begin; None if all may. ``alone``: one of them will be taken, else several."""
        if type_id not in self._usable:
            return None
        board = self._board
        kept = {name for name in board.rule.binding.values() if not board.world.robots[name].used}
        kept = {name for name in kept if board.world.robots[name].type_id == type_id}
        left = self._usable[type_id] - self._in_use[type_id] - len(kept)
        fresh = [robot.id for robot in board.world.robots.values() if robot.type_id == type_id and not robot.used]
        others = [name for name in fresh if name not in kept]
        return {*kept, *(others if alone and left > 0 else others[: max(0, left)])}

    def _together(self, role: int) -> int:
        """How many robots that are alike could be taken at once with this role."""
        board = self._board
        crew = 1 if board.rule.crew == "none" else len(board.crews[board.crew_of[role]])
        return max(crew, len(board.graph.activities[board.first(role)]))
