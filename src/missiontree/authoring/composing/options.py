"""Below which options of which choices the leaves of an outline hang."""

from __future__ import annotations

from missiontree.authoring.methods.outline import Outline, Piece

Option = tuple[int, int]
"""A choice, by its place among the choices of an outline, and the place of the option in it."""


class Options:
    """The options of an outline as it stands; one that is changed since has to be looked at anew."""

    def __init__(self, outline: Outline) -> None:
        self._below: dict[Piece, set[Option]] = {}
        choices = (piece for piece in outline.all_pieces if piece.gate == "xor" and piece.routine is None)
        for place, choice in enumerate(choices):
            for number, option in enumerate(choice.pieces):
                for leaf in option.leaves:
                    self._below.setdefault(leaf, set()).add((place, number))

    def done_with(self, one: Piece, other: Piece) -> bool:
        """Whether a leaf is done whenever another is: no choice takes it away alone."""
        return self._of(one) <= self._of(other)

    def exclude(self, one: Piece, other: Piece) -> bool:
        """Whether two leaves hang below different options of one choice."""
        taken = dict(self._of(one))
        return any(taken.get(choice, number) != number for choice, number in self._of(other))

    def _of(self, leaf: Piece) -> set[Option]:
        return self._below.get(leaf, set())
