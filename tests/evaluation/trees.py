"""Trees and briefs of the tests, written by hand: a tree is nested tuples, a leaf its routine, arguments and robot types."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Gate, Link, MissionNode, MissionTree
from missiontree.routines.library import built_in
from tests.builders import paper_fleet

HOUSE = Scene(
    places=(Entity(id="ward_3", kind="place", label="Ward 3", aliases=("infirmary",), position=Position(0, 0)),),
    entities=(
        Entity(id="anna", kind="person", label="Anna Berg", aliases=("nurse",), place="ward_3"),
        Entity(id="cup_1", label="Cup"),
        Entity(id="cup_2", label="Cup"),
    ),
)


def brief(scene: Scene | None = None) -> MissionBrief:
    return MissionBrief(text="-", fleet=paper_fleet(), routines=built_in(), scene=scene)


def leaf(name: str, call: str, *types: str) -> MissionNode:
    """A routine node from ``Reach(anna)``; the names in it are entity ids."""
    routine, _, inner = call.removesuffix(")").partition("(")
    names = ("agent", "location")
    arguments = dict(zip(names, (part.strip() for part in inner.split(",")), strict=False))
    return MissionNode(id=name, label=call, routine=routine, arguments=arguments, resources=types or None)


def task(name: str, gate: Gate, *children: Any) -> tuple[str, Gate, tuple[Any, ...]]:
    return name, gate, children


def tree(*children: Any, links: Sequence[Link] = (), new: Sequence[str] = (), gate: Gate = "and") -> MissionTree:
    """A tree whose root has these children; ``new`` are labels of introduced entities, their ids in lower case with ``_``."""
    entities = tuple(Entity(id=label.lower().replace(" ", "_"), label=label) for label in new)
    return MissionTree(
        objective="-", nodes=tuple(_nodes(task("root", gate, *children))), links=tuple(links), entities=entities
    )


def _nodes(spec: Any) -> list[MissionNode]:
    if isinstance(spec, MissionNode):
        return [spec]
    name, gate, children = spec
    below = [_nodes(child) for child in children]
    top = MissionNode(
        id=name, label=name, gate=gate if children else None, children=tuple(part[0].id for part in below)
    )
    return [top, *(node for part in below for node in part)]
