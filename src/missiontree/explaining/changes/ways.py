"""What closes ways: roads, lifts, keep-outs and zones."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from missiontree.explaining.case import Case
from missiontree.explaining.changes.editing import with_scene, with_type
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change
from missiontree.mission.fleet import Fleet
from missiontree.mission.ways import Lift, Road

BOTH_WAYS = "both ways"
"""Stands in the place of a robot type where a one-way road is opened for the way back."""


def candidates(case: Case, needs: Needs) -> Iterator[Change]:
    """Everything that is closed to somebody."""
    world, fleet = case.brief.world, case.brief.fleet
    roads, lifts = (world.roads.roads, world.roads.lifts) if world.roads else ((), ())
    closed = [change for road in roads for change in _closed(_named(road), road.blocked, road.types, fleet)]
    closed += [Change(kind="open_way", target=_named(road), name=BOTH_WAYS) for road in roads if road.one_way]
    closed += [change for lift in lifts for change in _closed(lift.id, lift.blocked, lift.types, fleet)]
    yield from dict.fromkeys(closed)
    for area in world.keep_outs:
        yield Change(kind="lift_keep_out", target=area.id)
    for kind in fleet.types:
        for zone in world.zones:
            if kind.zones is not None and zone.id not in kind.zones:
                yield Change(kind="allow_zone", target=kind.id, name=zone.id)


def _closed(name: str, blocked: bool, types: tuple[str, ...] | None, fleet: Fleet) -> Iterator[Change]:
    if blocked:
        yield Change(kind="open_way", target=name)
    for kind in fleet.types:
        if types is not None and kind.id not in types:
            yield Change(kind="open_way", target=name, name=kind.id)


def _named(road: Road) -> str:
    return f"{road.ends[0]} - {road.ends[1]}"


def open_way(case: Case, change: Change) -> Case:
    """A road or a lift can be used: by all, by one type more, or both ways."""
    roads = case.brief.world.roads
    assert roads is not None, "only what there is can be opened"
    opened = replace(
        roads,
        roads=tuple(_open_road(road, change.name) if _named(road) == change.target else road for road in roads.roads),
        lifts=tuple(_open_lift(lift, change.name) if lift.id == change.target else lift for lift in roads.lifts),
    )
    return with_scene(case, roads=opened)


def _open_road(road: Road, name: str) -> Road:
    if not name:
        return replace(road, blocked=False)
    if name == BOTH_WAYS:
        return replace(road, one_way=False)
    return road if road.types is None or name in road.types else replace(road, types=(*road.types, name))


def _open_lift(lift: Lift, name: str) -> Lift:
    if not name:
        return replace(lift, blocked=False)
    return lift if lift.types is None or name in lift.types else replace(lift, types=(*lift.types, name))


def open_way_words(case: Case, change: Change) -> str:
    """As an order."""
    road = " - " in change.target
    way = f"the road {change.target}" if road else f"the lift {change.target}"
    if change.name == BOTH_WAYS:
        return f"let {way} be used both ways"
    if change.name:
        return f"let {case.brief.fleet.by_id[change.name].label} use {way}"
    return f"open {way}" if road else f"put {way} back into service"


def lift_keep_out(case: Case, change: Change) -> Case:
    """A keep-out is none any more."""
    return with_scene(case, keep_outs=tuple(area for area in case.brief.world.keep_outs if area.id != change.target))


def lift_keep_out_words(case: Case, change: Change) -> str:
    """As an order."""
    return f"let robots through the keep-out {change.target}"


def allow_zone(case: Case, change: Change) -> Case:
    """A type may enter one zone more."""
    return with_type(case, change.target, lambda kind: replace(kind, zones=(*(kind.zones or ()), change.name)))


def allow_zone_words(case: Case, change: Change) -> str:
    """As an order."""
    return f"let {case.brief.fleet.by_id[change.target].label} enter the zone {change.name}"
