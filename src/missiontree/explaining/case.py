"""What a mission is planned from, as far as it can be changed: the brief and the tree."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree


@dataclass(frozen=True, slots=True)
class Case:
    """
    A mission whose tree is built.

    Parameters
    ----------
    brief
        Fleet, scene, routines and terms.
    tree
        The mission tree; every leaf is a routine.
    """

    brief: MissionBrief
    tree: MissionTree
