"""A mission text to its clauses: one goal each, joined by *and*, *then*, *before*, *while* ... In one pass over the words."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass, field, replace
from typing import Literal

from missiontree.authoring.language.lexicon import Lexicon, Verb, phrases_of

Relation = Literal["start", "and", "then", "earlier", "meanwhile", "before", "after", "while", "until", "shares", "or"]
MAX_WORDS = 1000
MAX_CLAUSE_WORDS = 60
MAX_SUBJECT_WORDS = 10
MARK = "@"  # begins a word that stands for a robot; no word of a text does, since signs are words of their own
_TITLES = frozenset({"mr", "mrs", "ms", "dr", "prof"})
_WORD = re.compile(r"\w+(?:['\-.,:]\w+)*|\S")
_QUOTES = str.maketrans(
    {"’": "'", "‘": "'", "“": " ", "”": " ", '"': " ", "„": " ", "«": " ", "»": " ", "‐": "-", "‑": "-"}
)
_BLANK_BEFORE_SIGN = re.compile(r" (?=[,)])")
STOPS = frozenset(".!?;:")
_AUXILIARIES = frozenset({"is", "are", "be", "gets", "been"})
_ANDS = (("as", "well", "as"), ("along", "with"), ("together", "with"))
_CALLS = frozenset(
    {
        "hurry",
        "quick",
        "quickly",
        "help",
        "look",
        "listen",
        "attention",
        "emergency",
        "alarm",
        "alert",
        "team",
        "robots",
        "everybody",
        "folks",
    }
)
_GO = frozenset(
    {
        "go",
        "come",
        "drive",
        "walk",
        "head",
        "return",
        "travel",
        "fly",
        "going",
        "driving",
        "walking",
        "heading",
        "returning",
    }
)
_ALONE = frozenset({"home", "there"})
_MUST = frozenset({"has", "have", "needs", "need", "is", "are", "ought"})
_DOERS = frozenset({"you", "we", "they", "the robots", "the robot", "a robot", "robots"})
_DOING = tuple(
    tuple(who.split())
    for who in ("you are", "we are", "they are", "the robots are", "robots are", "a robot is", "the robot is")
)
_MODALS = frozenset({"must", "should", "shall", "to"})
_CAUSES = phrases_of("statements", "causes")
_TO_BE: frozenset[str] = frozenset({"a", "an", "the"})
_IN_ORDER = phrases_of("statements", "in_order")
_DASH = re.compile(r"\s[-\u2013\u2014]+\s|\u2014")
_COORDINATE = frozenset({"and", "then", "meanwhile"})
_TO_MAIN = frozenset({"then", "and", "meanwhile", "earlier", "or"})
_OBJECTS = frozenset(
    {
        "the",
        "a",
        "an",
        "my",
        "your",
        "his",
        "her",
        "its",
        "our",
        "their",
        "it",
        "him",
        "them",
        "all",
        "both",
        "every",
        "each",
        "this",
        "that",
    }
)
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
        How it is joined to ``anchor``: itself *before*, *after*, *while* ... the other says so. ``earlier``: it ends before the other
        starts. ``or``: one of the two is done. ``shares``: it has no object of its own and takes that of the clause behind it.
    anchor
        Index of the clause it is joined to; None if to none.
    passed_over
        Words that change nothing, left out of ``words``.
    decisive
        Words that change what is asked for; if there are any, the clause is not understood.
    asked
        Robot types that are named to do it, once for each naming; any of one naming may.
    without
        Robot types that are left out.
    leads
        Whether those asked are named before the verb.
    either
        Whether a choice begins here that ends with the clause joined by *or*.
    in_order
        Whether what it asks for is to be done in the order in which it is named.
    pause
        Whether a comma stands before the *and* that joins it.
    sentence
        Number of its sentence.
    """

    words: tuple[Word, ...]
    verb: Verb | None = None
    relation: Relation = "start"
    anchor: int | None = None
    passed_over: tuple[str, ...] = ()
    decisive: tuple[str, ...] = ()
    asked: tuple[tuple[str, ...], ...] = ()
    without: tuple[str, ...] = ()
    leads: bool = False
    either: bool = False
    in_order: bool = False
    pause: bool = False
    sentence: int = 0

    @property
    def robots(self) -> tuple[str, ...]:
        """Robot types that may do it, going by what is asked for; none means any."""
        return self.asked[0] if self.asked else ()

    @property
    def text(self) -> str:
        """The words as they were written."""
        return _BLANK_BEFORE_SIGN.sub("", " ".join(word.text for word in self.words if word.text))


