"""Who is good enough for the mission where a user's own estimator says how good they are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from missiontree.estimation.estimator import Estimator
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason
from missiontree.mission.tree import MissionTree
from missiontree.routines.calls import Call, Way
from missiontree.routines.conditions import quality_refused
from missiontree.routines.estimates import qualities
from missiontree.routines.staffing import shortage


def good_enough(
    calls: Mapping[str, Call], tree: MissionTree, brief: MissionBrief, estimator: Estimator
) -> dict[str, Call]:
    """
    The calls without the types that would do an action worse than the mission asks for, by the estimator's word.

    Where qualities are the fleet's, offers have seen to that before anything was known of travel.
    """
    judged: dict[int, Call] = {}  # by identity: calls that are alike are one, and stay one
    for node in tree.nodes:
        if node.routine is not None and id(calls[node.id]) not in judged:
            judged[id(calls[node.id])] = _judged(calls[node.id], node.routine, brief, estimator)
    return {name: judged[id(call)] for name, call in calls.items()}


def _judged(call: Call, routine: str, brief: MissionBrief, estimator: Estimator) -> Call:
    ways: list[Way] = []
    refused = list(call.not_offered)
    for way in call.ways:
        types, bad = _types(call, way, routine, brief, estimator)
        offer = way.offer
        refused += bad
        if not bad:
            ways.append(way)
        elif not all(types):
            refused += _unfilled(way, types)
        elif (reason := shortage(offer.branch, types, brief.team, offer.task)) is not None:
            refused.append(reason)
        else:
            ways.append(replace(way, offer=replace(offer, types=types)))
    return replace(call, ways=tuple(ways), not_offered=tuple(dict.fromkeys(refused)))


def _types(
    call: Call, way: Way, routine: str, brief: MissionBrief, estimator: Estimator
) -> tuple[tuple[tuple[str, ...], ...], list[Reason]]:
    """Of the types of each role, those that are good enough; then why others are not."""
    branch = way.offer.branch
    good: list[tuple[str, ...]] = []
    bad: list[Reason] = []
    for index, (role, types) in enumerate(zip(branch.roles, way.offer.types, strict=True)):
        part = way.offer.task if len(branch.roles) == 1 else f"{role.name} of {way.offer.task}"
        found: dict[str, Reason | None] = {}
        for type_id in types:
            robot_type = brief.team.by_id[type_id]
            said = qualities(role.actions, robot_type, way.travels[index, type_id], call.entities, estimator)
            found[type_id] = quality_refused(role, robot_type, said, brief.terms, routine, part)
        good.append(tuple(type_id for type_id, reason in found.items() if reason is None))
        bad += [reason for reason in found.values() if reason is not None]
    return tuple(good), bad


def _unfilled(way: Way, types: tuple[tuple[str, ...], ...]) -> list[Reason]:
    """With several roles, a type good enough for one is lost with the way: say so. With one, each type has its own reason."""
    if len(types) == 1:
        return []
    return [
        Reason(
            rule="no_robot_able",
            message=f"{way.offer.task} needs a robot as {role.name}, and none is good enough.",
            found="no robot type",
            needed=role.name,
        )
        for role, able in zip(way.offer.branch.roles, types, strict=True)
        if not able
    ]
