"""Which words of a clause name whom: what becomes the slots of a method that is learned from it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.matching import words_of
from missiontree.authoring.methods.mention import Mention, UnclearError, title
from missiontree.authoring.methods.method import RESPONDER
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.entities import Speakers
from missiontree.authoring.reading.phrase import Phrase, kind_of_phrase
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.places import plain, spellings
from missiontree.authoring.reading.words import Word
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene

HAZARD = "hazard"
_WHERE_TO = frozenset({"to", "into", "onto", "toward", "towards"})
_JOINING = frozenset({"from", "to", "into", "onto", "for", "against"})
Weigh = Callable[[Sequence["Named"]], tuple[int, ...]]


@dataclass(frozen=True, slots=True)
class Named:
    """
    Somebody or something that a clause names.

    Parameters
    ----------
    start, end
        Its words: from one index up to another.
    mention
        Who is meant.
    kind
        Its base kind, or ``hazard``.
    used
        Whether the tree speaks of it.
    slot
        Name of the slot that stands for it.
    others
        Who stands with it in a list, in the same slot.
    """

    start: int
    end: int
    mention: Mention
    kind: str
    used: bool
    slot: str = ""
    others: tuple[Mention, ...] = ()

    @property
    def mentions(self) -> tuple[Mention, ...]:
        """All who are meant."""
        return (self.mention, *self.others)

    @property
    def conditions(self) -> tuple[str, ...]:
        """What a method asks of the slot: lost, if the words say so, or else the kinds."""
        if self.kind != HAZARD and any(mention.lost for mention in self.mentions):
            return ("lost",)
        return tuple(dict.fromkeys((self.kind, *(mention.kind for mention in self.others))))


@dataclass(frozen=True)
class Spotter:
    """
    Finds who is named in a clause.

    Parameters
    ----------
    scene
        The world, without those whom the tree introduces.
    complete
        Whether somebody wrote down what the world has.
    used
        Ids of those whom the tree speaks of.
    names
        What they are called, as words.
    introduced
        Those whom the tree introduces.
    phrases, lexicon
        How words are read.
    """

    scene: Scene
    complete: bool
    used: frozenset[str]
    names: tuple[tuple[str, ...], ...]
    introduced: tuple[Entity, ...]
    phrases: PhraseReader
    lexicon: Lexicon

    def readings(self, clause: Clause) -> Iterator[tuple[Named, ...]]:
        """Ways to see who is named, the most general first: none of them misses anybody whom the tree speaks of and another finds."""
        start = clause.verb.length if clause.verb is not None else 1
        every = list(self._all(clause.words, start))
        seen: list[tuple[Named, ...]] = []
        lows = [word.low for word in clause.words]
        for weigh in (partial(_joined, lows), _words_covered, _number):
            best = _best(every, len(clause.words), weigh)
            seen += [best] if best not in seen else []
        only = _best([named for named in every if named.used], len(clause.words), _words_covered)
        seen += [only] if only not in seen else []
        for reading in seen:
            yield with_slots(reading)

    def several(self, clause: Clause) -> str:
        """A phrase that names several by one noun, by their number or those whom the tree speaks of; empty if there is none."""
        for start, end, phrase in self._phrases(clause.words, clause.verb.length if clause.verb is not None else 0):
            met = self._met(phrase)
            if phrase.count is not None or (len(met) > 1 and self.used & {mention.name for mention in met}):
                return " ".join(word.text for word in clause.words[start:end])
        return ""

    def lost(self, clauses: Iterable[Clause]) -> frozenset[str]:
        """Names of those whom clauses call lost."""
        return frozenset(
            mention.name
            for clause in clauses
            for _, _, phrase in self._phrases(clause.words, 0)
            for mention in self._met(phrase)
            if mention.lost
        )

    def hazards(self, words: Sequence[str]) -> list[str]:
        """The hazards that words name."""
        return [hazard for hazard, _, _ in self.lexicon.hazard_words.within([word.lower() for word in words])]

    def _all(self, words: Sequence[Word], first: int) -> Iterator[Named]:
        for start, end, phrase in self._phrases(words, first):
            met = self._met(phrase)
            if len(met) != 1:
                continue
            used = met[0].name in self.used or self._is_in_a_name(met[0])
            if not used and (self._is_destination(words, start) or not self._is_common(phrase)):
                continue
            hazard = not used and self._is_hazard(phrase)
            yield Named(start, end, met[0], HAZARD if hazard else met[0].kind, used)

    def _is_destination(self, words: Sequence[Word], start: int) -> bool:
        """Whether a phrase says where to: a tree that makes no use of it goes elsewhere, as "to safety" does, and not wherever is said."""
        before = [word.low for word in words[:start] if word.low not in self.lexicon.words["determiners"]]
        return before[-1:] != [] and before[-1] in _WHERE_TO

    def _phrases(self, words: Sequence[Word], first: int) -> Iterator[tuple[int, int, Phrase]]:
        """All that may be one phrase, with its first word and the one behind it; the longest from each word first."""
        for start in range(first, len(words)):
            for end in range(len(words), start, -1):
                if (phrase := self._phrase(words[start:end])) is not None:
                    yield start, end, phrase

    def _is_in_a_name(self, mention: Mention) -> bool:
        """Whether somebody whom the tree speaks of is called after this one: the people of the school."""
        words = words_of(mention.label)
        return any(
            name[start : start + len(words)] == words
            for name in self.names
            for start in range(len(name) - len(words) + 1)
        )

    def _phrase(self, words: Sequence[Word]) -> Phrase | None:
        read = self.phrases.phrases(words)
        return read[0] if read is not None and len(read) == 1 and not read[0].pronoun else None

    def _met(self, phrase: Phrase) -> tuple[Mention, ...]:
        """Who is meant; of those whom the tree introduces, only who is called just so."""
        for entity in self.introduced:
            if spellings(entity) & {plain(phrase.name), plain(phrase.full)}:
                kind = self.scene.base_kind(entity.kind)
                lost = phrase.lost
                return (Mention(entity.id, title(phrase.name), title(phrase.full), kind, phrase.determined, lost=lost),)
        try:
            return Speakers(self.scene, complete=self.complete).resolve(phrase)
        except UnclearError:
            return ()

    def _is_common(self, phrase: Phrase) -> bool:
        """Whether a phrase that the tree does not speak of may be anything of its kind, and is no word of the pattern's own."""
        known = phrase.name.lower() in self.phrases.known or kind_of(phrase.name) is not None
        return known or (phrase.determined and kind_of_phrase(phrase) is not None) or self._is_hazard(phrase)

    def _is_hazard(self, phrase: Phrase) -> bool:
        head = phrase.name.lower().split(" of ")[0].split()
        return any(start + length == len(head) for _, start, length in self.lexicon.hazard_words.within(head))


