"""What somebody needs, as an order to bring it: "Anna needs her keys", "we need the ladder in the hall"."""

from __future__ import annotations

from dataclasses import replace

from missiontree.authoring.language.lexicon import Lexicon, phrases_of
from missiontree.authoring.reading.clauses import Clause, Word
from missiontree.authoring.reading.phrases import PhraseReader

_NEEDS = phrases_of("statements", "needs")
_PLACE = frozenset({"place"})
_ALL = frozenset({"person", "animal", "place"})
_WHERE = frozenset({"in", "at", "on"})


def errand_of(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> Clause | None:
    """A clause without a verb, such as "crate to dock 3", as an order to bring; None if it is no such clause."""
    lows = [word.low for word in clause.words]
    place = lows.index("to") if "to" in lows else 0
    if not 0 < place < len(lows) - 1 or lows.count("to") > 1:
        return None
    what, where = phrases.phrases(clause.words[:place]), phrases.phrases(clause.words[place + 1 :])
    if what is None or where is None or len(where) != 1 or any(phrase.pronoun for phrase in what):
        return None
    if any(phrases.kind_of(phrase) in {None, "place"} for phrase in what):
        return None
    words = (Word("bring", "bring"), *clause.words)
    return replace(clause, words=words, verb=lexicon.verb_at(["bring"], 0, "base"))


def wish_of(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> Clause | None:
    """The clause as an order to bring what is needed to who or where it is needed; None if it is no such clause."""
    lows = [word.low for word in clause.words]
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
    who, what = phrases.phrases(subject), phrases.phrases(wanted)
    if who is None or what is None or len(who) != 1 or who[0].pronoun or any(phrase.pronoun for phrase in what):
        return None
    if phrases.kind_of(who[0]) not in kinds or any(phrases.kind_of(phrase) in {None, "place"} for phrase in what):
        return None
    words = (Word("bring", "bring"), *wanted, Word("to", "to"), *subject)
    return replace(clause, words=words, verb=lexicon.verb_at([word.low for word in words], 0, "base"))
