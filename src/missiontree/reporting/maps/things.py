"""What stands and lies on a map."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.area import Area
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.reporting.escape import one_line

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
    closed_to
        Labels of the only robot types that a keep-out holds for; None (default): it is closed to all of the fleet.
    """

    label: str
    role: Literal["zone", "keep_out", "search_area"]
    area: Area
    note: str
    closed_to: tuple[str, ...] | None = None

    @property
    def closed_words(self) -> str:
        """For whom a keep-out holds that does not hold for all; empty if it does."""
        if self.closed_to is None:
            return ""
        return f"closed to {', '.join(map(one_line, self.closed_to)) or 'nobody'}"


@dataclass(frozen=True, slots=True)
class ShownRoad:
    """
    A road between two points of one floor.

    Parameters
    ----------
    start, end
        Its ends, in frame ``map``.
    one_way
        As in the scene.
    blocked
        Whether nobody may use it: by the scene, or since it passes through an area that is closed to all of the fleet.
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

    @property
    def floor_words(self) -> str:
        """What signs of kind ``lift`` stand for: lifts, and perhaps roads from floor to floor."""
        roads = self.scene.roads.roads if self.scene.roads is not None else ()
        points = self.scene.road_points
        ends = ([points[name].floor for name in road.ends] for road in roads)
        return "lift or ramp" if any(first != second for first, second in ends) else "lift"
