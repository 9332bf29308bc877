"""Figures of speech: "give Anna a hand" brings no hand, and "keep the ball rolling" follows no ball."""

from __future__ import annotations

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clause import Clause

_DROPPED = frozenset({"the", "a", "an", "my", "your", "his", "her", "its", "our", "their", "some", "any", "me", "us"})


def idiom_in(clause: Clause, lexicon: Lexicon) -> str:
    """The figure of speech that a clause ends with; empty if it has none."""
    if clause.verb is None:
        return ""
    lows = [word.low for word in clause.words]
    verb = clause.verb.phrase.split()
    for start in {" ".join(verb), verb[0]}:
        behind = [low for low in lows[min(clause.verb.length, len(start.split())) :] if low not in _DROPPED]
        for phrase in lexicon.idioms.get(start, ()):
            parts = [part for part in phrase.split() if part not in _DROPPED]
            if parts and behind[-len(parts) :] == parts and len(behind) - len(parts) <= MOST_BETWEEN:
                return f"{start} ... {phrase}" if len(behind) > len(parts) else f"{start} {phrase}"
    return ""


MOST_BETWEEN = 3
"""So many words may stand between the verb and the rest: "give the old man a hand"."""
