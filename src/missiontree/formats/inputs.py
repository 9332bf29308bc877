"""What a plan was made from, by name, and the digests of it."""

from __future__ import annotations

from typing import Any

from missiontree.formats.digest import digest
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree


def inputs_of(brief: MissionBrief, tree: MissionTree | None) -> dict[str, Any]:
    """
    Every input by name.

    Mission (its words), fleet, scene, routines, entities, weights, kinds (enforced or not), goals, terms, estimator, tree.
    """
    inputs = {
        "mission": brief.text,
        "fleet": brief.fleet,
        "scene": brief.scene,
        "routines": brief.routines,
        "entities": brief.entities,
        "weights": brief.weights,
        "kinds": brief.check_kinds,
        "goals": brief.goals or None,
        "without": brief.without or None,
        "require": brief.require or None,
        "min_quality": brief.min_quality or None,
        "estimator": brief.estimator,
        "accumulate": None if brief.accumulate == "sum" else brief.accumulate,
        "diverse": brief.diverse or None,
        "parts": brief.parts or None,
        "return_home": brief.return_home or None,
        "objective": None if brief.objective == "utility" else brief.objective,
        "tree": tree,
    }
    return {name: value for name, value in inputs.items() if value is not None}


def input_digests(brief: MissionBrief, tree: MissionTree | None) -> dict[str, str]:
    """SHA-256 of the canonical JSON of each input, by name."""
    return {name: digest(value) for name, value in inputs_of(brief, tree).items()}
