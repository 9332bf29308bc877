"""What somebody needs, as an order to bring it: "Anna needs her keys", "we need the ladder in the hall"."""

from __future__ import annotations

from dataclasses import replace

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.language.lexicon import Lexicon, phrases_of
from missiontree.authoring.reading.clause import SUBORDINATE, Clause
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.words import Word

_NEEDS = phrases_of("statements", "needs")
_PLACE = frozenset({"place"})
_ALL = frozenset({"person", "animal", "place"})
_BE = frozenset({"is", "are"})
_NEEDED = frozenset({"needed", "wanted", "required", "missed"})
_WHERE = frozenset({"in", "at", "on"})


def errand_of(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> Clause | None:
    """A clause without a verb, such as "crate to dock 3", as an order to bring; None if it is no such clause."""
    lows = [word.low for word in clause.words]
    place = lows.index("to") if "to" in lows else 0
    end = next((at for at in range(place, len(lows)) if lows[at] in {"or", "and", ","}), len(lows))
    if not 0 < place < end - 1 or lows[:end].count("to") > 1 or clause.relation in SUBORDINATE:
        return None
    what, where = phrases.phrases(clause.words[:place]), phrases.phrases(clause.words[place + 1 : end])
    if what is None or where is None or len(where) != 1 or any(phrase.pronoun for phrase in what):
        return None
    if any(phrases.kind_of(phrase) in {None, "place"} or not _is_named(phrase) for phrase in what):
        return None
    movers = lexicon.words["movers"]
    if any(p.name.lower().split()[-1] in movers and p.name.lower() not in phrases.known for p in what):
        return None  # "drone to tank 5" is rather an order to the drone
    first = clause.words[0]
    if kind_of(first.low) is not None and kind_of(first.text) is not None:  # capital at the beginning only
        first = Word(first.low, first.low)
    words = (Word("bring", "bring"), first, *clause.words[1:])
    return replace(clause, words=words, verb=lexicon.verb_at(["bring"], 0, "base"))


def _is_named(phrase: Phrase) -> bool:
    """Whether a phrase is a name and no more, unlike "Anna went", "the thief escaped" and "Welcome"."""
    *before, last = phrase.name.split()
    known = kind_of(last.lower()) is not None or last[-1].isdigit() or (bool(before) and last[:1].isupper())
    return not phrase.description and (known or last.lower() in _GIVEN_NAMES)


_GIVEN_NAMES = frozenset(word for key in ("women", "men") for (word,) in phrases_of("statements", key))
_NO_THINGS = frozenset({"hand", "break", "rest", "help", "favour", "favor", "lift", "ride", "minute", "moment", "word"})


def _wanted_somewhere(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> Clause | None:
    """The words "the ladder is needed in the hall" as an order to bring it there."""
    lows = [word.low for word in clause.words]
    place = next((at for at in range(1, len(lows) - 2) if lows[at] in _BE and lows[at + 1] in _NEEDED), 0)
    if clause.relation != "start" or not place or lows[place + 2] not in _WHERE | {"by"}:
        return None
    what, where = phrases.phrases(clause.words[:place]), phrases.phrases(clause.words[place + 3 :])
    if what is None or where is None or len(where) != 1 or any(phrase.pronoun for phrase in (*what, *where)):
        return None
    words = (Word("bring", "bring"), *clause.words[:place], Word("to", "to"), *clause.words[place + 3 :])
    return replace(clause, words=words, verb=lexicon.verb_at(["bring"], 0, "base"))


def wish_of(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> Clause | None:
    """The clause as an order to bring what is needed to who or where it is needed; None if it is no such clause."""
    lows = [word.low for word in clause.words]
    if (passive := _wanted_somewhere(clause, phrases, lexicon)) is not None:
        return passive
    found = ((at, len(n)) for at in range(1, len(lows)) for n in _NEEDS if tuple(lows[at : at + len(n)]) == n)
    place, width = next(found, (0, 0))
    if clause.relation != "start" or not 0 < place < len(lows) - width:
        return None
    subject, wanted = clause.words[:place], clause.words[place + width :]
    if lows[:place] in (["i"], ["we"]):
        at = next((at for at in range(len(wanted) - 1, 0, -1) if wanted[at].low in _WHERE), 0)
        if not at:
            return None
        wanted, subject = wanted[:at], wanted[at + 1 :]
        kinds = _PLACE
    else:
        kinds = _ALL
    open_choice = next((at for at, word in enumerate(wanted) if word.low == "or"), len(wanted))
    plain = tuple(word for word in wanted[:open_choice] if word.low != "either")
    who, what = phrases.phrases(subject), phrases.phrases(plain)
    if who is None or what is None or len(who) != 1 or who[0].pronoun or any(phrase.pronoun for phrase in what):
        return None
    if phrases.kind_of(who[0]) not in kinds or any(phrases.kind_of(phrase) in {None, "place"} for phrase in what):
        return None
    if any(phrase.name.lower() in _NO_THINGS for phrase in what):
        return None  # "Anna needs a hand"
    words = (Word("bring", "bring"), *wanted, Word("to", "to"), *subject)
    return replace(clause, words=words, verb=lexicon.verb_at([word.low for word in words], 0, "base"))
