"""Where routines occur in a plan: as its leaves, and as the parts of composed leaves."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from missiontree.evaluation.names import Words, scene_id, words_of
from missiontree.evaluation.notation import ANYTHING, PlannedCall
from missiontree.evaluation.structure import Named, Structure
from missiontree.mission.brief import MissionBrief
from missiontree.mission.routine import RoutineLibrary
from missiontree.routines.open_ended import is_open_ended


@dataclass(frozen=True, slots=True)
class Occurrence:
    """
    A routine that is done.

    Parameters
    ----------
    routine
        Its id.
    arguments
        What it is about.
    types
        Robot types allowed.
    leaf
        Place of the leaf that it is, or is a part of.
    steps
        Which part of the leaf it is: indices of parts, outermost first; empty for the leaf itself.
    open_ended
        Whether it has no end of its own.
    """

    routine: str
    arguments: tuple[Named, ...]
    types: frozenset[str]
    leaf: int
    steps: tuple[int, ...] = ()
    open_ended: bool = False

    def precedes_within(self, other: Occurrence) -> bool:
        """Whether both are parts of one leaf, and this one is over before the other starts."""
        if self.leaf != other.leaf:
            return False
        apart = next((pair for pair in zip(self.steps, other.steps, strict=False) if pair[0] != pair[1]), None)
        return apart is not None and apart[0] < apart[1]


def occurrences(plan: Structure, library: RoutineLibrary) -> tuple[Occurrence, ...]:
    """Every leaf, each followed by the routines that it is composed of."""
    found: list[Occurrence] = []
    for place, leaf in enumerate(plan.leaves):
        found += _with_parts(Occurrence(leaf.routine, leaf.arguments, leaf.types, place), library)
    return tuple(found)


def _with_parts(one: Occurrence, library: RoutineLibrary) -> Iterator[Occurrence]:
    routine = library.by_id.get(one.routine)
    if routine is None:
        yield one
        return
    yield Occurrence(one.routine, one.arguments, one.types, one.leaf, one.steps, is_open_ended(routine, library))
    given = dict(zip(routine.argument_kinds, one.arguments, strict=False))
    for index, part in enumerate(routine.parts):
        inner = library.by_id[part.routine]
        names = [part.arguments.get(argument.name, argument.name) for argument in inner.arguments]
        arguments = tuple(given[name] for name in names if name in given)
        yield from _with_parts(Occurrence(inner.id, arguments, one.types, one.leaf, (*one.steps, index)), library)


def is_meant(name: str, found: Named, pairs: dict[str, Words], brief: MissionBrief) -> bool:
    """
    Whether a suite's name means this argument of a plan.

    Parameters
    ----------
    name
        The name; ``*`` means anything.
    found
        The argument.
    pairs
        What each name of the plan that is not of the scene is taken for: its key to words of the suite.
    brief
        What the author was given.
    """
    if name == ANYTHING:
        return True
    known = scene_id(name, brief.world)
    if known is not None:
        return found.in_scene and found.key == known
    return not found.in_scene and pairs.get(found.key) == words_of(name)


def answers(call: PlannedCall, one: Occurrence, pairs: dict[str, Words], brief: MissionBrief) -> bool:
    """Whether an occurrence is one of this call, robot types aside."""
    routine = brief.routines.find(call.routine)
    if routine is None or routine.id != one.routine or len(call.arguments) != len(one.arguments):
        return False
    return all(is_meant(name, found, pairs, brief) for name, found in zip(call.arguments, one.arguments, strict=True))