def words_of_text(text: str) -> tuple[Word, ...]:
    """The words and signs of a text; look-alike signs made alike, quotation marks left out."""
    plain = _DASH.sub(" , ", unicodedata.normalize("NFC", text).translate(_QUOTES))
    words = [Word(word, word.lower()) for word in _WORD.findall(plain)]
    words = _joined_up(words)
    for place in range(len(words) - 1, 0, -1):  # "go home" as "go to home"
        if words[place].low in _ALONE and words[place].text.islower() and words[place - 1].low in _GO:
            words.insert(place, Word("", "to"))
    return tuple(
        word
        for place, word in enumerate(words)
        if not (word.low == "." and place and words[place - 1].low in _TITLES) and not _needless(words, place)
    )


def _joined_up(words: list[Word]) -> list[Word]:
    """The words with "as well as", "along with" and "together with" as "and"."""
    made: list[Word] = []
    place = 0
    while place < len(words):
        width = next((len(w) for w in _ANDS if tuple(word.low for word in words[place : place + len(w)]) == w), 0)
        if width and made and place + width < len(words):
            made.append(Word(" ".join(word.text for word in words[place : place + width]), "and"))
            place += width
            continue
        made.append(words[place])
        place += 1
    return made


def _needless(words: list[Word], place: int) -> bool:
    """Whether a comma only sets off what describes: "Anna, who is lost" and "the safe, which is heavy, to the hall"."""
    if words[place].low != ",":
        return False
    following = words[place + 1].low if place + 1 < len(words) else ""
    if following in {"who", "which", "whose"}:
        return True
    if following in _MODALS | _MUST | {"can", "will"} and words[place - 1].low not in STOPS:
        return bool({"who", "which", "whose"} & {word.low for word in words[max(0, place - 14) : place]})
    before = [word.low for word in words[max(0, place - 10) : place]]
    return following in {"to", "into", "onto"} and bool({"who", "which", "whose"} & set(before))


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
    pause: bool = False  # a comma stands before the clause under way
    either: bool = False  # the clause under way begins a choice
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
        if lows[place] in STOPS:
            self._close("start")
            self.sentence += 1
            return 1
        if not self.held and lows[place] in _CALLS and lows[place + 1 : place + 2] in ([","], ["!"]):
            return 1
        over = self.lexicon.passed_over.at(lows, place)
        joined = self.lexicon.joins.at(lows, place)
        if over is not None and over[1] > 1 and (joined is None or over[1] > joined[1]):
            self.held += self.words[place : place + over[1]]  # the "once" of "at once" joins nothing
            return over[1]
        if joined is not None and self._joins(lows, place, *joined):
            return joined[1]
        if (
            lows[place] == "either"
            and not _says_something(self.held, self.lexicon)
            and self._verb_follows(lows, place + 1)
        ):
            self.either = True
            return 1
        if lows[place] in {"or", "but"} and (width := self._or_but(lows, place)):
            return width
        if lows[place] == "to" and self._purpose(lows, place):
            self._close("then")  # "go to the hall to find Anna"
            return 1
        if lows[place] in {"and", ","}:
            return self._comma_or_and(lows, place)
        self.held.append(self.words[place])
        return 1

    def _purpose(self, lows: list[str], place: int) -> bool:
        """Whether a robot that goes somewhere is told what to do there."""
        verb = self._verb_of(self.held)
        if verb is None or len(self.held) <= verb.length or "reach" not in self.lexicon.goals_of.get(verb.phrase, ()):
            return False
        doing = self.lexicon.verb_at(lows, place + 1, "base")
        behind = place + 1 + doing.length if doing is not None else len(lows)
        about = self.words[behind] if behind < len(lows) else None
        return about is not None and (about.low in _OBJECTS or about.text[:1].isupper())

    def _or_but(self, lows: list[str], place: int) -> int:
        """An *or* between two clauses, or a *but* that only goes on; 0 if it is neither."""
        behind = place + 1 + (lows[place + 1 : place + 2] == ["else"] and lows[place] == "or")
        if lows[place] == "or":
            if not self.held or lows[behind : behind + 1] == ["to"] or not self._clause_follows(lows, behind):
                return 0
            self._close("or")
            return behind - place
        joined = self.lexicon.joins.at(lows, behind)
        if joined is not None and joined[0] == "first":
            self._close("earlier")
            return behind + joined[1] - place
        if joined is not None or self._verb_follows(lows, behind):
            return 1 if not self.held else self._comma_or_and(lows, place)
        return 0

    def _joins(self, lows: list[str], place: int, relation: str, length: int) -> bool:
        if relation == "first":
            ends = lows[place + length : place + length + 1]
            return not self.held or not ends or ends[0] in {",", "and", "then", *STOPS}
        if relation == "earlier":
            self._close("earlier")
            return True
        if relation == "then" and lows[place] == "next" and lows[place + 1 : place + 2] == ["to"]:
            return False
        if lows[place : place + 1] == ["having"] and self.lexicon.verb_at(lows, place + length, "past") is None:
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
        while behind < len(lows) and lows[behind] in {"and", ",", "but", "so"}:
            behind += 1
        if "but" in lows[place:behind] and self._is_first(lows, behind):
            return behind - 1 - place  # "but first" is for the next step
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
        if self.held and lows[behind : behind + 1] == ["or"] and self._verb_follows(lows, behind + 1):
            return behind - place  # "do this, or do that"
        if (subject := self._passive_subject()) and self.lexicon.verb_at(lows, behind, "past") is not None:
            self._close("and")
            self.held = subject  # "must be found and guided out"
            return behind - place
        if self.held and self._clause_follows(lows, behind):
            spoken = _without_openings(self.held, self.lexicon)[0]
            alone = (verb := self._verb_of(self.held)) is not None and verb.length == len(spoken)
            self._close("and", shares=alone)
            self.pause = lows[place] == "," and "and" in lows[place:behind]
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
        if place < len(lows) and self.words[place].text[:1].isupper() and not self._all_capitals:
            return self._passive_follows(lows, place)  # a name, such as "Block B"
        gerunds = (verb := self._verb_of(self.held)) is not None and verb.form == "gerund"
        verb = self.lexicon.verb_at(lows, place, *(("gerund",) if gerunds else ("base",)))
        return verb is not None or self._passive_follows(lows, place)

    @property
    def _all_capitals(self) -> bool:
        return all(word.text == word.text.upper() for word in self.words)

    def _clause_follows(self, lows: list[str], place: int) -> bool:
        """Whether another clause begins there, and not only a further subject: "the bed and the chair must be moved"."""
        if not self._verb_follows(lows, place):
            return False
        held = [word.low for word in self.held]
        return self._verb_of(self.held) is not None or "be" in held or not self._passive_follows(lows, place)

    def _passive_subject(self) -> list[Word]:
        """The words of the clause under way up to its "must be", if it has one and a verb behind that."""
        lows = [word.low for word in self.held]
        place = next((at for at in range(2, len(lows)) if lows[at] == "be" and lows[at - 1] in _MODALS), 0)
        if not place or self.lexicon.verb_at(lows, place + 1, "past") is None:
            return []
        return list(self.held[: place + 1])

    def _passive_follows(self, lows: list[str], place: int) -> bool:
        """Whether something like "Anna has to be guided" begins there."""
        for at in range(place + 1, min(place + MAX_SUBJECT_WORDS, len(lows) - 1)):
            if lows[at - 1] in STOPS | {"and", ",", "then", "that", "who", "which"}:
                return False
            if lows[at] == "be" and lows[at - 1] in _MODALS:
                return self.lexicon.verb_at(lows, at + 1, "past") is not None
        return False

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
            self.done.append(
                replace(
                    clause, relation=joined, anchor=anchor, sentence=self.sentence, either=self.either, pause=self.pause
                )
            )
            self.either = self.pause = False
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
            self.relation, self.anchor = following, self.main if following in _TO_MAIN else None
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
    asked = tuple(dict.fromkeys(tuple(words[place].low.removeprefix(MARK).split("|")) for place in marks))
    before, _ = _without_openings(list(words[: marks[0]]), lexicon) if marks else ([], ())
    leads = bool(marks) and lexicon.verb_at([word.low for word in before], 0, "base", "gerund") is None
    words = tuple(word for place, word in enumerate(words) if place not in marks)
    kept, passed = _without_openings(list(words), lexicon)
    doers = next((len(who) for who in _DOING if is_event and tuple(word.low for word in kept[: len(who)]) == who), 0)
    if lexicon.verb_at([word.low for word in kept], doers, "gerund") is not None:
        kept = kept[doers:]  # "while you are looking for it"
    kept, in_order = _without_order(kept)
    kept, more = _without_passed_over(kept, lexicon)
    while kept and kept[-1].low == ",":
        kept.pop()
    kept, _ = _without_openings(kept, lexicon)
    kept = _caused(_active(kept, lexicon, is_event=is_event), lexicon)
    lows = [word.low for word in kept]
    verb = lexicon.verb_at(lows, 0, "base", "gerund")
    return Clause(
        words=tuple(kept),
        verb=verb,
        passed_over=(*passed, *more),
        decisive=tuple(phrase for phrase, _, _ in lexicon.decisive.within(lows)),
        asked=asked,
        leads=leads,
        in_order=in_order,
    )


