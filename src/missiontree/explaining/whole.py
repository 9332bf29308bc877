"""The whole mission as a tree, also where its author stopped at the first routine that no robot can do."""

from __future__ import annotations

from missiontree.authoring.author import authored_from_tree
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.explaining.understood import understood
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree


def wholly_authored(request: Request, authored: Authored) -> Authored | None:
    """
    The mission with its whole tree, routines included that no robot can do.

    Parameters
    ----------
    request
        What is to be planned.
    authored
        What authoring came to.

    Returns
    -------
    Authored or None
        What was authored, if its tree is complete. Where an author without a model declared that the mission cannot be done, what the
        same author builds for a team that can do everything, as a tree that was handed in. None where there is no such tree: a
        language model is not asked again.
    """
    if authored.status == "complete":
        return authored
    if authored.status != "cannot_be_done" or authored.author != "offline":
        return None
    again = understood(request)
    return None if again is None or again.tree is None else as_given(again.tree, request.brief, again)


def as_given(tree: MissionTree, brief: MissionBrief, told: Authored | None = None) -> Authored:
    """A tree as one that was handed in, whoever can do what; with the reading and the assumptions of whoever built it."""
    found = authored_from_tree(tree, brief)
    notices = (*found.notices, *(told.notices if told is not None else ()))
    return Authored(
        status="complete",
        tree=tree,
        notices=tuple(dict.fromkeys(notices)),
        assumptions=told.assumptions if told is not None else (),
        reading=told.reading if told is not None else (),
        author="given",
    )
