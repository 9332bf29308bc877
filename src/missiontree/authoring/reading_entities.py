"""Who is meant by a noun phrase: somebody of the scene, or, if the scene has none such, somebody to be introduced."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from missiontree.authoring.kinds import kind_of
from missiontree.authoring.reading_phrases import Phrase, is_plural
from missiontree.mission.scene import Entity, Scene

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
    """All that was mentioned so far, in a world."""

    scene: Scene
    described: dict[str, str] = field(default_factory=dict)
    said: list[list[Mention]] = field(default_factory=list)
    """Mentions clause by clause."""

    def next_clause(self) -> None:
        """What is said from now on belongs to a new clause."""
        if not self.said or self.said[-1]:
            self.said.append([])

    def remember(self, mentions: tuple[Mention, ...]) -> None:
        """Keep what was mentioned, for pronouns."""
        self.said[-1].extend(mentions)

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
        found = self._in_scene(phrase)
        if len(found) > 1 and not is_plural(phrase.name):
            options = ", ".join(sorted(entity.id for entity in found))
            raise UnclearError(f"{phrase.text!r} may be any of {options}; say which one")
        if found:
            return tuple(self._of_scene(entity, phrase) for entity in found)
        return (self._introduced(phrase),)

    def implied(self, name: str, kind: str, known_as: tuple[str, ...] = ()) -> Mention:
        """Somebody whom a method needs: of the scene under one of the names, or introduced."""
        for spelling in (*known_as, name):
            phrase = Phrase(name=spelling, text=spelling)
            exact = [entity for entity in self.scene.all_entities if _plain(spelling) in _spellings(entity)]
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
        everyone, name = self.scene.all_entities, _plain(phrase.name)
        forms = _singular(name)
        groups = (
            [e for e in everyone if _spellings(e) & {name, _plain(phrase.full)}],
            [e for e in everyone if _spellings(e) & set(forms)],
            [e for e in everyone if self._is_called(e, name)],
        )
        found = next((group for group in groups if group), [])
        return self._narrowed(found, phrase)

    def _is_called(self, entity: Entity, name: str) -> bool:
        *before, last = name.split()
        words = {word for spelling in _spellings(entity) for word in spelling.split()}
        traits = {word for trait in entity.traits for word in _plain(trait).split()}
        kinds = {_plain(kind) for kind in self.scene.lineage(entity.kind)} - {"object", "place"}
        heads = {spelling.split()[-1] for spelling in _spellings(entity) if spelling} | kinds
        heads |= {
            word
            for spelling in _spellings(entity)
            for word in spelling.split()[-2:-1]
            if spelling.split()[-1].isdigit()
        }
        return any(form in heads for form in _singular(last)) and set(before) <= words | traits | kinds

    def _narrowed(self, found: list[Entity], phrase: Phrase) -> list[Entity]:
        """Those among several whose traits fit what is said of them."""
        if len(found) < 2:
            return found
        said = {word for part in (*phrase.states, phrase.description) for word in _plain(part).split()}
        fitting = [e for e in found if said & {word for trait in e.traits for word in _plain(trait).split()}]
        if not fitting and phrase.lost:
            fitting = [entity for entity in found if self.scene.whereabouts(entity).source != "known"]
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
            lost=phrase.lost,
            plural=is_plural(phrase.name),
        )

    def _introduced(self, phrase: Phrase) -> Mention:
        label = title(phrase.name)
        described = self.described.setdefault(label.lower(), phrase.description)
        if phrase.description and described != phrase.description:
            raise UnclearError(
                f"it is not clear whether {phrase.text!r} is the {phrase.name} of before; give them different names"
            )
        proper = not phrase.determined and phrase.name[:1].isupper()
        numbered = phrase.name.rsplit(" ", 1)[0] if phrase.name[-1].isdigit() else phrase.name
        kind = kind_of(numbered) or ("person" if proper else "object")
        plural = is_plural(phrase.name)
        return Mention(
            label, label, title(phrase.full), kind, determined=phrase.determined, lost=phrase.lost, plural=plural
        )

    def _antecedent(self, phrase: Phrase) -> tuple[Mention, ...]:
        """Whom a pronoun means: somebody of the clause under way or of those before, the nearest first."""
        for mentions in reversed(self.said):
            fitting = list(dict.fromkeys(replace(m, lost=False) for m in mentions if _fits(m, phrase)))
            if phrase.pronoun == "several":
                fitting = [m for m in fitting if m.plural] or fitting
            if len({mention.name for mention in fitting}) == 1 or (fitting and phrase.pronoun == "several"):
                return tuple({mention.name: replace(mention, determined=True) for mention in fitting}.values())
            if fitting:
                options = " or ".join(mention.label for mention in fitting)
                raise UnclearError(f"{phrase.text!r} may mean {options}; say which one")
        raise UnclearError(f"it is not clear what {phrase.text!r} means")


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
    return mention.kind in {"object", "animal"} and not mention.plural


def _plain(text: str) -> str:
    return " ".join(text.casefold().replace("_", " ").replace("-", " ").split())


def _spellings(entity: Entity) -> set[str]:
    return {_plain(spelling) for spelling in (entity.id, entity.label, *entity.aliases)}


def _singular(noun: str) -> list[str]:
    irregular = {"people": "person", "men": "man", "women": "woman", "children": "child", "mice": "mouse"}
    forms = [noun, irregular.get(noun, noun)]
    forms += [
        noun[: -len(end)] + instead for end, instead in (("ies", "y"), ("es", ""), ("s", "")) if noun.endswith(end)
    ]
    return forms
