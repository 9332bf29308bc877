"""The routes of an alternative on the map: from where by what way to where each robot goes, and what it does there."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from string import ascii_uppercase

from missiontree.estimation.travel import start_of
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.reporting.maps.errands import Errand, errands_of
from missiontree.reporting.maps.ways import WayFinder, Waypoint
from missiontree.reporting.maps.whereabouts import Deed, Whereabouts, whereabouts_of
from missiontree.reporting.palette import Livery, livery


@dataclass(frozen=True, slots=True)
class Stop:
    """
    Where a robot does something, or arrives.

    Parameters
    ----------
    number
        From 1, in the order of its route; 0 is its start.
    spot
        Where; None if not known.
    start_s, end_s
        From when to when it has something to do there.
    texts
        What it does there.
    at
        Entity or place that it goes to; None if that is nobody.
    """

    number: int
    spot: Position | None
    start_s: float
    end_s: float
    texts: tuple[str, ...]
    at: str | None = None


@dataclass(frozen=True, slots=True)
class Passage:
    """
    One leg as a line.

    Parameters
    ----------
    leaf
        Action that it is travelled for; -1 if it is travelled for the robot's own sake.
    line
        Where the robot is when.
    distance_m
        Its length.
    """

    leaf: int
    line: tuple[Waypoint, ...]
    distance_m: float


@dataclass(frozen=True, slots=True)
class Route:
    """
    What one robot does on the map.

    Parameters
    ----------
    robot, label
        Its id, and the label of its type.
    thing
        Id of the thing that it stands for at its start: its own, or, if robots are alike, the type's.
    letter
        ``A``, ``B``, … in the order of the fleet; the same in every alternative of a plan.
    livery
        How it is coloured.
    start
        Where it starts; None if not known.
    deeds
        What it does, in order.
    stops
        Where it does it; number 0 only if something is done at the start.
    passages
        Its ways, in order of time.
    errands
        Stops that are no actions, in order.
    """

    robot: str
    label: str
    thing: str
    letter: str
    livery: Livery
    start: Position | None
    deeds: tuple[Deed, ...]
    stops: tuple[Stop, ...]
    passages: tuple[Passage, ...]
    errands: tuple[Errand, ...] = ()

    @property
    def distance_m(self) -> float:
        """How far it goes in all."""
        return math.fsum(passage.distance_m for passage in self.passages)


def schedule_of(plan: Plan, rank: int | None) -> Schedule | None:
    """The schedule of a rank, if there is one with actions."""
    return next((one for one in plan.schedules if one.rank == rank and one.actions), None)


def letters_of(plan: Plan) -> dict[str, str]:
    """A letter for every robot that any schedule uses, in the order of the fleet; strangers to the fleet come last."""
    used = {action.robot for schedule in plan.schedules for action in schedule.actions}
    ordered = [robot for robot in plan.brief.fleet.robots if robot in used] if used else []
    ordered += sorted(used.difference(ordered))
    return {robot: _letter(place) for place, robot in enumerate(ordered)}


def routes_of(plan: Plan, rank: int | None, scene: Scene) -> tuple[list[Route], Whereabouts]:
    """
    The routes of an alternative in the order of the fleet, and where everything is.

    Parameters
    ----------
    plan
        The plan.
    rank
        Rank of the alternative; without a schedule there are no routes.
    scene
        The world, introduced entities included.
    """
    schedule = schedule_of(plan, rank)
    if schedule is None or plan.grounding is None:
        return [], Whereabouts()
    where = whereabouts_of(schedule, plan.grounding.tree, scene)
    fleet, letters, ways = plan.brief.fleet, letters_of(plan), WayFinder(scene)
    places = {robot: place for place, robot in enumerate(fleet.robots)}
    routes = []
    errands = errands_of(plan, schedule)
    for robot, deeds in where.by_robot():
        own = errands.get(robot, ())
        kind, known = fleet.type_of.get(robot), fleet.robots.get(robot)
        start = start_of(known, scene) if known is not None else None
        passages = [
            Passage(deed.scheduled.leaf, ways.line(deed.leg, kind, deed.action.brings), deed.leg.distance_m)
            for deed in deeds
            if deed.leg is not None
        ]
        passages += [Passage(-1, ways.line(one.leg, kind), one.leg.distance_m) for one in own if one.leg is not None]
        colours = livery(places.get(robot, len(places)))
        routes.append(
            Route(
                robot=robot,
                label=kind.label if kind is not None else robot,
                thing=kind.id if kind is not None and not kind.robots else robot,
                letter=letters[robot],
                livery=colours,
                start=start,
                deeds=tuple(deeds),
                stops=tuple(_stops(start, deeds, own)),
                passages=tuple(sorted(passages, key=lambda passage: passage.line[0].t_s if passage.line else 0.0)),
                errands=own,
            )
        )
    return sorted(routes, key=lambda route: (places.get(route.robot, len(places)), route.robot)), where


def _stops(start: Position | None, deeds: Sequence[Deed], errands: Sequence[Errand]) -> Iterator[Stop]:
    """Deeds one after the other at one spot are one stop; an errand is one of its own."""
    here = Stop(0, start, 0.0, 0.0, ())
    for deed in in_order(deeds, errands):
        if isinstance(deed, Errand):
            if here.number or here.texts:
                yield here
            here = Stop(here.number + 1, deed.spot, deed.start_s, deed.end_s, (deed.text,))
            continue
        one = deed.scheduled
        stays = deed.action.at is None and not deed.action.moves
        spot = here.spot if stays else deed.at
        if spot == here.spot:
            here = replace(here, end_s=one.end_s, texts=(*here.texts, deed.action.text))
            continue
        if here.number or here.texts:
            yield here
        arrival_s = one.end_s if deed.action.moves else deed.leg.end_s if deed.leg is not None else one.start_s
        here = Stop(here.number + 1, spot, arrival_s, one.end_s, (deed.action.text,), deed.action.at)
    if here.number or here.texts:
        yield here


def in_order(deeds: Sequence[Deed], errands: Sequence[Errand]) -> list[Deed | Errand]:
    """What a robot does, errands included, in order of time; at one moment deeds that end there come first."""
    steps: list[tuple[float, float, int, Deed | Errand]] = []
    for place, deed in enumerate(deeds):
        steps.append((deed.scheduled.start_s, deed.scheduled.end_s, place, deed))
    for errand in errands:
        steps.append((errand.start_s, errand.end_s, len(deeds), errand))
    return [step[-1] for step in sorted(steps, key=lambda step: step[:-1])]


def _letter(place: int) -> str:
    """``A`` to ``Z``, then ``AA``, ``AB`` and so on."""
    letters = ""
    place += 1
    while place:
        place, rest = divmod(place - 1, len(ascii_uppercase))
        letters = ascii_uppercase[rest] + letters
    return letters
