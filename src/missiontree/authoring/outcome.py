"""What authoring came to: a value, whatever happened."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.reason import Reason
from missiontree.mission.spent import Spent
from missiontree.mission.tree import MissionTree
from missiontree.mission.value import Id, Value

AuthoringStatus = Literal["complete", "cannot_be_done", "incomplete", "exhausted", "provider_failed"]


@dataclass(frozen=True, kw_only=True)
class Authored(Value):
    """
    The end of a dialogue between an author and the tree-building functions.

    Parameters
    ----------
    status
        ``complete``: the tree passed the finish gate. ``cannot_be_done``: declared so, with reasons. ``incomplete``: it did not pass
        the gate, or words were not understood. ``exhausted``: a budget ran out. ``provider_failed``: the model could not be used.
    tree
        The tree as far as it was built; None if nothing was.
    reasons
        Why the status is not ``complete``.
    notices, assumptions
        What was changed or taken for granted on the way.
    transcript
        The dialogue, one canonical JSON object per line.
    reading
        How an author that reads plain language understood the text, a line per clause.
    author, model
        Who built it, see :class:`missiontree.mission.plan.Provenance`.
    spent
        What the dialogue took; None if no model was asked.
    """

    status: AuthoringStatus
    tree: MissionTree | None = None
    reasons: tuple[Reason, ...] = ()
    notices: tuple[Reason, ...] = ()
    assumptions: tuple[Reason, ...] = ()
    transcript: tuple[str, ...] = ()
    reading: tuple[str, ...] = ()
    author: Id = "offline"
    model: str = ""
    spent: Spent | None = None
