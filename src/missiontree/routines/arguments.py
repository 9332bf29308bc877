"""What a routine node names: its routine, the entities of its arguments, the robot types it allows."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from difflib import get_close_matches

from missiontree.errors import InputError
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.routine import Routine, RoutineLibrary
from missiontree.mission.scene import Scene


def find_routine(spelling: str, library: RoutineLibrary, where: str) -> Routine:
    """The routine of that id or wire name; ``InputError`` with the nearest match if there is none."""
    routine = library.find(spelling)
    if routine is None:
        raise _unknown("routine", spelling, library.by_id, where)
    return routine


def find_entities(routine: Routine, arguments: Mapping[str, str], scene: Scene, where: str) -> dict[str, Entity]:
    """
    The entities that arguments name, by argument, in the routine's order.

    Raises
    ------
    InputError
        If an argument is missing or not the routine's, or nobody knows the entity.
    """
    check_arguments(routine, arguments, where)
    for name, entity in arguments.items():
        if entity not in scene.by_id:
            raise _unknown("entity", entity, scene.by_id, f"{where}.{name}")
    return {argument.name: scene.by_id[arguments[argument.name]] for argument in routine.arguments}


def check_arguments(routine: Routine, arguments: Iterable[str], where: str) -> None:
    """Raise ``InputError`` unless the names are those of the routine's arguments."""
    accepted = list(routine.argument_kinds)
    given = list(arguments)
    for name in given:
        if name not in accepted:
            raise InputError(
                f"routine {routine.id!r} has no argument {name!r}.", where=where, accepted=", ".join(accepted)
            )
    for name in accepted:
        if name not in given:
            raise InputError(
                f"routine {routine.id!r} lacks its argument {name!r}.", where=where, accepted=", ".join(accepted)
            )


def check_resources(resources: Iterable[str] | None, fleet: Fleet, where: str) -> None:
    """Raise ``InputError`` if a robot type is named that the fleet does not have."""
    for name in resources or ():
        if name not in fleet.by_id:
            raise _unknown("robot type", name, fleet.by_id, where)


def _unknown(what: str, name: str, known: Iterable[str], where: str) -> InputError:
    names = list(known)
    near = get_close_matches(name, names, n=1) or [each for each in names if each.casefold() == name.casefold()]
    shown = ", ".join(names[:20]) + (" ..." if len(names) > 20 else "")
    return InputError(
        f"{what} {name!r} is not known.",
        where=where,
        accepted=shown or "none is declared",
        hint=f"Did you mean {near[0]!r}?" if near else "",
    )
