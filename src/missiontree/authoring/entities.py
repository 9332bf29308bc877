"""Who and what a call may speak of: the scene's entities, the introduced ones, and without a scene the words of the mission."""

from __future__ import annotations

from collections.abc import Iterable

from missiontree.authoring.answer import refuse
from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.matching import did_you_mean, listed, quoted, same_name, words_of
from missiontree.authoring.naming import make_id
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.reason import Reason
from missiontree.mission.scene import BASE_KINDS, Scene


class Cast:
    """
    The entities of a mission while one call is looked at; what it introduces on the spot is kept in ``added``.

    Parameters
    ----------
    brief
        The mission, with its scene if it has one.
    introduced
        Entities introduced by earlier calls.
    """

    def __init__(self, brief: MissionBrief, introduced: tuple[Entity, ...]) -> None:
        self.brief = brief
        self.introduced = introduced
        self.added: list[Entity] = []
        self.assumptions: list[Reason] = []
        self._scene: tuple[int, Scene] | None = None

    @property
    def everyone(self) -> tuple[Entity, ...]:
        """All entities there are, the scene's first."""
        return (*self.brief.world.all_entities, *self.introduced, *self.added)

    @property
    def scene(self) -> Scene:
        """The world with the introduced entities."""
        more = (*self.introduced, *self.added)
        if self._scene is None or self._scene[0] != len(more):  # entities are only ever added
            self._scene = (len(more), self.brief.world.extended(more))
        return self._scene[1]

    def find(self, name: str) -> Entity | None:
        """
        The entity of that id, label or alias, letter case aside; None if there is none.

        Raises
        ------
        RefusalError
            If several entities are called that.
        """
        exact = [entity for entity in self.everyone if entity.id == name]
        wanted = same_name(name)
        called = exact or [entity for entity in self.everyone if wanted in names_of(entity)]
        if len(called) > 1:
            ids = listed(entity.id for entity in called)
            raise refuse(
                "ambiguous_name", f"{quoted(name)} may be any of {ids}.", node=name[:200], hint="Use one of these ids."
            )
        return called[0] if called else None

    def resolve(self, name: str) -> Entity:
        """
        The entity of that name. Without a scene, a word of the mission becomes an entity on the spot, its kind an assumption.

        Raises
        ------
        RefusalError
            ``unknown_entity`` with the nearest names.
        """
        found = self.find(name)
        if found is not None:
            return found
        if self.brief.scene is None and is_said(name, self.brief.words):
            return self.introduce(name, None)
        known = [entity.label for entity in self.everyone]
        hint = did_you_mean(name, [spelling for entity in self.everyone for spelling in _spellings(entity)])
        way_out = "introduceEntity makes a new one; its position is then unknown."
        raise refuse(
            "unknown_entity",
            f"There is no entity {quoted(name)}. Known are: {listed(known)}.",
            node=name[:200],
            hint=f"{hint} {way_out}".strip(),
        )

    def introduce(self, name: str, kind: str | None) -> Entity:
        """A new entity at an unknown position; a kind that is not given is taken from the noun, and said to be."""
        taken = {entity.id for entity in self.everyone}
        guessed = kind_of(name)
        entity = Entity(id=make_id(name, taken, "entity"), kind=kind or guessed or "object", label=name)
        self.added.append(entity)
        because = (
            "as introduced"
            if kind
            else "going by the word"
            if guessed
            else "since the word is not in the list of nouns"
        )
        self.assumptions.append(
            Reason(
                rule="entity_introduced",
                message=f"{name} is taken to be of kind {entity.kind}, {because}; its position is unknown.",
                severity="assumption",
                node=entity.id,
                hint=""
                if kind
                else "If that is wrong, declare it under entities: in the mission file or in the scene.",
            )
        )
        return entity


def names_of(entity: Entity) -> set[str]:
    """Everything an entity may be called, in the form in which names are compared."""
    return {same_name(spelling) for spelling in _spellings(entity)}


def known_kinds(scene: Scene) -> tuple[str, ...]:
    """The base kinds, then those that the scene declares."""
    return (*BASE_KINDS, *scene.kinds)


def is_said(name: str, text: str) -> bool:
    """Whether the name stands in the text, as whole words."""
    wanted, words = words_of(name), words_of(text)
    width = len(wanted)
    return width > 0 and any(words[start : start + width] == wanted for start in range(len(words) - width + 1))


def nouns_said(text: str) -> tuple[str, ...]:
    """Words of the text that are known to name a person, an animal, an object or a place; each once, in order."""
    return tuple(dict.fromkeys(word for word in words_of(text) if kind_of(word) is not None))


def _spellings(entity: Entity) -> Iterable[str]:
    return (entity.id, entity.label, *entity.aliases)
