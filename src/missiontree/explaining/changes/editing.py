"""Copies of a case with one part replaced."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from missiontree.explaining.case import Case
from missiontree.mission.fleet import RobotType
from missiontree.mission.scene import Scene


def with_brief(case: Case, **fields: Any) -> Case:
    """The case with fields of its brief replaced."""
    return replace(case, brief=replace(case.brief, **fields))


def with_type(case: Case, type_id: str, change: Callable[[RobotType], RobotType]) -> Case:
    """The case with one robot type changed."""
    fleet = case.brief.fleet
    types = tuple(change(kind) if kind.id == type_id else kind for kind in fleet.types)
    return with_brief(case, fleet=replace(fleet, types=types))


def with_scene(case: Case, **fields: Any) -> Case:
    """The case with fields of its scene replaced."""
    scene = case.brief.scene if case.brief.scene is not None else Scene()
    return with_brief(case, scene=replace(scene, **fields))


def with_node(case: Case, node_id: str, **fields: Any) -> Case:
    """The case with fields of one node of the tree replaced."""
    nodes = tuple(replace(node, **fields) if node.id == node_id else node for node in case.tree.nodes)
    return replace(case, tree=replace(case.tree, nodes=nodes))


def put(numbers: Mapping[str, float], name: str, to: float | None) -> dict[str, float]:
    """Numbers by name with one of them replaced; without it if it is to be None."""
    kept = {other: number for other, number in numbers.items() if other != name}
    return kept if to is None else kept | {name: to}


def shown(number: float | None) -> str:
    """A number as people read it."""
    return "any number" if number is None else f"{number:.12g}"
