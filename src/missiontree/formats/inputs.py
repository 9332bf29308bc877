"""Digests of what a plan was made from."""

from __future__ import annotations

from missiontree.formats.digest import digest
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree


def input_digests(brief: MissionBrief, tree: MissionTree | None) -> dict[str, str]:
    """SHA-256 of the canonical JSON of each input by name: mission (its words), fleet, scene, routines, tree."""
    inputs = {
        "mission": brief.text,
        "fleet": brief.fleet,
        "scene": brief.scene,
        "routines": brief.routines,
        "tree": tree,
    }
    return {name: digest(value) for name, value in inputs.items() if value is not None}
