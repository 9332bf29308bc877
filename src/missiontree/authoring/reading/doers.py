"""Who does it, and who comes along, where the words may mean either: each raises :class:`UnclearError` with a sentence that asks."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.methods.mention import UnclearError
from missiontree.authoring.reading.advice import RobotAdvice
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.plurals import noun_of
from missiontree.authoring.reading.words import Word

_RIDDEN = frozenset(
    {
        "escalator",
        "stairs",
        "staircase",
        "underground",
        "cab",
        "taxi",
        "bike",
        "bicycle",
        "road",
        "path",
        "shuttle",
        "jeep",
        "motorway",
    }
)


@dataclass(frozen=True)
class Doers:
    """What is held against a reading by who knows robots, vehicles and tools."""

    lexicon: Lexicon
    phrases: PhraseReader
    advice: RobotAdvice

    def robots(self, phrases: Iterable[Phrase]) -> None:
        """Who shall do it is no description of whom it is done to."""
        for phrase in phrases:
            if phrase.name.lower().split()[-1] in {"robot", "robots"} and phrase.name.lower() not in self.phrases.known:
                raise UnclearError(f"{phrase.text!r} does things; it is not clear what is to be done with it")
            short = self.advice.short_names
            words = phrase.name.lower().split()
            if (words[0] in short and len(words) > 1 and phrase.name.lower() not in self.phrases.known) or (
                phrase.name.lower() in short and (phrase.text.lower().startswith("the ") or not phrase.determined)
            ):
                raise UnclearError(
                    f"{phrase.text!r} may be a robot of the fleet; say 'with' or 'use' before it if it does something"
                )
            named = self.advice.named_in(phrase.text)
            if named and phrase.name.lower() not in self.phrases.known:
                raise UnclearError(self.advice.on(named[0]))

    def instruments(self, phrases: Iterable[Phrase]) -> None:
        """What it shall be done with is no description either, if it is no robot of the fleet."""
        for phrase in phrases:
            lows = phrase.description.lower().split()
            if lows[:1] == ["with"] and lows[-1] in self.lexicon.words["instruments"]:
                named = f"names no robot of the fleet ({self.advice.types})"
                raise UnclearError(f"{phrase.description!r} may say who does it, and {named}")

    def with_what(self, phrases: Iterable[Phrase]) -> None:
        """In "feed the lions with meat", a routine of the user may want to know of the meat."""
        for phrase in phrases:
            if phrase.description.lower().split()[:1] == ["with"]:
                raise UnclearError(f"it is not clear whether {phrase.description!r} says how it is done")

    def sent(self, phrases: Iterable[Phrase], verb: str) -> None:
        """Who sends a drone to the roof wants it to go there by itself."""
        for phrase in phrases if verb in {"send", "dispatch"} else ():
            name = phrase.name.lower()
            if name.split()[-1] in self.lexicon.words["movers"] and name not in self.phrases.known:
                lacks = f"names no robot of the fleet ({self.advice.types})"
                raise UnclearError(f"{phrase.text!r} may be meant to go there by itself, and {lacks}")

    def ridden(self, phrases: Iterable[Phrase], verb: str) -> None:
        """Who takes the bus to the stadium goes there by bus, and brings no bus."""
        for phrase in phrases if verb == "take" else ():
            name = phrase.name.lower()
            if (
                noun_of(name) in self.lexicon.words["vessels"] | self.lexicon.words["movers"] | _RIDDEN
                and name not in self.phrases.known
            ):
                raise UnclearError(f"{phrase.text!r} may be the way to go there; say 'bring' if it is to be brought")

    def companions(self, words: Iterable[Word], goals: Collection[str]) -> None:
        """In "go to the port together with Anna", nobody says whether Anna is to be brought there."""
        joined = {word.text.lower() for word in words} & {"together with", "along with"}
        if joined and set(goals) & {"reach", "search", "look at", "follow"}:
            raise UnclearError(f"it is not clear whether who stands behind {joined.pop()!r} comes along")

    def company(self, phrases: Iterable[Phrase], *, goes: bool) -> None:
        """In "the green box with the blue box", the second may be meant to come along."""
        for phrase in phrases:
            words = phrase.description.lower().split()
            if words[:1] == ["with"] and goes:
                raise UnclearError(f"it is not clear whether {phrase.description!r} says who or what comes along")
            name = " ".join(
                words[2:] if words[1:2] and words[1] in {"the", "a", "an", "his", "her", "its"} else words[1:]
            )
            if words[:1] == ["with"] and name in self.phrases.known:
                raise UnclearError(f"it is not clear whether {name!r} is meant as well; say 'and' if it is")
