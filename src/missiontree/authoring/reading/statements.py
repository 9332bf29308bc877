"""Statements that tell what somebody needs to know for the next sentence: "The cat is lost.", "The house is on fire."."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.authoring.language.lexicon import Lexicon, phrases_of
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.words import Word

_IS = frozenset({"is", "are", "has", "have"})
MOST_BEFORE = 5
"""In "Mrs Brown has lost her keys" the verb begins within so many words."""
_BEEN = frozenset({"been", "gone", "got"})


@dataclass(frozen=True, slots=True)
class Statement:
    """Who is spoken of, and what is wrong with them: they are lost, or hazards stand beside them."""

    phrases: tuple[Phrase, ...]
    hazards: tuple[str, ...]
    losers: tuple[Phrase, ...] = ()

    @property
    def lost(self) -> bool:
        """Whether all that are spoken of have to be found."""
        return all(phrase.lost for phrase in self.phrases)


_SOMEBODY = (["i"], ["we"], ["somebody"], ["someone"])
_LOSES = phrases_of("statements", "loses")
_GONE = phrases_of("statements", "gone")
_STANDS = frozenset(word for (word,) in phrases_of("statements", "stands"))
_ADVERBS = frozenset(word for (word,) in phrases_of("statements", "adverbs"))
_AT = frozenset(word for (word,) in phrases_of("statements", "at"))
_FEELINGS = frozenset(phrases_of("statements", "feelings"))
_VERY = phrases_of("statements", "very")
_THERE = phrases_of("statements", "there")
_CAUSE = phrases_of("statements", "cause")
_ENDS = phrases_of("statements", "ends")


CANNOT = frozenset({"cannot", "can't", "not"})
"""What a clause may hold that says who has lost something."""


def loses(clause: Clause) -> bool:
    """Whether a clause says that somebody has lost something: "the old lady cannot find her bag"."""
    return clause.relation == "start" and _subject_length(clause) > 0


def cause_of(words: Sequence[Word]) -> tuple[tuple[Word, ...], tuple[Word, ...]]:
    """The words without a closing "because of the fire", and the words of the cause; none if there is none."""
    lows = [word.low for word in words]
    for phrase in _CAUSE:
        for place in range(len(lows) - len(phrase)):
            if tuple(lows[place : place + len(phrase)]) == phrase:
                return tuple(words[:place]), tuple(words[place + len(phrase) :])
    return tuple(words), ()


def _recast(words: tuple[Word, ...]) -> tuple[Word, ...]:
    """Statements that a thing is lost, in the plain form "... is lost"."""
    lows = [word.low for word in words]
    lost = (Word("is", "is"), Word("lost", "lost"))
    for phrase in _GONE:
        for place in range(1, len(lows)):
            if tuple(lows[place : place + len(phrase)]) == phrase:
                return (*words[:place], *lost, *words[place + len(phrase) :])
    for phrase in _LOSES:
        for place in range(1, MOST_BEFORE):
            said = tuple(lows[place : place + len(phrase)]) == phrase and lows[place - 1] not in _IS | _BEEN
            if said and place + len(phrase) < len(lows):
                return (*words[place + len(phrase) :], *lost)
    return words


def danger_of(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> tuple[str, ...]:
    """Hazards that a clause without a verb names: "gas leak", "there is a fire in the kitchen", "because of the flood"."""
    lows = [word.low for word in clause.words]
    start = next((len(phrase) for phrase in (*_THERE, *_CAUSE) if tuple(lows[: len(phrase)]) == phrase), 0)
    words = clause.words[start:]
    if clause.verb is not None or clause.relation != "start":
        return ()
    behind = [word.low for word in words if word.low not in lexicon.words["determiners"]]
    hit = lexicon.hazard_words.at(behind, 0)
    if hit is None:
        return ()
    goes_on = behind[hit[1] : hit[1] + 1]
    if not lexicon.hazards_in(behind) or {
        "out",
        "over",
        "gone",
        "extinguished",
        "contained",
        "fixed",
        "stopped",
        "false",
    } & set(behind):
        return ()
    told = not goes_on or goes_on[0] in _IS | _AT | {
        "was",
        "were",
        "broke",
        "breaks",
        "spreads",
        "leaks",
        "alarm",
        "alert",
    }
    return (hit[0],) if told or phrases.phrases(words) is not None else ()


def site_of(clause: Clause, phrases: PhraseReader) -> Phrase | None:
    """Where a danger is said to be: the kitchen in "there is a fire in the kitchen"; None if that is not said."""
    for place, word in enumerate(clause.words[:-1]):
        if place and word.low in _AT and (read := phrases.phrases(clause.words[place + 1 :])) is not None:
            return read[0] if len(read) == 1 and not read[0].pronoun else None
    return None


def event_of(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> Phrase | None:
    """Who has come to the end of a way, if a clause behind "until", "once", "before" or "while" says no more than that."""
    if clause.relation not in {"before", "after", "until", "while"}:
        return None
    lows = [word.low for word in clause.words]
    for end in _ENDS:
        if tuple(lows[-len(end) :]) == end and (read := phrases.phrases(clause.words[: -len(end)])) is not None:
            return read[0] if len(read) == 1 else None
    moved = clause.verb is not None and {"bring", "transport", "guide", "put"} & set(
        lexicon.goals_of.get(clause.verb.phrase, ())
    )
    if not moved or clause.verb is None:
        return None
    read = phrases.phrases(clause.words[clause.verb.length :])
    return read[0] if read is not None and len(read) == 1 else None


def feeling_of(clause: Clause, phrases: PhraseReader) -> tuple[Phrase, ...] | None:
    """Who is said to be thirsty, tired or waiting, which changes nothing; None if the clause says something else."""
    words = tuple(word for word in clause.words if word.low not in _ADVERBS)
    lows = [word.low for word in words]
    place = next((at for at in range(1, len(lows) - 1) if lows[at] in _IS | {"feels", "feel", "looks", "look"}), 0)
    if clause.verb is not None or clause.relation != "start" or not place:
        return None
    behind = " ".join(low for low in lows[place + 1 :] if low not in {"today", "now", "there", "here"})
    for very in _VERY:
        behind = behind.removeprefix(f"{' '.join(very)} ")
    read = phrases.phrases(words[:place])
    return (
        read if tuple(behind.split()) in _FEELINGS and read is not None and not any(p.pronoun for p in read) else None
    )


def place_of(clause: Clause, phrases: PhraseReader) -> tuple[tuple[Phrase, ...], str] | None:
    """Who is said to be where: "Anna is waiting in the lobby"; None if the clause says something else."""
    words = tuple(word for word in clause.words if word.low not in _ADVERBS)
    lows = [word.low for word in words]
    for phrase in _THERE:
        for at in range(len(lows) - len(phrase)):
            if tuple(lows[at : at + len(phrase)]) == phrase and clause.verb is None and clause.relation == "start":
                where = words[:at] if at and lows[0] != "somewhere" else words[1:at]
                read = phrases.phrases((*words[at + len(phrase) :], *where))
                return (read, "there") if read is not None and not any(one.pronoun for one in read) else None
    if (left := _left(words, phrases)) is not None:
        words, lows = left, [word.low for word in left]
    place = next(
        (index for index, low in enumerate(lows) if low in {"is", "are", "stands", "waits", "lies", "sits"}), 0
    )
    if clause.verb is not None or clause.relation != "start" or not 0 < place < len(lows) - 2:
        return None
    behind = place + 1 + (lows[place + 1] in _STANDS and lows[place] in _IS)
    if lows[behind] not in _AT or phrases.phrases(words[:place]) is None:
        return None
    read = phrases.phrases((*words[:place], *words[behind:]))
    if read is None or any(phrase.pronoun for phrase in read) or not read[-1].description:
        return None
    return read, " ".join(word.text for word in words[behind:])


def _left(words: tuple[Word, ...], phrases: PhraseReader) -> tuple[Word, ...] | None:
    """The words "somebody left the trolley in the yard" as "the trolley is in the yard"; None if they say something else."""
    lows = [word.low for word in words]
    place = next((at for at in range(1, min(len(lows), MOST_BEFORE)) if lows[at] == "left"), 0)
    where = next((at for at in range(place + 2, len(lows) - 1) if lows[at] in _AT), 0)
    somebody = lows[:place] in _SOMEBODY or phrases.phrases(words[:place]) is not None
    if not place or not where or not somebody:
        return None
    what = phrases.phrases(words[place + 1 : where])
    if what is None or len(what) != 1 or phrases.kind_of(what[0]) in {None, "place"}:
        return None
    return (*words[place + 1 : where], Word("is", "is"), *words[where:])


def statement_of(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> Statement | None:
    """What a clause states; None if it is no statement, or one that says something else."""
    words = _recast(clause.words)
    lows = [word.low for word in words]
    if clause.verb is not None or clause.relation != "start":
        return None
    place = next((index for index, low in enumerate(lows) if low in _IS), 0)
    behind = place + 1
    while lows[behind : behind + 1] and lows[behind] in _BEEN:
        behind += 1
    if not 0 < place < behind < len(lows) or (subjects := phrases.parts(words[:place])) is None:
        return None
    hazards = tuple(dict.fromkeys(lexicon.hazards_in(lows[behind:])))
    if lows[behind] not in lexicon.words["lost"] and not (hazards and lexicon.hazard_words.at(lows, behind)):
        return None
    read = [phrases.phrases((*subject, *words[behind:])) for subject in subjects]
    if any(found is None or len(found) != 1 or found[0].pronoun for found in read):
        return None
    loser = () if words is clause.words else phrases.phrases(clause.words[: _subject_length(clause)]) or ()
    losers = tuple(
        phrase for phrase in loser if not phrase.pronoun and phrase.name.lower() not in {"somebody", "someone"}
    )
    return Statement(tuple(phrase for found in read if found is not None for phrase in found), hazards, losers)


def _subject_length(clause: Clause) -> int:
    """How many words say who has lost what follows; 0 if the clause says it otherwise."""
    lows = [word.low for word in clause.words]
    places = (at for at in range(1, min(len(lows), MOST_BEFORE)) for p in _LOSES if tuple(lows[at : at + len(p)]) == p)
    return next(places, 0)
