"""What scene understanding hands over: who and what is there, where, and the ways between."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations, pairwise
from typing import Any, Literal, cast

from missiontree.mission.area import KeepOut, Zone
from missiontree.mission.charger import Charger
from missiontree.mission.entity import Entity
from missiontree.mission.position import Position
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.value import Id, NonNegative, Value, require_unique
from missiontree.mission.ways import OccupancyGrid, RoadGraph

BASE_KINDS = ("person", "animal", "object", "place")


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
    stock
        What the actions of a whole mission may take, whoever takes it: ``{medkits: 4}``, in the unit in which actions use it
        (``uses: {medkits: 1}``); at least 0. It is not refilled. Default: no such limit.
    resources
        What robots share and only so many may hold at one time: lifts, doors, chargers. They are held during the actions that name
        them (``holds: [lift-1]``). Default: none.
    chargers
        Where robots refill what they use up. A stock that the robots of a type can refill at one of them is no budget that
        allocation counts; schedules keep its level between nothing and full, the type's limit. Default: none.
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
    stock: Mapping[Id, NonNegative] = field(default_factory=dict)
    resources: tuple[SharedResource, ...] = ()
    chargers: tuple[Charger, ...] = ()

    def _check(self) -> None:
        places = tuple(replace(place, kind="place") if place.kind == "object" else place for place in self.places)
        object.__setattr__(self, "places", places)
        if self.roads is not None and self.grid is not None:
            raise ValueError("a scene has either roads or a grid, not both.")
        require_unique("entity", tuple(entity.id for entity in self.all_entities))
        require_unique("zone", tuple(zone.id for zone in self.zones))
        require_unique("keep-out", tuple(area.id for area in self.keep_outs))
        require_unique("frame", tuple(frame.id for frame in self.frames))
        require_unique("shared resource", tuple(resource.id for resource in self.resources))
        require_unique("charger", tuple(charger.id for charger in self.chargers))
        for charger in self.chargers:
            self._check_charger(charger)
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

    def _check_charger(self, charger: Charger) -> None:
        if charger.id in {resource.id for resource in self.resources}:
            raise ValueError(
                f"{charger.id!r} is the name of a charger and of a shared resource; a charger has a capacity of its own."
            )
        if charger.position is not None:
            self.in_map(charger.position)
            return
        place = self.by_id.get(charger.place or "")
        if place is None or self.base_kind(place.kind) != "place" or place.position is None:
            raise ValueError(
                f"charger {charger.id!r} stands at {charger.place!r}, which is no place of the scene with a position."
            )

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
        named = [(f"the road {road.ends[0]} - {road.ends[1]}", road.resource) for road in self.roads.roads]
        named += [(f"lift {lift.id!r}", lift.resource) for lift in self.roads.lifts]
        for what, resource in named:
            if resource is not None and resource not in self.shared:
                raise ValueError(
                    f"{what} names {resource!r}, which is no shared resource of the scene; "
                    f"it has {', '.join(self.shared) or 'none; declare them under resources'}."
                )
        for lift in self.roads.lifts:
            for stop in lift.stops:
                if stop not in known:
                    raise ValueError(
                        f"lift {lift.id!r} stops at {stop!r}, which is neither a road node nor a place with a position."
                    )

    @cached_property
    def derived(self) -> dict[str, Any]:
        """What others worked out from this scene and keep with it, by a name of theirs; no part of the value."""
        return {}

    @cached_property
    def all_entities(self) -> tuple[Entity, ...]:
        """Places, then entities."""
        return (*self.places, *self.entities)

    @cached_property
    def by_id(self) -> dict[str, Entity]:
        """Places and entities by id."""
        return {entity.id: entity for entity in self.all_entities}

    @cached_property
    def spots(self) -> dict[str, Position | None]:
        """Where planning takes places and entities to be, by id; None where nothing is known. See :meth:`whereabouts`."""
        return {entity.id: self.whereabouts(entity).position for entity in self.all_entities}

    @cached_property
    def shared(self) -> dict[str, SharedResource]:
        """Shared resources by id."""
        return {resource.id: resource for resource in self.resources}

    @cached_property
    def charger_spots(self) -> dict[str, Position]:
        """Where chargers stand, in ``map``, by id."""
        found = {}
        for charger in self.chargers:
            position = charger.position or self.by_id[charger.place or ""].position
            assert position is not None  # checked at birth
            found[charger.id] = self.in_map(position)
        return found

    @cached_property
    def passages(self) -> dict[frozenset[str], tuple[str, ...]]:
        """Shared resources between neighbouring nodes of the road graph: of any road or lift that joins the two."""
        found: dict[frozenset[str], dict[str, None]] = {}
        for road in self.roads.roads if self.roads is not None else ():
            if road.resource is not None:
                found.setdefault(frozenset(road.ends), {})[road.resource] = None
        for lift in self.roads.lifts if self.roads is not None else ():
            for pair in combinations(lift.stops, 2) if lift.resource is not None else ():
                found.setdefault(frozenset(pair), {})[lift.resource or ""] = None
        return {pair: tuple(names) for pair, names in found.items()}

    def passed(self, via: Sequence[str]) -> tuple[str, ...]:
        """Shared resources that a way along such nodes of the road graph holds, each once."""
        pairs = (frozenset(pair) for pair in pairwise(via)) if self.passages else ()
        return tuple(dict.fromkeys(name for pair in pairs for name in self.passages.get(pair, ())))

    @cached_property
    def road_points(self) -> dict[str, Position]:
        """Positions, in ``map``, of road nodes and of places that have one, under ``entities`` too."""
        listed = (*self.places, *(one for one in self.entities if "place" in self.lineage(one.kind)))
        places = {place.id: self.in_map(place.position) for place in listed if place.position is not None}
        nodes = self.roads.nodes if self.roads is not None else ()
        return places | {node.id: self.in_map(node.position) for node in nodes}

    def extended(self, entities: tuple[Entity, ...]) -> Scene:
        """The scene with more entities: those that the operator declares or the author introduces; the last such is kept."""
        if not entities:
            return self
        known, larger = self.derived.get("extended", ((), self))
        if known != entities:
            larger = replace(self, entities=(*self.entities, *entities))
            self.derived["extended"] = entities, larger
        return cast("Scene", larger)

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
