"""What scene understanding hands over: who and what is there, where, and the ways between."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal

from missiontree.mission.position import Position
from missiontree.mission.value import Id, NonNegative, Positive, Value, require_unique

BASE_KINDS = ("person", "animal", "object", "place")
Corner = tuple[float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Area(Value):
    """
    A polygon on one floor.

    Parameters
    ----------
    corners
        At least three (x, y) pairs in metres, in order along the edge, in frame ``map``.
    floor
        Floor, default ``ground``.
    """

    corners: tuple[Corner, ...]
    floor: Id = "ground"

    def _check(self) -> None:
        if len(self.corners) < 3:
            raise ValueError(f"an area needs at least 3 corners, got {len(self.corners)}.")
        if not all(math.isfinite(number) for corner in self.corners for number in corner):
            raise ValueError("corners must be finite numbers.")

    @property
    def middle(self) -> Position:
        """Mean of the corners."""
        count = len(self.corners)
        return Position(
            sum(x for x, _ in self.corners) / count, sum(y for _, y in self.corners) / count, floor=self.floor
        )


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


@dataclass(frozen=True, slots=True, kw_only=True)
class Zone(Value):
    """
    A part of the scene that robot types may be allowed in or kept out of.

    Parameters
    ----------
    id
        Name of the zone.
    area
        Its extent; None if entities and roads name the zone themselves.
    """

    id: Id
    area: Area | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class KeepOut(Value):
    """
    An area that robots do not enter.

    Parameters
    ----------
    id
        Name of the keep-out.
    area
        Its extent; the edge itself may be touched.
    types
        Robot types it holds for; None (default) means all.
    """

    id: Id
    area: Area
    types: tuple[Id, ...] | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class RoadNode(Value):
    """
    A named point of the road graph.

    Parameters
    ----------
    id
        Name, used by roads and lifts.
    position
        Where it is.
    """

    id: Id
    position: Position


@dataclass(frozen=True, slots=True, kw_only=True)
class Road(Value):
    """
    An edge of the road graph.

    Parameters
    ----------
    ends
        Two ids of road nodes, or of places with a position.
    length_m
        Length, default the straight distance of the ends.
    one_way
        Only from the first end to the second. Default false.
    blocked
        Nobody can pass. Default false.
    types
        Robot types allowed; None (default) means all.
    zone
        Zone the road runs through; only types allowed there pass.
    """

    ends: tuple[Id, Id]
    length_m: NonNegative | None = None
    one_way: bool = False
    blocked: bool = False
    types: tuple[Id, ...] | None = None
    zone: Id | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Lift(Value):
    """
    Joins road nodes on different floors.

    Parameters
    ----------
    id
        Name of the lift.
    stops
        Road nodes or places it stops at, at least two.
    ride_s
        Seconds from any stop to any other, waiting included.
    blocked
        Out of order. Default false.
    types
        Robot types allowed; None (default) means all.
    """

    id: Id
    stops: tuple[Id, ...]
    ride_s: NonNegative
    blocked: bool = False
    types: tuple[Id, ...] | None = None

    def _check(self) -> None:
        if len(self.stops) < 2:
            raise ValueError(f"lift {self.id!r} needs at least two stops.")


@dataclass(frozen=True, kw_only=True)
class RoadGraph(Value):
    """
    The ways there are. Points off the road join the nearest node of their floor straight.

    Parameters
    ----------
    nodes
        Named points; places with a position may be used as nodes too.
    roads
        Edges.
    lifts
        What joins floors.
    """

    nodes: tuple[RoadNode, ...] = ()
    roads: tuple[Road, ...] = ()
    lifts: tuple[Lift, ...] = ()

    def _check(self) -> None:
        require_unique("road node", tuple(node.id for node in self.nodes))
        require_unique("lift", tuple(lift.id for lift in self.lifts))


@dataclass(frozen=True, kw_only=True)
class OccupancyGrid(Value):
    """
    A map of free and blocked cells. Robots move in 8 directions and cut no corners.

    Parameters
    ----------
    rows
        Strings of ``.`` (free) and ``#`` (blocked), all of one length; the first row has the largest y, as on a printed map.
    cell_m
        Side of a cell in metres, above 0.
    x_m, y_m
        Lower left corner of the grid, default (0, 0).
    floor
        Floor, default ``ground``.
    """

    rows: tuple[str, ...]
    cell_m: Positive
    x_m: float = 0.0
    y_m: float = 0.0
    floor: Id = "ground"

    def _check(self) -> None:
        if not self.rows or not self.rows[0]:
            raise ValueError("a grid needs at least one row with at least one cell.")
        for number, row in enumerate(self.rows, start=1):
            if len(row) != len(self.rows[0]):
                raise ValueError(f"row {number} of the grid has {len(row)} cells, row 1 has {len(self.rows[0])}.")
            if wrong := set(row) - {".", "#"}:
                raise ValueError(
                    f"row {number} of the grid has {sorted(wrong)[0]!r}; cells are '.' (free) or '#' (blocked)."
                )


@dataclass(frozen=True, slots=True, kw_only=True)
class Frame(Value):
    """
    Pose of a frame in ``map``: turned by ``yaw_deg`` counter-clockwise, then moved to (x_m, y_m).

    Parameters
    ----------
    id
        Name of the frame, as positions give it.
    x_m, y_m
        Where its origin lies in ``map``, in metres, default (0, 0).
    yaw_deg
        By how much it is turned, in degrees counter-clockwise, default 0.
    """

    id: Id
    x_m: float = 0.0
    y_m: float = 0.0
    yaw_deg: float = 0.0


WhereaboutsSource = Literal["known", "last_seen", "search_area", "unknown"]


@dataclass(frozen=True, slots=True)
class Whereabouts(Value):
    """Where planning takes an entity to be (in frame ``map``), and how that is known."""

    position: Position | None
    source: WhereaboutsSource


@dataclass(frozen=True, kw_only=True)
class Scene(Value):
    """
    The world as far as it is known.

    Parameters
    ----------
    label
        Name shown to people.
    kinds
        Kinds of the user's own, each under another: ``{cat: animal, crate: object}``.
    frames
        Frames other than ``map``.
    zones, keep_outs
        Parts of the world with rules of their own.
    places
        Entities of kind ``place``.
    entities
        Everybody and everything else.
    roads
        Road graph. At most one of ``roads`` and ``grid``; with neither, robots go straight, round the keep-outs.
    grid
        Occupancy grid.
    """

    label: str = ""
    kinds: Mapping[Id, Id] = field(default_factory=dict)
    frames: tuple[Frame, ...] = ()
    zones: tuple[Zone, ...] = ()
    keep_outs: tuple[KeepOut, ...] = ()
    places: tuple[Entity, ...] = ()
    entities: tuple[Entity, ...] = ()
    roads: RoadGraph | None = None
    grid: OccupancyGrid | None = None

    def _check(self) -> None:
        places = tuple(replace(place, kind="place") if place.kind == "object" else place for place in self.places)
        object.__setattr__(self, "places", places)
        if self.roads is not None and self.grid is not None:
            raise ValueError("a scene has either roads or a grid, not both.")
        require_unique("entity", tuple(entity.id for entity in self.all_entities))
        require_unique("zone", tuple(zone.id for zone in self.zones))
        require_unique("keep-out", tuple(area.id for area in self.keep_outs))
        require_unique("frame", tuple(frame.id for frame in self.frames))
        for kind in self.kinds:
            self.base_kind(kind)
        for entity in self.all_entities:
            self._check_entity(entity)
        for place in self.places:
            if self.base_kind(place.kind) != "place":
                raise ValueError(f"{place.id!r} stands under places but is of kind {place.kind!r}.")
        self._check_roads()

    def _check_entity(self, entity: Entity) -> None:
        self.base_kind(entity.kind)
        if entity.place is not None and entity.place not in self.by_id:
            raise ValueError(f"{entity.id!r} is at place {entity.place!r}, which the scene does not have.")
        if entity.zone is not None and entity.zone not in {zone.id for zone in self.zones}:
            raise ValueError(f"{entity.id!r} is in zone {entity.zone!r}, which the scene does not have.")
        for position in (entity.position, entity.last_seen):
            if position is not None:
                self.in_map(position)

    def _check_roads(self) -> None:
        if self.roads is None:
            return
        known = self.road_points
        for road in self.roads.roads:
            for end in road.ends:
                if end not in known:
                    raise ValueError(
                        f"a road ends at {end!r}, which is neither a road node nor a place with a position."
                    )
            if road.length_m is None and known[road.ends[0]].floor != known[road.ends[1]].floor:
                raise ValueError(f"the road {road.ends[0]} - {road.ends[1]} joins two floors; use a lift.")
        for lift in self.roads.lifts:
            for stop in lift.stops:
                if stop not in known:
                    raise ValueError(
                        f"lift {lift.id!r} stops at {stop!r}, which is neither a road node nor a place with a position."
                    )

    @cached_property
    def all_entities(self) -> tuple[Entity, ...]:
        """Places, then entities."""
        return (*self.places, *self.entities)

    @cached_property
    def by_id(self) -> dict[str, Entity]:
        """Places and entities by id."""
        return {entity.id: entity for entity in self.all_entities}

    @cached_property
    def road_points(self) -> dict[str, Position]:
        """Positions, in ``map``, of road nodes and of places that have one."""
        places = {place.id: self.in_map(place.position) for place in self.places if place.position is not None}
        nodes = self.roads.nodes if self.roads is not None else ()
        return places | {node.id: self.in_map(node.position) for node in nodes}

    def extended(self, entities: tuple[Entity, ...]) -> Scene:
        """The scene with more entities: those that the operator declares or the author introduces."""
        return replace(self, entities=(*self.entities, *entities)) if entities else self

    def lineage(self, kind: str) -> Iterator[str]:
        """The kind, then what it stands under, up to a base kind."""
        seen: set[str] = set()
        while kind not in BASE_KINDS:
            if kind in seen:
                raise ValueError(f"kind {kind!r} stands under itself.")
            if kind not in self.kinds:
                raise ValueError(
                    f"kind {kind!r} is not known; base kinds are {', '.join(BASE_KINDS)}; declare others under kinds."
                )
            seen.add(kind)
            yield kind
            kind = self.kinds[kind]
        yield kind

    def base_kind(self, kind: str) -> str:
        """The base kind that a kind stands under."""
        return list(self.lineage(kind))[-1]

    def in_map(self, position: Position) -> Position:
        """The same point in frame ``map``."""
        if position.frame == "map":
            return position
        for frame in self.frames:
            if frame.id == position.frame:
                turn = math.radians(frame.yaw_deg)
                x_m = frame.x_m + position.x_m * math.cos(turn) - position.y_m * math.sin(turn)
                y_m = frame.y_m + position.x_m * math.sin(turn) + position.y_m * math.cos(turn)
                return Position(x_m, y_m, floor=position.floor)
        raise ValueError(f"frame {position.frame!r} is not known; declare it under frames, or use 'map'.")

    def whereabouts(self, entity: Entity) -> Whereabouts:
        """Where planning takes an entity (of the scene or introduced) to be; see design: position, last seen, middle of its area."""
        if entity.position is not None:
            return Whereabouts(self.in_map(entity.position), "known")
        if entity.place is not None:
            place = self.by_id[entity.place]
            if place.position is not None:
                return Whereabouts(self.in_map(place.position), "known")
        if entity.last_seen is not None:
            return Whereabouts(self.in_map(entity.last_seen), "last_seen")
        if entity.search_area is not None:
            return Whereabouts(entity.search_area.middle, "search_area")
        return Whereabouts(None, "unknown")
