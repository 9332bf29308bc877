"""The times of goals, put on what is built for them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from missiontree.authoring.methods.outline import Outline, Piece
from missiontree.mission.goal import Goal
from missiontree.mission.reason import Reason
from missiontree.mission.times import words_of_times

Call = tuple[str, tuple[str, ...], tuple[str, ...]]


def give_times(
    timed: Sequence[tuple[Goal, Sequence[Piece]]], calls: Mapping[Piece, Sequence[Call]], outline: Outline
) -> Reason | None:
    """
    Put times on the pieces of goals; where a search is done once for several goals, all their times hold for it.

    Parameters
    ----------
    timed
        Goals with times, and their pieces.
    calls
        What each of those pieces asked for before goals were put together.
    outline
        What is built.

    Returns
    -------
    Reason or None
        Why two goals contradict each other.
    """
    standing = set(outline.all_pieces)
    leaves = [piece for piece in standing if piece.routine is not None]
    for goal, pieces in timed:
        for piece in pieces:
            own = [piece] if piece in standing else []
            gone = set(calls[piece]).difference(leaf.call for one in own for leaf in one.leaves)
            for one in (*own, *(leaf for leaf in leaves if leaf.call in gone)):
                deadlines = [due for due in (one.deadline_s, goal.deadline_s) if due is not None]
                one.release_s, one.deadline_s = max(one.release_s, goal.release_s), min(deadlines, default=None)
                if one.deadline_s is not None and one.deadline_s < one.release_s:
                    return _contradiction(goal, one)
    return None


def _contradiction(goal: Goal, piece: Piece) -> Reason:
    asked = " and ".join(words_of_times(piece.release_s, piece.deadline_s))
    return Reason(
        rule="times_conflict",
        message=f"{piece.label} is done once for several goals, which ask for it {asked}; one of them is {goal.shown[:200]!r}.",
        node=piece.label,
        found=asked,
        hint="Change the times of one of the goals.",
    )
