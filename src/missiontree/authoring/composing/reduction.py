"""Links that other links imply are left out, so that a tree reads well: a transitive reduction that keeps the meaning."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.authoring.methods.outline import Outline, Piece

MAX_PAIRS = 2000
"""If the links order more pairs of leaves than these, all links stay: looking for what is implied takes the square of the number."""

Pair = tuple[Piece, Piece]


def without_implied(outline: Outline, unsaid: Sequence[Pair]) -> list[Pair]:
    """
    Drop every precedence that others imply, from the outline and from the pairs that nobody said.

    Parameters
    ----------
    outline
        Pieces and links; its links are changed in place.
    unsaid
        Further precedence.

    Returns
    -------
    list of pairs
        Those of ``unsaid`` that remain.
    """
    said = [(first, second) for first, second, kind in outline.links if kind == "precedence"]
    after = _Order([*unsaid, *said], _optional(outline))
    if after.pairs > MAX_PAIRS or after.circular():
        return list(unsaid)  # in a circle every link implies every other
    for pair in dict.fromkeys((*unsaid, *said)):
        after.drop_if_implied(pair)
    outline.links[:] = [link for link in outline.links if link[2] != "precedence" or link[:2] in after.kept]
    return [pair for pair in unsaid if pair in after.kept]


def _optional(outline: Outline) -> set[Piece]:
    """The leaves that may not be selected: nothing follows by way of them."""
    waiting = [(piece, False) for piece in outline.pieces]
    found: set[Piece] = set()
    while waiting:
        piece, chosen = waiting.pop()
        if piece.routine is not None and chosen:
            found.add(piece)
        waiting += [(below, chosen or piece.gate == "xor") for below in piece.pieces]
    return found


class _Order:
    """Which leaf ends before which other starts, and which link says so."""

    def __init__(self, links: Sequence[Pair], optional: set[Piece]) -> None:
        self.kept = set(links)
        self.pairs = 0
        self._optional = optional
        self._behind: dict[Piece, list[tuple[Piece, Pair]]] = {}
        for pair in dict.fromkeys(links):
            seconds = list(pair[1].leaves)
            for first in pair[0].leaves:
                self.pairs += len(seconds)
                if self.pairs > MAX_PAIRS:
                    return
                self._behind.setdefault(first, []).extend((second, pair) for second in seconds)

    def circular(self) -> bool:
        """Whether some leaf would come before itself."""
        return any(leaf in self._reached(leaf) for leaf in self._behind)

    def drop_if_implied(self, pair: Pair) -> None:
        """Leave a link out if the others that are kept say all that it says."""
        self.kept.discard(pair)
        seconds = set(pair[1].leaves)
        if not all(seconds <= self._reached(leaf) for leaf in pair[0].leaves):
            self.kept.add(pair)

    def _reached(self, start: Piece) -> set[Piece]:
        """The leaves that come after one, by links that are kept and by way of leaves that are selected for sure."""
        waiting, reached = [start], set[Piece]()
        while waiting:
            for leaf, pair in self._behind.get(waiting.pop(), ()):
                if pair in self.kept and leaf not in reached:
                    reached.add(leaf)
                    waiting += [] if leaf in self._optional else [leaf]
        return reached
