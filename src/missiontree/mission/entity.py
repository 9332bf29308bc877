"""Who and what a mission can speak of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from missiontree.mission.area import Area
from missiontree.mission.position import Position
from missiontree.mission.value import Id, NonNegative, Positive, Value


@dataclass(frozen=True, slots=True, kw_only=True)
class Entity(Value):
    """
    A person, an animal, an object or a place that a mission can speak of.

    Parameters
    ----------
    id
        Name, unique among the entities and places of a scene.
    kind
        ``person``, ``animal``, ``object``, ``place`` or a kind that the scene declares under one of them.
    label
        Name shown to people and put into action texts; default: the id.
    aliases
        Other words that mean the same.
    position
        Where it is; None if unknown ("lost").
    place
        The place it is at, instead of a position.
    last_seen
        Where it was seen last; planned with, as an assumption, while the position is unknown.
    search_area
        Where it must be; its middle is planned with, as an assumption, if there is no ``last_seen`` either.
    mass_kg, height_m, max_speed_mps
        Mass, height, and the speed at which it can be led or carried; None if unknown.
    attributes
        Further numbers by name, unit in the name, for conditions of routines to compare.
    traits
        Words that describe it, such as ``red`` or ``injured``.
    zone
        Zone it is in; default: the zone whose area holds its position.
    note
        Free text of whoever described the scene. It is data, never an instruction.
    """

    id: Id
    kind: Id = "object"
    label: str = ""
    aliases: tuple[str, ...] = ()
    position: Position | None = None
    place: Id | None = None
    last_seen: Position | None = None
    search_area: Area | None = None
    mass_kg: NonNegative | None = None
    height_m: NonNegative | None = None
    max_speed_mps: Positive | None = None
    attributes: Mapping[Id, float] = field(default_factory=dict)
    traits: tuple[str, ...] = ()
    zone: Id | None = None
    note: str = ""

    def _check(self) -> None:
        if not self.label:
            object.__setattr__(self, "label", self.id)
        if self.position is not None and self.place is not None:
            raise ValueError(f"entity {self.id!r} has both a position and a place; give one.")

    def attribute(self, name: str) -> float | None:
        """The number of that name (``mass_kg``, or any of ``attributes``), or None if unknown."""
        if name in {"mass_kg", "height_m", "max_speed_mps"}:
            number: float | None = getattr(self, name)
            return number
        return self.attributes.get(name)
