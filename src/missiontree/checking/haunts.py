"""Where actions can happen and robots can be, whatever the times: what any schedule of an alternative has in common."""

from __future__ import annotations

from missiontree.checking.case import Case
from missiontree.checking.journeys import Spot, start_spot
from missiontree.checking.timetable import Timetable

MOST_MOVES = 200
"""Moves of one alternative, beyond which every entity that is moved may be anywhere."""

ANYWHERE: frozenset[Spot] = frozenset((None,))


class Haunts:
    """
    Places of an alternative's actions, as far as its order leaves no doubt.

    Parameters
    ----------
    case
        Scene and fleet.
    timetable
        Its alternative counts, and not its times.
    """

    def __init__(self, case: Case, timetable: Timetable) -> None:
        self._case = case
        self._timetable = timetable
        self._actions = timetable.staffing.actions
        self._moves: dict[str, list[int]] = {}
        for leaf, action in self._actions.items():
            for entity in action.brings if action.moves else ():
                self._moves.setdefault(entity, []).append(leaf)
        self._too_many = sum(map(len, self._moves.values())) > MOST_MOVES
        self._spots: dict[tuple[str, int], frozenset[Spot]] = {}
        self._of_type: dict[str, frozenset[Spot]] = {}
        self._starts: dict[str, frozenset[Spot]] = {}
        for leaf, action in self._actions.items():
            if action.moves and action.at is not None:
                self._find(action.at, leaf, ())

    def of_leaf(self, leaf: int) -> frozenset[Spot]:
        """Where an action may happen, or a move may end; None among them where that may be unknown."""
        at = self._actions[leaf].at
        return ANYWHERE if at is None else self._find(at, leaf, ())

    def of_type(self, type_id: str) -> frozenset[Spot]:
        """Where robots of a type may be when they set out for a role; None among them where that may be unknown."""
        if type_id not in self._of_type:
            self._of_type[type_id] = self._anywhere_of(type_id)
        return self._of_type[type_id]

    def _anywhere_of(self, type_id: str) -> frozenset[Spot]:
        kind = self._case.fleet.by_id.get(type_id)
        starts = (
            {start_spot(self._case, robot) for robot in self._case.at_hand(kind.id)} if kind is not None else {None}
        )
        visited = (
            self.of_leaf(leaf)
            for leaf, action in self._actions.items()
            if action.robot_type == type_id and (action.at is not None or action.moves)
        )
        return frozenset(starts).union(*visited)

    def starts(self, type_id: str) -> frozenset[Spot]:
        """Where robots of a type start."""
        if type_id not in self._starts:
            self._starts[type_id] = frozenset(start_spot(self._case, robot) for robot in self._case.at_hand(type_id))
        return self._starts[type_id]

    def _find(self, entity: str, leaf: int, asking: tuple[tuple[str, int], ...]) -> frozenset[Spot]:
        """Where an entity may be when an action starts: at its start, or where a move not surely after it may have ended."""
        key = (entity, leaf)
        if key in self._spots:
            return self._spots[key]
        if key in asking or len(asking) > MOST_MOVES:
            return ANYWHERE
        before = self._timetable.surely_before
        found: set[Spot] = {self._case.scene.spots.get(entity)}
        moves = [move for move in self._moves.get(entity, ()) if move != leaf]
        if moves and self._too_many:
            return ANYWHERE
        moves = [move for move in moves if not before(leaf, move)]
        past = {move for move in moves if before(move, leaf)}
        if past:
            found.clear()
        for move in moves:
            if any(before(move, later) for later in past if later != move):
                continue  # brought on again before the action starts
            at = self._actions[move].at
            found |= self._find(at, move, (*asking, key)) if at is not None else ANYWHERE
        self._spots[key] = frozenset(found)
        return self._spots[key]
