"""What the operator asks of a mission as a whole: who stays out of it, who takes part, how good every action must be."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from difflib import get_close_matches

from missiontree.mission.charger import Charger
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.frozen_map import FrozenMap

MinQuality = float | Mapping[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Terms:
    """
    The terms of one mission; made by :attr:`missiontree.mission.brief.MissionBrief.terms`, which has checked them.

    Parameters
    ----------
    without
        Robot types and robots that take no part. A name that both a type and a robot have means the type.
    require
        Robot types and robots each of which fills at least one role in every alternative.
    min_quality
        Quality that every action must have at least: one number for all, or numbers by routine or capability. Default 0.
    stock
        What the scene holds for the whole mission.
    by_estimator
        Whether qualities are said by an estimator of the user's own, so that the fleet's do not tell who is good enough.
    return_home
        Whether each robot that takes part goes back to where it started, after its last action.
    home_by_s
        By when all of them must be back, in seconds; None (default) means no such deadline.
    chargers
        Where robots refill what they use up. Default: nowhere.
    """

    without: tuple[str, ...] = ()
    require: tuple[str, ...] = ()
    min_quality: MinQuality = 0.0
    stock: Mapping[str, float] = field(default_factory=dict)
    by_estimator: bool = False
    return_home: bool = False
    home_by_s: float | None = None
    chargers: tuple[Charger, ...] = ()

    def team_of(self, fleet: Fleet) -> Fleet:
        """
        The fleet without what is left out; the fleet itself if nothing is.

        Raises
        ------
        ValueError
            If nobody is left.
        """
        if not self.without:
            return fleet
        kept = (self.left_of(kind, fleet) for kind in fleet.types)
        return replace(fleet, types=tuple(kind for kind in kept if kind is not None))

    def left_of(self, kind: RobotType, fleet: Fleet) -> RobotType | None:
        """What is left of a type of the fleet; None if nobody is."""
        if kind.id in self.without:
            return None
        out = {name for name in self.without if name not in fleet.by_id}
        left = tuple(robot for robot in kind.members if robot.id not in out)
        if len(left) == len(kind.members):
            return kind
        return replace(kind, robots=left, count=None, position=None, place=None) if left else None

    def required_by_type(self, fleet: Fleet) -> dict[str, tuple[str, ...]]:
        """Types that must take part, those required and those of required robots, with the names that say so."""
        found: dict[str, tuple[str, ...]] = {}
        for name in dict.fromkeys(self.require):
            type_id = name if name in fleet.by_id else fleet.type_of[name].id
            found[type_id] = (*found.get(type_id, ()), name)
        return found

    def required_robots(self, fleet: Fleet) -> tuple[str, ...]:
        """Robots that must take part, by name."""
        return tuple(name for name in self.require if name not in fleet.by_id)

    def refilled(self, kind: RobotType) -> frozenset[str]:
        """Limits of a type that its robots can refill, so that they are no budgets."""
        stocks = {charger.stock for charger in self.chargers if charger.serves(kind.id)}
        return frozenset(stocks & kind.limits.keys())

    @property
    def judged_by_estimator(self) -> bool:
        """Whether there is a minimum that only an estimator of the user's own can hold anybody to."""
        return self.by_estimator and bool(self.min_quality)

    def least_quality(self, capability: str, routines: Iterable[str]) -> float:
        """Quality that an action must have that is rated by a capability and done in these routines, one inside the other."""
        if not isinstance(self.min_quality, Mapping):
            return self.min_quality
        return max(self.min_quality.get(name, 0.0) for name in (capability, *routines))


NO_TERMS = Terms()


def check_terms(terms: Terms, fleet: Fleet, routines: tuple[str, ...], capabilities: tuple[str, ...]) -> None:
    """
    Refuse terms that name what there is not, or that contradict each other.

    Raises
    ------
    ValueError
        Naming the term and what to do.
    """
    for what, names in (("without", terms.without), ("require", terms.require)):
        for name in names:
            if name not in fleet.by_id and name not in fleet.robots:
                known = (*fleet.by_id, *fleet.robots)
                raise ValueError(
                    f"{what} names {name!r}, and the fleet has neither a type nor a robot of that name; "
                    f"{_nearest(name, known)}it has {', '.join(known):.300}."
                )
    if terms.without:
        _check_left(terms, fleet)
    for type_id in terms.required_by_type(fleet):
        kind = fleet.by_id[type_id]
        asked = {name for name in terms.required_robots(fleet) if fleet.type_of[name] is kind}
        if len(asked) > kind.usable:
            raise ValueError(
                f"{len(asked)} robots of type {kind.id!r} are required, and at most {kind.usable} may be in use; "
                "raise its max_in_use, or require fewer."
            )
    for name in terms.min_quality if isinstance(terms.min_quality, Mapping) else ():
        if name not in routines and name not in capabilities:
            raise ValueError(
                f"min_quality names {name!r}, which is neither a routine nor a capability; "
                f"{_nearest(name, (*routines, *capabilities))}routines are "
                f"{', '.join(routines)}; capabilities are {', '.join(capabilities)}."
            )


def _nearest(name: str, known: tuple[str, ...]) -> str:
    """The name most alike, as a part of a sentence; empty if none is."""
    near = get_close_matches(name, known, n=1) or [each for each in known if each.casefold() == name.casefold()]
    return f"the nearest is {near[0]!r}; " if near else ""


def _check_left(terms: Terms, fleet: Fleet) -> None:
    """Somebody is left, and so is whoever is required."""
    kept = [left for kind in fleet.types if (left := terms.left_of(kind, fleet)) is not None]
    if not kept:
        raise ValueError("without leaves out every robot of the fleet; leave somebody in.")
    there = {kind.id for kind in kept} | {robot.id for kind in kept for robot in kind.members}
    for name in terms.require:
        if name not in there:
            raise ValueError(f"{name!r} is required, and left out by 'without'; take it off one of the two.")


def checked_quality(given: object) -> MinQuality:
    """
    A minimum of quality as it is kept: a number, or numbers by name that do not change.

    Raises
    ------
    ValueError
        If a number is negative or none.
    """
    if isinstance(given, Mapping):
        return FrozenMap({str(name): _number(f"min_quality.{name}", least) for name, least in given.items()})
    return _number("min_quality", given)


def _number(name: str, given: object) -> float:
    if isinstance(given, bool) or not isinstance(given, int | float) or not math.isfinite(given) or given < 0:
        raise ValueError(f"{name} must be a number, at least 0, got {given!r}.")
    return given
