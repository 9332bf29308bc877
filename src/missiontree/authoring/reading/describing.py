"""What is said of somebody behind their name: "trapped in a building on fire", "who is lost", "with the red seat"."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.language.lexicon import Lexicon, phrases_of
from missiontree.authoring.reading.listing import is_letter
from missiontree.authoring.reading.words import Word

_NOT_DESCRIBING = frozenset(word for (word,) in phrases_of("statements", "not_describing"))

_NEAR = frozenset({"with", "by", "near", "beside", "for", "to", "from"})

# Words that want a place said behind them: "the table next" has lost its "to the bed".
_LEADING_ON = frozenset({"next", "close", "closest", "adjacent", "near", "according", "due", "prior", "thanks", "up"})

_GONE = phrases_of("statements", "gone")

_PAST = frozenset({"yesterday", "this", "last", "ago"})

_AFTER_LOST = frozenset({"somewhere", "since", "again", "yesterday", "and", ","})


class Descriptions:
    """Tells what only describes from what may mean something else."""

    def __init__(self, lexicon: Lexicon) -> None:
        self._lexicon = lexicon
        self._small = lexicon.words

    def describe(self, words: tuple[Word, ...]) -> bool:
        """Whether the words only describe: no quantity, no time, nothing that stands by itself."""
        if not words:
            return True
        small, lows = self._small, [word.low for word in words]
        if lows[0] == "being" or lows[:2] in (["in", "at"], ["whose", "name"]):
            return False  # "the lions being fed", "check the case in at the counter", "the boy, whose name is Tim"
        if len(words) == 1 and lows[0] in small["describing"] | small["relatives"]:
            return False
        states = small["lost"] | small["states"]
        for place, low in enumerate(lows):
            past = lows[0] in small["relatives"] and (low in _PAST or lows[place - 1] in _PAST)
            timed = low in small["times"] and not past
            if low in small["quantities"] or timed or low in small["decisive"]:
                return False
            purpose = low == "to" and lows[0] in small["relatives"] and self._lexicon.verb_at(lows, place + 1, "base")
            if low in _NOT_DESCRIBING and not purpose:
                return False
            if not (low[0].isalnum() or low in {",", "'"}):
                return False
            if low[0].isdigit() and (place == 0 or lows[place - 1] in small["describing"] or place != len(lows) - 1):
                return False
            if low.endswith("ly") and len(low) > 4 and kind_of(low) is None:
                return False
        last = lows[-1]
        if last in _LEADING_ON:
            return False
        if last in {"it", "him", "them", "this", "that", "these", "those"} and lows[-2:-1] and lows[-2] in _NEAR:
            return False
        return (
            last not in small["describing"]
            and last not in small["relatives"]
            and (last not in small["determiners"] or last in states or is_letter(words[-1]))
        )

    def say_lost(self, words: tuple[Word, ...]) -> bool:
        """Whether a description says that who is spoken of is lost or went missing, and not that they lost something."""
        if _is_gone(words):
            return True
        lows = [word.low for word in words]
        for place, low in enumerate(lows):
            following = lows[place + 1] if place + 1 < len(lows) else ""
            ends = not following or following in self._small["describing"] | _AFTER_LOST
            if low in self._small["lost"] and ends and not {"whose", "following", "with"} & set(lows[:place]):
                return True
        return False


def _is_gone(words: Sequence[Word]) -> bool:
    """Whether a description says that somebody went missing: "who ran away"."""
    lows = tuple(word.low for word in words)
    return any(lows[at : at + len(gone)] == gone for gone in _GONE for at in range(len(lows)))
