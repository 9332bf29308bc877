"""What must be under way when others end: the last of those others waits, as long as it must, for it to begin."""

from __future__ import annotations

from missiontree.scheduling.board import Board


class UnderWay:
    """
    Holds back the last activity of what an until link names, until the open-ended activity has begun.

    Only the last one that could begin is held back, and it only has to end a tick after the open-ended one has started.

    Parameters
    ----------
    board
        The run.
    """

    def __init__(self, board: Board) -> None:
        self._board = board
        self._until = board.graph.until
        self._left = {open_ended: len(ends) for open_ended, ends in self._until.items()}  # not let through yet
        self._waited_for: dict[int, list[int]] = {}
        for open_ended, ends in sorted(self._until.items()):
            for one in ends:
                self._waited_for.setdefault(one, []).append(open_ended)
        self._held: dict[int, list[int]] = {}

    def lets(self, activity: int) -> bool:
        """Whether an activity may begin; one that may not is given back by :meth:`begun`."""
        last_for = [one for one in self._waited_for.get(activity, ()) if self._left[one] == 1]
        for one in last_for:
            if one not in self._board.placed:
                self._held.setdefault(one, []).append(activity)
                return False
        for one in last_for:
            started = self._board.time[2 * one]
            if not self._ended_later(one, started):
                self._board.least_end[activity] = max(self._board.least_end.get(activity, 0), started + 1)
        for one in self._waited_for.get(activity, ()):
            self._left[one] -= 1
        return True

    def holds(self, activity: int) -> bool:
        """Whether an activity is held back right now."""
        return any(activity in held for held in self._held.values())

    def begun(self, activity: int) -> list[int]:
        """Activities that were held back for this one; it has been placed."""
        return self._held.pop(activity, [])

    def _ended_later(self, open_ended: int, started: int) -> bool:
        placed = self._board.placed
        return any(one in placed and self._board.time[2 * one + 1] > started for one in self._until[open_ended])
