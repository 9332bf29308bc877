"""A mission text to its clauses: one goal each, joined by *and*, *then*, *before*, *while* ... In one pass over the words."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.language.lexicon import Lexicon, Verb
from missiontree.authoring.reading.clause import SUBORDINATE, Clause, Doubt, Relation
from missiontree.authoring.reading.finishing import finished, says_something, without_openings
from missiontree.authoring.reading.words import MODALS, OBJECTS, STOPS, Word, is_mark

MAX_SUBJECT_WORDS = 10
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
_COORDINATE = frozenset({"and", "then", "meanwhile"})
_TO_MAIN = frozenset({"then", "and", "meanwhile", "earlier", "or"})


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
    listed: bool = False  # a comma alone joins the clause under way
    first: bool = False  # what was said last goes before what comes
    opens: bool = False  # the clause under way is the first of all
    closes: bool = False  # the clause under way is the last of all
    doubt: Doubt = ""
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
        self._end_sentence()
        if self.held:  # a robot that is told nothing
            self.done.append(Clause(words=tuple(Word(word.text, word.text.lower()) for word in self.held)))
        return tuple(self.done)

    def _end_sentence(self) -> None:
        """Close the clause under way; one that waits for a main clause belongs to the last one, if that is of its sentence."""
        if self.leading and self.held and self.main is not None and self.done[self.main].sentence == self.sentence:
            self.leading, self.anchor = False, self.main
        self._close("start")

    def _step(self, lows: list[str], place: int) -> int:
        """Take what stands at a place; return how many words that was."""
        if lows[place] in STOPS:
            self._end_sentence()
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
            and not says_something(self.held, self.lexicon)
            and self._order_follows(lows, place + 1)
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
        return about is not None and (about.low in OBJECTS or about.text[:1].isupper())

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
            self.opens = True
            return behind + joined[1] - place
        if joined is not None or self._verb_follows(lows, behind):
            return 1 if not self.held else self._comma_or_and(lows, place)
        return 0

    def _is_late(self) -> bool:
        """Whether a sentence that begins with "first" comes behind orders of which none is said to be the last."""
        before = [clause for clause in self.done if clause.sentence < self.sentence and clause.verb is not None]
        return bool(before) and not self.held and self.done == before and not any(clause.closes for clause in before)

    def _joins(self, lows: list[str], place: int, relation: str, length: int) -> bool:
        if relation == "first":
            ends = lows[place + length : place + length + 1]
            self.opens = self.opens or not (self.held or self.done)
            self.doubt = "first" if self._is_late() else self.doubt
            if (
                self.held
                and (not ends or ends[0] in {",", "and", *STOPS})
                and lows[place + length + 1 : place + length + 2] != ["then"]
            ):
                self._said_first()
            return not self.held or not ends or ends[0] in {",", "and", "then", *STOPS}
        if self.held and relation in {"then", "earlier", "meanwhile"} and self._ends(lows, place + length):
            return self._said_last(relation)
        if relation == "earlier":
            self._close("earlier")
            return True
        if relation == "then" and lows[place] == "next" and lows[place + 1 : place + 2] == ["to"]:
            return False
        if lows[place] == "till" and place and lows[place - 1] in {"the", "a", "this", "that", "each", "every"}:
            return False
        if lows[place : place + 1] == ["having"] and self.lexicon.verb_at(lows, place + length, "past") is None:
            return False
        if relation == "then" and not (self.held or self.done):
            self.closes = True
        if relation in {"then", "meanwhile"}:
            self._close("then" if relation == "then" else "meanwhile")
            return True
        self._subordinate(relation)  # type: ignore[arg-type]  # the four that are left
        return True

    def _ends(self, lows: list[str], place: int) -> bool:
        return place >= len(lows) or lows[place] in STOPS

    def _said_first(self) -> None:
        """The word *first* behind what is to be done: it goes before what it is joined to, or before what comes."""
        if self.relation == "and":
            self.relation = "earlier"
        elif self.relation == "start":
            self.first, self.opens = True, not self.done

    def _said_last(self, relation: str) -> bool:
        """A word such as *afterwards* behind what is to be done says how it is joined to what stands before."""
        if relation == "then" and (self.main is None or self.relation not in {"and", "start"}):
            if {"and", ","} & {word.low for word in self.held}:
                self.doubt = "last"  # "visit room 3, and room 5 after that"
                return True
            self.closes = self.closes or self.main is None
        if self.relation in {"and", "start"} and self.main is not None and not self.leading:
            self.relation, self.anchor = relation, self.main  # type: ignore[assignment]  # then, earlier or meanwhile
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
            if joined[0] in SUBORDINATE and "and" in lows[place:behind] and not self.leading:
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
            spoken = without_openings(self.held, self.lexicon)[0]
            alone = (verb := self._verb_of(self.held)) is not None and verb.length == len(spoken)
            self._close("and", shares=alone)
            self.pause = lows[place] == "," and "and" in lows[place:behind]
            self.listed = "and" not in lows[place:behind]
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
        while (hit := self.lexicon.passed_over.at(lows, place)) is not None or is_mark(lows, place):
            place += hit[1] if hit else 1
        if (hit := self.lexicon.openings.at(lows, place)) is not None:
            place += hit[1]
        if place < len(lows) and self.words[place].text[:1].isupper() and not self._all_capitals:
            return self._passive_follows(lows, place)  # a name, such as "Block B"
        gerunds = (verb := self._verb_of(self.held)) is not None and verb.form == "gerund"
        verb = self.lexicon.verb_at(lows, place, *(("gerund",) if gerunds else ("base",)))
        if verb is not None and verb.length == 1 and lows[place + 1 : place + 2] in (["to"], ["for"]):
            return kind_of(lows[place]) is None  # "and water to the sheep"
        return verb is not None or self._passive_follows(lows, place)

    @property
    def _all_capitals(self) -> bool:
        return all(word.text == word.text.upper() for word in self.words)

    def _order_follows(self, lows: list[str], place: int) -> bool:
        """Whether a verb begins there that tells what to do."""
        return self._verb_follows(lows, place) and not self._passive_follows(lows, place)

    def _clause_follows(self, lows: list[str], place: int) -> bool:
        """Whether another clause begins there, and not only a further subject: "the bed and the chair must be moved"."""
        if not self._verb_follows(lows, place):
            return False
        held = [word.low for word in self.held]
        return self._verb_of(self.held) is not None or "be" in held or not self._passive_follows(lows, place)

    def _passive_subject(self) -> list[Word]:
        """The words of the clause under way up to its "must be", if it has one and a verb behind that."""
        lows = [word.low for word in self.held]
        place = next((at for at in range(2, len(lows)) if lows[at] == "be" and lows[at - 1] in MODALS), 0)
        if not place or self.lexicon.verb_at(lows, place + 1, "past") is None:
            return []
        return list(self.held[: place + 1])

    def _passive_follows(self, lows: list[str], place: int) -> bool:
        """Whether something like "Anna has to be guided" begins there."""
        for at in range(place + 1, min(place + MAX_SUBJECT_WORDS, len(lows) - 1)):
            if lows[at - 1] in STOPS | {"and", ",", "then", "that", "who", "which"}:
                return False
            if lows[at] == "be" and lows[at - 1] in MODALS:
                return self.lexicon.verb_at(lows, at + 1, "past") is not None
        return False

    def _verb_of(self, words: list[Word]) -> Verb | None:
        kept, _ = without_openings(words, self.lexicon)
        return self.lexicon.verb_at([word.low for word in kept], 0, "base", "gerund")

    def _close(self, following: Relation, *, shares: bool = False) -> None:
        """End the clause under way; the next one is joined to it by ``following``."""
        if self.held and says_something(self.held, self.lexicon):
            clause = finished(tuple(self.held), self.lexicon, is_event=self.relation in SUBORDINATE)
            index = len(self.done)
            anchor = index + 1 if self.leading or shares else self.anchor
            joined: Relation = "shares" if shares else self.relation
            self.done.append(
                replace(
                    clause,
                    relation=joined,
                    anchor=anchor,
                    sentence=self.sentence,
                    either=self.either,
                    pause=self.pause,
                    listed=self.listed,
                    opens=self.opens,
                    closes=self.closes,
                    doubt=self.doubt,
                )
            )
            self.either = self.pause = self.listed = self.opens = self.closes = False
            self.doubt = ""
            if not self.leading and self.relation not in SUBORDINATE:
                self.main = index
        elif following in {"start", "and"}:
            self.held = [word for word in self.held if is_mark([word.low], 0)]
            return
        self.held = []
        inherits = (
            following == "and"
            and self.done
            and self._gerund(self.done[-1])
            and self.relation in SUBORDINATE
            and not self.leading
        )
        if self.first and following in {"start", "and"} and self.done and self.done[-1].relation == "start":
            following, self.first = "then", False
        if not inherits and not shares:
            self.relation, self.anchor = following, self.main if following in _TO_MAIN else None
        self.leading = False

    @staticmethod
    def _gerund(clause: Clause) -> bool:
        return clause.verb is not None and clause.verb.form == "gerund"
