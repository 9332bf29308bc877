"""Whether a mission's plans speak only of what its setting has: routines, robot types, entities that a name tells apart."""

from __future__ import annotations

from missiontree.evaluation.expected import Expected
from missiontree.evaluation.names import ambiguous_in
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.formats.fault import nearest
from missiontree.mission.fleet import Fleet
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.routines.open_ended import is_open_ended


def misfit(mission: SuiteMission, fleet: Fleet, routines: RoutineLibrary, scene: Scene | None) -> str:
    """What a mission's plans say that the setting does not have, in words; empty if nothing."""
    found = (_misfit(expected, fleet, routines, scene) for expected in mission.expected)
    return next((f"mission {mission.id!r}: {words}" for words in found if words), "")


def _misfit(expected: Expected, fleet: Fleet, library: RoutineLibrary, scene: Scene | None) -> str:
    for text, call in zip(expected.texts, expected.calls, strict=True):
        routine = library.find(call.routine)
        if routine is None:
            known = tuple(library.by_id)
            return f"{text!r} names no routine; there are {', '.join(known)}. {nearest(call.routine, known)}".strip()
        if len(call.arguments) != len(routine.arguments):
            accepted = ", ".join(argument.name for argument in routine.arguments)
            return f"{text!r} has {len(call.arguments)} arguments; {routine.id} takes {len(routine.arguments)}: {accepted}."
        types = tuple(fleet.by_id)
        for name in call.types:
            if name not in types:
                return (
                    f"{text!r} names no robot type {name}; there are {', '.join(types)}. {nearest(name, types)}".strip()
                )
        if call.by is None and set(call.not_by) == set(types):
            return f"{text!r} leaves no robot type."
        for name in call.arguments:
            if scene is not None and (several := ambiguous_in(name, scene)):
                return f"{text!r} may mean any of {', '.join(several)}; use an id."
    for text, order in zip(expected.order, expected.relations, strict=True):
        first = library.find(expected.calls[order.first - 1].routine)
        if order.relation == "~" and first is not None and not is_open_ended(first, library):
            return f"{text!r} has no meaning; {first.id} ends by itself."
    return ""
