"""Readings that fit the words and that nobody can have meant: each raises :class:`UnclearError` with a sentence that asks who is meant."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.language.verbs import english_verbs
from missiontree.authoring.methods.mention import Mention, UnclearError
from missiontree.authoring.methods.outline import Outline
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.places import stands_at
from missiontree.authoring.reading.plurals import noun_of, singular
from missiontree.authoring.reading.remarks import Read, Said
from missiontree.mission.scene import Scene

_KIN = frozenset({"brother", "sister", "son", "daughter", "child", "sibling", "cousin"})
_EVERYBODY = frozenset({"everyone", "everybody", "all", "anyone", "anybody", "others", "rest"})


@dataclass(frozen=True)
class Refusals:
    """What is held against a reading, in a world, by who knows nouns and small words."""

    world: Scene
    lexicon: Lexicon
    phrases: PhraseReader

    def each_its_own(self, read: Read) -> None:
        """To bring each parcel to its owner is more than one errand, and nobody knows how many."""
        phrases = [phrase for group in read.values() for phrase in group]
        own = [phrase for phrase in phrases if phrase.text.lower().split()[0] in {"its", "their", "his", "her"}]
        first, *later = read.values() if read else ((),)
        for phrase in (phrase for group in later for phrase in group):
            word = phrase.text.lower().split()[0]
            if word in {"each", "every"} or (word == "their" and len(first) > 1 and phrase.several):
                raise UnclearError(f"it is not clear who or what is meant for which of {phrase.text!r}")
        each = [phrase for phrase in phrases if phrase.text.lower().split()[0] in {"each", "every"}]
        if each and own:
            raise UnclearError(
                f"it is not clear who {own[0].text!r} is for each one of {each[0].text!r}; name them one by one"
            )

    def two_places(self, phrases: tuple[Phrase, ...]) -> None:
        """In "the child in the park and the forest" the forest is no second child."""
        where = phrases[-1].description.lower().split()[:1]
        shared = where and where[0] in {"in", "at", "on", "from"} and len(phrases) > 1
        if shared and any(phrase.several and not phrase.description for phrase in phrases[:-1]):
            raise UnclearError(
                f"it is not clear whether {phrases[-1].description!r} is said of {phrases[0].text} as well"
            )
        kinds = [self.phrases.kind_of(phrase) for phrase in phrases]
        for place, phrase in enumerate(phrases[:-1]):
            if phrase.description and kinds[place] != "place" and "place" in kinds[place + 1 :]:
                raise UnclearError(f"it is not clear what goes with {phrase.description!r}")

    def apposition(self, phrases: tuple[Phrase, ...], lows: Collection[str]) -> None:
        """In "find the driver, Mr Rossi" the second may be the name of the first."""
        people = all(self.phrases.kind_of(phrase) in {"person", "animal"} for phrase in phrases)
        if len(phrases) == 2 and people and "," in lows and not {"and", "&"} & set(lows):
            one, other = (phrase.text for phrase in phrases)
            raise UnclearError(
                f"it is not clear whether {other!r} is {one!r} or somebody else; say 'and' if they are two"
            )

    def belongings(self, phrases: tuple[Phrase, ...]) -> None:
        """In "the girl with the red shoes and hat" and "the box of nuts and bolts", the last is nothing by itself."""
        kinds = [self.phrases.kind_of(phrase) for phrase in phrases]
        for place, phrase in enumerate(phrases[:-1]):
            following, described = phrases[place + 1], phrase.description.lower().split()[:1]
            worn = described in (["with"], ["wearing"], ["carrying"]) and kinds[place] != "place"
            dressed = described == ["in"] and kinds[place : place + 2] == ["person", "object"]
            bare = not following.determined or kinds[place] != kinds[place + 1]
            of_both = " of " in phrase.name and phrase.name.lower() not in self.phrases.known
            if of_both or (bare and (worn or dressed)):
                raise UnclearError(f"it is not clear whether {following.text!r} belongs to {phrase.text!r}")

    def other_places(self, outline: Outline, said: Said) -> None:
        """A place that only says where somebody is must be where the scene has them."""
        world = self.world
        used = {mention.name for piece in outline.pieces for leaf in piece.leaves for mention in leaf.mentions}
        mentions = [mention for group in said.values() for mention in group if not mention.new]
        for site in (mention for mention in mentions if mention.kind == "place" and mention.name not in used):
            for mention in mentions:
                if (
                    mention.name in used
                    and stands_at(world.by_id[mention.name], world.by_id[site.name], world) is False
                ):
                    raise UnclearError(f"the scene has {mention.label} elsewhere, not at {site.label}")

    def evacuated(self, phrases: Iterable[Phrase]) -> None:
        """Whether "evacuate block B" is said of a block or of those in it, nobody knows who does not know blocks."""
        for phrase in phrases:
            noun, last = noun_of(phrase.name), phrase.name.split()[-1]
            known = phrase.name.lower() in self.phrases.known or noun in self.lexicon.words["vessels"]
            if phrase.pronoun or known or noun in _EVERYBODY:
                continue
            kind, numbered = self.phrases.kind_of(phrase), noun != last.lower()
            if (numbered and kind == "object") or (kind is None and (numbered or last.islower())):
                raise UnclearError(f"{phrase.text!r} may be a place, or somebody; say 'the people in {phrase.text}'")

    def compared(self, mentions: Iterable[Mention], said: Iterable[Iterable[Iterable[Mention]]]) -> None:
        """Who is new is not bigger than anybody, and not the biggest of those that were named."""
        named = {noun_of(singular(m.label.lower())) for groups in said for group in groups for m in group}
        for mention in mentions:
            words = mention.label.lower().split()
            compared = mention.new and set(words) & self.lexicon.words["comparatives"]
            superlative = mention.new and set(words) & self.lexicon.words["superlatives"]
            if words[-1] in _KIN:
                continue  # "her older brother"
            bare = words[-1] in self.lexicon.words["superlatives"] or "of" in words
            if compared or (superlative and (bare or noun_of(mention.label) in named)):
                raise UnclearError(f"it is not clear which one {mention.label!r} is; give it a name")

    def done_there(self, phrases: Iterable[Phrase]) -> None:
        """In "bring the guard tea to drink", nothing goes to a drink."""
        for phrase in phrases:
            name = phrase.name
            if not phrase.determined and name in english_verbs() and self.phrases.kind_of(phrase) in {None, "object"}:
                raise UnclearError(f"'to {name}' may say what it is for")
