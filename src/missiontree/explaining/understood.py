"""
The tree of a mission that an author declined, since no robot can do a part of it.

The author without a model is asked again, for a team that can do everything: what it then builds is what the mission asks for, and shows
who lacks what. Nobody is asked who costs money.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from missiontree.authoring.formal import author_formal
from missiontree.authoring.methods.method import load_methods
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.mission.brief import MissionBrief
from missiontree.mission.fleet import RobotType

BEST = 1_000_000.0
"""A quality that nothing asks more of."""


def understood(request: Request) -> Authored | None:
    """What an author builds for a team that can do everything; None if it does not understand the mission or nobody serves it."""
    methods = load_methods(request.methods)
    for brief in eased(request.brief):
        made = author_formal(brief, methods) if brief.goals else author_offline(brief, methods)
        if made.status == "complete" and made.tree is not None:
            return made
    return None


def eased(brief: MissionBrief) -> Iterator[MissionBrief]:
    """The same mission for ever abler teams: the same with all limits lifted, then one without kinds as well."""
    needs = [role.rating for routine in brief.routines.routines for way in routine.branches for role in way.roles]
    needs += [
        need.capability
        for routine in brief.routines.routines
        for way in routine.branches
        for role in way.roles
        for need in role.needs
        if need.capability is not None
    ]
    fleet = replace(brief.fleet, types=tuple(_able(kind, needs) for kind in brief.fleet.types))
    able = replace(brief, fleet=fleet, without=(), require=(), min_quality=0.0)
    yield able
    if brief.check_kinds:
        yield replace(able, check_kinds=False)


def _able(kind: RobotType, capabilities: list[str]) -> RobotType:
    speed = {name: value for name, value in kind.limits.items() if name == "max_speed_mps"}
    return replace(
        kind,
        capabilities={**dict.fromkeys(capabilities, BEST), **dict.fromkeys(kind.capabilities, BEST)},
        limits=speed,
        robots=tuple(replace(robot, remaining={}) for robot in kind.robots),
        zones=None,
    )
