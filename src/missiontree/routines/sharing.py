"""Shared resources that the actions of a branch hold: which they are, and whether joint work asks for more than there is room for."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from missiontree.mission.entity import Entity
from missiontree.mission.reason import Reason
from missiontree.mission.routine import ActionStep
from missiontree.mission.scene import Scene
from missiontree.routines.compose import FlatBranch


def held_by(step: ActionStep, entities: Mapping[str, Entity], scene: Scene) -> tuple[str, ...]:
    """Shared resources of the scene that an action holds, by id; what the scene has no limit for is left out."""
    named = dict.fromkeys(_named(held, entities) for held in step.holds)
    return tuple(name for name in named if name in scene.shared)


def too_crowded(branch: FlatBranch, entities: Mapping[str, Entity], scene: Scene, task: str) -> Reason | None:
    """Why a branch cannot be done because of what its joint actions hold together; None if nothing stands against it."""
    together: Counter[tuple[str, str]] = Counter()
    for role in branch.roles:
        for action in role.actions:
            for name in held_by(action.step, entities, scene):
                if action.sync is not None:
                    together[action.sync, name] += role.robots
    for (_, name), robots in together.items():
        shared = scene.shared[name]
        if robots > shared.capacity:
            return Reason(
                rule="resource_too_small",
                message=f"{task} has {robots} robots hold {shared.label} at once, and it has room for {shared.capacity}.",
                found=f"capacity {shared.capacity}",
                needed=f"capacity {robots}",
                hint=f"Raise the capacity of {name}, or let the robots act one after the other.",
            )
    return None


def without_limit(branch: FlatBranch, entities: Mapping[str, Entity], scene: Scene, task: str) -> tuple[Reason, ...]:
    """What the actions of a branch hold and the scene has no capacity for: as many robots as like may hold it, as an assumption."""
    held = (held for role in branch.roles for action in role.actions for held in action.step.holds)
    names = dict.fromkeys(_named(each, entities) for each in held)
    return tuple(
        Reason(
            rule="resource_unlimited",
            severity="assumption",
            message=f"{task} holds {name}, which is no shared resource of the scene; any number of robots may hold it at once.",
            found=name,
            needed=", ".join(scene.shared) or "resources in the scene",
            hint=f"Declare it under resources of the scene: {{id: {name}, capacity: 1}}.",
        )
        for name in names
        if name not in scene.shared
    )


def _named(held: str, entities: Mapping[str, Entity]) -> str:
    return entities[held[1:-1]].id if held.startswith("{") else held
