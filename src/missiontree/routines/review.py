"""What may be wrong with a mission tree, and what is taken for granted about where things are."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches

from missiontree.mission.fleet import Fleet
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.tree import MissionTree
from missiontree.routines.calls import Call
from missiontree.routines.order import RoutineOrder
from missiontree.routines.selection import CoSelection


def never_binding(tree: MissionTree, selection: CoSelection) -> list[Reason]:
    """Links between children of one XOR, of which never more than one is done."""
    number = {node.id: index for index, node in enumerate(tree.nodes)}
    return [
        Reason(
            rule="link_never_binds",
            severity="warning",
            message=f"The {link.kind} link of {tree.by_id[link.first].label} and {tree.by_id[link.second].label} never binds: "
            "they are alternatives, only one of them is done.",
            node=link.first,
            found=f"{link.kind} {link.first} - {link.second}",
            hint="Drop the link, or make the gate above them AND.",
        )
        for link in tree.links
        if selection.exclusive(number[link.first], number[link.second])
    ]


def lost_entities(tree: MissionTree, calls: Mapping[str, Call], order: RoutineOrder, world: Scene) -> list[Reason]:
    """Uses of entities whose position is not known, where no search (or move) of them comes first for sure."""
    findings: list[Reason] = []
    for leaf in order.leaves:
        node = tree.nodes[leaf]
        lost = [
            world.by_id[entity]
            for entity in calls[node.id].touch.unfound
            if world.whereabouts(world.by_id[entity]).source != "known"
        ]
        if not lost:
            continue
        before = [calls[tree.nodes[each].id] for each in sorted(order.leaves_before(leaf)) if tree.nodes[each].routine]
        located = {entity for call in before for entity in (*call.touch.finds, *call.touch.moves)}
        findings += [
            Reason(
                rule="entity_not_located",
                severity="warning",
                message=f"{node.label} uses {entity.label}, whose position is not known, and nothing finds it first.",
                node=node.id,
                found=f"{entity.label}: position {world.whereabouts(entity).source}",
                needed="a search that comes before",
                hint=f"Search for {entity.label} first, or give it a position.",
            )
            for entity in lost
            if entity.id not in located
        ]
    return findings


def assumed_positions(calls: Mapping[str, Call], world: Scene, has_scene: bool) -> list[Reason]:
    """Positions that planning takes for granted, and, in a scene, those that nobody knows; one Reason per entity."""
    used = dict.fromkeys(entity for call in calls.values() for entity in call.touch.uses)
    assumed: list[Reason] = []
    for entity in map(world.by_id.__getitem__, used):
        where = world.whereabouts(entity)
        if where.source == "unknown" and has_scene:
            assumed.append(
                Reason(
                    rule="position_unknown",
                    severity="assumption",
                    message=f"The position of {entity.label} is not known; going there takes the routine's nominal time.",
                    node=entity.id,
                    found="no position, last_seen or search_area",
                    hint="Give it a position, a last_seen or a search_area in the scene.",
                )
            )
        elif where.position is not None and where.source in {"last_seen", "search_area"}:
            how = "where it was seen last" if where.source == "last_seen" else "in the middle of its search area"
            assumed.append(
                Reason(
                    rule="position_assumed",
                    severity="assumption",
                    message=f"{entity.label} is taken to be {how}, at {_shown(where.position)}, until it is found.",
                    node=entity.id,
                    found=where.source,
                )
            )
    return assumed


def idle_chargers(fleet: Fleet, world: Scene) -> list[Reason]:
    """Chargers that refill what no robot that may use them has a limit of, so that nobody ever refills there."""
    findings: list[Reason] = []
    for charger in world.chargers:
        served = [kind for kind in fleet.types if charger.serves(kind.id)]
        known = list(dict.fromkeys(limit for kind in served for limit in kind.limits))
        if charger.stock in known:
            continue
        near = get_close_matches(charger.stock, known, n=1)
        findings.append(
            Reason(
                rule="charger_idle",
                severity="warning",
                message=f"Nobody refills at {charger.label}: no robot type that may has a limit of {charger.stock}.",
                node=charger.id,
                found=charger.stock,
                needed=", ".join(known) or "a limit of a robot type",
                hint=f"Did you mean {near[0]!r}?"
                if near
                else f"State how much is full as limit {charger.stock} of a type.",
            )
        )
    return findings


def _shown(position: Position) -> str:
    return f"({position.x_m:g}, {position.y_m:g}) on floor {position.floor}"
