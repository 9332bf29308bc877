"""
Job shops in the classic form of Fisher and Thompson, Lawrence and others (OR-Library), told apart from flexible ones.

A line per job: machine and time in turn, in the order of its operations, every machine once. Nothing says how many operations there are.
"""

from __future__ import annotations

from collections.abc import Sequence


def is_classic(rows: Sequence[Sequence[str]], machines: int) -> bool:
    """Whether all lines of jobs are of the classic form, and not all of them can be read as those of a flexible job shop."""
    pairs = [row for row in rows if len(row) == 2 * machines and all(word.isdecimal() for word in row)]
    if not rows or len(pairs) < len(rows):
        return False
    first = min(int(word) for row in rows for word in row[::2])
    own = set(range(first, first + machines))
    every = first in {0, 1} and all({int(word) for word in row[::2]} == own for row in rows)
    return every and not all(_may_be_flexible([*map(int, row)]) for row in rows)


def _may_be_flexible(row: Sequence[int]) -> bool:
    """Whether a line ends where the numbers of operations and of able machines in it say."""
    place = 1
    for _ in range(row[0]):
        if place >= len(row) or not row[place]:
            return False
        place += 1 + 2 * row[place]
    return row[0] > 0 and place == len(row)


def as_flexible(row: Sequence[str]) -> list[str]:
    """A line of the classic form as one of a flexible job shop, with one able machine for each operation."""
    line = [str(len(row) // 2)]
    for machine, time in zip(row[::2], row[1::2], strict=True):
        line += ["1", machine, time]
    return line