def _caused(words: list[Word], lexicon: Lexicon) -> list[Word]:
    """Turn "have the crate moved to the hall" and "I need the crate taken to the hall" into "move the crate to the hall"."""
    lows = [word.low for word in words]
    start = next((len(phrase) for phrase in _CAUSES if tuple(lows[: len(phrase)]) == phrase), 0)
    if not start:
        return words
    for place in range(start + 1, min(len(lows), MAX_CLAUSE_WORDS)):
        if lows[place - 1] in _TO_BE or (verb := _past(lows, place, lexicon)) is None:
            continue
        if lows[place - 1] in {"that", "who", "which", "was", "been"}:
            continue
        if lows[place - 1] in {"is", "are"} and lows[0] not in {"make", "ensure", "see"}:
            continue
        end = (
            place - 2
            if lows[place - 2 : place] == ["to", "be"]
            else place - 1
            if lows[place - 1] in _AUXILIARIES
            else place
        )
        return [*(Word(part, part) for part in verb.phrase.split()), *words[start:end], *words[place + verb.length :]]
    return words


def _past(lows: list[str], place: int, lexicon: Lexicon) -> Verb | None:
    """The verb that begins there; in "moved to the hall", *move* and not *move to*, which asks whoever moves."""
    verb = lexicon.verb_at(lows, place, "past")
    if verb is None or verb.length == 1 or verb.phrase.split()[-1] not in {"to", "from"}:
        return verb
    return lexicon.verb_at(lows[: place + 1], place, "past") or verb


