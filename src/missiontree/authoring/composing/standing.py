"""What stands before what in an outline, as far as its links say so."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.authoring.methods.outline import Outline, Piece


class StandingOrder:
    """What stands before what, as far as links say so."""

    def __init__(self, outline: Outline) -> None:
        self._above: dict[Piece, Piece] = {}
        waiting = list(outline.pieces)
        while waiting:
            piece = waiting.pop()
            self._above.update(dict.fromkeys(piece.pieces, piece))
            waiting += piece.pieces
        self._after: dict[Piece, list[Piece]] = {}
        for first, second, kind in outline.links:
            if kind == "precedence":
                self.add(first, second)

    def add(self, first: Piece, second: Piece) -> None:
        self._after.setdefault(first, []).append(second)

    def between(self, one: Piece, other: Piece) -> bool:
        """Whether either stands before the other already."""
        return self._reaches(one, other) or self._reaches(other, one)

    def _reaches(self, start: Piece, goal: Piece) -> bool:
        goals = set(self._line(goal))
        waiting, seen = [start], set()
        while waiting:
            piece = waiting.pop()
            if piece in seen:
                continue
            seen.add(piece)
            for above in self._line(piece):
                for following in self._after.get(above, []):
                    if following in goals:
                        return True
                    waiting += [following, *following.leaves]
        return False

    def _line(self, piece: Piece) -> Iterator[Piece]:
        above: Piece | None = piece
        while above is not None:
            yield above
            above = self._above.get(above)
