"""Whether a robot type can fill a role: capabilities, limits and zones. What is unknown refuses nobody, but is stated."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from missiontree.mission.entity import Entity
from missiontree.mission.fleet import RobotType
from missiontree.mission.reason import Reason
from missiontree.mission.routine import Need
from missiontree.mission.scene import Scene
from missiontree.mission.terms import Terms
from missiontree.routines.compose import FlatBranch, FlatRole
from missiontree.routines.zones import zones_of


@dataclass(frozen=True, slots=True)
class Verdict:
    """
    What is to be said of a type in a role.

    Parameters
    ----------
    refused
        Why it cannot fill the role; empty if it can.
    assumed
        What was unknown and taken in its favour.
    """

    refused: tuple[Reason, ...] = ()
    assumed: tuple[Reason, ...] = ()


def judge(role: FlatRole, robot_type: RobotType, entities: Mapping[str, Entity], scene: Scene, task: str) -> Verdict:
    """
    Judge one type for one role.

    Parameters
    ----------
    role
        The robot's part.
    robot_type
        The candidate.
    entities
        Entities by argument.
    scene
        Where zones and kinds are declared.
    task
        Name of the work in messages, such as ``Search(Child)``.
    """
    found = [reason for need in role.needs if (reason := _judge_need(need, robot_type, entities, task)) is not None]
    found += _zones_refused(role, robot_type, entities, scene, task)
    return Verdict(
        refused=tuple(reason for reason in found if reason.severity == "error"),
        assumed=tuple(reason for reason in found if reason.severity == "assumption"),
    )


def quality_refused(
    role: FlatRole, robot_type: RobotType, qualities: Sequence[float], terms: Terms, routine: str, task: str
) -> Reason | None:
    """Why a type that does the actions of a role so well is not good enough for the mission; None if it is. The worst is told."""
    worst: tuple[float, str, float, float] | None = None
    for action, quality in zip(role.actions, qualities, strict=True):
        least = terms.least_quality(action.rating, (*action.parts, routine))
        if quality < least:
            worst = min(worst or (0.0, "", 0.0, 0.0), (quality - least, action.rating, quality, least))
    if worst is None:
        return None
    _, capability, found, needed = worst
    return Reason(
        rule="quality_below_minimum",
        message=f"{robot_type.label} is not good enough for {task}: quality of {capability} {found:g}, and the mission asks for "
        f"at least {needed:g}.",
        robot=robot_type.id,
        found=f"{capability} {found:g}",
        needed=f"{capability} {needed:g}",
        hint="Lower min_quality of the mission, or take a robot that does it better.",
    )


def kind_refused(branch: FlatBranch, entities: Mapping[str, Entity], scene: Scene, task: str) -> Reason | None:
    """Why the branch does not take these entities; None if it does. Kinds declared under an accepted kind count."""
    for argument, accepted in branch.accepts:
        entity = entities[argument]
        if not set(scene.lineage(entity.kind)) & set(accepted):
            kinds = " or ".join(accepted)
            return Reason(
                rule="kind_refused",
                message=f"{task} takes as {argument} only {kinds}, and {entity.label} is of kind {entity.kind}.",
                found=f"{entity.label}: {entity.kind}",
                needed=kinds,
            )
    return None


def _judge_need(need: Need, robot_type: RobotType, entities: Mapping[str, Entity], task: str) -> Reason | None:
    if need.capability is not None:
        return _judge_capability(need, need.capability, robot_type, task)
    assert need.limit is not None, "a need names a capability or a limit"
    wanted, why = _wanted(need, entities)
    has = robot_type.limits.get(need.limit)
    if wanted is None:
        return Reason(
            rule="attribute_unknown",
            severity="assumption",
            message=f"{task}: {why} is unknown; {need.limit} of {robot_type.label} is taken to be sufficient.",
            robot=robot_type.id,
            needed=why,
        )
    if has is None:
        return Reason(
            rule="limit_unknown",
            severity="assumption",
            message=f"{task}: {robot_type.label} states no {need.limit}; it is taken to meet {wanted:.12g}{_because(why)}.",
            robot=robot_type.id,
            needed=f"{need.limit} {wanted:.12g}{_because(why)}",
        )
    too_low = need.at_least is not None and has < wanted
    if not too_low and not (need.at_most is not None and has > wanted):
        return None
    return Reason(
        rule="limit_too_low" if too_low else "limit_too_high",
        message=f"{robot_type.label} cannot do {task}: {need.limit} {has:.12g}, needed "
        f"{'' if too_low else 'at most '}{wanted:.12g}{_because(why)}.",
        robot=robot_type.id,
        found=f"{need.limit} {has:.12g}",
        needed=f"{need.limit} {wanted:.12g}{_because(why)}",
    )


def _judge_capability(need: Need, capability: str, robot_type: RobotType, task: str) -> Reason | None:
    has = robot_type.capability(capability)
    if has is None:
        return Reason(
            rule="capability_missing",
            message=f"{robot_type.label} cannot do {task}: it lacks the capability {capability}.",
            robot=robot_type.id,
            found=", ".join(robot_type.capabilities) or "no capability",
            needed=capability,
        )
    if isinstance(need.at_least, str) or need.at_least is None or has.quality >= need.at_least:
        return None
    return Reason(
        rule="quality_too_low",
        message=f"{robot_type.label} cannot do {task}: quality of {capability} {has.quality:g}, needed "
        f"{need.at_least:g}.",
        robot=robot_type.id,
        found=f"{capability} {has.quality:g}",
        needed=f"{capability} {need.at_least:g}",
    )


def _wanted(need: Need, entities: Mapping[str, Entity]) -> tuple[float | None, str]:
    """The number compared with (None if unknown), and in words where it comes from."""
    if need.reference is None:
        bound = need.at_least if need.at_least is not None else need.at_most
        assert isinstance(bound, float | int), "a bound that is no reference is a number"
        return bound * need.share, ""
    argument, attribute = need.reference
    entity = entities[argument]
    value = entity.attribute(attribute)
    if value is None:
        return None, f"{attribute} of {entity.label}"
    shared = f", share {need.share:g}" if need.share != 1 else ""
    return value * need.share, f"{entity.label} {attribute} {value:.12g}{shared}"


def _because(why: str) -> str:
    return f" ({why})" if why else ""


def _zones_refused(
    role: FlatRole, robot_type: RobotType, entities: Mapping[str, Entity], scene: Scene, task: str
) -> list[Reason]:
    if robot_type.zones is None:
        return []
    used = dict.fromkeys(
        argument
        for action in role.actions
        for argument in (action.step.at, action.step.goes_to)
        if argument is not None
    )
    return [
        Reason(
            rule="zone_forbidden",
            message=f"{robot_type.label} cannot do {task}: {entities[argument].label} is in zone {zone}, which it may not "
            "enter.",
            robot=robot_type.id,
            found=", ".join(robot_type.zones) or "no zone",
            needed=zone,
        )
        for argument in used
        for zone in zones_of(entities[argument], scene)
        if zone not in robot_type.zones
    ]
