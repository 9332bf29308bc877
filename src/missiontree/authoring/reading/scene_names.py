"""Who of the scene is called so: by name, alias, kind or trait, and where the words say that they are."""

from __future__ import annotations

from dataclasses import dataclass, replace

from missiontree.authoring.matching import is_misspelt, listed
from missiontree.authoring.methods.mention import UnclearError
from missiontree.authoring.reading.phrase import Phrase, kind_of_phrase
from missiontree.authoring.reading.places import is_designation, place_said, plain, spellings, stands_at
from missiontree.authoring.reading.plurals import is_plural, singular
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene

# "All places" are all that the scene has, of whatever kind it says they are.
_BASES = {
    "place": ("place",),
    "location": ("place",),
    "site": ("place",),
    "object": ("object",),
    "thing": ("object",),
    "item": ("object",),
    "animal": ("animal",),
    "person": ("person",),
}
_PLURAL = {"place": "places", "object": "objects", "animal": "animals", "person": "people"}
_WHERE = ("in ", "at ", "inside ", "from ", "on ")


_BEHIND = frozenset({"of", "on", "in", "at", "for", "with", "to", "near", "by", "and", "&", "behind", "under", "from"})
_TITLES = frozenset(
    {
        "dr",
        "doctor",
        "mr",
        "mrs",
        "ms",
        "miss",
        "prof",
        "professor",
        "sir",
        "lady",
        "von",
        "van",
        "de",
        "der",
        "the",
        "of",
    }
)


@dataclass(frozen=True)
class SceneNames:
    """Looks for entities by what they are called; ``complete`` if somebody wrote down what the scene has."""

    scene: Scene
    complete: bool

    def alike(self, phrase: Phrase) -> list[Entity]:
        """Entities that go by the same noun, but for what is said before or behind it."""
        return [entity for entity in self.scene.all_entities if self._is_like(entity, phrase)]

    def called(self, phrase: Phrase) -> list[Entity]:
        everyone, name = self.scene.all_entities, plain(phrase.name)
        forms = _singular(name)
        one_of_all = phrase.other or (phrase.every and not is_plural(phrase.name))
        exact = [] if one_of_all else [e for e in everyone if spellings(e) & {name, plain(phrase.full)}]
        single = [e for e in everyone if spellings(e) & set(forms)]
        called = [e for e in everyone if self._is_called(e, name)]
        if phrase.several:
            bases = {base for form in forms for base in _BASES.get(form, ())}
            called = [e for e in everyone if e in single or e in called or self.scene.base_kind(e.kind) in bases]
            single = []
        owner, _, owned = name.partition("'s ")
        if owned and not (exact or single or called) and any(self._is_called(e, owner) for e in everyone):
            return self.called(replace(phrase, name=owned))
        groups = (exact, single, called)
        found = next((group for group in groups if group), [])
        return self._narrowed(found, phrase)

    def _is_like(self, entity: Entity, phrase: Phrase) -> bool:
        """Whether an entity goes by the same noun, but for what is said before or behind it."""
        words = plain(phrase.name).split()
        noun = words[-2] if len(words) > 1 and is_designation(words[-1]) else words[-1]
        return len(words) > 1 and self._is_called(entity, noun)

    def _is_called(self, entity: Entity, name: str) -> bool:
        *before, last = name.split()
        words = {word for spelling in spellings(entity) for word in spelling.split()}
        traits = {word for trait in entity.traits for word in plain(trait).split()}
        kinds = {plain(kind) for kind in self.scene.lineage(entity.kind)} - {"object", "place"}
        heads = {_head(spelling) for spelling in spellings(entity) if spelling} | kinds
        if self.scene.base_kind(entity.kind) == "person":
            heads |= {word for word in words if word not in _TITLES}
        heads |= {
            word
            for spelling in spellings(entity)
            for word in spelling.split()[-2:-1]
            if is_designation(spelling.split()[-1])
        }
        return any(form in heads for form in _singular(last)) and set(before) <= words | traits | kinds

    def _narrowed(self, found: list[Entity], phrase: Phrase) -> list[Entity]:
        """Those among several whose traits fit what is said of them."""
        if len(found) < 2:
            return found
        said = {word for part in (*phrase.states, *_adjectives(phrase)) for word in plain(part).split()}
        fitting = [e for e in found if said & {w for text in (*e.traits, *spellings(e)) for w in plain(text).split()}]
        if not fitting and phrase.lost:
            fitting = [entity for entity in found if self.scene.whereabouts(entity).source != "known"]
        if not fitting and phrase.several and phrase.states:
            states = " and ".join(phrase.states)
            raise UnclearError(f"the scene does not say which of {', '.join(e.label for e in found)} are {states}")
        return fitting or found

    def at_place(self, found: list[Entity], phrase: Phrase) -> list[Entity]:
        """Those that are where the words say; all if the scene does not know."""
        place = place_said(phrase.description, self.scene) if found else None
        if place is None:
            if found and self.complete and phrase.several and phrase.description.lower().startswith(_WHERE):
                raise UnclearError(f"the scene does not say which of {phrase.name} are {phrase.description!r}")
            return found
        stands = {entity.id: stands_at(entity, place, self.scene) for entity in found}
        there = [entity for entity in found if stands[entity.id]]
        if not there and phrase.several and len(found) > 1:
            raise UnclearError(
                f"the scene does not say which of {' and '.join(e.label for e in found)} are at {place.label}"
            )
        if not there and all(verdict is False for verdict in stands.values()):
            raise UnclearError(f"the scene has {' and '.join(e.label for e in found)} elsewhere, not at {place.label}")
        return there or found

    def refuse_misspelt(self, phrase: Phrase) -> None:
        """A name that is nearly one of the scene is no name of somebody new."""
        everyone = self.scene.all_entities
        near = [e for e in everyone if any(is_misspelt(phrase.name, s) for s in (e.id, e.label, *e.aliases))]
        if near:
            options = " or ".join(sorted({entity.label for entity in near}))
            raise UnclearError(
                f"nobody and nothing is called {phrase.name!r}; did you mean {options}? "
                "If not, declare who is meant in the scene"
            )

    def refuse_none(self, phrase: Phrase) -> None:
        """Several of which the scene has none are not one thing that it forgot."""
        if not (self.complete and phrase.several):
            return
        kind = kind_of_phrase(phrase)
        alike = [e.label for e in self.scene.all_entities if kind in {None, self.scene.base_kind(e.kind)}]
        raise UnclearError(
            f"the scene has no {phrase.name!r}; its {_PLURAL.get(kind or '', 'entities')} are {listed(alike)}. "
            "Name those that are meant, or declare them in the scene"
        )


def _head(spelling: str) -> str:
    """The noun of a name: house, in "house on the hill"."""
    words = spelling.split()
    end = next((at for at, word in enumerate(words) if at and word in _BEHIND), len(words))
    return words[end - 1]


def _adjectives(phrase: Phrase) -> tuple[str, ...]:
    """What a relative clause says a thing is: red, in "the crate that is red"."""
    words = phrase.description.lower().split()
    says = len(words) > 2 and words[0] in {"that", "which", "who"} and words[1] in {"is", "are"}
    return tuple(words[2:]) if says and not set(words) & _BEHIND else ()


def _singular(noun: str) -> list[str]:
    """The noun, and what it may be the plural of."""
    forms = [noun, singular(noun)]
    forms += [
        noun[: -len(end)] + instead for end, instead in (("ies", "y"), ("es", ""), ("s", "")) if noun.endswith(end)
    ]
    return forms
