"""
Job shops in the classic form of Fisher and Thompson, Lawrence and others (OR-Library), told apart from flexible ones.

A line per job: machine and time in turn, in the order of its operations, every machine once. Nothing says how many operations there are.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

MOST_DIGITS = 18
"""Of a number; with more it is refused."""


def is_classic(rows: Sequence[Sequence[str]], machines: int) -> bool:
    """Whether more lines of jobs are of the classic form than can be read as those of a flexible job shop."""
    flexible = sum(_is_flexible(row) for row in rows)
    return flexible < len(rows) and sum(fault_of(row, machines) == "" for row in rows) > flexible


def fault_of(row: Sequence[str], machines: int) -> str:
    """What is wrong with a line of the classic form; nothing if nothing is."""
    wrong = next((word for word in row if not _is_number(word)), None)
    if wrong is not None:
        return f"{wrong[:40]!r} is {'too large' if wrong.isdecimal() else 'not a whole number'}"
    if len(row) != 2 * machines:
        return f"{len(row)} numbers for {machines} machines"
    named = [int(word) for word in row[::2]]
    if len(set(named)) < len(named):
        return f"machine {Counter(named).most_common(1)[0][0]} is named twice"
    first = 0 if 0 in named else 1
    unknown = next((machine for machine in named if not first <= machine < first + machines), None)
    return "" if unknown is None else f"machine {unknown}, and there are {machines}"


def _is_flexible(row: Sequence[str]) -> bool:
    """Whether a line ends where the numbers of operations and of able machines in it say."""
    if not all(map(_is_number, row)):
        return False
    numbers, place = [*map(int, row)], 1
    for _ in range(min(numbers[0], len(numbers))):
        if place >= len(numbers) or not numbers[place]:
            return False
        place += 1 + 2 * numbers[place]
    return numbers[0] > 0 and place == len(numbers)


def _is_number(word: str) -> bool:
    return word.isdecimal() and len(word) <= MOST_DIGITS


def as_flexible(row: Sequence[str]) -> list[str]:
    """A sound line of the classic form as one of a flexible job shop, with one able machine for each operation."""
    line = [str(len(row) // 2)]
    for machine, time in zip(row[::2], row[1::2], strict=True):
        line += ["1", machine, time]
    return line
