"""What there is to show on the map of a plan: everything that has a position, and who has none."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from missiontree.estimation.travel import start_of
from missiontree.mission.area import KeepOut
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Road, RoadGraph
from missiontree.reporting.maps.shut import shut_roads
from missiontree.reporting.maps.things import KINDS, MapContent, Missing, ShownArea, ShownRoad, Thing, ThingKind
from missiontree.reporting.references import world_of


def content_of(plan: Plan) -> MapContent:
    """
    What there is to show. Linear in scene and fleet.

    Raises
    ------
    InputError
        If an entity stands in the scene and again in the tree.
    """
    scene = world_of(plan)
    entities = [thing for entity in scene.entities if (thing := _standing(entity, scene)) is not None]
    things = (
        *(place for entity in scene.places if (place := _standing(entity, scene)) is not None),
        *(_lift_stops(scene.roads, scene) if scene.roads is not None else ()),
        *(_ramp_ends(scene.roads, scene) if scene.roads is not None else ()),
        *entities,
        *_starts(plan.brief.fleet, scene),
        *(_nodes(scene.roads, scene) if scene.roads is not None else ()),
    )
    areas = tuple(_areas(scene, plan.brief.fleet))
    roads = tuple(_roads(scene.roads, scene, plan.brief.fleet) if scene.roads is not None else ())
    floors = [thing.spot.floor for thing in things] + [area.area.floor for area in areas]
    floors = [*([scene.grid.floor] if scene.grid is not None else ()), *floors]
    return MapContent(scene, things, tuple(_missing(scene)), areas, roads, tuple(dict.fromkeys(floors)))


def base_kind(entity: Entity, scene: Scene) -> ThingKind:
    """The base kind of an entity, as things have it."""
    base = scene.base_kind(entity.kind)
    return next((kind for kind in KINDS if kind == base), "object")


def _standing(entity: Entity, scene: Scene) -> Thing | None:
    found = scene.whereabouts(entity)
    if found.position is None:
        return None
    sure = found.source == "known"
    kind = entity.kind if entity.kind != base_kind(entity, scene) else ""
    parts = [kind, "" if sure else _PLANNED[found.source], *(f"is {trait}" for trait in entity.traits[:4])]
    return Thing(entity.id, entity.label, base_kind(entity, scene), found.position, _listed(parts), sure)


_PLANNED = {
    "last_seen": "position unknown, planned where it was seen last",
    "search_area": "position unknown, planned in the middle of its search area",
}


def _missing(scene: Scene) -> Iterator[Missing]:
    for entity in scene.all_entities:
        source = scene.whereabouts(entity).source
        if source != "known":
            note = {"last_seen": "planned where last seen", "search_area": "planned in the search area"}.get(source, "")
            yield Missing(entity.id, entity.label, base_kind(entity, scene), note)


def _starts(fleet: Fleet, scene: Scene) -> Iterator[Thing]:
    """Robots at their starts; those that are alike together, whatever their number."""
    for kind in fleet.types:
        if kind.count is not None:
            spot = start_of(kind.members[0], scene)
            if spot is not None:
                yield Thing(kind.id, kind.label, "robot", spot, "starts here", count=kind.count)
            continue
        for robot in kind.robots:
            spot = start_of(robot, scene)
            if spot is not None:
                yield Thing(robot.id, robot.id, "robot", spot, f"{kind.label}, starts here")


def _lift_stops(graph: RoadGraph, scene: Scene) -> Iterator[Thing]:
    for lift in graph.lifts:
        stops = [scene.road_points[stop] for stop in dict.fromkeys(lift.stops)]
        rules = [f"{lift.ride_s:g} s a ride", "out of order" if lift.blocked else "", _only(lift.types)]
        for stop in stops:
            floors = dict.fromkeys(other.floor for other in stops if other.floor != stop.floor)
            leads = f"to {', '.join(floors)}" if floors else ""
            label = f"{lift.id} {leads}" if leads else lift.id
            label += ", out of order" if lift.blocked else ""
            yield Thing(lift.id, label, "lift", stop, _listed(["lift", *rules]))


def _ramp_ends(graph: RoadGraph, scene: Scene) -> Iterator[Thing]:
    """The ends of roads from floor to floor, which no panel can show as a line."""
    for road in graph.roads:
        first, second = (scene.road_points[name] for name in road.ends)
        if first.floor != second.floor:
            name, shut = f"ramp {' - '.join(road.ends)}", ", blocked" if road.blocked else ""
            back = "from" if road.one_way else "to"
            note = _listed([name, *_rules(road)])
            yield Thing(name, f"ramp to {second.floor}{shut}", "lift", first, note)
            yield Thing(name, f"ramp {back} {first.floor}{shut}", "lift", second, note)


def _nodes(graph: RoadGraph, scene: Scene) -> Iterator[Thing]:
    for node in graph.nodes:
        yield Thing(node.id, node.id, "node", scene.in_map(node.position), "road node")


def _roads(graph: RoadGraph, scene: Scene, fleet: Fleet) -> Iterator[ShownRoad]:
    shut = shut_roads(scene, fleet)
    for index, road in enumerate(graph.roads):
        start, end = (scene.road_points[name] for name in road.ends)
        if start.floor == end.floor:
            to_all, why = shut.get(index, (False, ""))
            note = _listed([f"road {' - '.join(road.ends)}", *_rules(road), why])
            limited = road.types is not None or bool(why and not to_all)
            yield ShownRoad(start, end, road.one_way, road.blocked or to_all, limited, note)


def _rules(road: Road) -> Iterator[str]:
    """What holds on a road, in words; some may be empty."""
    yield "one-way" if road.one_way else ""
    yield "blocked" if road.blocked else ""
    yield f"{road.length_m:g} m long" if road.length_m is not None else ""
    yield _only(road.types)
    yield f"through zone {road.zone}" if road.zone is not None else ""


def _areas(scene: Scene, fleet: Fleet) -> Iterator[ShownArea]:
    for zone in scene.zones:
        if zone.area is not None:
            yield ShownArea(zone.id, "zone", zone.area, f"zone {zone.id}")
    for keep_out in scene.keep_outs:
        note = _listed([f"keep-out {keep_out.id}", _only(keep_out.types, "for ")])
        yield ShownArea(keep_out.id, "keep_out", keep_out.area, note, _closed_to(keep_out, fleet))
    for entity in scene.all_entities:
        if entity.search_area is not None and scene.whereabouts(entity).source != "known":
            yield ShownArea(entity.label, "search_area", entity.search_area, f"{entity.label} may be anywhere in here")


def _closed_to(keep_out: KeepOut, fleet: Fleet) -> tuple[str, ...] | None:
    """Labels of the robot types of the fleet that a keep-out holds for; None if that is all of them."""
    if keep_out.types is None:
        return None
    closed = [kind.label for kind in fleet.types if kind.id in keep_out.types]
    return None if len(closed) == len(fleet.types) else tuple(closed)


def _only(types: Iterable[str] | None, lead: str = "only for ") -> str:
    return "" if types is None else f"{lead}{', '.join(types) or 'nobody'}"


def _listed(parts: Iterable[str]) -> str:
    return ", ".join(part for part in parts if part)
