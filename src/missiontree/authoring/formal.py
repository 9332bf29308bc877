"""
The author of goals that are stated formally: the same mission methods, the same calls and the same checks, with no words to read.

Whoever is named must be known: to the scene, to the entities of the mission file, or, without a scene, by the goals themselves.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product

from missiontree.authoring.building import built
from missiontree.authoring.composing.composing import composed
from missiontree.authoring.composing.composition import Composition
from missiontree.authoring.conditional import conditional_links
from missiontree.authoring.desk import Desk
from missiontree.authoring.methods.method import MethodLibrary, built_in_methods
from missiontree.authoring.methods.outline import NobodyError, Piece
from missiontree.authoring.outcome import Authored
from missiontree.authoring.stating import Statements
from missiontree.authoring.timing import give_times
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason
from missiontree.mission.tree import LinkKind

Call = tuple[str, tuple[str, ...], tuple[str, ...]]


def author_formal(brief: MissionBrief, methods: MethodLibrary | None = None) -> Authored:
    """
    Have the tree of a mission built whose goals are stated formally.

    Parameters
    ----------
    brief
        The mission.
    methods
        The mission methods; default: those that ship with missiontree.

    Returns
    -------
    Authored
        ``complete``, ``cannot_be_done`` or ``incomplete``; ``reading`` has a line for each goal.
    """
    desk = Desk(brief)
    stated = Statements(brief, methods or built_in_methods())
    try:
        goals = [stated.understood(goal, str(number)) for number, goal in enumerate(brief.goals, 1)]
    except NobodyError as nobody:
        desk.reading = tuple(filter(None, stated.reading))
        return desk.declared_impossible((_lacking(nobody.capability, brief),), nobody.capability)
    desk.reading = tuple(stated.reading)
    if stated.troubles:
        return desk.ended("incomplete", stated.troubles)
    links = stated.linked()
    calls = {piece: [leaf.call for leaf in piece.leaves] for link in links for piece in link[:2]}
    timed = {piece: [leaf.call for leaf in piece.leaves] for _, pieces in stated.timed() for piece in pieces}
    made = composed(goals, brief.routines)
    _stand_in(made, links, calls)
    if contradiction := give_times(stated.timed(), timed, made.outline):
        return desk.ended("incomplete", (contradiction,))
    made.notices += conditional_links(brief.goals)
    return built(desk, made, [assumption for goal in goals for assumption in goal.assumptions])


def _lacking(capability: str, brief: MissionBrief) -> Reason:
    types = ", ".join(kind.label or kind.id for kind in brief.fleet.types)
    return Reason(
        rule="capability_missing",
        message=f"The mission needs the capability {capability}, which no robot type has; there are {types}.",
        needed=capability,
        hint=f"Give the capability {capability} to a robot type that has it.",
    )


def _stand_in(
    made: Composition, links: Sequence[tuple[Piece, Piece, LinkKind]], calls: Mapping[Piece, Sequence[Call]]
) -> None:
    """What is searched for once may have left a goal with nothing of its own: its links go to what is done instead."""
    standing = set(made.outline.all_pieces)
    leaves = [piece for piece in standing if piece.routine is not None]
    for link in links:
        if standing.issuperset(link[:2]):
            continue
        ends = [[end] if end in standing else [leaf for leaf in leaves if leaf.call in calls[end]] for end in link[:2]]
        made.outline.links[:] = [kept for kept in made.outline.links if kept != link]
        for first, second in product(*ends):
            made.outline.link(first, second, link[2])
