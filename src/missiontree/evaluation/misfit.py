"""Whether a mission's plans speak only of what its setting has: routines, robot types, entities that a name tells apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from missiontree.evaluation.names import ambiguous_in
from missiontree.evaluation.notation import ANYTHING, Order, PlannedCall
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.formats.fault import nearest
from missiontree.mission.fleet import Fleet
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.routines.open_ended import is_open_ended


def misfit(mission: SuiteMission, fleet: Fleet, routines: RoutineLibrary, scene: Scene | None) -> str:
    """What a mission's expectations say that its world does not have, in words; empty if nothing."""
    found = (words for part in _parts(mission) for words in _misfits(part, fleet, routines, scene))
    return next((f"mission {mission.id!r}: {words}" for words in found), "")


class _Part(NamedTuple):
    """Calls with the order between them, and names that stand alone."""

    texts: Sequence[str]
    calls: Sequence[PlannedCall]
    order: Sequence[str] = ()
    relations: Sequence[Order] = ()
    names: Sequence[str] = ()


def _parts(mission: SuiteMission) -> Iterator[_Part]:
    for expected in mission.expected:
        yield _Part(expected.texts, expected.calls, expected.order, expected.relations)
    if (loose := mission.loose) is not None:
        yield _Part(loose.must, loose.calls, loose.order, loose.relations, loose.entities)
        yield _Part(loose.must_not, loose.refused)


def _misfits(part: _Part, fleet: Fleet, library: RoutineLibrary, scene: Scene | None) -> Iterator[str]:
    for text, call in zip(part.texts, part.calls, strict=True):
        routine = library.find(call.routine)
        if routine is None:
            known = tuple(library.by_id)
            yield f"{text!r} names no routine; there are {', '.join(known)}. {nearest(call.routine, known)}".strip()
        elif len(call.arguments) != len(routine.arguments):
            accepted = ", ".join(argument.name for argument in routine.arguments)
            yield f"{text!r} has {len(call.arguments)} arguments; {routine.id} takes {len(routine.arguments)}: {accepted}."
        yield from _misfits_of_types(text, call, tuple(fleet.by_id))
        yield from _misfits_of_names(text, call.arguments, scene)
    for name in part.names:
        yield from _misfits_of_names(name, (name,), scene)
    for text, order in zip(part.order, part.relations, strict=True):
        first = library.find(part.calls[order.first - 1].routine)
        if order.relation == "~" and first is not None and not is_open_ended(first, library):
            yield f"{text!r} has no meaning; {first.id} ends by itself."


def _misfits_of_types(text: str, call: PlannedCall, types: tuple[str, ...]) -> Iterator[str]:
    for name in call.types:
        if name not in types:
            yield f"{text!r} names no robot type {name}; there are {', '.join(types)}. {nearest(name, types)}".strip()
    if call.by is None and set(call.not_by) == set(types):
        yield f"{text!r} leaves no robot type."


def _misfits_of_names(text: str, names: Sequence[str], scene: Scene | None) -> Iterator[str]:
    for name in names:
        if scene is not None and name != ANYTHING and (several := ambiguous_in(name, scene)):
            yield f"{text!r} may mean any of {', '.join(several)}; use an id."
