"""How much room words take: widths without a font at hand, and lines of bounded width."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import islice, pairwise
from math import inf

NARROWEST = 0.4
"""Width of the narrowest letters, in font sizes."""
_WIDTHS = {
    **dict.fromkeys("ijl.,:;'|!I() []f-`\"/\\t", NARROWEST),
    **dict.fromkeys("rsczJ", 0.52),
    **dict.fromkeys("mwMW%@&", 0.98),
}
_LOWER, _UPPER, _WIDE = 0.62, 0.74, 1.0
ELLIPSIS = "…"
_BREAKS = "(,-_/"
_STOPS = (",", ".", ";", ":", "(")
_FOR_NUMBERS, _FOR_STOPS = 0.3, 0.2


def text_width(text: str, size: float) -> float:
    """
    Width of a line of text in a sans-serif font, rather too much than too little.

    Parameters
    ----------
    text
        One line.
    size
        Font size; the width is in the same unit.
    """
    return sum(map(_character_width, text)) * size


@lru_cache(maxsize=4096)
def _character_width(character: str) -> float:
    if (width := _WIDTHS.get(character)) is not None:
        return width
    if unicodedata.combining(character):
        return 0.0
    if unicodedata.east_asian_width(character) in "FW":
        return _WIDE
    return _UPPER if character.isupper() else _LOWER


def wrapped(text: str, size: float, width: float, most_lines: int) -> list[str]:
    """
    Lines no wider than asked for, broken at blanks; words wider than a line are broken within.

    Parameters
    ----------
    text
        One line of words.
    size
        Font size.
    width
        Room for a line, at least some characters wide.
    most_lines
        If more lines are needed, the last one ends in an ellipsis.
    """
    lines = list(islice(_lines(text, size, width), most_lines + 1))
    if len(lines) <= most_lines:
        return lines
    last = lines[most_lines - 1]
    while last and text_width(last + ELLIPSIS, size) > width:
        last = last[:-1]
    return [*lines[: most_lines - 1], last + ELLIPSIS]


def balanced(text: str, size: float, width: float, most_lines: int) -> list[str]:
    """
    The lines of :func:`wrapped`, no more of them, about equally long: no word is left alone needlessly.

    Breaks after a comma, a stop or a bracket are preferred to others, and those before a number avoided: ``berth 3`` stays together.

    Parameters
    ----------
    text, size, width, most_lines
        As there. Lines of which some are left out stay as they are.
    """
    lines = wrapped(text, size, width, most_lines)
    words = [piece for word in text.split() for piece in _pieces(word, size, width)]
    if len(lines) < 2 or " ".join(words) != " ".join(lines):
        return lines
    widths = [text_width(word, size) for word in words]
    blank = text_width(" ", size)
    best: list[tuple[float, list[int]]] = [(0.0, [0])] + [(inf, [])] * len(words)
    for _ in lines:  # the best ways to write the first so many words on one line more
        longer: list[tuple[float, list[int]]] = [(inf, [])] * len(best)
        for start, (ragged, breaks) in enumerate(best[:-1]):
            taken = -blank
            for end in range(start + 1, len(best) if ragged < inf else 0):
                taken += blank + widths[end - 1]
                if taken > width and end > start + 1:
                    break
                cost = ragged + taken * taken + _reluctance(words, end) * width * width
                longer[end] = min(longer[end], (cost, [*breaks, end]))
        best = longer
    ragged, breaks = best[-1]
    if ragged == inf:
        return lines
    return [" ".join(words[start:end]) for start, end in pairwise(breaks)]


def _reluctance(words: Sequence[str], end: int) -> float:
    """How little a line likes to end before a word, in squares of its room."""
    if end == len(words):
        return 0.0
    return _FOR_NUMBERS * words[end][0].isdigit() - _FOR_STOPS * words[end - 1].endswith(_STOPS)


def _lines(text: str, size: float, width: float) -> Iterator[str]:
    line = ""
    for piece in (piece for word in text.split() for piece in _pieces(word, size, width)):
        longer = f"{line} {piece}" if line else piece
        if line and text_width(longer, size) > width:
            yield line
            line = piece
        else:
            line = longer
    yield line


def _pieces(word: str, size: float, width: float) -> Iterator[str]:
    """A word, cut where it is wider than a line: after a bracket or a stroke if there is one, else anywhere."""
    piece, room = "", width
    for character in word:
        taken = _character_width(character) * size
        while piece and taken > room:  # what stays after a cut may be too much still
            cut = max(piece.rfind(mark) for mark in _BREAKS) + 1 or len(piece)
            yield piece[:cut]
            piece = piece[cut:]
            room = width - text_width(piece, size)
        piece, room = piece + character, room - taken
    yield piece
