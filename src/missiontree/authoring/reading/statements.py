"""Statements that tell what somebody needs to know for the next sentence: "The cat is lost.", "The house is on fire."."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clauses import Clause
from missiontree.authoring.reading.phrases import Phrase, PhraseReader

_IS = frozenset({"is", "are", "has", "have"})
_BEEN = frozenset({"been", "gone", "got"})


@dataclass(frozen=True, slots=True)
class Statement:
    """Who is spoken of, and what is wrong with them: they are lost, or hazards stand beside them."""

    phrases: tuple[Phrase, ...]
    hazards: tuple[str, ...]

    @property
    def lost(self) -> bool:
        """Whether all that are spoken of have to be found."""
        return all(phrase.lost for phrase in self.phrases)


def statement_of(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> Statement | None:
    """What a clause states; None if it is no statement, or one that says something else."""
    words, lows = clause.words, [word.low for word in clause.words]
    if clause.verb is not None or clause.relation != "start":
        return None
    place = next((index for index, low in enumerate(lows) if low in _IS), 0)
    behind = place + 1
    while lows[behind : behind + 1] and lows[behind] in _BEEN:
        behind += 1
    if not 0 < place < behind < len(lows) or (subjects := phrases.parts(words[:place])) is None:
        return None
    hazards = tuple(dict.fromkeys(name for name, _, _ in lexicon.hazard_words.within(lows[behind:])))
    if lows[behind] not in lexicon.words["lost"] and not (hazards and lexicon.hazard_words.at(lows, behind)):
        return None
    read = [phrases.phrases((*subject, *words[behind:])) for subject in subjects]
    if any(found is None or len(found) != 1 or found[0].pronoun for found in read):
        return None
    return Statement(tuple(phrase for found in read if found is not None for phrase in found), hazards)
