"""
One clause that says several: a choice ("to the lobby or the kitchen"), or one verb for two ("Anna to the lobby and Bob to the lab").

Each function only cuts words; whether what comes out means something is for the reader of goals to say.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.reading.places import is_designation
from missiontree.authoring.reading.wording import PREPOSITIONS, TO
from missiontree.authoring.reading.words import DETERMINERS, Word

MAX_OPTIONS = 6
_TO = frozenset(TO.split("|"))


@dataclass(frozen=True, slots=True)
class Cut:
    """
    A way of reading a choice.

    Parameters
    ----------
    variants
        The clause once for each option, with all words that the options share.
    options
        The words that differ.
    whole
        Whether the options are all that stands behind the verb.
    """

    variants: tuple[tuple[Word, ...], ...]
    options: tuple[tuple[Word, ...], ...]
    whole: bool = False


def has_choice(words: Sequence[Word]) -> bool:
    """Whether an *or* stands in the words."""
    return any(word.low == "or" for word in words)


def choices(words: tuple[Word, ...], verb_length: int) -> Iterator[Cut]:
    """The ways of reading the first choice of a clause, the nearest option first; none if there is no *or*."""
    lows = [word.low for word in words]
    if "or" not in lows[verb_length:]:
        return
    place = lows.index("or", verb_length)
    either = [at for at in range(verb_length, place) if lows[at] == "either"]
    words = tuple(word for at, word in enumerate(words) if at not in either)
    lows = [word.low for word in words]
    place = lows.index("or", verb_length)
    starts = [either[-1]] if either else range(place - 1, verb_length - 1, -1)
    for start in starts:
        if either or (_begins(lows, start, verb_length) and not _within_list(lows, start, verb_length)):
            yield from _cuts(words, start, place, verb_length, either=bool(either))


def _cuts(words: tuple[Word, ...], start: int, place: int, verb_length: int, *, either: bool) -> Iterator[Cut]:
    lows = [word.low for word in words]
    left = _split(words[start:place])
    for end in range(len(words), place + 1, -1):
        if end < len(words) and not (lows[end] in PREPOSITIONS or _adjectives(left, words[place + 1 : end])):
            continue
        if any(word.low == "," for word in words[place + 1 : end]):
            continue  # "this or that, these or those" may mean either of two things
        right = _split(words[place + 1 : end], also_or=True)
        options = (*left, *right)
        if not either and any(word.low == "and" for option in options for word in option):
            continue  # "this and that or those" may mean either of two things
        if not all(options) or len(options) > MAX_OPTIONS or not _parallel(left, right):
            continue
        options = tuple(_with_head(_with_noun(option, left[0]), right[-1]) for option in options)
        options = tuple(_with_noun_of(option, options[0]) for option in options)
        variants = tuple((*words[:start], *option, *words[end:]) for option in options)
        yield Cut(variants, options, whole=start == verb_length and end == len(words))


def gaps(words: tuple[Word, ...], verb_length: int) -> Iterator[tuple[tuple[Word, ...], tuple[Word, ...]]]:
    """The ways of reading a clause as two with one verb, the shortest first one first."""
    for place in range(verb_length + 1, len(words) - 1):
        if words[place].low in {"and", ","} and words[place + 1].low not in {"and", ","}:
            yield words[:place], (*words[:verb_length], *words[place + 1 :])


def _begins(lows: Sequence[str], start: int, verb_length: int) -> bool:
    """Whether an option may begin there: behind the verb, a preposition, an article, a comma."""
    before = lows[start - 1]
    return start == verb_length or lows[start] in PREPOSITIONS or before in PREPOSITIONS or before in DETERMINERS


def _within_list(lows: Sequence[str], start: int, verb_length: int) -> bool:
    """Whether an option stands behind an *and* of its own list: "this and that or those" may mean either of two things."""
    begin = max((at + 1 for at in range(verb_length, start) if lows[at] in PREPOSITIONS), default=verb_length)
    return "and" in lows[begin:start]


def _split(words: tuple[Word, ...], *, also_or: bool = False) -> list[tuple[Word, ...]]:
    """The options that commas separate."""
    parts: list[list[Word]] = [[]]
    for word in words:
        if word.low == "," or (also_or and word.low == "or"):
            parts.append([])
        else:
            parts[-1].append(word)
    return [tuple(part) for part in parts if part]


def _parallel(left: Sequence[tuple[Word, ...]], right: Sequence[tuple[Word, ...]]) -> bool:
    """Whether options are of one form: each with the same preposition, or each without, and articles alike."""
    options = [*left, *right]
    heads = {_family(option[0].low) for option in options}
    return len(heads) == 1


def _family(low: str) -> str:
    return "to" if low in _TO else low if low in PREPOSITIONS else ""


def _adjectives(left: Sequence[tuple[Word, ...]], right: Sequence[Word]) -> bool:
    """Whether the options are single words that say which: "the red or blue box"."""
    options = [*left, tuple(right)]
    return all(len(option) == 1 and _says_which(option[0]) for option in options)


def _says_which(word: Word) -> bool:
    return word.text.isalpha() and word.text.islower() and kind_of(word.low) is None and word.low not in DETERMINERS


def _with_noun_of(option: tuple[Word, ...], first: tuple[Word, ...]) -> tuple[Word, ...]:
    """The option in full: "the bronze one" behind "the marble bust or" is "the bronze bust"."""
    ones = len(option) > 1 and option[-1].low in {"one", "ones"} and option is not first
    return (*option[:-1], first[-1]) if ones and not is_designation(first[-1].low) else option


def _with_head(option: tuple[Word, ...], last: tuple[Word, ...]) -> tuple[Word, ...]:
    """The option in full: "the red" before "or the yellow generator" is "the red generator"."""
    bare = len(option) == 1 and len(last) > 1 and last[0].low not in DETERMINERS and kind_of(last[0].low) is None
    if bare and kind_of(option[0].low) is None and option[0].text.islower() and last[0].text.islower():
        return (*option, *last[1:])
    says_which = len(option) == 2 and option[0].low in DETERMINERS and kind_of(option[1].low) is None
    if not says_which or option[1].text[:1].isupper() or len(last) < 3 or last[0].low not in DETERMINERS:
        return option
    return (*option, *last[2:])


def _with_noun(option: tuple[Word, ...], first: tuple[Word, ...]) -> tuple[Word, ...]:
    """The option in full: "13" behind "room 12 or" is "room 13"."""
    alone = len(option) == 1 and is_designation(option[0].low)
    return (*first[:-1], *option) if alone and len(first) > 1 and is_designation(first[-1].low) else option
