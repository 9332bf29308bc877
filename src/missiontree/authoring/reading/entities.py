"""Who is meant by a noun phrase: somebody of the scene, or, if the scene has none such, somebody to be introduced."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from missiontree.authoring.matching import is_misspelt, listed
from missiontree.authoring.reading.phrases import Phrase, is_plural, kind_of_phrase
from missiontree.authoring.reading.places import is_designation, place_said, plain, spellings, stands_at
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene

_SMALL = frozenset(
    {
        "the",
        "a",
        "an",
        "and",
        "or",
        "of",
        "in",
        "on",
        "at",
        "to",
        "with",
        "for",
        "from",
        "by",
        "into",
        "her",
        "his",
        "its",
        "their",
    }
)


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
_INFANTS = frozenset({"child", "baby", "infant", "toddler"})  # may be "it"


@dataclass(frozen=True, slots=True)
class Mention:
    """
    Somebody or something, as the calls name it.

    Parameters
    ----------
    name
        Id of an entity of the scene, or the name under which it is introduced.
    label, full
        What people read, without and with its states.
    kind
        Its base kind.
    determined
        Whether "the" goes before it.
    new
        Whether the scene does not have it.
    known
        Whether the scene knows where it is.
    lost
        Whether the words say that it is lost.
    plural
        Whether it is more than one.
    """

    name: str
    label: str
    full: str
    kind: str
    determined: bool = True
    new: bool = True
    known: bool = False
    lost: bool = False
    plural: bool = False

    @property
    def to_be_found(self) -> bool:
        """Whether it has to be searched for before anything else is done with it."""
        return self.lost or (not self.new and not self.known and self.kind != "place")


class UnclearError(Exception):
    """What is meant cannot be said; carries a sentence that asks. Never leaves the reading of a clause."""


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

    def next_clause(self) -> None:
        """What is said from now on belongs to a new clause."""
        if not self.said or self.said[-1]:
            self.said.append([])

    def remember(self, groups: tuple[tuple[Mention, ...], ...]) -> None:
        """Keep what was mentioned, for pronouns."""
        self.said[-1].extend(groups)

    def resolve(self, phrase: Phrase) -> tuple[Mention, ...]:
        """
        Who is meant: one, or for a plural all of the scene that it fits.

        Raises
        ------
        UnclearError
            If it may be several, or nobody.
        """
        if phrase.pronoun:
            return self._antecedent(phrase)
        found = self._at_place(self._in_scene(phrase), phrase)
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
        return (self._introduced(phrase),)

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
        fitting = [e for e in found if said & {word for trait in e.traits for word in plain(trait).split()}]
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

    def _introduced(self, phrase: Phrase) -> Mention:
        label = title(phrase.name)
        described = self.described.setdefault(label.lower(), phrase.description)
        if phrase.description and described != phrase.description:
            raise UnclearError(
                f"it is not clear whether {phrase.text!r} is the {phrase.name} of before; give them different names"
            )
        plural, kind = phrase.several, kind_of_phrase(phrase)
        if kind is None and not (phrase.determined or plural or phrase.name[-1].isdigit()):
            raise UnclearError(f"{phrase.text!r} is no noun that is known; say 'the {phrase.name}' if it is a thing")
        return Mention(
            label,
            label,
            title(phrase.full),
            kind or "object",
            determined=phrase.determined,
            lost=phrase.lost or label in self.lost,
            plural=plural,
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

    def _antecedent(self, phrase: Phrase) -> tuple[Mention, ...]:
        """Whom a pronoun means: somebody of the clause under way or of those before, the nearest first."""
        if phrase.pronoun == "several":
            return self._antecedents(phrase)
        for groups in reversed(self.said):
            fitting = {m.name: m for group in groups for m in group if _fits(m, phrase)}
            if len(fitting) == 1:
                return tuple(self._again(mention) for mention in fitting.values())
            if fitting:
                raise _which(phrase, fitting.values())
        raise UnclearError(f"it is not clear what {phrase.text!r} means")

    def _antecedents(self, phrase: Phrase) -> tuple[Mention, ...]:
        """Whom "them" means: those named together in the nearest clause, or else the two that were named one by one."""
        single: dict[str, Mention] = {}
        for groups in reversed(self.said):
            fitting = [[m for m in group if _fits(m, phrase)] for group in groups]
            together = [group for group in fitting if len(group) > 1 or any(m.plural for m in group)]
            if len(together) > 1:
                raise _which(phrase, (mention for group in together for mention in group))
            if together and not single:
                return tuple({m.name: self._again(m) for m in together[0]}.values())
            single |= {m.name: m for group in fitting for m in group if m.name not in single}
            if together:
                raise _which(phrase, single.values())
        if len(single) == 2:
            return tuple(self._again(single[name]) for name in sorted(single, key=self._first_said))
        if single:
            raise _which(phrase, single.values())
        raise UnclearError(f"it is not clear what {phrase.text!r} means")

    def _first_said(self, name: str) -> int:
        everybody = (mention.name for groups in self.said for group in groups for mention in group)
        return list(everybody).index(name)

    def _again(self, mention: Mention) -> Mention:
        """Somebody who is spoken of again; still lost if a statement said so."""
        return replace(mention, lost=mention.name in self.lost, determined=True)


def _which(phrase: Phrase, mentions: Iterable[Mention]) -> UnclearError:
    options = " or ".join(dict.fromkeys(mention.label for mention in mentions))
    return UnclearError(f"{phrase.text!r} may mean {options}; say which one")


def title(text: str) -> str:
    """The text as a heading: small words small, all others with a capital letter."""
    words = text.split()
    return " ".join(
        word if index and word.lower() in _SMALL else word[:1].upper() + word[1:] for index, word in enumerate(words)
    )


def _fits(mention: Mention, phrase: Phrase) -> bool:
    if phrase.pronoun == "place":
        return mention.kind == "place"
    if phrase.pronoun == "person":
        return mention.kind in {"person", "animal"} and not mention.plural
    if phrase.pronoun == "several":
        return mention.kind != "place"
    infant = mention.name.lower().split()[-1] in _INFANTS
    return (mention.kind in {"object", "animal"} or infant) and not mention.plural


def _singular(noun: str) -> list[str]:
    irregular = {"people": "person", "men": "man", "women": "woman", "children": "child", "mice": "mouse"}
    forms = [noun, irregular.get(noun, noun)]
    forms += [
        noun[: -len(end)] + instead for end, instead in (("ies", "y"), ("es", ""), ("s", "")) if noun.endswith(end)
    ]
    return forms
