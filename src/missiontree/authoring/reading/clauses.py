"""A mission text to its clauses: one goal each, joined by *and*, *then*, *before*, *while* ... In one pass over the words."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass, field, replace
from typing import Literal

from missiontree.authoring.language.lexicon import Lexicon, Verb

Relation = Literal["start", "and", "then", "meanwhile", "before", "after", "while", "until", "shares"]
MAX_WORDS = 1000
MAX_CLAUSE_WORDS = 60
MARK = "@"  # begins a word that stands for a robot; no word of a text does, since signs are words of their own
_TITLES = frozenset({"mr", "mrs", "ms", "dr", "prof"})
_WORD = re.compile(r"\w+(?:['\-.,:]\w+)*|\S")
_QUOTES = str.maketrans(
    {"’": "'", "‘": "'", "“": " ", "”": " ", '"': " ", "„": " ", "«": " ", "»": " ", "‐": "-", "‑": "-"}
)
_BLANK_BEFORE_SIGN = re.compile(r" (?=[,)])")
_STOPS = frozenset(".!?;:")
_AUXILIARIES = frozenset({"is", "are", "be", "gets", "been"})
_DOERS = frozenset({"you", "we", "they", "the robots", "the robot", "a robot", "robots"})
_MODALS = frozenset({"must", "should", "shall"})
_COORDINATE = frozenset({"and", "then", "meanwhile"})
_SUBORDINATE = frozenset({"before", "after", "while", "until"})


@dataclass(frozen=True, slots=True)
class Word:
    """A word as it is written, and in small letters."""

    text: str
    low: str


@dataclass(frozen=True, slots=True)
class Clause:
    """
    A part of the mission that asks for one thing.

    Parameters
    ----------
    words
        Its words from the verb on, or all of them if no verb is understood.
    verb
        The verb it begins with; None if none is understood.
    relation
        How it is joined to ``anchor``: itself *before*, *after*, *while* ... the other says so. ``shares``: it has no object of its
        own and takes that of the clause behind it.
    anchor
        Index of the clause it is joined to; None if to none.
    passed_over
        Words that change nothing, left out of ``words``.
    decisive
        Words that change what is asked for; if there are any, the clause is not understood.
    robots
        Robot types that are named to do it.
    leads
        Whether they are named before the verb.
    sentence
        Number of its sentence.
    """

    words: tuple[Word, ...]
    verb: Verb | None = None
    relation: Relation = "start"
    anchor: int | None = None
    passed_over: tuple[str, ...] = ()
    decisive: tuple[str, ...] = ()
    robots: tuple[str, ...] = ()
    leads: bool = False
    sentence: int = 0

    @property
    def text(self) -> str:
        """The words as they were written."""
        return _BLANK_BEFORE_SIGN.sub("", " ".join(word.text for word in self.words))


def words_of_text(text: str) -> tuple[Word, ...]:
    """The words and signs of a text; look-alike signs made alike, quotation marks left out."""
    plain = unicodedata.normalize("NFC", text).translate(_QUOTES)
    words = [Word(word, word.lower()) for word in _WORD.findall(plain)]
    return tuple(
        word for place, word in enumerate(words) if not (word.low == "." and place and words[place - 1].low in _TITLES)
    )


def clauses_of(words: tuple[Word, ...], lexicon: Lexicon) -> tuple[Clause, ...]:
    """The clauses of a text, in the order in which they are written."""
    return _Splitter(words, lexicon).split()


@dataclass
class _Splitter:
    """Walks over the words once. ``held`` are the words of the clause under way."""

    words: tuple[Word, ...]
    lexicon: Lexicon
    done: list[Clause] = field(default_factory=list)
    held: list[Word] = field(default_factory=list)
    relation: Relation = "start"
    anchor: int | None = None
    leading: bool = False  # the clause under way is subordinate and its main clause comes behind it
    main: int | None = None  # index of the last main clause
    pending: tuple[Relation, int | None] = ("start", None)  # how that main clause is joined to what stands before both
    sentence: int = 0

    def split(self) -> tuple[Clause, ...]:
        lows = [word.low for word in self.words]
        place = 0
        while place < len(lows):
            place += self._step(lows, place)
        self._close("start")
        if self.held:  # a robot that is told nothing
            self.done.append(Clause(words=tuple(Word(word.text, word.text.lower()) for word in self.held)))
        return tuple(self.done)

    def _step(self, lows: list[str], place: int) -> int:
        """Take what stands at a place; return how many words that was."""
        if lows[place] in _STOPS:
            self._close("start")
            self.sentence += 1
            return 1
        if (joined := self.lexicon.joins.at(lows, place)) is not None and self._joins(lows, place, *joined):
            return joined[1]
        if lows[place] in {"and", ","}:
            return self._comma_or_and(lows, place)
        self.held.append(self.words[place])
        return 1

    def _joins(self, lows: list[str], place: int, relation: str, length: int) -> bool:
        if relation == "first":
            return not self.held
        if relation == "then" and lows[place] == "next" and lows[place + 1 : place + 2] == ["to"]:
            return False
        if relation in {"then", "meanwhile"}:
            self._close("then" if relation == "then" else "meanwhile")
            return True
        self._subordinate(relation)  # type: ignore[arg-type]  # the four that are left
        return True

    def _subordinate(self, relation: Relation) -> None:
        if self.held:
            self._close(relation)
            self.anchor = self.main
        else:
            self.pending = (self.relation, self.anchor) if self.relation in _COORDINATE else ("start", None)
            self.relation, self.leading = relation, True

    def _comma_or_and(self, lows: list[str], place: int) -> int:
        behind = place + 1
        while behind < len(lows) and lows[behind] in {"and", ","}:
            behind += 1
        if (joined := self.lexicon.joins.at(lows, behind)) is not None and not self._is_first(lows, behind):
            if joined[0] in _SUBORDINATE and "and" in lows[place:behind] and not self.leading:
                self._close("and")  # "and when it is found, ..." belongs to what comes
            return behind - place
        if self.leading and lows[place] == "," and self.held:
            self._close("start")
            self.relation, self.anchor = self.pending
            return behind - place
        if self.held and self._one_verb(lows, place):
            self.held.append(self.words[place])
            return 1
        if self.held and self._verb_follows(lows, behind):
            spoken = _without_openings(self.held, self.lexicon)[0]
            alone = (verb := self._verb_of(self.held)) is not None and verb.length == len(spoken)
            self._close("and", shares=alone)
            return behind - place
        if self.held:
            self.held.extend(self.words[place:behind])
        return behind - place

    def _one_verb(self, lows: list[str], place: int) -> bool:
        """Whether the *and* stands inside one verb, as in "find and follow"."""
        verb = self._verb_of(self.held)
        if verb is None or not (len(self.held) >= verb.length) or lows[place] != "and":
            return False
        start = place - verb.length
        longer = self.lexicon.verb_at(lows, start, verb.form) if start >= 0 else None
        return longer is not None and longer.length > verb.length

    def _is_first(self, lows: list[str], place: int) -> bool:
        joined = self.lexicon.joins.at(lows, place)
        return joined is not None and joined[0] == "first"

    def _verb_follows(self, lows: list[str], place: int) -> bool:
        while (hit := self.lexicon.passed_over.at(lows, place)) is not None or _is_mark(lows, place):
            place += hit[1] if hit else 1
        if (hit := self.lexicon.openings.at(lows, place)) is not None:
            place += hit[1]
        gerunds = (verb := self._verb_of(self.held)) is not None and verb.form == "gerund"
        return self.lexicon.verb_at(lows, place, *(("gerund",) if gerunds else ("base",))) is not None

    def _verb_of(self, words: list[Word]) -> Verb | None:
        kept, _ = _without_openings(words, self.lexicon)
        return self.lexicon.verb_at([word.low for word in kept], 0, "base", "gerund")

    def _close(self, following: Relation, *, shares: bool = False) -> None:
        """End the clause under way; the next one is joined to it by ``following``."""
        if self.held and _says_something(self.held, self.lexicon):
            clause = _finished(tuple(self.held), self.lexicon, is_event=self.relation in _SUBORDINATE)
            index = len(self.done)
            anchor = index + 1 if self.leading or shares else self.anchor
            joined: Relation = "shares" if shares else self.relation
            self.done.append(replace(clause, relation=joined, anchor=anchor, sentence=self.sentence))
            if not self.leading and self.relation not in _SUBORDINATE:
                self.main = index
        elif following in {"start", "and"}:
            self.held = [word for word in self.held if _is_mark([word.low], 0)]
            return
        self.held = []
        inherits = (
            following == "and"
            and self.done
            and self._gerund(self.done[-1])
            and self.relation in _SUBORDINATE
            and not self.leading
        )
        if not inherits and not shares:
            self.relation, self.anchor = following, self.main if following in {"then", "and", "meanwhile"} else None
        self.leading = False

    @staticmethod
    def _gerund(clause: Clause) -> bool:
        return clause.verb is not None and clause.verb.form == "gerund"


def _says_something(words: list[Word], lexicon: Lexicon) -> bool:
    """Whether there is more than "hello" or "your mission is to"."""
    lows, place = [word.low for word in words], 0
    while place < len(lows):
        hit = lexicon.passed_over.at(lows, place) or lexicon.openings.at(lows, place)
        if hit is None and lows[place] != "," and not _is_mark(lows, place):
            return True
        place += hit[1] if hit else 1
    return False


def _is_mark(lows: list[str], place: int) -> bool:
    return place < len(lows) and lows[place].startswith(MARK) and len(lows[place]) > len(MARK)


def _finished(words: tuple[Word, ...], lexicon: Lexicon, *, is_event: bool) -> Clause:
    marks = [place for place, word in enumerate(words) if _is_mark([word.low], 0)]
    robots = tuple(dict.fromkeys(words[place].low.removeprefix(MARK) for place in marks))
    before, _ = _without_openings(list(words[: marks[0]]), lexicon) if marks else ([], ())
    leads = bool(marks) and lexicon.verb_at([word.low for word in before], 0, "base", "gerund") is None
    words = tuple(word for place, word in enumerate(words) if place not in marks)
    lows = [word.low for word in words]
    decisive = tuple(phrase for phrase, _, _ in lexicon.decisive.within(lows))
    kept, passed = _without_openings(list(words), lexicon)
    kept, more = _without_passed_over(kept, lexicon)
    while kept and kept[-1].low == ",":
        kept.pop()
    kept, _ = _without_openings(kept, lexicon)
    kept = _active(kept, lexicon, is_event=is_event)
    verb = lexicon.verb_at([word.low for word in kept], 0, "base", "gerund")
    over = (*passed, *more)
    return Clause(words=tuple(kept), verb=verb, passed_over=over, decisive=decisive, robots=robots, leads=leads)


def _without_openings(words: list[Word], lexicon: Lexicon) -> tuple[list[Word], tuple[str, ...]]:
    """The words behind "please", "the robots should" and the like, if a verb follows; else all of them, save marks."""
    words = [word for word in words if not _is_mark([word.low], 0)]
    lows, start, passed = [word.low for word in words], 0, []
    while start < len(lows):
        if (hit := lexicon.passed_over.at(lows, start)) is not None:
            passed.append(hit[0])
        elif (hit := lexicon.openings.at(lows, start)) is None and lows[start] == ",":
            hit = (",", 1)
        if hit is None:
            break
        start += hit[1]
    if lexicon.verb_at(lows, start, "base", "gerund") is not None:
        return words[start:], tuple(passed)
    return words, ()


def _without_passed_over(words: list[Word], lexicon: Lexicon) -> tuple[list[Word], tuple[str, ...]]:
    lows, kept, passed, place = [word.low for word in words], [], [], 0
    while place < len(words):
        if (hit := lexicon.passed_over.at(lows, place)) is not None:
            passed.append(hit[0])
            place += hit[1]
        else:
            kept.append(words[place])
            place += 1
    return kept, tuple(passed)


def _active(words: list[Word], lexicon: Lexicon, *, is_event: bool) -> list[Word]:
    """
    Turn "the forklift must be found" and "you have found the forklift" into "find the forklift"; other words stay as they are.

    "The forklift is found" asks for something only as an event that something else waits for; alone it is a statement.
    """
    lows = [word.low for word in words]
    if is_event and (place := next((at for at in (1, 2) if lows[at : at + 1] in (["have"], ["has"])), 0)):
        verb = lexicon.verb_at(lows, place + 1, "past")
        if verb is not None and " ".join(lows[:place]) in _DOERS:
            return [*(Word(part, part) for part in verb.phrase.split()), *words[place + 1 + verb.length :]]
    for place in range(1, min(len(lows), MAX_CLAUSE_WORDS)):
        if lows[place] not in _AUXILIARIES:
            continue
        behind = place + 1 + (lows[place + 1 : place + 2] == ["been"])
        asked = lows[place] == "be" and lows[place - 1] in _MODALS
        if (asked or is_event) and (verb := lexicon.verb_at(lows, behind, "past")) is not None:
            end = place - 1 if asked or lows[place - 1] in {"has", "have"} else place
            active = [Word(part, part) for part in verb.phrase.split()]
            return [*active, *words[:end], *words[behind + verb.length :]]
    return words
