"""
Robots that the mission leaves out, or asks for throughout: "do not use the drone", "any robot but the crawler", "only use drones".

What is left out in a sentence is left out in all of that sentence; in a sentence of its own, in the whole mission.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from missiontree.authoring.language.lexicon import Lexicon, PhraseTable, phrase_table, phrases_of
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.robots import Named, named_at, robot_names
from missiontree.authoring.reading.words import STOPS, Word
from missiontree.mission.fleet import Fleet

_JOINS = frozenset({"or", "nor", "and", ",", "any", "with", "by", "using"})
_LEAVES_OUT = phrase_table("robots", "leaves_out")
_ANY_BUT = frozenset(phrases_of("robots", "anybody"))
_ORDERS = frozenset({"send", "have", "let", "use", "ask", "tell", "get", "dispatch"})
_SUBJECTS = frozenset(
    {
        ",",
        "and",
        "but",
        "also",
        "you",
        "we",
        "they",
        "i",
        "robots",
        "robot",
        "the",
        "a",
        "please",
        "must",
        "should",
        "may",
    }
)
_IS_OUT = phrase_table("robots", "is_out")
_FOR_IT = phrase_table("robots", "for_it")
_THROUGHOUT = phrase_table("robots", "throughout")
_ONLY_USE = phrase_table("robots", "only_use")


@dataclass(frozen=True, slots=True)
class Standing:
    """
    Who is left out, and who alone is asked for, by sentence and for the whole mission.

    Parameters
    ----------
    words
        The words without those that say so.
    left_out
        Robot types left out, by number of the sentence.
    left_out_throughout, asked_throughout
        Those of the whole mission; for the latter, none means no restriction.
    """

    words: tuple[Word, ...]
    left_out: Mapping[int, tuple[str, ...]] = field(default_factory=dict)
    left_out_throughout: tuple[str, ...] = ()
    asked_throughout: tuple[str, ...] = ()

    def without(self, sentence: int) -> tuple[str, ...]:
        """All that are left out in a sentence."""
        return tuple(dict.fromkeys((*self.left_out.get(sentence, ()), *self.left_out_throughout)))


def standing_orders(words: tuple[Word, ...], fleet: Fleet, lexicon: Lexicon, known: frozenset[str]) -> Standing:
    """Take out of the words what says who must not do it, or who alone may; see :func:`robots_marked` for the parameters."""
    names = robot_names(fleet, known)
    return _Taker(words, names, lexicon).taken() if names else Standing(words)


def robots_restricted(clauses: Sequence[Clause], standing: Standing) -> tuple[Clause, ...]:
    """The clauses with those left out, and with those asked for throughout where none is asked for."""
    throughout = (standing.asked_throughout,) if standing.asked_throughout else ()
    return tuple(
        replace(
            clause,
            without=standing.without(clause.sentence),
            throughout=standing.asked_throughout,
            asked=clause.asked
            if set(clause.robots) <= set(standing.asked_throughout) and clause.asked
            else (*clause.asked, *throughout),
        )
        for clause in clauses
    )


@dataclass
class _Taker:
    """Walks over the words once."""

    words: tuple[Word, ...]
    names: PhraseTable
    lexicon: Lexicon
    kept: list[Word] = field(default_factory=list)
    left_out: dict[int, list[str]] = field(default_factory=dict)
    throughout: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)
    sentence: int = 0
    start: int = 0
    """Index among the words kept of the first of the sentence."""
    said: list[str] = field(default_factory=list)
    """Left out in the sentence under way."""
    asked_here: list[str] = field(default_factory=list)
    narrow: bool = False
    """Whether "for that" leaves somebody out of the sentence before alone."""

    def taken(self) -> Standing:
        lows = [word.low for word in self.words]
        place = 0
        while place < len(lows):
            width = self._left_out(lows, place) or self._asked(lows, place)
            if width:
                self._drop_joint(lows, place)
                place += width
                continue
            if lows[place] in STOPS:
                self._end_sentence()
            self.kept.append(self.words[place])
            place += 1
            if lows[place - 1] in STOPS:
                self.sentence += 1
                self.start = len(self.kept)
        self._end_sentence()
        left_out = {number: tuple(dict.fromkeys(types)) for number, types in self.left_out.items()}
        asked = tuple(dict.fromkeys(self.asked))
        return Standing(tuple(self.kept), left_out, tuple(dict.fromkeys(self.throughout)), asked)

    def _left_out(self, lows: Sequence[str], place: int) -> int:
        if (hit := _LEAVES_OUT.at(lows, place)) is not None:
            if (named := named_at(self.names, lows, place + hit[1], _JOINS)) is None:
                return 0
            end = place + hit[1] + named.length
            told = _FOR_IT.at(lows, end)
            self.narrow = told is not None and told[0] in {"for that", "for this", "for it"}
            end += self._for_it(lows, end)
            anybody = tuple(lows[place : place + hit[1]]) in _ANY_BUT
            if self._goes_on(lows, end) and not anybody:
                return 0
            self.said += named.types
            return end - place
        named = self._named(lows, place)
        if named is not None and (out := _IS_OUT.at(lows, place + named.length)) is not None:
            self.said += named.types
            end = place + named.length + out[1]
            return end + self._for_it(lows, end) - place
        return 0

    def _asked(self, lows: Sequence[str], place: int) -> int:
        """Words such as "only use drones" and "use the drone for everything", which are said of no single task."""
        hit = _ONLY_USE.at(lows, place)
        only = hit is not None
        if hit is None and lows[place] == "use":
            hit = ("use", 1)
        if hit is None or (named := named_at(self.names, lows, place + hit[1], frozenset({"or", "and", ","}))) is None:
            return 0
        end = place + hit[1] + named.length
        through = _THROUGHOUT.at(lows, end)
        if through is not None:
            end += through[1]
        elif only:
            end += self._for_it(lows, end)
        else:
            return 0
        if end < len(lows) and lows[end] not in STOPS | {",", "and"}:
            return 0  # "use only the drone to ...": said of one task
        if (
            self.kept[self.start :]
            and lows[place] != "use"
            and through is None
            and lows[place - 1] not in {",", "and", "but"}
        ):
            return 0  # "find the cat using only the drone": likewise
        self.asked_here += named.types
        return end - place

    def _named(self, lows: Sequence[str], place: int) -> Named | None:
        begins = place == 0 or lows[place - 1] in STOPS or lows[place - 1] in {",", "and", "but", "neither", "either"}
        return named_at(self.names, lows, place, _JOINS) if begins else None

    def _for_it(self, lows: Sequence[str], place: int) -> int:
        hit = _THROUGHOUT.at(lows, place) or _FOR_IT.at(lows, place)
        return hit[1] if hit is not None else 0

    def _goes_on(self, lows: Sequence[str], place: int) -> bool:
        """Whether "do not use the drone" goes on with "to find the cat", which leaves it open whether the cat is to be found."""
        return place + 1 < len(lows) and lows[place] in {"to", "for"}

    def _drop_joint(self, lows: Sequence[str], place: int) -> None:
        """Drop a "but" or a comma that led to what was taken out; of "send any robot but the drone", keep the robot."""
        if (
            self.kept
            and self.kept[-1].low in _ORDERS
            and any(tuple(lows[place : place + len(p)]) == p for p in _ANY_BUT)
        ):
            self.kept += [Word("a", "a"), Word("robot", "robot")]
            return
        while self.kept and self.kept[-1].low in {"but", ",", "and", "however"}:
            self.kept.pop()
        self.kept.append(Word(",", ","))

    def _end_sentence(self) -> None:
        own = not any(self._matters(word) for word in self.kept[self.start :])
        if own:
            del self.kept[self.start :]
            if self.narrow and self.sentence:
                self.left_out.setdefault(self.sentence - 1, []).extend(self.said)
            else:
                self.throughout += self.said
        elif self.said:
            self.left_out.setdefault(self.sentence, []).extend(self.said)
        self.asked += self.asked_here
        self.said, self.asked_here, self.narrow = [], [], False

    def _matters(self, word: Word) -> bool:
        return word.low not in _SUBJECTS and self.lexicon.passed_over.at([word.low], 0) is None
