"""Missions that cannot be done, each for one reason that can be read off it."""

from __future__ import annotations

from typing import Any

from missiontree.briefing import Request
from missiontree.formats.document import read_text
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.routines.library import built_in

FLEET = """
types:
  - {id: rover, label: Rover, count: 1, capabilities: {search: 0.8, reach: 0.8}, limits: {max_speed_mps: 1}, place: dock}
  - {id: arm, label: Arm, count: 1, capabilities: {carry: 1.0}, limits: {max_speed_mps: 1, payload_kg: 15, energy_j: 600}, place: dock,
     uses_per_m: {energy_j: 5}}
"""
SCENE = """
places:
  - {id: dock, position: {x_m: 0, y_m: 0}}
  - {id: hall, position: {x_m: 30, y_m: 0}}
entities:
  - {id: crate, mass_kg: 12, place: hall}
  - {id: Anna, kind: person, place: hall}
"""
ROADS = "roads: {roads: [{ends: [dock, hall]}]}\n"
CARRY = ("Transport", {"agent": "crate", "location": "dock"})
FIND = ("Search", {"agent": "Anna"})


def mission(
    *calls: tuple[str, dict[str, str]],
    fleet: str = FLEET,
    scene: str = SCENE,
    links: tuple[Link, ...] = (),
    resources: tuple[str, ...] | None = None,
    due: dict[str, float] | None = None,
    **terms: Any,
) -> Request:
    """A mission of routines, each a child of the root and named ``n0``, ``n1`` and so on; resources are those of ``n0``."""
    leaves = tuple(
        MissionNode(
            id=f"n{number}",
            label=f"{routine}({', '.join(arguments.values())})",
            routine=routine,
            arguments=arguments,
            resources=resources if number == 0 else None,
            deadline_s=(due or {}).get(f"n{number}"),
        )
        for number, (routine, arguments) in enumerate(calls)
    )
    root = MissionNode(id="root", label="Mission", gate="and", children=tuple(leaf.id for leaf in leaves))
    tree = MissionTree(objective="Mission", nodes=(root, *leaves), links=links)
    brief = MissionBrief(
        text="Mission",
        fleet=read_text(fleet, "fleet"),
        scene=read_text(scene, "scene"),
        **{"routines": built_in(), **terms},
    )
    return Request(brief=brief, tree=tree)
