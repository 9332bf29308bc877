"""How many are meant: "both dogs", "the three crates", "each of the beds", "all patients", "the other one"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.reading.words import POSSESSIVES, Word

MAX_COUNT = 20
_IN_WORDS = (
    *("two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"),
    *("thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty"),
)
NUMBERS: Mapping[str, int] = MappingProxyType({word: number for number, word in enumerate(_IN_WORDS, start=2)})
ORDINALS: Mapping[str, int] = MappingProxyType({"first": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5})
_DETERMINERS = {"the", "these", "those"} | POSSESSIVES
_VAGUE = frozenset({"some", "any"})


@dataclass(frozen=True, slots=True)
class Quantity:
    """
    What stands before a noun and says how many.

    Parameters
    ----------
    length
        How many words it takes, its determiner included; 0 if there is none.
    determined
        Whether a determiner is among them.
    every
        Whether all there are, are meant.
    count
        How many; None if that is not said.
    other
        Whether those not named so far are meant.
    ordinal
        Which of a number, from 1; None if that is not said.
    """

    length: int = 0
    determined: bool = False
    every: bool = False
    count: int | None = None
    other: bool = False
    ordinal: int | None = None


def quantity_of(words: Sequence[Word]) -> Quantity:
    """How many, going by the first words of a noun phrase."""
    lows = [word.low for word in words]
    place, every, determined, count = 0, False, False, None
    first = lows[0] if lows else ""
    if first in {"all", "every", "each", "both"}:
        place, every = 1, True
        count = 2 if first == "both" else None
        if lows[1:2] == ["single"] and first in {"every", "each"}:
            place = 2
        place += lows[place : place + 1] == ["of"]
        determined = True
    elif first in _VAGUE and lows[1:2] not in (["of"], ["other"], ["more"]):
        return Quantity(1) if len(lows) > 1 else Quantity()
    if lows[place : place + 1] and lows[place] in _DETERMINERS:
        place, determined = place + 1, True
    other = lows[place : place + 1] == ["other"]
    place += other
    number = number_of(lows[place]) if place < len(lows) - 1 else None
    if number is not None and not lows[place + 1][0].isdigit():
        place, count = place + 1, number
        other = other or lows[place : place + 1] == ["other"]
        place += lows[place : place + 1] == ["other"] and place < len(lows) - 1
    elif determined and not every and place < len(lows) and (ordinal := _ordinal(lows, place)):
        return Quantity(place + 1, determined=True, ordinal=ordinal, other=False)
    if place >= len(lows) or not (every or count or other):
        return Quantity()
    return Quantity(place, determined or count is not None, every, count, other)


def number_of(word: str) -> int | None:
    """The number that a word says, from 2 to 20; None if it says none."""
    if word.isdecimal() and word.isascii():
        return int(word) if len(word) <= 2 and 2 <= int(word) <= MAX_COUNT else None
    return NUMBERS.get(word)


def _ordinal(lows: Sequence[str], place: int) -> int | None:
    """Which one; not in "the first aid kit", where it belongs to the name."""
    named = any(
        kind_of(" ".join(lows[place:end])) is not None
        for end in range(place + 2, min(len(lows), place + 4) + 1)
        if end - place > 2
    )
    return None if named or place + 1 >= len(lows) else ORDINALS.get(lows[place])