def with_slots(named: Sequence[Named]) -> tuple[Named, ...]:
    """Those named with slots: by kind, the second of a kind with a number."""
    count: dict[str, int] = {}
    made: list[Named] = []
    for one in named:
        count[one.kind] = count.get(one.kind, 0) + 1
        made.append(replace(one, slot=one.kind if count[one.kind] == 1 else f"{one.kind}_{count[one.kind]}"))
    return tuple(made)


def slot_name(label: str, taken: Mapping[str, object] | Sequence[str] = ()) -> str:
    """A label as the name of a slot: ``safe_area``."""
    words = re.findall("[a-z0-9]+", label.lower())
    while words and not words[0][0].isalpha():
        words.pop(0)
    base = "_".join(words)[:40].rstrip("_") or "thing"
    number, made = 1, base
    while made in taken or made == RESPONDER:
        number += 1
        made = f"{base}_{number}"
    return made


def _joined(lows: Sequence[str], named: Sequence[Named]) -> tuple[int, ...]:
    """How many are joined by one word: "Anna from the barn" are two, "the man with the dog" is one."""
    joined = [lows[two.start - 1] in _JOINING for one, two in pairwise(named) if two.start - one.end == 1]
    return (sum(joined), *_words_covered(named))


def _words_covered(named: Sequence[Named]) -> tuple[int, ...]:
    return sum(one.end - one.start for one in named), -len(named)


def _number(named: Sequence[Named]) -> tuple[int, ...]:
    return len(named), sum(one.end - one.start for one in named)


def _best(every: Sequence[Named], length: int, weigh: Weigh) -> tuple[Named, ...]:
    """Of all choices that do not overlap: one that names as many of the tree's as can be, then the one that weighs most."""

    def worth(chosen: Sequence[Named]) -> tuple[int, ...]:
        return (len({one.mention.name for one in chosen if one.used}), *weigh(chosen))

    upto: list[tuple[Named, ...]] = [()]
    for end in range(1, length + 1):
        best = upto[end - 1]
        for named in (one for one in every if one.end == end):
            other = (*upto[max(named.start - 1, 0)], named)  # between two slots stands a word
            if worth(other) > worth(best):
                best = other
        upto.append(best)
    return upto[-1]
