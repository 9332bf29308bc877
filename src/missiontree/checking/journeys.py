"""
Where every robot must travel, told from where everybody and everything is at what time.

What is moved in no time at the moment at which somebody comes to it may have been moved before or after that: the times of a schedule do
not say, and not always do the rules. Then it may be at either place, and so may who was there be afterwards; a schedule is sound if it is
for one of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.clock import tick
from missiontree.checking.timetable import Deed, Timetable
from missiontree.checking.ways import apart_m
from missiontree.mission.fleet import Robot
from missiontree.mission.position import Position
from missiontree.mission.schedule import Recharge

Spot = Position | None
"""A point in frame ``map``; None where it is not known."""

NEAR_M = 1e-3
"""Metres by which a distance or a place may be off."""

MOST_AT_ONCE = 50
"""Moves that take no time at one moment, beyond which nobody can tell what is where."""


class Journey(NamedTuple):
    """
    What a robot has to travel for one action that has a place.

    ``origins`` are the spots at which it may be before; None is one of them once it was at a place that is not known. ``goals`` are those
    at which the action may be. Either holds more than one spot only where an entity is moved, in no time, at the very moment.
    ``free_from`` is when the robot's action before ended, in ticks.
    """

    deed: Deed
    origins: tuple[Spot, ...]
    goals: tuple[Spot, ...]
    free_from: int


class Movements:
    """Where entities are over time: at their start, then where the moves that bring them end."""

    def __init__(self, case: Case, timetable: Timetable) -> None:
        self._case = case
        self._timetable = timetable
        self._moves: dict[str, list[Deed]] = {}
        self._spots: dict[tuple[str, int], tuple[Spot, ...]] = {}
        turns = timetable.by_robot.values()
        self._turn = {deed.leaf: turn for deeds in turns for turn, deed in enumerate(deeds)}
        for deed in sorted(timetable.deeds.values(), key=lambda deed: (deed.end, deed.start, deed.leaf)):
            for entity in deed.action.brings if deed.action.moves else ():
                self._moves.setdefault(entity, []).append(deed)
        for deed in sorted(timetable.deeds.values(), key=lambda deed: (deed.start, deed.end, deed.leaf)):
            if deed.action.moves and deed.action.at is not None:
                self.spots(deed.action.at, deed)  # in order of time, so that no question goes deep

    def spots(self, entity: str, deed: Deed) -> tuple[Spot, ...]:
        """Where an entity may be when an action starts."""
        return self._spots_at(entity, deed, set())

    def _spots_at(self, entity: str, deed: Deed, visiting: set[tuple[str, int]]) -> tuple[Spot, ...]:
        key = (entity, deed.leaf)
        if key in self._spots:
            return self._spots[key]
        if (
            key in visiting or len(visiting) > MOST_AT_ONCE
        ):  # moves that wait for one another: nothing is known of the place
            return (None,)
        visiting.add(key)
        found = self._initial(entity)
        for move in self._moves.get(entity, ()):
            if move.leaf == deed.leaf or move.end > deed.start or _one_activity(move, deed) or self._surely(deed, move):
                continue
            there = self._spots_at(move.action.at, move, visiting) if move.action.at is not None else (None,)
            found = (
                there if move.start < deed.start or self._surely(move, deed) else tuple(dict.fromkeys(found + there))
            )
        self._spots[key] = found
        return found

    def _surely(self, first: Deed, second: Deed) -> bool:
        """Whether one action that starts when another does comes before it: as the order of the tree or that of a robot has it."""
        if first.start != second.start:
            return False
        if first.robot == second.robot and self._turn[first.leaf] < self._turn[second.leaf]:
            return True
        return self._timetable.surely_before(first.leaf, second.leaf)

    def _initial(self, entity: str) -> tuple[Spot, ...]:
        return (self._case.scene.spots.get(entity),)


def _one_activity(one: Deed, other: Deed) -> bool:
    """Whether two actions are joint: they start as one, before either moves anything, even if they take no time."""
    return one.action.sync is not None and one.action.sync == other.action.sync


def start_spot(case: Case, robot: Robot | None) -> Spot:
    """Where the fleet says that a robot starts."""
    if robot is None:
        return None
    if robot.position is not None:
        return case.scene.in_map(robot.position)
    return case.scene.spots.get(robot.place or "")


def journeys(case: Case, timetable: Timetable) -> Iterator[Journey]:
    """What every robot of a schedule has to travel, robot by robot, in order of time."""
    for steps in case.once(_walks, timetable).values():
        yield from (step for step in steps if isinstance(step, Journey))


class Stand(NamedTuple):
    """Where a robot may be after all that it does, and from when, in ticks."""

    spots: tuple[Spot, ...]
    free_from: int


def final_stands(case: Case, timetable: Timetable) -> dict[str, Stand]:
    """Where every robot that does something is in the end."""
    walks = case.once(_walks, timetable)
    return {robot: step for robot, steps in walks.items() for step in steps if isinstance(step, Stand)}


class Visit(NamedTuple):
    """A visit to a charger: where its robot may be before and from when on it is free, in ticks, and where the charger is."""

    visit: Recharge
    origins: tuple[Spot, ...]
    goal: Spot
    free_from: int


def visits(case: Case, timetable: Timetable) -> Iterator[Visit]:
    """Every visit to a charger, robot by robot, in order of time."""
    for steps in case.once(_walks, timetable).values():
        yield from (step for step in steps if isinstance(step, Visit))


Step = Journey | Visit | Stand


def _walks(case: Case, timetable: Timetable) -> dict[str, tuple[Step, ...]]:
    movements = Movements(case, timetable)
    return {robot: tuple(_steps(case, timetable, movements, robot)) for robot in timetable.by_robot}


def _steps(case: Case, timetable: Timetable, movements: Movements, robot: str) -> Iterator[Step]:
    """A robot's journeys and its visits to chargers in order of time, then where it ends."""
    spots: tuple[Spot, ...] = (start_spot(case, case.fleet.robots.get(robot)),)
    free_from = 0
    for deed in timetable.turns(robot):
        if isinstance(deed, Recharge):
            charger = case.scene.charger_spots.get(deed.charger)
            yield Visit(deed, spots, charger, free_from)
            spots, free_from = (charger,), max(free_from, tick(deed.end_s))
            continue
        if deed.action.at is not None or deed.action.moves:
            goals = movements.spots(deed.action.at, deed) if deed.action.at is not None else (None,)
            if deed.action.at is not None:
                yield Journey(deed, spots, goals, free_from)
            spots = goals if len(goals) == 1 else _reached(timetable, deed, spots, goals)
        free_from = max(free_from, deed.end)
    yield Stand(spots, free_from)


def _reached(timetable: Timetable, deed: Deed, origins: tuple[Spot, ...], goals: tuple[Spot, ...]) -> tuple[Spot, ...]:
    """Those goals of an action at which a robot is after it: where its leg leads, or where it was if it has none."""
    leg = timetable.legs.get((deed.robot, deed.leaf))
    stops = origins if leg is None else (leg.destination,)
    if None in stops:
        return goals
    return tuple(goal for goal in goals if any(same_spot(goal, stop) for stop in stops)) or goals


def same_spot(one: Spot, other: Spot) -> bool:
    """Whether two spots are known and the same."""
    return one is not None and other is not None and one.frame == other.frame and apart_m(one, other) <= NEAR_M
