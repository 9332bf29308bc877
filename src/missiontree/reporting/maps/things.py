"""What stands and lies on a map."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.area import Area
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene

ThingKind = Literal["place", "person", "animal", "object", "robot", "lift", "node"]
KINDS: tuple[ThingKind, ...] = ("place", "lift", "person", "animal", "object", "robot", "node")
"""In the order in which things that stand at one point are named."""


@dataclass(frozen=True, slots=True)
class Thing:
    """
    Somebody or something at a point.

    Parameters
    ----------
    id
        Id in the scene or fleet; of robots that are alike, the type's.
    label
        What people read.
    kind
        Base kind, or what else it is.
    spot
        Where, in frame ``map``.
    note
        What else there is to say of it, for those who point at it.
    sure
        False if it is only taken to be there.
    count
        How many there are, all alike.
    """

    id: str
    label: str
    kind: ThingKind
    spot: Position
    note: str = ""
    sure: bool = True
    count: int = 1


@dataclass(frozen=True, slots=True)
class Missing:
    """
    Somebody or something whose position is not known.

    Parameters
    ----------
    id, label, kind
        As of things.
    note
        Where it is planned to be, if anywhere.
    """

    id: str
    label: str
    kind: ThingKind
    note: str


@dataclass(frozen=True, slots=True)
class ShownArea:
    """
    An area with a name.

    Parameters
    ----------
    label
        What people read.
    role
        What it is; of a search area, somebody who is missing may be anywhere in it.
    area
        Its extent.
    note
        For those who point at it.
    """

    label: str
    role: Literal["zone", "keep_out", "search_area"]
    area: Area
    note: str


@dataclass(frozen=True, slots=True)
class ShownRoad:
    """
    A road between two points of one floor.

    Parameters
    ----------
    start, end
        Its ends, in frame ``map``.
    one_way, blocked
        As in the scene.
    limited
        Whether only some robot types may use it.
    note
        For those who point at it.
    """

    start: Position
    end: Position
    one_way: bool
    blocked: bool
    limited: bool
    note: str


@dataclass(frozen=True, slots=True)
class MapContent:
    """
    All that a map shows before anybody moves. Equal for all alternatives of a plan.

    Parameters
    ----------
    scene
        The world, introduced entities included.
    things
        What stands at a point: places first, then what joins floors, entities, robots at their start, road nodes.
    missing
        Entities of unknown position, in the order of the scene.
    areas
        Zones, keep-outs and search areas.
    roads
        Roads of one floor each.
    floors
        Floors with something on them, in the order in which the scene names them.
    """

    scene: Scene
    things: tuple[Thing, ...]
    missing: tuple[Missing, ...]
    areas: tuple[ShownArea, ...]
    roads: tuple[ShownRoad, ...]
    floors: tuple[str, ...]
