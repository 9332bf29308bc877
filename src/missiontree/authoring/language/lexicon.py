"""General knowledge of words: verbs and what they ask for, hazards and who is called, small words that join, forbid or mean nothing."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import resources
from itertools import product
from typing import Any, Literal

from missiontree.authoring.language.kinds import kind_of
from missiontree.formats.reader import parse

Form = Literal["base", "gerund", "past", "third"]
Words = tuple[str, ...]
_VOWELS = "aeiou"


@dataclass(frozen=True, slots=True)
class Verb:
    """
    A verb as it stands in a text.

    Parameters
    ----------
    phrase
        Its base form: ``search for``.
    form
        The form it has in the text.
    length
        How many words it takes.
    """

    phrase: str
    form: Form
    length: int


class PhraseTable:
    """Phrases, found longest first at a place in a text. Looking up costs the same however many phrases there are."""

    def __init__(self, phrases: Mapping[Words, str]) -> None:
        self._meaning = phrases
        self._lengths: dict[str, tuple[int, ...]] = {}
        for phrase in phrases:
            lengths = {len(phrase), *self._lengths.get(phrase[0], ())}
            self._lengths[phrase[0]] = tuple(sorted(lengths, reverse=True))

    def at(self, words: Sequence[str], start: int) -> tuple[str, int] | None:
        """Meaning and length of the longest phrase that begins at a place; None if none does."""
        if start >= len(words):
            return None
        for length in self._lengths.get(words[start], ()):
            phrase = tuple(words[start : start + length])
            if len(phrase) == length and phrase in self._meaning:
                return self._meaning[phrase], length
        return None

    def within(self, words: Sequence[str]) -> list[tuple[str, int, int]]:
        """All phrases of a text, none overlapping: meaning, start, length."""
        found: list[tuple[str, int, int]] = []
        start = 0
        while start < len(words):
            if (hit := self.at(words, start)) is not None:
                found.append((hit[0], start, hit[1]))
                start += hit[1]
            else:
                start += 1
        return found


def phrases_of(file: str, name: str) -> tuple[tuple[str, ...], ...]:
    """
    A list of small words by file and name, each phrase as its words, longest first.

    ``{not}`` in a phrase stands for every entry of the list of that name.
    """
    lists = _data(file)
    made: list[tuple[str, ...]] = []
    for phrase in lists[name]:
        choices = [lists[part[1:-1]] if part.startswith("{") else [part] for part in phrase.split()]
        made += [tuple(" ".join(parts).split()) for parts in product(*choices)]
    return tuple(sorted(dict.fromkeys(made), key=lambda words: -len(words)))


def phrase_table(file: str, name: str) -> PhraseTable:
    """The same list as a table; the meaning is the phrase itself."""
    return PhraseTable({words: " ".join(words) for words in phrases_of(file, name)})


class Lexicon:
    """
    The words the offline author knows.

    Parameters
    ----------
    further_verbs
        Verbs of routines and methods beside those of the files.
    """

    def __init__(self, further_verbs: Iterable[str] = ()) -> None:
        verbs: dict[str, list[str]] = _data("verbs")["verbs"]
        self.past: dict[str, str] = _data("verbs")["past"]
        self.phrases_of: dict[str, tuple[str, ...]] = {goal: tuple(phrases) for goal, phrases in verbs.items()}
        self.goals_of: dict[str, tuple[str, ...]] = {}
        for goal, phrases in verbs.items():
            for phrase in phrases:
                self.goals_of[phrase] = (*self.goals_of.get(phrase, ()), goal)
        for phrase in further_verbs:
            self.goals_of.setdefault(phrase, ())
        self.small: dict[str, Any] = _data("words")
        self.idioms: dict[str, list[str]] = _data("idioms")["idioms"]
        self.hazards: dict[str, Any] = _data("hazards")["hazards"]

    @cached_property
    def _verbs(self) -> dict[Form, PhraseTable]:
        forms: dict[Form, dict[Words, str]] = {"base": {}, "gerund": {}, "past": {}, "third": {}}
        for phrase in self.goals_of:
            first, *rest = phrase.split()
            forms["base"][(first, *rest)] = phrase
            forms["gerund"][(gerund(first), *rest)] = phrase
            forms["third"][(third_person(first), *rest)] = phrase
            forms["past"][(self.past.get(first, regular_past(first)), *rest)] = phrase
        return {form: PhraseTable(phrases) for form, phrases in forms.items()}

    def verb_at(self, words: Sequence[str], start: int, *forms: Form) -> Verb | None:
        """The longest verb that begins at a place in one of the forms; None if none does, or if a noun stands there."""
        if _is_noun(words, start):
            return None
        for form in forms:
            if (hit := self._verbs[form].at(words, start)) is not None:
                return Verb(hit[0], form, hit[1])
        return None

    @cached_property
    def joins(self) -> PhraseTable:
        """What joins clauses, to the name of the relation."""
        return PhraseTable(
            {tuple(phrase.split()): name for name, phrases in self.small["joins"].items() for phrase in phrases}
        )

    def table(self, name: str) -> PhraseTable:
        """One list of small words as a table; the meaning is the phrase itself."""
        return PhraseTable({tuple(phrase.split()): phrase for phrase in self.small[name]})

    @cached_property
    def openings(self) -> PhraseTable:
        """What may stand before the verb."""
        return self.table("openings")

    @cached_property
    def passed_over(self) -> PhraseTable:
        """Manner and courtesy."""
        return self.table("passed_over")

    @cached_property
    def decisive(self) -> PhraseTable:
        """Words that change what is asked for."""
        return self.table("decisive")

    @cached_property
    def hazard_words(self) -> PhraseTable:
        """What may be wrong, to the name of the hazard."""
        return PhraseTable(
            {tuple(phrase.split()): name for name, hazard in self.hazards.items() for phrase in hazard["words"]}
        )

    def hazards_in(self, words: Sequence[str]) -> list[str]:
        """Names of the hazards that words speak of; a fire alarm is none."""
        found = self.hazard_words.within(words)
        return [name for name, at, length in found if not _is_part_of_a_name(words, at, length)]

    @cached_property
    def words(self) -> dict[str, frozenset[str]]:
        """Each list of single small words as a set."""
        return {name: frozenset(words) for name, words in self.small.items() if name not in {"joins", "format"}}


_NOUN_HAZARDS = frozenset(
    {
        "fire",
        "gas",
        "flood",
        "storm",
        "smoke",
        "bomb",
        "avalanche",
        "blaze",
        "wildfire",
        "earthquake",
        "radiation",
        "cliff",
    }
)


def _is_part_of_a_name(words: Sequence[str], at: int, length: int) -> bool:
    """Whether a hazard is the first part of a compound: "fire alarm", "avalanche museum", "flood of readers"."""
    following = words[at + length : at + length + 1]
    noun = length == 1 and words[at] in _NOUN_HAZARDS and bool(following)
    return noun and (following[0] == "of" or following[0] in {"alarm", "drill"} or kind_of(following[0]) is not None)


_AFTER_A_NUMBER = ((), ("to",), ("into",), (",",), ("and",))


def _is_noun(words: Sequence[str], at: int) -> bool:
    """Whether a noun stands there, as in "water is coming in" and "book 9 to Ben", but not in "book 9 seats"."""
    if at + 1 >= len(words) or kind_of(words[at]) is None:
        return False
    if words[at + 1] in {"is", "are", "was", "were"}:
        return True
    return words[at + 1].isdecimal() and tuple(words[at + 2 : at + 3]) in _AFTER_A_NUMBER


def gerund(verb: str) -> str:
    """The -ing form: find, finding; locate, locating; get, getting."""
    if verb.endswith("ie"):
        return verb[:-2] + "ying"
    if verb.endswith("e") and not verb.endswith(("ee", "oe", "ye")):
        return verb[:-1] + "ing"
    return verb + (verb[-1] if _doubles(verb) else "") + "ing"


def third_person(verb: str) -> str:
    """The form with he, she or it: find, finds; search, searches; carry, carries; go, goes."""
    if verb.endswith("y") and verb[-2:-1] not in _VOWELS:
        return verb[:-1] + "ies"
    return verb + ("es" if verb.endswith(("s", "sh", "ch", "x", "z", "o")) else "s")


def regular_past(verb: str) -> str:
    """The -ed form of a regular verb: rescue, rescued; carry, carried; stop, stopped."""
    if verb.endswith("e"):
        return verb + "d"
    if verb.endswith("y") and verb[-2:-1] not in _VOWELS:
        return verb[:-1] + "ied"
    return verb + (verb[-1] if _doubles(verb) else "") + "ed"


def _doubles(verb: str) -> bool:
    """Whether the last consonant is doubled: a short verb that ends consonant, vowel, consonant."""
    end = verb[-3:]
    short = sum(letter in _VOWELS for letter in verb) == 1
    return short and len(end) == 3 and end[0] not in _VOWELS and end[1] in _VOWELS and end[2] not in _VOWELS + "wxy"


@cache
def _data(name: str) -> dict[str, Any]:
    text = (resources.files("missiontree.authoring") / "language" / "words" / f"{name}.yaml").read_text(
        encoding="utf-8"
    )
    data: dict[str, Any] = parse(text, f"{name}.yaml").data
    return data
