"""Who is meant by a noun phrase: somebody of the scene, or, if the scene has none such, somebody to be introduced."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

from missiontree.authoring.language.kinds import is_abstract
from missiontree.authoring.matching import is_misspelt, listed
from missiontree.authoring.methods.mention import Mention, UnclearError, title
from missiontree.authoring.reading.ones import picked, with_noun
from missiontree.authoring.reading.phrases import Phrase, is_plural, kind_of_phrase, plural, singular
from missiontree.authoring.reading.places import is_designation, place_said, plain, spellings, stands_at
from missiontree.authoring.reading.pronouns import antecedent, fits
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
_EVERYBODY = frozenset({"everyone", "everybody", "anyone", "anybody"})


@dataclass
class Speakers:
    """All that was mentioned so far, in a world; ``complete`` if somebody wrote down what it has."""

    scene: Scene
    complete: bool = False
    described: dict[str, str] = field(default_factory=dict)
    said: list[list[tuple[Mention, ...]]] = field(default_factory=list)
    """Mentions clause by clause, those that were named together in one."""
    lost: set[str] = field(default_factory=set)
    """Names of those who were stated to be lost."""
    numbered: dict[str, tuple[Mention, ...]] = field(default_factory=dict)
    """Those who were introduced by their number, such as the three crates, by their noun."""

    starts: dict[str, str] = field(default_factory=dict)
    """Where somebody or something was taken from, by name."""

    def kept(self) -> Speakers:
        """A copy, to come back to if a way of reading a clause leads nowhere."""
        said = [list(groups) for groups in self.said]
        return replace(
            self,
            described=dict(self.described),
            said=said,
            lost=set(self.lost),
            numbered=dict(self.numbered),
            starts=dict(self.starts),
        )

    def joined(self, other: Speakers, clauses: int) -> Speakers:
        """These, with what another way of reading the clause under way has mentioned beside it."""
        mine, its = self.kept(), other.kept()
        for number in range(max(clauses - 1, 0), len(its.said)):
            if number == len(mine.said):
                mine.said.append([])
            mine.said[number] += [group for group in its.said[number] if group not in mine.said[number]]
        mine.described |= its.described
        mine.numbered |= its.numbered
        mine.starts |= its.starts
        return mine

    def next_clause(self) -> None:
        """What is said from now on belongs to a new clause."""
        if not self.said or self.said[-1]:
            self.said.append([])

    def remember(self, groups: tuple[tuple[Mention, ...], ...]) -> None:
        """Keep what was mentioned, for pronouns."""
        self.said[-1].extend(groups)

    def resolved(
        self, phrases: Sequence[Phrase], slot: int, kind: str = "", beside: Collection[str] = ()
    ) -> tuple[Mention, ...]:
        """
        Who is meant by phrases that stand together, in a slot by number; see :meth:`resolve`.

        A noun that is not known is taken to be of ``kind``, if the slot is for that kind alone.
        """
        found: tuple[Mention, ...] = ()
        for phrase in phrases:
            found += self.resolve(with_noun(phrase, self.said, slot, found), kind, beside)
        return found

    def came_from(self, read: Mapping[str, tuple[Phrase, ...]], said: Mapping[str, tuple[Mention, ...]]) -> None:
        """Keep where things were taken from, for what is brought back."""
        for slot, phrases in read.items():
            for phrase in phrases:
                preposition, _, place = phrase.description.partition(" ")
                if preposition.lower() == "from":
                    start = re.sub(r"^(the|a|an|my|our|her|his|their) ", "", place, flags=re.IGNORECASE)
                    self.starts |= {mention.name: start for mention in said[slot]}

    def moved(self, phrase: Phrase) -> tuple[Mention, ...]:
        """Who is meant by what is brought back; of several that a pronoun may mean, the one that was taken from somewhere."""
        try:
            return self.kept().resolve(phrase)
        except UnclearError:
            groups = next((groups for groups in reversed(self.said) if groups), [])
            taken = {m.name: m for group in groups for m in group if m.name in self.starts and fits(m, phrase)}
            if not phrase.pronoun or len(taken) != 1:
                raise
            return tuple(taken.values())

    def start_of(self, mention: Mention) -> str:
        """Where somebody or something was taken from, or is by the scene; empty if nobody knows."""
        if mention.name in self.starts:
            return self.starts[mention.name]
        entity = self.scene.by_id.get(mention.name)
        place = self.scene.by_id.get(entity.place) if entity is not None and entity.place is not None else None
        return place.label if place is not None else ""

    def resolve(self, phrase: Phrase, expected: str = "", beside: Collection[str] = ()) -> tuple[Mention, ...]:
        """
        Who is meant: one, or for a plural all of the scene that it fits.

        Raises
        ------
        UnclearError
            If it may be several, or nobody.
        """
        if phrase.pronoun:
            return tuple(self._again(mention) for mention in antecedent(phrase, self.said, beside))
        if phrase.name.lower() in _EVERYBODY:
            phrase = replace(phrase, name="people" if self.complete else phrase.name)
        if group := self._numbered(phrase):
            return tuple(self._again(mention) for mention in group)
        found = self._at_place(self._in_scene(phrase), phrase)
        if found and phrase.ordinal:
            raise UnclearError(f"{phrase.text!r} may be any of {listed(sorted(e.id for e in found))}; say which one")
        if found and phrase.other:
            several = replace(phrase, every=True)
            among = tuple(self._of_scene(entity, phrase) for entity in self._at_place(self._in_scene(several), several))
            return picked(phrase, among, self.said)
        if phrase.count is not None and found and len(found) != phrase.count:
            options = listed(sorted(entity.id for entity in found))
            raise UnclearError(f"{phrase.text!r} are {phrase.count}, and the scene has {len(found)}: {options}")
        if len(found) > 1 and not phrase.several:
            options = ", ".join(sorted(entity.id for entity in found))
            raise UnclearError(f"{phrase.text!r} may be any of {options}; say which one")
        if found:
            return tuple(self._of_scene(entity, phrase) for entity in found)
        if like := [entity for entity in self.scene.all_entities if self._is_like(entity, phrase)]:
            options = ", ".join(sorted(entity.label for entity in like))
            raise UnclearError(f"the scene has {options}, and none of them is called {phrase.name!r}")
        self._refuse_misspelt(phrase)
        self._refuse_none(phrase)
        if phrase.ordinal:
            raise UnclearError(f"it is not clear what {phrase.text!r} means; give it a name")
        if phrase.count is not None:
            return self._counted(phrase)
        return (self._introduced(phrase, expected),)

    def _numbered(self, phrase: Phrase) -> tuple[Mention, ...]:
        """Those introduced by number whom a phrase means: "the crates", "the other crate", "the second one"."""
        group = self.numbered.get(singular(plain(phrase.name)), ())
        if not group or not (phrase.several or phrase.other or phrase.ordinal):
            return ()
        if phrase.other or phrase.ordinal:
            return picked(phrase, group, self.said)
        if phrase.count not in {None, len(group)}:
            raise UnclearError(f"{phrase.text!r} are {phrase.count}, and before they were {len(group)}")
        return group

    def _counted(self, phrase: Phrase) -> tuple[Mention, ...]:
        """As many as the words say, numbered."""
        assert phrase.count is not None
        *before, noun = phrase.name.split()
        one = " ".join((*before, singular(noun.lower()) if noun.islower() else singular(noun)))
        alone = replace(phrase, name=one, count=None, every=False, determined=True)
        first = self._introduced(alone)
        group = tuple(
            replace(
                first, name=f"{first.name} {number}", label=f"{first.label} {number}", full=f"{first.full} {number}"
            )
            for number in range(1, phrase.count + 1)
        )
        self.numbered[singular(plain(phrase.name))] = group
        return group

    def _refuse_misspelt(self, phrase: Phrase) -> None:
        """A name that is nearly one of the scene is no name of somebody new."""
        everyone = self.scene.all_entities
        near = [e for e in everyone if any(is_misspelt(phrase.name, s) for s in (e.id, e.label, *e.aliases))]
        if near:
            options = " or ".join(sorted({entity.label for entity in near}))
            raise UnclearError(
                f"nobody and nothing is called {phrase.name!r}; did you mean {options}? "
                "If not, declare who is meant in the scene"
            )

    def _refuse_none(self, phrase: Phrase) -> None:
        """Several of which the scene has none are not one thing that it forgot."""
        if not (self.complete and phrase.several):
            return
        kind = kind_of_phrase(phrase)
        alike = [e.label for e in self.scene.all_entities if kind in {None, self.scene.base_kind(e.kind)}]
        raise UnclearError(
            f"the scene has no {phrase.name!r}; its {_PLURAL.get(kind or '', 'entities')} are {listed(alike)}. "
            "Name those that are meant, or declare them in the scene"
        )

    def implied(self, name: str, kind: str, known_as: tuple[str, ...] = ()) -> Mention:
        """Somebody whom a method needs: of the scene under one of the names, or introduced."""
        for spelling in (*known_as, name):
            phrase = Phrase(name=spelling, text=spelling)
            exact = [entity for entity in self.scene.all_entities if plain(spelling) in spellings(entity)]
            if len(exact) == 1:
                return self._of_scene(exact[0], phrase)
            if len(exact) > 1:
                raise UnclearError(
                    f"{spelling!r} may be any of {', '.join(sorted(e.id for e in exact))}; say which one"
                )
        return Mention(
            name=name,
            label=name,
            full=name,
            kind=kind,
            determined=False,
            plural=is_plural(name.split(" of ", maxsplit=1)[0]),
        )

    def _in_scene(self, phrase: Phrase) -> list[Entity]:
        everyone, name = self.scene.all_entities, plain(phrase.name)
        forms = _singular(name)
        exact = [e for e in everyone if spellings(e) & {name, plain(phrase.full)}]
        single = [e for e in everyone if spellings(e) & set(forms)]
        called = [e for e in everyone if self._is_called(e, name)]
        if phrase.several:
            bases = {base for form in forms for base in _BASES.get(form, ())}
            called = [e for e in everyone if e in single or e in called or self.scene.base_kind(e.kind) in bases]
            single = []
        owner, _, owned = name.partition("'s ")
        if owned and not (exact or single or called) and any(self._is_called(e, owner) for e in everyone):
            return self._in_scene(replace(phrase, name=owned))
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
        heads = {spelling.split()[-1] for spelling in spellings(entity) if spelling} | kinds
        if self.scene.base_kind(entity.kind) == "person":
            heads |= {spelling.split()[0] for spelling in spellings(entity) if spelling}
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
        said = {word for part in (*phrase.states, phrase.description) for word in plain(part).split()}
        fitting = [e for e in found if said & {w for text in (*e.traits, *spellings(e)) for w in plain(text).split()}]
        if not fitting and phrase.lost:
            fitting = [entity for entity in found if self.scene.whereabouts(entity).source != "known"]
        if not fitting and phrase.several and phrase.states:
            states = " and ".join(phrase.states)
            raise UnclearError(f"the scene does not say which of {', '.join(e.label for e in found)} are {states}")
        return fitting or found

    def _of_scene(self, entity: Entity, phrase: Phrase) -> Mention:
        states = " ".join(title(state) for state in phrase.states)
        return Mention(
            name=entity.id,
            label=entity.label,
            full=f"{states} {entity.label}".strip(),
            kind=self.scene.base_kind(entity.kind),
            determined=phrase.determined,
            new=False,
            known=self.scene.whereabouts(entity).source == "known",
            lost=phrase.lost or entity.id in self.lost,
            plural=phrase.several,
        )

    def _introduced(self, phrase: Phrase, expected: str = "") -> Mention:
        if is_abstract(phrase.name) and not phrase.is_own_name and expected != "place":
            raise UnclearError(f"{phrase.text!r} is nothing that a robot can find, reach or carry")
        everybody = phrase.name.lower() in _EVERYBODY
        if phrase.other and not phrase.several:
            phrase = replace(phrase, name=f"other {phrase.name}")
        elif phrase.every and not (everybody or phrase.count):
            phrase = replace(phrase, name=plural(phrase.name))
        label = title(phrase.name)
        described = self.described.setdefault(label.lower(), phrase.description)
        if phrase.description and described != phrase.description:
            raise UnclearError(
                f"it is not clear whether {phrase.text!r} is the {phrase.name} of before; give them different names"
            )
        several, kind = phrase.several, "person" if everybody else kind_of_phrase(phrase)
        kind = kind or expected or None
        if kind is None and not (phrase.determined or several or is_designation(phrase.name.split()[-1].lower())):
            raise UnclearError(f"{phrase.text!r} is no noun that is known; say 'the {phrase.name}' if it is a thing")
        return Mention(
            label,
            label,
            title(phrase.full),
            kind or "object",
            determined=phrase.determined,
            lost=phrase.lost or label in self.lost,
            plural=several,
        )

    def _at_place(self, found: list[Entity], phrase: Phrase) -> list[Entity]:
        """Those that are where the words say; all if the scene does not know."""
        place = place_said(phrase.description, self.scene) if found else None
        if place is None:
            if found and self.complete and phrase.several and phrase.description.lower().startswith(_WHERE):
                raise UnclearError(f"the scene does not say which of {phrase.name} are {phrase.description!r}")
            return found
        stands = {entity.id: stands_at(entity, place, self.scene) for entity in found}
        there = [entity for entity in found if stands[entity.id]]
        if not there and all(verdict is False for verdict in stands.values()):
            raise UnclearError(f"the scene has {' and '.join(e.label for e in found)} elsewhere, not at {place.label}")
        return there or found

    def _again(self, mention: Mention) -> Mention:
        """Somebody who is spoken of again; still lost if a statement said so."""
        return replace(mention, lost=mention.name in self.lost, determined=True)


def _singular(noun: str) -> list[str]:
    """The noun, and what it may be the plural of."""
    forms = [noun, singular(noun)]
    forms += [
        noun[: -len(end)] + instead for end, instead in (("ies", "y"), ("es", ""), ("s", "")) if noun.endswith(end)
    ]
    return forms
