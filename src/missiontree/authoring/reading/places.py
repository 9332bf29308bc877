"""Where the words say that something is, held against where the scene has it."""

from __future__ import annotations

from missiontree.authoring.reading.words import ARTICLES, POSSESSIVES
from missiontree.mission.entity import Entity
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene

_AT = frozenset({"in", "at", "inside", "from", "on"})
_BEING = frozenset({"is", "are", "stands", "stand", "lies", "lie", "sits", "sit", "waits", "wait", "lives", "works"})
_STAYING = frozenset(
    {"standing", "waiting", "sitting", "lying", "parked", "kept", "stored", "staying", "working", "located"}
)
_NUMBERS = frozenset(
    {"one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"}
)
_TITLES = {"prof": "professor", "dr": "doctor"}
_BEFORE_NAMES = ARTICLES | POSSESSIVES


def place_said(description: str, scene: Scene) -> Entity | None:
    """The one place or thing of the scene that a description such as "in the kitchen" names; None if it names none."""
    words = plain(description).split()
    if words[:1] and words[0] in {"who", "that", "which"}:
        words = words[1 + (words[1:2] != [] and words[1] in _BEING) :]
        words = words[words[:1] != [] and words[0] in _STAYING :]
    if len(words) < 2 or words[0] not in _AT:
        return None
    name = " ".join(words[1 + (words[1] in _BEFORE_NAMES) :])
    named = [entity for entity in scene.all_entities if name in spellings(entity)]
    return named[0] if len(named) == 1 else None


def stands_at(entity: Entity, place: Entity, scene: Scene) -> bool | None:
    """
    Whether the scene has an entity at a place; None if it does not say.

    An entity that has only a position is at the place that is nearest to it.
    """
    line = _line(entity, scene)
    if place.id in line:
        return True
    here, there = scene.whereabouts(entity), scene.whereabouts(place)
    same = here.position is not None and here.position == there.position
    if entity.place is not None:
        return None if entity.place in _line(place, scene) else same
    if here.source != "known" or here.position is None or there.position is None:
        return None
    reach = _distance(here.position, there.position)
    others = (scene.whereabouts(other).position for other in scene.places if other.id not in {place.id, entity.id})
    return all(reach <= _distance(here.position, other) for other in others if other is not None)


def _line(entity: Entity, scene: Scene) -> list[str]:
    """The place that an entity is at, the place where that is, and so on."""
    line: list[str] = []
    above = entity.place
    while above is not None and above not in line:
        line.append(above)
        above = scene.by_id[above].place
    return line


def plain(text: str) -> str:
    """The text as names are compared: small letters, words separated by single spaces."""
    words = text.casefold().replace("_", " ").replace("-", " ").replace(".", " ").split()
    return " ".join(_TITLES.get(word, word) if place + 1 < len(words) else word for place, word in enumerate(words))


def is_designation(word: str) -> bool:
    """Whether a word behind a noun tells it from others of the same noun: "ward 3", "ward three", "gallery A", "dock B2"."""
    return word in _NUMBERS or len(word) == 1 or any(sign.isdigit() for sign in word)


def spellings(entity: Entity) -> set[str]:
    """Everything an entity may be called."""
    return {plain(spelling) for spelling in (entity.id, entity.label, *entity.aliases)}


def _distance(one: Position, other: Position) -> float:
    """Squared, in the plane; what is on another floor is farther than anything else."""
    if one.floor != other.floor:
        return float("inf")
    return (one.x_m - other.x_m) ** 2 + (one.y_m - other.y_m) ** 2
