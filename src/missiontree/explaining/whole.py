"""The whole mission as a tree, also where its author stopped at the first routine that no robot can do."""

from __future__ import annotations

from dataclasses import replace

from missiontree.authoring.author import authored_from_tree
from missiontree.authoring.formal import author_formal
from missiontree.authoring.methods.method import load_methods
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request


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
        What was authored, if its tree is complete. Where an author without a model declared that the mission cannot be done, the same
        author is asked once more for all of the tree, which then stands as one that was handed in. None where there is no such
        tree: a language model is not asked again.
    """
    if authored.status == "complete":
        return authored
    if authored.status != "cannot_be_done" or authored.author != "offline":
        return None
    author = author_formal if request.brief.goals else author_offline
    again = author(request.brief, load_methods(request.methods), by_anybody=True)
    if again.status != "complete" or again.tree is None:
        return None
    whole = authored_from_tree(again.tree, request.brief)
    if whole.status != "complete":
        return None
    return replace(
        whole, reading=again.reading, notices=(*whole.notices, *again.notices), assumptions=again.assumptions
    )
