"""Figures of speech: "give Anna a hand" brings no hand, and "keep the ball rolling" follows no ball."""

from __future__ import annotations

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.wording import PREPOSITIONS
from missiontree.authoring.reading.words import ARTICLES, POSSESSIVES

_DROPPED = ARTICLES | POSSESSIVES | {"some", "any", "me", "us"}


def idiom_in(clause: Clause, lexicon: Lexicon) -> str:
    """The figure of speech that a clause ends with; empty if it has none."""
    if clause.verb is None:
        return ""
    lows = [word.low for word in clause.words]
    verb = clause.verb.phrase.split()
    for start in dict.fromkeys((" ".join(verb), verb[0])):
        whole = lows[min(clause.verb.length, len(start.split())) :]
        for phrase in lexicon.idioms.get(start, ()):
            bare = phrase.startswith("to ")  # "put the lamp next to the bed" puts nobody to bed
            behind = whole if bare else [low for low in whole if low not in _DROPPED]
            parts = phrase.split() if bare else [part for part in phrase.split() if part not in _DROPPED]
            for at in range(min(len(behind) - len(parts), MOST_BETWEEN) + 1):
                end = at + len(parts)
                if behind[at:end] == parts and _ends(parts, behind[end:]):
                    return f"{start} ... {phrase}" if at else f"{start} {phrase}"
    return ""


def _ends(parts: list[str], rest: list[str]) -> bool:
    """Whether a figure of speech may end before the rest of the words."""
    if not rest:
        return True
    if len(parts) == 1 and parts[0] in _PARTICLES:
        return False
    if parts[-1] in {"up", "down"} and rest[0] == "to":
        return False  # the curtain comes down to the laundry
    return rest[0] in PREPOSITIONS | {"of"}


_PARTICLES = frozenset({"up", "out", "off", "on", "over", "away", "in", "back", "by", "through", "down", "about"})
MOST_BETWEEN = 3
"""So many words may stand between the verb and the rest: "give the old man a hand"."""
