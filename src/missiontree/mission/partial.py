"""What a plan leaves out of a mission that cannot be done as a whole, and what is known of there being no larger part."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.tree import MissionTree
from missiontree.mission.value import Count, Id, Positive, Value

PartClaim = Literal["proven", "found"]


@dataclass(frozen=True, slots=True)
class LeftOut(Value):
    """
    A part of the mission that is not done.

    Parameters
    ----------
    node
        Id of the node in the whole mission tree: a child of an AND that has other children.
    weight
        How much it counts, above 0.
    """

    node: Id
    weight: Positive


@dataclass(frozen=True, kw_only=True)
class Partial(Value):
    """
    What was taken away from the whole mission so that the rest can be done.

    The weight of a node is what the mission file says (``parts``), else that of what stands below it: a routine counts 1, an AND as
    much as its children together, an XOR as much as its lightest child, and each child of an XOR as much as the XOR.

    Parameters
    ----------
    whole
        The mission tree as it was authored. The plan's own tree is what is left of it.
    left_out
        What is not done, in tree order, none below another.
    total, kept
        Weight of the whole mission, and of what is done.
    claim
        ``proven``: no part of greater weight can be done. ``found``: a larger part is not excluded.
    examined
        How many parts were planned before this one was found, itself included.
    """

    whole: MissionTree
    left_out: tuple[LeftOut, ...]
    total: Positive
    kept: Positive
    claim: PartClaim
    examined: Count = 1
