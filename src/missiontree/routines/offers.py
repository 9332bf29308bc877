"""What a routine call has on offer: its branches, the robot types that can fill each role, and why the others cannot."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.reason import Reason
from missiontree.mission.routine import Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.routines.arguments import check_arguments, check_resources
from missiontree.routines.compose import FlatBranch, FlatRole, flatten
from missiontree.routines.conditions import judge, kind_refused, quality_refused
from missiontree.routines.sharing import too_crowded, without_limit
from missiontree.routines.staffing import shortage


@dataclass(frozen=True, slots=True)
class BranchOffer:
    """
    A branch that can be done.

    Parameters
    ----------
    branch
        What is done.
    task
        Its name in messages: ``Transport(cat, safe area) by carry``.
    types
        For each role, the ids of the types able to fill it, in fleet order.
    """

    branch: FlatBranch
    task: str
    types: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, slots=True)
class Offers:
    """
    What a routine call has on offer.

    Parameters
    ----------
    branches
        The branches that can be done.
    refused
        Why types and branches are not offered. Every pair that is not offered has its Reason; one without a robot speaks of
        the whole branch.
    assumptions
        What was unknown and taken in favour of what is offered.
    """

    branches: tuple[BranchOffer, ...]
    refused: tuple[Reason, ...] = ()
    assumptions: tuple[Reason, ...] = ()

    @property
    def able(self) -> bool:
        """Whether anybody can do it."""
        return bool(self.branches)

    @property
    def able_types(self) -> tuple[str, ...]:
        """Types that can fill a role of some branch, in the order in which they come up."""
        return tuple(dict.fromkeys(type_id for offer in self.branches for types in offer.types for type_id in types))


def offers_for(
    routine: Routine,
    entities: Mapping[str, Entity],
    fleet: Fleet,
    scene: Scene,
    library: RoutineLibrary,
    resources: tuple[str, ...] | None = None,
    check_kinds: bool = True,
    terms: Terms = NO_TERMS,
    flat: tuple[FlatBranch, ...] | None = None,
) -> Offers:
    """
    What a call of a routine has on offer.

    Parameters
    ----------
    routine
        The routine called.
    entities
        Entity by argument.
    fleet, scene
        Who is there, and where.
    library
        Where the parts of composed routines are.
    resources
        Types allowed; None (default) means all.
    check_kinds
        Whether kinds of arguments are enforced. Default true.
    terms
        Who is left out of the mission, and how good every action must be. Default: nobody, and anything goes.
    flat
        The routine's flat branches, where they are known already. Default: worked out.

    Raises
    ------
    InputError
        If arguments are missing or not the routine's, or a type is named that the fleet does not have.
    """
    check_arguments(routine, entities, routine.id)
    check_resources(resources, fleet, routine.id)
    call = f"{routine.id}({', '.join(entities[argument.name].label for argument in routine.arguments)})"
    flat = flatten(routine, library) if flat is None else flat
    offered: list[BranchOffer] = []
    team = terms.team_of(fleet)
    refused: list[Reason] = [*_left_out(call, fleet, team), *_excluded(call, team, resources)]
    assumed: list[Reason] = []
    for branch in flat:
        task = f"{call} by {branch.name}" if len(flat) > 1 else call
        reason = kind_refused(branch, entities, scene, task) if check_kinds else None
        reason = reason or too_crowded(branch, entities, scene, task)
        if reason is not None:
            refused.append(reason)
            continue
        types, unfit, taken = _able_types(branch, entities, team, scene, task, resources)
        types, bad = _good_types(branch, types, team, terms, routine.id, task)
        unfit += bad
        refused += unfit
        if all(types) and (reason := shortage(branch, types, team, task)) is not None:
            refused.append(reason)
        elif all(types):
            offered.append(BranchOffer(branch, task, types))
            assumed += (*taken, *without_limit(branch, entities, scene, task))
        else:
            refused += _unfilled(branch, types, task)
    return Offers(tuple(offered), tuple(dict.fromkeys(refused)), tuple(dict.fromkeys(assumed)))


def _left_out(call: str, fleet: Fleet, team: Fleet) -> list[Reason]:
    return [
        Reason(
            rule="left_out",
            message=f"{robot_type.label} does not do {call}: the mission leaves it out.",
            robot=robot_type.id,
            found=robot_type.id,
            needed=", ".join(team.by_id),
            hint="Take it off 'without' of the mission.",
        )
        for robot_type in fleet.types
        if robot_type.id not in team.by_id
    ]


def _good_types(
    branch: FlatBranch, types: tuple[tuple[str, ...], ...], team: Fleet, terms: Terms, routine: str, task: str
) -> tuple[tuple[tuple[str, ...], ...], list[Reason]]:
    """Of the types able to fill each role, those that do so well enough for the mission; then why others do not."""
    if not terms.min_quality or terms.by_estimator:
        return types, []
    good: list[tuple[str, ...]] = []
    refused: list[Reason] = []
    for role, able in zip(branch.roles, types, strict=True):
        part = task if len(branch.roles) == 1 else f"{role.name} of {task}"
        found = {
            name: quality_refused(role, team.by_id[name], _stated(role, team.by_id[name]), terms, routine, part)
            for name in able
        }
        good.append(tuple(name for name, reason in found.items() if reason is None))
        refused += [reason for reason in found.values() if reason is not None]
    return tuple(good), refused


def _stated(role: FlatRole, robot_type: RobotType) -> tuple[float, ...]:
    """Quality of every action of a role, as the fleet states it."""
    stated = (robot_type.capability(action.rating) for action in role.actions)
    return tuple(math.inf if capability is None else capability.quality for capability in stated)


def _excluded(call: str, fleet: Fleet, resources: tuple[str, ...] | None) -> list[Reason]:
    return [
        Reason(
            rule="resource_excluded",
            message=f"{robot_type.label} is not among the resources allowed for {call}.",
            robot=robot_type.id,
            found=robot_type.id,
            needed=", ".join(resources or ()) or "none",
        )
        for robot_type in fleet.types
        if resources is not None and robot_type.id not in resources
    ]


def _able_types(
    branch: FlatBranch,
    entities: Mapping[str, Entity],
    fleet: Fleet,
    scene: Scene,
    task: str,
    resources: tuple[str, ...] | None,
) -> tuple[tuple[tuple[str, ...], ...], list[Reason], list[Reason]]:
    """Types able to fill each role; then why others are not, and what was assumed."""
    types: list[tuple[str, ...]] = []
    refused: list[Reason] = []
    assumed: list[Reason] = []
    for role in branch.roles:
        part = task if len(branch.roles) == 1 else f"{role.name} of {task}"
        able: list[str] = []
        for robot_type in fleet.types:
            if resources is not None and robot_type.id not in resources:
                continue
            verdict = judge(role, robot_type, entities, scene, part)
            refused += verdict.refused
            if not verdict.refused:
                able.append(robot_type.id)
                assumed += verdict.assumed
        types.append(tuple(able))
    return tuple(types), refused, assumed


def _unfilled(branch: FlatBranch, types: tuple[tuple[str, ...], ...], task: str) -> list[Reason]:
    """With several roles, a type able to fill one is lost with the branch: say so. With one, each type has its own reason."""
    if len(branch.roles) == 1:
        return []
    empty = [role.name for role, able in zip(branch.roles, types, strict=True) if not able]
    return [
        Reason(
            rule="no_robot_able",
            message=f"{task} needs a robot as {name}, and none can be that.",
            found="no robot type",
            needed=name,
        )
        for name in empty
    ]
