"""MissionTree to GroundedTree: each routine becomes an XOR over the ways and the robot types able to do it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from missiontree.errors import InputError
from missiontree.estimation.answers import WritingDown
from missiontree.estimation.estimator import Estimator
from missiontree.estimation.table import TableEstimator
from missiontree.mission.brief import MissionBrief
from missiontree.mission.estimator_source import Estimated
from missiontree.mission.grounded import GroundedLink, GroundedTree, Grounding
from missiontree.mission.magnitude import MOST, counts_too_much
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, MissionTree
from missiontree.routines.calls import Call, calls_of
from missiontree.routines.expansion import Expansion
from missiontree.routines.good_enough import good_enough
from missiontree.routines.open_ended import pointless_until
from missiontree.routines.order import RoutineOrder, order_moved
from missiontree.routines.review import assumed_positions, idle_chargers, lost_entities, never_binding


def ground(tree: MissionTree, brief: MissionBrief, estimator: Estimator | None = None) -> Grounding:
    """
    Expand a mission tree over fleet and scene.

    A routine node becomes an XOR with a child for each of its ways and each robot type able to go it; below are the actions.
    A way for several robots is an AND of roles, each an XOR over types. A routine that nobody can do is an XOR without children.

    Parameters
    ----------
    tree
        The mission; every leaf is a routine.
    brief
        Fleet, scene and routines.
    estimator
        What says how well, how long and how dear. Default: the table of the fleet.
        A brief that names an estimator of the user's own needs it.

    Raises
    ------
    InputError
        If a routine, argument, entity or robot type is not known, a leaf is no routine, or links contradict each other; if the brief
        names an estimator and none is given, or it says what cannot be worked with.
    """
    asked = _asked(brief, estimator)
    world = _world(tree, brief)
    for leaf in tree.open_leaves:
        raise InputError(f"task {leaf.label!r} is a leaf.", where=leaf.id, accepted="routines as leaves")
    for link in tree.links:
        if pointless_until(tree, link, brief.routines):
            message = (
                f"nothing in {link.first!r} goes on without an end of its own, until {link.second!r} ends or otherwise"
            )
            raise InputError(message, where="links", accepted="an until link from something open-ended, such as Follow")
    if brief.deadline_s is not None and brief.deadline_s < tree.root.release_s:
        message = f"the mission has the deadline {brief.deadline_s:g} s, and nothing of its tree starts before {tree.root.release_s:g} s"
        raise InputError(message, where=tree.root.id, accepted="a release time of the root no later than the deadline")
    order = RoutineOrder(tree)
    calls = calls_of(tree, brief, world)
    if brief.terms.judged_by_estimator:
        calls = good_enough(calls, tree, brief, asked)
    added, notices = order_moved(tree, calls, order)
    grounded = _grounded(tree, brief, world, calls, (*tree.links, *added), asked)
    return Grounding(
        tree=grounded,
        not_offered=tuple(replace(reason, node=name) for name, call in calls.items() for reason in call.not_offered),
        assumptions=(
            *(replace(reason, node=name) for name, call in calls.items() for reason in call.assumptions),
            *assumed_positions(calls, world, brief.scene is not None),
        ),
        notices=(*notices, *_own_estimator(brief)),
        findings=(
            *never_binding(tree, order.selection),
            *(lost_entities(tree, calls, order, world) if brief.scene is not None else ()),
            *idle_chargers(brief.fleet, world),
        ),
        estimates=_answers(brief, asked),
    )


def _asked(brief: MissionBrief, estimator: Estimator | None) -> Estimator:
    """Who is asked; if it is not the fleet's table, what it says is written down."""
    if brief.estimator is not None and estimator is None:
        raise InputError(
            f"the estimates of this mission are those of {brief.estimator.shown}, and it is not there.",
            where="estimator",
            hint="Hand it in.",
        )
    estimator = estimator or TableEstimator()
    return estimator if brief.estimator is None else WritingDown(estimator)


def _own_estimator(brief: MissionBrief) -> tuple[Reason, ...]:
    if brief.estimator is None:
        return ()
    message = f"Quality, duration and cost of every action are as {brief.estimator.shown} estimates them, not as the fleet states."
    notice = Reason(
        rule="own_estimator",
        message=message,
        severity="notice",
        found=brief.estimator.name,
    )
    return (notice,)


def _answers(brief: MissionBrief, asked: Estimator) -> tuple[Estimated, ...]:
    if not isinstance(asked, WritingDown):
        return ()
    for said in asked.answers:
        if counts_too_much(said.estimate, brief.weights):
            raise InputError(
                f"the estimate of action {said.action!r} by robot type {said.robot_type!r} counts for more than {MOST:,.0f}: "
                "its quality, its duration or its cost, or a weight, is too large.",
                where="estimator",
            )
    return asked.answers


def _world(tree: MissionTree, brief: MissionBrief) -> Scene:
    try:
        return brief.world.extended(tree.entities)
    except ValueError as error:
        raise InputError(str(error), where="entities") from error


def _grounded(
    tree: MissionTree,
    brief: MissionBrief,
    world: Scene,
    calls: Mapping[str, Call],
    links: tuple[Link, ...],
    estimator: Estimator,
) -> GroundedTree:
    expansion = Expansion(brief.team, estimator, world)
    index: dict[str, int] = {}
    for node in tree.nodes:
        parent = index[tree.parent[node.id]] if node.id in tree.parent else -1
        if node.routine is not None:
            index[node.id] = expansion.add_call(parent, node, calls[node.id])
        else:
            index[node.id] = expansion.add(parent, node.gate or "and", node.label, node.id)
        deadlines = (node.deadline_s, brief.deadline_s if parent < 0 else None)
        due = min((deadline for deadline in deadlines if deadline is not None), default=None)
        expansion.time(index[node.id], node.release_s, due)
    own = (GroundedLink(index[link.first], index[link.second], link.kind) for link in links)
    return GroundedTree(
        objective=tree.objective,
        nodes=tuple(expansion.nodes),
        roles=tuple(expansion.roles),
        links=(*own, *expansion.links),
    )