def _without_order(words: list[Word]) -> tuple[list[Word], bool]:
    """The words without a closing "in that order", and whether there was one."""
    while words and words[-1].low == ",":
        words = words[:-1]
    for phrase in _IN_ORDER:
        width = len(phrase)
        if len(words) > width and tuple(word.low for word in words[-width:]) == phrase:
            return words[:-width], True
    return words, False


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
    if words and words[0].low in {"shall", "should", "must"}:  # "only then shall the gate be closed"
        be = next((at for at in range(2, len(words)) if words[at].low == "be"), 0)
        words = [*words[1:be], words[0], *words[be:]] if be else words
    lows = [word.low for word in words]
    if is_event and (done := _past(lows, 0, lexicon)) is not None:  # "having delivered the box"
        return [*(Word(part, part) for part in done.phrase.split()), *words[done.length :]]
    if is_event and (place := next((at for at in (1, 2) if lows[at : at + 1] in (["have"], ["has"])), 0)):
        verb = lexicon.verb_at(lows, place + 1, "past")
        if verb is not None and " ".join(lows[:place]) in _DOERS:
            return [*(Word(part, part) for part in verb.phrase.split()), *words[place + 1 + verb.length :]]
    for place in range(1, min(len(lows), MAX_CLAUSE_WORDS)):
        if lows[place] not in _AUXILIARIES:
            continue
        behind = place + 1 + (lows[place + 1 : place + 2] in (["been"], ["being"]))
        asked = lows[place] == "be" and lows[place - 1] in _MODALS
        must = place - 2 if lows[place - 1] == "to" and lows[place - 2] in _MUST else place - 1
        if (asked or is_event) and (verb := _past(lows, behind, lexicon)) is not None:
            end = must if asked else place - 1 if lows[place - 1] in {"has", "have"} else place
            active = [Word(part, part) for part in verb.phrase.split()]
            return [*active, *words[:end], *words[behind + verb.length :]]
    return words
