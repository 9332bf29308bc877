"""The whole mission as a tree, also where its author stopped at the first routine that no robot can do."""

from __future__ import annotations

from dataclasses import replace

from missiontree.authoring.author import authored_from_tree
from missiontree.authoring.methods.method import load_methods
from missiontree.authoring.naming import make_id
from missiontree.authoring.offline import author_served
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.explaining.understood import eased, understood
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionNode, MissionTree


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
    return wholly_understood(request)


def wholly_understood(request: Request) -> Authored | None:
    """
    What the author without a model makes of a mission for a team that can do everything; None if it does not understand it.

    A goal that no routine serves stands in the tree as a task without children, which nobody can do.
    """
    again = understood(request)
    if again is not None and again.tree is not None:
        return as_given(again.tree, request.brief, again)
    if request.brief.goals:
        return None
    methods = load_methods(request.methods)
    for brief in eased(request.brief):
        made, aside = author_served(brief, methods)
        if made.status == "complete" and made.tree is not None and aside and made.tree.root.gate == "and":
            return as_given(_with_tasks(made.tree, aside), request.brief, made)
    return None


def _with_tasks(tree: MissionTree, labels: tuple[str, ...]) -> MissionTree:
    """The tree with tasks below its root that have no children."""
    taken = set(tree.by_id)
    tasks = []
    for label in labels:
        tasks.append(MissionNode(id=make_id(label, taken, "task"), label=label))
        taken.add(tasks[-1].id)
    root = replace(tree.root, children=(*tree.root.children, *(task.id for task in tasks)))
    return replace(tree, nodes=(root, *tree.nodes[1:], *tasks))


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
