"""
Which steps of which routine a robot's actions are, read off the routine library afresh.

A robot's part in a routine is a *stretch* of steps, or several stretches one after the other where a composed routine lets one
robot fill the roles of several parts.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from missiontree.mission.grounded import Action
from missiontree.mission.routine import ActionStep, Branch, RoleSpec, Routine, RoutineLibrary

Names = Mapping[str, str]
"""Entity by argument."""


class Stretch(NamedTuple):
    """
    A role of a branch as one part of what a robot does, with the entities of the branch's arguments.

    ``within`` names the routines around it, the called one first and its own last.
    """

    routine: Routine
    branch: Branch
    role: RoleSpec
    entities: Names
    within: tuple[str, ...] = ()

    def place(self, argument: str | None) -> str | None:
        """Entity that an argument stands for."""
        return None if argument is None else self.entities.get(argument)


class Slot(NamedTuple):
    """A plain routine whose branches offer stretches, with the entities of its arguments, and the routines around it."""

    routine: Routine
    entities: Names
    within: tuple[str, ...] = ()


def chains(
    routine: Routine, entities: Names, library: RoutineLibrary, around: tuple[str, ...] = ()
) -> list[list[Slot]]:
    """What robots may be asked to do in a routine call: for each robot's part, the plain routines it passes through."""
    within = (*around, routine.id)
    if not routine.parts:
        return [[Slot(routine, entities, within)]]
    found: list[list[Slot]] = []
    held: list[Slot] = []
    for index, part in enumerate(routine.parts):
        inner = library.by_id[part.routine]
        own = {
            argument.name: entities[outer]
            for argument in inner.arguments
            if (outer := part.arguments.get(argument.name, argument.name)) in entities
        }
        below = chains(inner, own, library, within)
        if index in routine.same_robot:
            held += [slot for chain in below for slot in chain]
        else:
            found += below
    return [*([held] if held else []), *found]


def readings(chain: Sequence[Slot], actions: Sequence[Action]) -> list[list[Stretch]]:
    """Ways to read a robot's actions as stretches of a chain, one from each of its routines; empty if there is none."""
    partial: list[tuple[int, list[Stretch]]] = [(0, [])]
    for slot in chain:
        partial = [
            (place + len(role.actions), [*stretches, Stretch(slot.routine, branch, role, slot.entities, slot.within)])
            for place, stretches in partial
            for branch in slot.routine.branches
            for role in branch.roles
            if _fits(role.actions, actions[place : place + len(role.actions)], role.rating)
        ]
    return [stretches for place, stretches in partial if place == len(actions)]


def _fits(steps: Sequence[ActionStep], actions: Sequence[Action], rating: str) -> bool:
    return len(steps) == len(actions) and all(
        step.name == action.name and action.capability == rating for step, action in zip(steps, actions, strict=True)
    )
