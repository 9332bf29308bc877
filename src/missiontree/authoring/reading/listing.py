"""Lists of noun phrases: "the bed and the chair", "docks 1, 2 and 3", "the white and black van", "all but Anna and Bob"."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.language.lexicon import PhraseTable, phrases_of
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.plurals import is_plural, singular
from missiontree.authoring.reading.words import POSSESSIVES, Word

_QUALITIES = frozenset(word for (word,) in phrases_of("words", "qualities"))
_THE = {"the"} | POSSESSIVES


def is_letter(word: Word) -> bool:
    """Whether a word is a capital letter that tells things of one kind apart: "Block A"."""
    return len(word.text) == 1 and word.text.isupper()


def _numbered_alike(parts: Iterable[tuple[Word, ...]]) -> Iterator[tuple[Word, ...]]:
    """The parts in full: "docks 1, 2 and 3" are dock 1, dock 2 and dock 3."""
    before: tuple[Word, ...] = ()
    listed = list(parts)
    for place, part in enumerate(listed):
        made: tuple[Word, ...]
        following = listed[place + 1] if place + 1 < len(listed) else ()
        if len(part) == 2 and part[0].low in _THE and _is_short_for(part[1], following):
            several = is_plural(following[-1].low) or following[0].low in _THE
            # "The white and the black van" are two, "the white and black van" is one, or two: no name.
            made = (*part, following[-1]) if several else (*part, Word("and", "and"), *following)
        elif len(part) == 1 and _designates(part[0]) and len(before) > 1:
            made = (*before[:-1], part[0])
        elif len(following) == 1 and _designates(following[0]) and len(part) > 1 and _designates(part[-1]):
            noun = part[-2]
            made = (*part[:-2], Word(singular(noun.text), singular(noun.low)), part[-1])
        else:
            made = part
        before = made if made and _designates(made[-1]) else ()
        yield made


def _says_which(word: Word) -> bool:
    return kind_of(word.low) is None and word.text.islower() and word.text.isalpha()


def _is_short_for(word: Word, following: Sequence[Word]) -> bool:
    """Whether a word says which of the kind that the following phrase names, and is no noun that nobody knows."""
    if len(following) < 2 or not _says_which(word):
        return False
    return following[0].low not in _THE or {word.low, following[1].low} <= _QUALITIES


def _designates(word: Word) -> bool:
    return word.text.isdecimal() or is_letter(word)


def all_but_these(phrases: tuple[Phrase, ...]) -> tuple[Phrase, ...]:
    """In "all people except Anna and Bob", Bob is left out as well."""
    for place, phrase in enumerate(phrases[:-1]):
        if phrase.without:
            return (*phrases[:place], replace(phrase, without=(*phrase.without, *phrases[place + 1 :])))
    return phrases


def _split(words: Sequence[Word], names: PhraseTable) -> Iterator[tuple[Word, ...]]:
    """Split at commas and *and*, save those of a name and that of "between the hall and the yard"."""
    part: list[Word] = []
    lows_all = [word.low for word in words]
    inside = 0
    for place, word in enumerate(words):
        lows = [held.low for held in part]
        inside = max(inside, place + hit[1] if (hit := names.at(lows_all, place)) is not None else 0)
        if place < inside or (word.low == "and" and "between" in lows and "and" not in lows):
            part.append(word)
        elif word.low in {"and", ",", "&"}:
            if part:
                yield tuple(part)
            part = []
        else:
            part.append(word)
    yield tuple(part)


def parts_of(words: Sequence[Word], names: PhraseTable) -> Iterator[tuple[Word, ...]]:
    """The words of each phrase of a list; ``names`` are those that hold an *and* themselves."""
    return _numbered_alike(_split(words, names))
