"""Roles that ask the same of a robot, so that the answer for one is the answer for all."""

from __future__ import annotations

from collections.abc import Mapping

from missiontree.mission.grounded import Action
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing


def alike_roles(graph: TaskGraph, staffing: Staffing, needs: Mapping[int, Mapping[str, float]]) -> dict[int, int]:
    """For each role a number that it shares with the roles of the same type, places, uses, needs and marks to avoid."""
    numbers: dict[object, int] = {}
    found: dict[int, int] = {}
    for role, leaves in graph.roles.items():
        group = staffing.group_of[role]
        asks = (
            staffing.type_of[role],
            tuple(_asks(graph.tree.action(leaf)) for leaf in leaves),
            tuple(needs[group].items()),
            staffing.avoids[group],
        )
        found[role] = numbers.setdefault(asks, len(numbers))
    return found


def _asks(action: Action) -> object:
    nominal_s = action.duration_s if action.moves else None
    return action.at, action.moves, action.brings, nominal_s, tuple(action.uses.items()), action.holds
