"""
Kinds of damage that can be done to a sound plan, each with the rule that must name it.

A kind of damage yields the plan damaged at one place after another. It yields nothing where a plan has no such place.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Any

from missiontree.mission.alternative import Alternative, Assignment, Choice, RoleType, selected_leaves
from missiontree.mission.area import Zone
from missiontree.mission.certificate import Certificate
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate
from missiontree.mission.estimator_source import Estimated
from missiontree.mission.fleet import Robot, RobotType
from missiontree.mission.front import Option
from missiontree.mission.grounded import GroundedNode, GroundedTree, Grounding
from missiontree.mission.limit_use import LimitUse
from missiontree.mission.objective import WEIGHTED
from missiontree.mission.partial import LeftOut
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.routine import Need, Routine, RoutineLibrary
from missiontree.mission.schedule import OwnLeg, Recharge, Schedule, ScheduledAction, TravelLeg
from missiontree.mission.search_limit import SearchLimit
from missiontree.mission.tree import Link, MissionNode

Damage = Callable[[Plan], Iterator[Plan]]
DAMAGES: list[tuple[str, Damage]] = []
WHY = Reason(rule="time_limit", message="Time was up.")


def breaks(rule: str) -> Callable[[Damage], Damage]:
    """Lists a kind of damage under the rule that must name it."""

    def listed(damage: Damage) -> Damage:
        DAMAGES.append((rule, damage))
        return damage

    return listed


# Where damage is done.


def with_alternative(plan: Plan, place: int, **changes: Any) -> Plan:
    assert plan.ranking is not None
    alternatives = list(plan.ranking.alternatives)
    alternatives[place] = replace(alternatives[place], **changes)
    return replace(plan, ranking=replace(plan.ranking, alternatives=tuple(alternatives)))


def with_schedule(plan: Plan, place: int, **changes: Any) -> Plan:
    schedules = list(plan.schedules)
    schedules[place] = replace(schedules[place], **changes)
    return replace(plan, schedules=tuple(schedules))


def with_ranking(plan: Plan, **changes: Any) -> Plan:
    assert plan.ranking is not None
    return replace(plan, ranking=replace(plan.ranking, **changes))


def with_nodes(plan: Plan, place: int, node: MissionNode, **changes: Any) -> Plan:
    assert plan.tree is not None
    nodes = list(plan.tree.nodes)
    nodes[place] = node
    return replace(plan, tree=replace(plan.tree, nodes=tuple(nodes), **changes))


def with_grounded(plan: Plan, **changes: Any) -> Plan:
    assert plan.grounding is not None
    return replace(plan, grounding=replace(plan.grounding, tree=replace(plan.grounding.tree, **changes)))


def with_notes(grounding: Grounding, what: str, notes: tuple[Reason, ...]) -> Grounding:
    changes: dict[str, Any] = {what: notes}
    return replace(grounding, **changes)


def with_action(plan: Plan, leaf: int, **changes: Any) -> Plan:
    tree = grounded_tree(plan)
    nodes = list(tree.nodes)
    nodes[leaf] = replace(nodes[leaf], action=replace(tree.action(leaf), **changes))
    return with_grounded(plan, nodes=tuple(nodes))


def with_brief(plan: Plan, **changes: Any) -> Plan:
    return replace(plan, brief=replace(plan.brief, **changes))


def with_kind(plan: Plan, type_id: str, **changes: Any) -> Plan:
    types = tuple(replace(kind, **changes) if kind.id == type_id else kind for kind in plan.brief.fleet.types)
    return replace(plan, brief=replace(plan.brief, fleet=replace(plan.brief.fleet, types=types)))


def with_routines(plan: Plan, changed: Callable[[Routine], Routine]) -> Plan:
    library = RoutineLibrary(routines=tuple(changed(routine) for routine in plan.brief.routines.routines))
    return replace(plan, brief=replace(plan.brief, routines=library))


def grounded_tree(plan: Plan) -> GroundedTree:
    assert plan.grounding is not None
    return plan.grounding.tree


def alternatives(plan: Plan) -> Iterator[tuple[int, Alternative]]:
    assert plan.ranking is not None
    yield from enumerate(plan.ranking.alternatives)


def schedules(plan: Plan) -> Iterator[tuple[int, Schedule]]:
    yield from enumerate(plan.schedules)


def calls(plan: Plan) -> Iterator[tuple[int, MissionNode]]:
    assert plan.tree is not None
    yield from ((place, node) for place, node in enumerate(plan.tree.nodes) if node.routine is not None)


def leaves(plan: Plan) -> Iterator[tuple[int, GroundedNode]]:
    yield from ((leaf, node) for leaf, node in enumerate(grounded_tree(plan).nodes) if node.action is not None)


def used_types(plan: Plan) -> Iterator[RobotType]:
    used = {entry.robot_type for _, alternative in alternatives(plan) for entry in alternative.roles}
    yield from (kind for kind in plan.brief.fleet.types if kind.id in used)


def scheduled(plan: Plan) -> Iterator[tuple[int, Schedule, int, ScheduledAction]]:
    for place, schedule in schedules(plan):
        for number, done in enumerate(schedule.actions):
            yield place, schedule, number, done


def travelled(plan: Plan) -> Iterator[tuple[int, Schedule, int, TravelLeg]]:
    for place, schedule in schedules(plan):
        for number, leg in enumerate(schedule.legs):
            yield place, schedule, number, leg


def with_done(plan: Plan, place: int, number: int, **changes: Any) -> Plan:
    actions = list(plan.schedules[place].actions)
    actions[number] = replace(actions[number], **changes)
    return with_schedule(plan, place, actions=tuple(actions))


def refilled(plan: Plan) -> Iterator[tuple[int, Schedule, int, Recharge]]:
    for place, schedule in schedules(plan):
        for number, visit in enumerate(schedule.recharges):
            yield place, schedule, number, visit


def with_visit(plan: Plan, place: int, number: int, **changes: Any) -> Plan:
    visits = list(plan.schedules[place].recharges)
    visits[number] = replace(visits[number], **changes)
    return with_schedule(plan, place, recharges=tuple(visits))


def returning(plan: Plan) -> Iterator[tuple[int, Schedule, int, OwnLeg]]:
    for place, schedule in schedules(plan):
        for number, leg in enumerate(schedule.returns):
            yield place, schedule, number, leg


def with_return(plan: Plan, place: int, number: int, **changes: Any) -> Plan:
    returns = list(plan.schedules[place].returns)
    returns[number] = replace(returns[number], **changes)
    return with_schedule(plan, place, returns=tuple(returns))


def with_leg(plan: Plan, place: int, number: int, **changes: Any) -> Plan:
    legs = list(plan.schedules[place].legs)
    legs[number] = replace(legs[number], **changes)
    return with_schedule(plan, place, legs=tuple(legs))


def without(entries: tuple[Any, ...], number: int) -> tuple[Any, ...]:
    return (*entries[:number], *entries[number + 1 :])


def moves(plan: Plan, leaf: int) -> bool:
    return grounded_tree(plan).action(leaf).moves


# Inputs and mission tree.


@breaks("digest_mismatch")
def digest_changed(plan: Plan) -> Iterator[Plan]:
    for name in plan.digests:
        yield replace(plan, digests={**plan.digests, name: "0" * 64})


@breaks("digest_mismatch")
def digest_dropped(plan: Plan) -> Iterator[Plan]:
    for name in plan.digests:
        yield replace(plan, digests={other: value for other, value in plan.digests.items() if other != name})


@breaks("digest_mismatch")
def mission_reworded(plan: Plan) -> Iterator[Plan]:
    yield replace(plan, brief=replace(plan.brief, text=plan.brief.text + " now"))


@breaks("digest_unknown")
def digest_added(plan: Plan) -> Iterator[Plan]:
    yield replace(plan, digests={**plan.digests, "weather": "0" * 64})


@breaks("tree_missing")
def tree_dropped(plan: Plan) -> Iterator[Plan]:
    yield replace(plan, tree=None)
    yield replace(plan, grounding=None)


@breaks("leaf_open")
def routine_dropped(plan: Plan) -> Iterator[Plan]:
    for place, node in calls(plan):
        yield with_nodes(plan, place, MissionNode(id=node.id, label=node.label))


@breaks("routine_unknown")
def routine_misnamed(plan: Plan) -> Iterator[Plan]:
    for place, node in calls(plan):
        yield with_nodes(plan, place, replace(node, routine="Juggle"))


@breaks("argument_wrong")
def argument_dropped(plan: Plan) -> Iterator[Plan]:
    for place, node in calls(plan):
        for name in node.arguments:
            kept = {other: value for other, value in node.arguments.items() if other != name}
            yield with_nodes(plan, place, replace(node, arguments=kept))


@breaks("argument_wrong")
def argument_added(plan: Plan) -> Iterator[Plan]:
    for place, node in calls(plan):
        yield with_nodes(
            plan, place, replace(node, arguments={**node.arguments, "mood": next(iter(node.arguments.values()))})
        )


@breaks("entity_unknown")
def entity_misnamed(plan: Plan) -> Iterator[Plan]:
    for place, node in calls(plan):
        for name in node.arguments:
            yield with_nodes(plan, place, replace(node, arguments={**node.arguments, name: "nobody"}))


@breaks("entity_clash")
def entity_doubled(plan: Plan) -> Iterator[Plan]:
    assert plan.tree is not None
    if plan.brief.scene is not None:
        yield replace(plan, tree=replace(plan.tree, entities=(plan.brief.scene.all_entities[0],)))
    yield replace(plan, tree=replace(plan.tree, entities=(*plan.tree.entities, Entity(id="oddity", kind="wonder"))))


@breaks("resource_unknown")
def resource_misnamed(plan: Plan) -> Iterator[Plan]:
    for place, node in calls(plan):
        yield with_nodes(plan, place, replace(node, resources=("ghost",)))


@breaks("precedence_circular")
def precedence_reversed(plan: Plan) -> Iterator[Plan]:
    assert plan.tree is not None
    for link in plan.tree.links:
        if link.kind == "precedence":
            yield replace(plan, tree=replace(plan.tree, links=(*plan.tree.links, Link(link.second, link.first))))


# The dialogue.


def with_provenance(plan: Plan, **changes: Any) -> Plan:
    return replace(plan, provenance=replace(plan.provenance, **changes))


def with_header(plan: Plan, **changes: str) -> Plan:
    lines = plan.provenance.transcript
    header = json.dumps({**json.loads(lines[0]), **changes}, sort_keys=True, separators=(",", ":"))
    return with_provenance(plan, transcript=(header, *lines[1:]))


@breaks("transcript_missing")
def transcript_dropped(plan: Plan) -> Iterator[Plan]:
    if plan.provenance.transcript:
        yield with_provenance(plan, transcript=())
        yield with_provenance(plan, author="given")
    else:
        yield with_provenance(plan, author="offline")
        yield with_provenance(plan, author="gpt", model="gpt")


@breaks("transcript_damaged")
def transcript_cut(plan: Plan) -> Iterator[Plan]:
    lines = plan.provenance.transcript
    if lines:
        yield with_provenance(plan, transcript=lines[:-1])
        yield with_provenance(plan, transcript=lines[1:])
        yield with_provenance(plan, transcript=(*lines, lines[-1]))
        yield with_provenance(plan, transcript=(*lines[:-1], "{"))


@breaks("author_contradicted")
def author_changed(plan: Plan) -> Iterator[Plan]:
    yield with_provenance(plan, model="gpt")
    if plan.provenance.transcript:
        yield with_provenance(plan, author="gpt")
        yield with_provenance(plan, author="gpt", model="gpt")
        yield with_provenance(plan, author="recorded", model="gpt")
        yield with_header(plan, source="gpt")
        yield with_header(plan, model="gpt")


@breaks("transcript_of_another_mission")
def transcript_borrowed(plan: Plan) -> Iterator[Plan]:
    if plan.provenance.transcript:
        yield with_header(plan, mission="0" * 64)
        yield with_provenance(with_header(plan, mission="0" * 64), author="recorded")


# What is taken for granted.


@breaks("note_dropped")
def note_left_out(plan: Plan) -> Iterator[Plan]:
    assert plan.grounding is not None
    scheduled = [reason for schedule in plan.schedules for reason in schedule.assumptions]
    needed = {
        "assumptions": [*plan.grounding.assumptions, *scheduled],
        "notices": plan.grounding.notices,
        "findings": plan.grounding.findings,
    }
    for what, reasons in needed.items():
        for dropped in dict.fromkeys(reasons):
            left: Any = {what: tuple(reason for reason in getattr(plan, what) if reason != dropped)}
            yield replace(plan, **left)
        if reasons:
            emptied: Any = {what: ()}
            yield replace(plan, **emptied)


@breaks("entity_unsaid")
def introduction_concealed(plan: Plan) -> Iterator[Plan]:
    assert plan.tree is not None
    for entity in plan.tree.entities if plan.provenance.transcript else ():
        left = tuple(reason for reason in plan.assumptions if reason.node != entity.id)
        yield replace(plan, assumptions=left)


@breaks("remark_dropped")
def remark_left_out(plan: Plan) -> Iterator[Plan]:
    """The dialogue ends with a remark that the plan does not hold."""
    lines = plan.provenance.transcript
    if lines:
        remark = {"rule": "words_unused", "message": "'gently' is not understood.", "severity": "notice"}
        end = json.dumps({**json.loads(lines[-1]), "remarks": [remark]}, sort_keys=True, separators=(",", ":"))
        yield with_provenance(plan, transcript=(*lines[:-1], end))


@breaks("assumption_missing")
def guess_concealed(plan: Plan) -> Iterator[Plan]:
    """Everywhere: in the schedule and in the plan's own list."""
    for place, schedule in schedules(plan):
        for dropped in schedule.assumptions:
            left = tuple(reason for reason in schedule.assumptions if reason.robot != dropped.robot)
            yield replace(with_schedule(plan, place, assumptions=left), assumptions=left)


# The tree over the fleet.


@breaks("grounding_impossible")
def nothing_to_ground(plan: Plan) -> Iterator[Plan]:
    for place, node in calls(plan):
        yield with_nodes(plan, place, replace(node, routine="Juggle"))


@breaks("grounding_differs")
def label_changed(plan: Plan) -> Iterator[Plan]:
    tree = grounded_tree(plan)
    for place, node in enumerate(tree.nodes):
        nodes = (*tree.nodes[:place], replace(node, label=node.label + "!"), *tree.nodes[place + 1 :])
        yield with_grounded(plan, nodes=nodes)


@breaks("grounding_differs")
def node_dropped(plan: Plan) -> Iterator[Plan]:
    yield with_grounded(plan, nodes=grounded_tree(plan).nodes[:-1])


@breaks("grounding_differs")
def link_dropped(plan: Plan) -> Iterator[Plan]:
    links = grounded_tree(plan).links
    for number in range(len(links)):
        yield with_grounded(plan, links=without(links, number))


@breaks("grounding_differs")
def team_changed(plan: Plan) -> Iterator[Plan]:
    roles = grounded_tree(plan).roles
    for number, role in enumerate(roles):
        yield with_grounded(plan, roles=(*roles[:number], replace(role, team=77), *roles[number + 1 :]))


@breaks("grounding_notes_differ")
def note_changed(plan: Plan) -> Iterator[Plan]:
    assert plan.grounding is not None
    whats = ("not_offered", "assumptions", "notices", "findings")
    for what in whats:
        notes: tuple[Reason, ...] = getattr(plan.grounding, what)
        yield replace(plan, grounding=with_notes(plan.grounding, what, (*notes, WHY)))
        if notes:
            yield replace(plan, grounding=with_notes(plan.grounding, what, notes[1:]))


@breaks("type_unknown")
def type_misnamed(plan: Plan) -> Iterator[Plan]:
    for leaf, _ in leaves(plan):
        yield with_action(plan, leaf, robot_type="ghost")


@breaks("capability_missing")
def capability_lost(plan: Plan) -> Iterator[Plan]:
    for leaf, _ in leaves(plan):
        yield with_action(plan, leaf, capability="levitate")


@breaks("capability_missing")
def fleet_lost_capabilities(plan: Plan) -> Iterator[Plan]:
    for kind in used_types(plan):
        yield with_kind(plan, kind.id, capabilities={})


@breaks("quality_differs")
def quality_raised(plan: Plan) -> Iterator[Plan]:
    for leaf, node in leaves(plan) if plan.brief.estimator is None else ():
        assert node.action is not None
        estimate = replace(node.action.estimate, quality=node.action.estimate.quality + 0.25)
        yield with_action(plan, leaf, estimate=estimate)


@breaks("quality_differs")
def estimator_forgotten(plan: Plan) -> Iterator[Plan]:
    if plan.brief.estimator is not None:
        yield with_brief(plan, estimator=None)


@breaks("estimate_unsaid")
def own_estimate_changed(plan: Plan) -> Iterator[Plan]:
    for leaf, node in leaves(plan) if plan.brief.estimator is not None else ():
        assert node.action is not None
        for what in ("quality", "duration_s", "cost"):
            number = getattr(node.action.estimate, what) + 0.25
            yield with_action(plan, leaf, estimate=replace(node.action.estimate, **{what: number}))


@breaks("action_differs")
def own_duration_changed(plan: Plan) -> Iterator[Plan]:
    for leaf, node in leaves(plan) if plan.brief.estimator is not None else ():
        assert node.action is not None
        yield with_action(plan, leaf, duration_s=node.action.duration_s + 1)


@breaks("estimates_differ")
def answer_added(plan: Plan) -> Iterator[Plan]:
    said = Estimated(robot_type="cart", action="dance", rating="reach", estimate=Estimate(1))
    if plan.grounding is not None:
        yield replace(plan, grounding=replace(plan.grounding, estimates=(*plan.grounding.estimates, said)))


@breaks("grounding_impossible")
def answer_lost(plan: Plan) -> Iterator[Plan]:
    """Without an answer the tree cannot be made again; that of somebody who was not good enough included."""
    assert plan.grounding is not None
    answers = plan.grounding.estimates
    for place in range(len(answers)):
        yield replace(plan, grounding=replace(plan.grounding, estimates=(*answers[:place], *answers[place + 1 :])))


@breaks("grounding_differs")
def answer_changed(plan: Plan) -> Iterator[Plan]:
    assert plan.grounding is not None
    answers = plan.grounding.estimates
    for place, said in enumerate(answers):
        better = replace(said, estimate=replace(said.estimate, quality=said.estimate.quality + 0.5))
        # Of an action without its travel only the duration is used, and nothing of a type that is not good enough anyway.
        if said.travel_m and any(
            node.action is not None and node.action.estimate == said.estimate for _, node in leaves(plan)
        ):
            estimates = (*answers[:place], better, *answers[place + 1 :])
            yield replace(plan, grounding=replace(plan.grounding, estimates=estimates))


@breaks("routine_not_followed")
def action_renamed(plan: Plan) -> Iterator[Plan]:
    for leaf, _ in leaves(plan):
        yield with_action(plan, leaf, name="dance")


@breaks("resource_excluded")
def resource_withdrawn(plan: Plan) -> Iterator[Plan]:
    for place, node in calls(plan):
        yield with_nodes(plan, place, replace(node, resources=()))


@breaks("left_out")
def type_left_out(plan: Plan) -> Iterator[Plan]:
    for kind in used_types(plan):
        if len(plan.brief.team.types) > 1:
            yield with_brief(plan, without=(*plan.brief.without, kind.id), require=())


@breaks("quality_below_minimum")
def more_quality_asked(plan: Plan) -> Iterator[Plan]:
    tree = grounded_tree(plan)
    yield with_brief(plan, min_quality=99.0)
    for name in dict.fromkeys(tree.action(leaf).capability for leaf, _ in leaves(plan)):
        yield with_brief(plan, min_quality={name: 99.0})
    for name in dict.fromkeys(node.routine for _, node in calls(plan) if node.routine is not None):
        yield with_brief(plan, min_quality={name: 99.0})


@breaks("robot_left_out")
def robot_withdrawn(plan: Plan) -> Iterator[Plan]:
    for _, schedule in schedules(plan):
        for robot in dict.fromkeys(entry.robot for entry in schedule.assignments):
            if robot not in plan.brief.fleet.by_id and len(plan.brief.team.robots) > 1:
                yield with_brief(plan, without=(*plan.brief.without, robot), require=())


@breaks("required_idle")
def idler_required(plan: Plan) -> Iterator[Plan]:
    fleet = plan.brief.fleet
    for _, schedule in schedules(plan):
        busy = {entry.robot for entry in schedule.assignments}
        for robot in plan.brief.team.robots if busy else ():
            if robot not in busy and robot not in fleet.by_id:
                yield with_brief(plan, require=(robot,))
        for kind in plan.brief.team.types if busy else ():
            if kind.id not in {fleet.type_of[robot].id for robot in busy}:
                yield with_brief(plan, require=(kind.id,))


@breaks("max_in_use_exceeded")
def fewer_in_use(plan: Plan) -> Iterator[Plan]:
    for _, schedule in schedules(plan):
        busy = {entry.robot for entry in schedule.assignments}
        for kind in plan.brief.fleet.types:
            if sum(robot.id in busy for robot in kind.members) > 1:
                yield with_kind(plan, kind.id, max_in_use=1)


@breaks("release_broken")
def started_too_early(plan: Plan) -> Iterator[Plan]:
    assert plan.grounding is not None
    windows = plan.grounding.tree.windows
    for place, schedule in schedules(plan):
        for at, done in enumerate(schedule.actions):
            if release := windows[done.leaf].release:
                early = replace(done, start_s=release / 1000 - 0.002)
                actions = (*schedule.actions[:at], early, *schedule.actions[at + 1 :])
                yield with_schedule(plan, place, actions=actions)


@breaks("release_broken")
def released_later(plan: Plan) -> Iterator[Plan]:
    """The mission tree says so, and grounding has lost it."""
    for place, node in enumerate(plan.tree.nodes if plan.tree is not None else ()):
        if any(schedule.makespan_s for _, schedule in schedules(plan)):
            yield with_nodes(plan, place, replace(node, release_s=1e6, deadline_s=None))


@breaks("deadline_missed")
def due_earlier(plan: Plan) -> Iterator[Plan]:
    for _, schedule in schedules(plan):
        if (last_s := max((done.end_s for done in schedule.actions), default=0.0)) > 1:
            yield replace(plan, brief=replace(plan.brief, deadline_s=last_s - 0.002))


@breaks("deadline_missed")
def nodes_due_earlier(plan: Plan) -> Iterator[Plan]:
    assert plan.grounding is not None
    nodes = plan.grounding.tree.nodes
    for _, schedule in schedules(plan):
        for done in schedule.actions:
            if done.end_s > 1:
                due = replace(nodes[done.leaf], release_s=0.0, deadline_s=done.end_s - 0.002)
                yield with_grounded(plan, nodes=(*nodes[: done.leaf], due, *nodes[done.leaf + 1 :]))


@breaks("robot_away")
def comes_later(plan: Plan) -> Iterator[Plan]:
    for _, schedule in schedules(plan):
        for robot in {done.robot for done in schedule.actions if done.end_s > 1}:
            kind = plan.brief.fleet.type_of[robot]
            if all(member.available_from_s is None for member in kind.robots):
                yield with_kind(plan, kind.id, available_from_s=1e6, available_until_s=None)


@breaks("robot_away")
def leaves_earlier(plan: Plan) -> Iterator[Plan]:
    for _, schedule in schedules(plan):
        for done in schedule.actions:
            if done.end_s > 1:
                kind = plan.brief.fleet.type_of[done.robot]
                yield with_kind(plan, kind.id, available_from_s=None, available_until_s=done.end_s - 0.002)


@breaks("alternative_late")
def due_at_once(plan: Plan) -> Iterator[Plan]:
    """Whatever the alternative, some work of it takes time."""
    if plan.ranking is not None and plan.ranking.alternatives and plan.grounding is not None:
        tree = plan.grounding.tree
        for alternative in plan.ranking.alternatives:
            works = (tree.action(leaf) for leaf in selected_leaves(tree, alternative.choices))
            if any(action.duration_s > 0 and not action.moves and not action.open_ended for action in works):
                yield replace(plan, brief=replace(plan.brief, deadline_s=0.0))


@breaks("kind_refused")
def kinds_narrowed(plan: Plan) -> Iterator[Plan]:
    for place in range(2):

        def narrowed(routine: Routine, place: int = place) -> Routine:
            if routine.parts:
                return routine
            if place == 0:
                return replace(routine, arguments=tuple(replace(a, kinds=("spook",)) for a in routine.arguments))
            accepts = {routine.arguments[0].name: ("spook",)}
            return replace(routine, branches=tuple(replace(branch, accepts=accepts) for branch in routine.branches))

        yield with_routines(plan, narrowed)


@breaks("need_unmet")
def needs_raised(plan: Plan) -> Iterator[Plan]:
    def demanding(routine: Routine) -> Routine:
        branches = tuple(
            replace(
                branch,
                roles=tuple(
                    replace(role, needs=(*role.needs, Need(capability=role.rating, at_least=99.0)))
                    for role in branch.roles
                ),
            )
            for branch in routine.branches
        )
        return replace(routine, branches=branches)

    yield with_routines(plan, demanding)


@breaks("need_unmet")
def payload_lost(plan: Plan) -> Iterator[Plan]:
    for kind in used_types(plan):
        if "payload_kg" in kind.limits:
            yield with_kind(plan, kind.id, limits={**kind.limits, "payload_kg": 1.0})


@breaks("zone_forbidden")
def zone_closed(plan: Plan) -> Iterator[Plan]:
    scene = plan.brief.scene
    if scene is None:
        return
    closed = replace(
        scene,
        zones=(Zone(id="shut"), Zone(id="open")),
        places=tuple(replace(place, zone="shut") for place in scene.places),
        entities=tuple(replace(entity, zone="shut") for entity in scene.entities),
    )
    types = tuple(replace(kind, zones=("open",)) for kind in plan.brief.fleet.types)
    yield replace(plan, brief=replace(plan.brief, scene=closed, fleet=replace(plan.brief.fleet, types=types)))


@breaks("action_differs")
def action_altered(plan: Plan) -> Iterator[Plan]:
    for leaf, node in leaves(plan):
        assert node.action is not None
        yield with_action(plan, leaf, duration_s=node.action.duration_s + 1.0)
        yield with_action(
            plan, leaf, at=None if node.action.at is not None else next(iter(plan.brief.world.by_id), "nowhere")
        )
        yield with_action(plan, leaf, uses={"sugar_kg": 1.0})
        if node.action.holds:
            yield with_action(plan, leaf, holds=())


@breaks("held_unknown")
def nothing_held(plan: Plan) -> Iterator[Plan]:
    """An action holds what there is not."""
    for leaf, _ in leaves(plan):
        yield with_action(plan, leaf, holds=("ghost",))


# Alternatives.


@breaks("choice_dangling")
def choice_astray(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for number, choice in enumerate(alternative.choices):
            for wrong in (replace(choice, xor=9999), replace(choice, child=0), replace(choice, child=9999)):
                choices = (*alternative.choices[:number], wrong, *alternative.choices[number + 1 :])
                yield with_alternative(plan, place, choices=choices)


@breaks("choice_missing")
def choice_dropped(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for number in range(len(alternative.choices)):
            yield with_alternative(plan, place, choices=without(alternative.choices, number))


@breaks("choice_double")
def choice_doubled(plan: Plan) -> Iterator[Plan]:
    tree = grounded_tree(plan)
    for place, alternative in alternatives(plan):
        for choice in alternative.choices:
            for child in tree.children[choice.xor]:
                yield with_alternative(plan, place, choices=(*alternative.choices, Choice(choice.xor, child)))


@breaks("choice_unreached")
def choice_elsewhere(plan: Plan) -> Iterator[Plan]:
    tree = grounded_tree(plan)
    xors = [node for node, value in enumerate(tree.nodes) if value.kind == "xor" and tree.children[node]]
    for place, alternative in alternatives(plan):
        chosen = {choice.xor for choice in alternative.choices}
        for node in xors:
            if node not in chosen:
                extra = Choice(node, tree.children[node][0])
                yield with_alternative(plan, place, choices=(*alternative.choices, extra))


@breaks("choice_order")
def choices_reversed(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        if len(alternative.choices) > 1:
            yield with_alternative(plan, place, choices=alternative.choices[::-1])


@breaks("role_type_missing")
def role_type_dropped(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for number in range(len(alternative.roles)):
            yield with_alternative(plan, place, roles=without(alternative.roles, number))


@breaks("role_type_extra")
def role_type_added(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for extra in (alternative.roles[0], RoleType(9999, alternative.roles[0].robot_type)):
            yield with_alternative(plan, place, roles=(*alternative.roles, extra))


@breaks("role_type_differs")
def role_type_changed(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for number, entry in enumerate(alternative.roles):
            for type_id in (*plan.brief.fleet.by_id, "ghost"):
                if type_id != entry.robot_type:
                    roles = (
                        *alternative.roles[:number],
                        RoleType(entry.role, type_id),
                        *alternative.roles[number + 1 :],
                    )
                    yield with_alternative(plan, place, roles=roles)


@breaks("role_order")
def roles_reversed(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        if len(alternative.roles) > 1:
            yield with_alternative(plan, place, roles=alternative.roles[::-1])
            yield with_schedule(plan, place, assignments=plan.schedules[place].assignments[::-1])


@breaks("utility_wrong")
def utility_changed(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for shift in (-0.1, 0.1, 5e-6):
            yield with_alternative(plan, place, utility=alternative.utility + shift)


@breaks("utility_wrong")
def weights_changed(plan: Plan) -> Iterator[Plan]:
    yield replace(plan, brief=replace(plan.brief, weights=replace(plan.brief.weights, alpha=2.0)))


@breaks("utility_wrong")
def accumulated_otherwise(plan: Plan) -> Iterator[Plan]:
    for how in ("sum", "mean", "min"):
        if how != plan.brief.accumulate and plan.brief.objective not in WEIGHTED:  # which add up by their meaning
            yield with_brief(plan, accumulate=how)


@breaks("team_repeated")
def teams_to_differ(plan: Plan) -> Iterator[Plan]:
    """Where they do not."""
    teams = [{filled.robot_type for filled in alternative.roles} for _, alternative in alternatives(plan)]
    if any(team in teams[:place] for place, team in enumerate(teams)):
        yield with_brief(plan, diverse=True)


@breaks("rank_wrong")
def rank_changed(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        yield with_alternative(plan, place, rank=alternative.rank + 1)


@breaks("ranking_unsorted")
def neighbours_swapped(plan: Plan) -> Iterator[Plan]:
    assert plan.ranking is not None
    listed = plan.ranking.alternatives
    for place in range(len(listed) - 1):
        swapped = (replace(listed[place + 1], rank=place + 1), replace(listed[place], rank=place + 2))
        yield with_ranking(plan, alternatives=(*listed[:place], *swapped, *listed[place + 2 :]))


@breaks("alternative_double")
def alternative_repeated(plan: Plan) -> Iterator[Plan]:
    assert plan.ranking is not None
    listed = plan.ranking.alternatives
    for alternative in listed:
        yield with_ranking(plan, alternatives=(*listed, replace(alternative, rank=len(listed) + 1)))


@breaks("witness_incomplete")
def witness_cut(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        witness = plan.schedules[place].assignments
        for number in range(len(witness) if len(witness) > 1 else 0):
            yield with_alternative(plan, place, witness=without(witness, number))
        yield with_alternative(plan, place, witness=(*witness, Assignment(9999, witness[0].robot)))
        yield with_alternative(plan, place, witness=(Assignment(witness[0].role, "ghost"), *witness[1:]))
        assert alternative.rank == place + 1


@breaks("witness_broken")
def witness_of_wrong_type(plan: Plan) -> Iterator[Plan]:
    fleet = plan.brief.fleet
    for place, _ in alternatives(plan):
        witness = plan.schedules[place].assignments
        for number, entry in enumerate(witness):
            for robot, kind in fleet.type_of.items():
                if kind is not fleet.type_of[entry.robot]:
                    changed = (*witness[:number], Assignment(entry.role, robot), *witness[number + 1 :])
                    yield with_alternative(plan, place, witness=changed)


@breaks("witness_broken")
def witness_shares_robot(plan: Plan) -> Iterator[Plan]:
    roles = grounded_tree(plan).roles
    for place, _ in alternatives(plan):
        witness = plan.schedules[place].assignments
        for number, entry in enumerate(witness):
            for other in witness[:number]:
                if roles[other.role].team is not None and roles[other.role].team == roles[entry.role].team:
                    changed = (*witness[:number], Assignment(entry.role, other.robot), *witness[number + 1 :])
                    yield with_alternative(plan, place, witness=changed)


@breaks("alternative_unstaffable")
def too_few_robots(plan: Plan) -> Iterator[Plan]:
    """A team of two of a type that has one robot left."""
    for place, schedule in schedules(plan):
        fleet, roles = plan.brief.fleet, grounded_tree(plan).roles
        team = [fleet.type_of[entry.robot].id for entry in schedule.assignments if roles[entry.role].team is not None]
        for type_id in {type_id for type_id in team if team.count(type_id) > 1}:
            yield with_kind(with_alternative(plan, place, witness=()), type_id, count=1)


@breaks("limit_use_missing")
def use_concealed(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for number in range(len(alternative.uses)):
            yield with_alternative(plan, place, uses=without(alternative.uses, number))


@breaks("limit_use_wrong")
def use_misstated(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for number, use in enumerate(alternative.uses):
            others = without(alternative.uses, number)
            yield with_alternative(plan, place, uses=(*others, replace(use, used=use.used + 1)))
            yield with_alternative(plan, place, uses=(*others, replace(use, used=use.used / 2)))
            yield with_alternative(plan, place, uses=(*others, replace(use, limit=use.limit + 1)))
            yield with_alternative(plan, place, uses=(*others, replace(use, name="sugar_g")))
            yield with_alternative(plan, place, uses=(*alternative.uses, use))


@breaks("limit_use_wrong")
def use_invented(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for whose in ("robot", "robots", "type", "mission", "stock"):
            invented = LimitUse(whose, alternative.roles[0].robot_type, "sugar_g", 1.0, 2.0)
            yield with_alternative(plan, place, uses=(*alternative.uses, invented))


@breaks("ranking_status_unfounded")
def ranking_status_changed(plan: Plan) -> Iterator[Plan]:
    assert plan.ranking is not None
    yield with_ranking(plan, status="infeasible")
    yield with_ranking(plan, status="unknown")
    yield with_ranking(plan, alternatives=())
    yield with_ranking(plan, certificate=replace(plan.ranking.certificate, claim="unproven"))


@breaks("search_limit_unfounded")
def limit_of_a_proof(plan: Plan) -> Iterator[Plan]:
    assert plan.ranking is not None
    certificate = plan.ranking.certificate
    for limit in (SearchLimit("time_s", 10.0), SearchLimit("stopped"), SearchLimit("nodes", 500)):
        yield with_ranking(plan, certificate=replace(certificate, limit=limit))


@breaks("search_limit_unfounded")
def limit_concealed(plan: Plan) -> Iterator[Plan]:
    assert plan.ranking is not None
    certificate = plan.ranking.certificate
    bounded = replace(certificate, claim="bounded")
    yield with_ranking(plan, status="partial", certificate=bounded)
    ended = replace(bounded, limit=SearchLimit("candidates", 200.0))
    yield with_ranking(plan, status="partial", certificate=replace(ended, seed=plan.provenance.seed + 1))


@breaks("rank_unproven")
def proof_withdrawn(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        for claim in ("bounded", "unproven"):
            yield with_alternative(plan, place, certificate=replace(alternative.certificate, claim=claim))


@breaks("bound_below_utility")
def bound_lowered(plan: Plan) -> Iterator[Plan]:
    for place, alternative in alternatives(plan):
        certificate = replace(alternative.certificate, bound=alternative.utility - 0.5)
        yield with_alternative(plan, place, certificate=certificate)


@breaks("claim_refuted")
def alternative_hidden(plan: Plan) -> Iterator[Plan]:
    """A better alternative is left out and those below it move up, each still called proven."""
    assert plan.ranking is not None
    listed = plan.ranking.alternatives
    for place in range(len(listed) - 1):
        kept = [replace(one, rank=rank) for rank, one in enumerate(without(listed, place), start=1)]
        yield with_ranking(plan, alternatives=tuple(kept))


@breaks("claim_refuted")
def called_infeasible(plan: Plan) -> Iterator[Plan]:
    certificate = Certificate(claim="proven", method="hope")
    plan = with_ranking(plan, alternatives=(), status="infeasible", certificate=certificate)
    yield replace(plan, outcome="cannot_be_done", schedules=(), reasons=(WHY,))


@breaks("claim_refuted")
def bound_on_rest_lowered(plan: Plan) -> Iterator[Plan]:
    assert plan.ranking is not None
    if len(plan.ranking.alternatives) > 1:
        cut = plan.ranking.alternatives[:1]
        certificate = replace(plan.ranking.certificate, bound=plan.ranking.alternatives[1].utility - 0.01)
        yield replace(with_ranking(plan, alternatives=cut, certificate=certificate), schedules=plan.schedules[:1])


# Outcome.


@breaks("nothing_delivered")
def schedules_dropped(plan: Plan) -> Iterator[Plan]:
    yield replace(plan, schedules=())
    unknown = tuple(
        Schedule(
            rank=s.rank, status="unknown", certificate=Certificate(claim="unproven", method="none"), reasons=(WHY,)
        )
        for s in plan.schedules
    )
    yield replace(plan, schedules=unknown)
    yield replace(plan, ranking=None)


@breaks("delivered_unsaid")
def outcome_changed(plan: Plan) -> Iterator[Plan]:
    for outcome in ("cannot_be_done", "incomplete", "exhausted", "provider_failed"):
        yield replace(plan, outcome=outcome, reasons=(WHY,))


@breaks("reason_missing")
def reasons_withheld(plan: Plan) -> Iterator[Plan]:
    yield replace(plan, outcome="exhausted", schedules=(), ranking=None, reasons=())
    for place, _ in schedules(plan):
        yield with_schedule(
            plan, place, status="unknown", actions=(), legs=(), assignments=(), makespan_s=0.0, reasons=()
        )


@breaks("reason_uncalled")
def reasons_added(plan: Plan) -> Iterator[Plan]:
    if plan.outcome == "delivered":
        yield replace(plan, reasons=(WHY,))


@breaks("schedule_astray")
def schedule_lost(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        yield replace(plan, schedules=without(plan.schedules, place))
        yield with_schedule(plan, place, rank=schedule.rank + 7)
    if len(plan.schedules) > 1:
        yield replace(plan, schedules=plan.schedules[::-1])


@breaks("schedule_not_empty")
def schedule_disowned(plan: Plan) -> Iterator[Plan]:
    for place, _ in schedules(plan):
        for status in ("unknown", "infeasible"):
            yield with_schedule(plan, place, status=status, reasons=(WHY,))


# Who does what.


@breaks("action_missing")
def action_dropped(plan: Plan) -> Iterator[Plan]:
    for place, schedule, number, _ in scheduled(plan):
        yield with_schedule(plan, place, actions=without(schedule.actions, number))


@breaks("action_extra")
def action_added(plan: Plan) -> Iterator[Plan]:
    for place, schedule, _, done in scheduled(plan):
        chosen = {other.leaf for other in schedule.actions}
        unchosen = next((leaf for leaf, _ in leaves(plan) if leaf not in chosen), 9999)
        for leaf in (unchosen, 0, 9999):
            yield with_schedule(plan, place, actions=(*schedule.actions, replace(done, leaf=leaf)))


@breaks("action_double")
def action_doubled(plan: Plan) -> Iterator[Plan]:
    for place, schedule, _, done in scheduled(plan):
        yield with_schedule(plan, place, actions=(*schedule.actions, done))


@breaks("assignment_missing")
def assignment_dropped(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        for number in range(len(schedule.assignments)):
            yield with_schedule(plan, place, assignments=without(schedule.assignments, number))


@breaks("assignment_extra")
def assignment_added(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        for extra in (schedule.assignments[0], Assignment(9999, schedule.assignments[0].robot)):
            yield with_schedule(plan, place, assignments=(*schedule.assignments, extra))


@breaks("robot_unknown")
def robot_misnamed(plan: Plan) -> Iterator[Plan]:
    for place, _, number, _ in scheduled(plan):
        yield with_done(plan, place, number, robot="ghost")
    for place, _, number, _ in travelled(plan):
        yield with_leg(plan, place, number, robot="ghost")


@breaks("robot_type_wrong")
def robot_of_other_type(plan: Plan) -> Iterator[Plan]:
    """The whole role is handed to a robot of another type, actions and legs with it."""
    for place, schedule in schedules(plan):
        for entry in schedule.assignments:
            for robot, kind in plan.brief.fleet.type_of.items():
                if kind is not plan.brief.fleet.type_of[entry.robot]:
                    yield handed_over(plan, place, entry.role, robot)


def handed_over(plan: Plan, place: int, role: int, robot: str) -> Plan:
    """A role given to another robot in one schedule, with all that belongs to it."""
    tree, schedule = grounded_tree(plan), plan.schedules[place]
    own = {done.leaf for done in schedule.actions if tree.action(done.leaf).role == role}
    return with_schedule(
        plan,
        place,
        assignments=tuple(replace(e, robot=robot) if e.role == role else e for e in schedule.assignments),
        actions=tuple(replace(done, robot=robot) if done.leaf in own else done for done in schedule.actions),
        legs=tuple(replace(leg, robot=robot) if leg.leaf in own else leg for leg in schedule.legs),
    )


@breaks("action_robot_differs")
def action_handed_over(plan: Plan) -> Iterator[Plan]:
    for place, _, number, done in scheduled(plan):
        for robot in plan.brief.fleet.robots:
            if robot != done.robot:
                yield with_done(plan, place, number, robot=robot)


@breaks("team_shares_robot")
def team_in_one(plan: Plan) -> Iterator[Plan]:
    roles = grounded_tree(plan).roles
    for place, schedule in schedules(plan):
        team = [entry for entry in schedule.assignments if roles[entry.role].team is not None]
        for first, second in pairwise(team):
            if roles[first.role].team == roles[second.role].team:
                yield handed_over(plan, place, second.role, first.robot)


def _linked_roles(plan: Plan, place: int, kind: str) -> Iterator[tuple[int, int]]:
    """Roles below the two ends of the links of a kind, in a schedule."""
    tree, assigned = grounded_tree(plan), {entry.role for entry in plan.schedules[place].assignments}
    for link in tree.links:
        if link.kind == kind:
            sides = []
            for end in (link.first, link.second):
                source = tree.nodes[end].source
                sides.append(
                    [role for role, value in enumerate(tree.roles) if value.source == source and role in assigned]
                )
            yield from ((first, second) for first in sides[0] for second in sides[1])


@breaks("same_robot_broken")
def same_robot_split(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        held = {entry.role: entry.robot for entry in schedule.assignments}
        for first, second in _linked_roles(plan, place, "same_robot"):
            for robot in plan.brief.fleet.robots:
                if robot != held[first]:
                    yield handed_over(plan, place, second, robot)


@breaks("different_robot_broken")
def different_robot_joined(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        held = {entry.role: entry.robot for entry in schedule.assignments}
        for first, second in _linked_roles(plan, place, "different_robot"):
            yield handed_over(plan, place, second, held[first])


# When.


@breaks("time_off_grid")
def time_between_ticks(plan: Plan) -> Iterator[Plan]:
    for place, _, number, done in scheduled(plan):
        yield with_done(plan, place, number, end_s=done.end_s + 0.0004)
    for place, _, number, leg in travelled(plan):
        yield with_leg(plan, place, number, end_s=leg.end_s + 0.0004)


def _until(plan: Plan, place: int) -> set[int]:
    """Open-ended leaves below the first ends of until links."""
    tree = grounded_tree(plan)
    sources = {tree.nodes[link.first].source for link in tree.links if link.kind == "until"}
    own = {done.leaf for done in plan.schedules[place].actions}
    return {leaf for leaf in own if tree.action(leaf).open_ended and tree.nodes[leaf].source in sources}


@breaks("duration_wrong")
def action_shortened(plan: Plan) -> Iterator[Plan]:
    for place, _, number, done in scheduled(plan):
        if not moves(plan, done.leaf) and done.leaf not in _until(plan, place) and done.end_s - done.start_s > 0.01:
            yield with_done(plan, place, number, end_s=round(done.end_s - 0.005, 3))


@breaks("duration_wrong")
def action_stretched(plan: Plan) -> Iterator[Plan]:
    for place, _, number, done in scheduled(plan):
        if not moves(plan, done.leaf) and done.leaf not in _until(plan, place):
            yield with_done(plan, place, number, end_s=round(done.end_s + 0.005, 3))


@breaks("joint_broken")
def joint_shifted(plan: Plan) -> Iterator[Plan]:
    tree = grounded_tree(plan)
    for place, _, number, done in scheduled(plan):
        if tree.action(done.leaf).sync is not None:
            yield with_done(plan, place, number, start_s=done.start_s + 1, end_s=done.end_s + 1)
            yield with_done(plan, place, number, end_s=done.end_s + 0.5)


@breaks("schedule_unsorted")
def listing_reversed(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        yield with_schedule(plan, place, actions=schedule.actions[::-1])
        if len(schedule.legs) > 1:
            yield with_schedule(plan, place, legs=schedule.legs[::-1])


@breaks("role_out_of_order")
def action_before_its_turn(plan: Plan) -> Iterator[Plan]:
    """An action is put at the start of the one before it in its role, which lasts more than the millisecond that is tolerated."""
    tree = grounded_tree(plan)
    for place, schedule, number, done in scheduled(plan):
        before = [
            other
            for other in schedule.actions
            if other.leaf < done.leaf
            and tree.action(other.leaf).role == tree.action(done.leaf).role
            and other.end_s > other.start_s + 0.01
        ]
        if before:
            start_s = max(before, key=lambda other: other.leaf).start_s
            length_s = done.end_s - done.start_s
            yield with_done(plan, place, number, start_s=start_s, end_s=round(start_s + length_s, 3))


@breaks("precedence_broken")
def node_moved_to_the_start(plan: Plan) -> Iterator[Plan]:
    """What a precedence names second starts at 0, with all its actions in their places relative to each other."""
    assert plan.tree is not None
    tree = grounded_tree(plan)
    for place, schedule in schedules(plan):
        for link in plan.tree.links:
            later = {link.second, *(node.id for node in plan.tree.nodes if plan.tree.contains(link.second, node.id))}
            own = [done for done in schedule.actions if tree.nodes[done.leaf].source in later]
            first_s = min((done.start_s for done in own), default=0.0)
            if link.kind == "precedence" and first_s > 1:
                early = {
                    done.leaf: replace(
                        done, start_s=round(done.start_s - first_s, 3), end_s=round(done.end_s - first_s, 3)
                    )
                    for done in own
                }
                yield with_schedule(plan, place, actions=tuple(early.get(done.leaf, done) for done in schedule.actions))


@breaks("until_broken")
def open_end_missed(plan: Plan) -> Iterator[Plan]:
    for place, _, number, done in scheduled(plan):
        if done.leaf in _until(plan, place):
            for shift_s in (-1.0, 2.0):
                yield with_done(plan, place, number, end_s=round(done.end_s + shift_s, 3))


@breaks("until_broken")
def follower_too_late(plan: Plan) -> Iterator[Plan]:
    """It follows for no time at all, at the end of what it was to follow until, or after it."""
    for place, _, number, done in scheduled(plan):
        if done.leaf in _until(plan, place):
            yield with_done(plan, place, number, start_s=done.end_s)
            yield with_done(plan, place, number, start_s=done.end_s + 5, end_s=done.end_s + 5)


@breaks("robot_overlap")
def two_roles_at_once(plan: Plan) -> Iterator[Plan]:
    """A role goes to a robot of the same type that is busy with another role at that time."""
    tree = grounded_tree(plan)
    for place, schedule in schedules(plan):
        for entry in schedule.assignments:
            own = [
                done
                for done in schedule.actions
                if tree.action(done.leaf).role == entry.role and done.end_s > done.start_s
            ]
            for other in schedule.actions:
                meets = any(done.start_s < other.end_s and other.start_s < done.end_s for done in own)
                if other.robot != entry.robot and meets and other.end_s > other.start_s:
                    yield handed_over(plan, place, entry.role, other.robot)


@breaks("holding_broken")
def role_within_a_role(plan: Plan) -> Iterator[Plan]:
    """The last action of a role is put off until the robot has done another role."""
    tree = grounded_tree(plan)
    for place, schedule in schedules(plan):
        for entry in schedule.assignments:
            role = [done for done in schedule.actions if tree.action(done.leaf).role == entry.role]
            last = max(role, key=lambda done: done.leaf)
            after = [
                done.end_s
                for done in schedule.actions
                if done.robot == entry.robot
                and done.start_s >= last.end_s
                and done not in role
                and done.end_s > done.start_s
            ]
            if len(role) > 1 and after:
                number, start_s = schedule.actions.index(last), max(after)
                end_s = round(start_s + last.end_s - last.start_s, 3)
                yield with_done(plan, place, number, start_s=start_s, end_s=end_s)


@breaks("hand_over_missed")
def taken_over_late(plan: Plan) -> Iterator[Plan]:
    """The first action of who takes over starts two seconds later."""
    for place, _, number, done in scheduled(plan):
        if done.leaf in _takers(plan, place):
            yield with_done(plan, place, number, start_s=done.start_s + 2, end_s=done.end_s + 2)


@breaks("hand_over_unfit")
def taken_over_elsewhere(plan: Plan) -> Iterator[Plan]:
    """Who takes over begins at another place than who hands over ends at, or at none."""
    for place, _ in schedules(plan):
        for leaf in _takers(plan, place):
            yield with_action(plan, leaf, at=None)
            yield with_action(plan, leaf, at="elsewhere")


def _takers(plan: Plan, place: int) -> set[int]:
    """First actions of who takes over, in one schedule."""
    tree = grounded_tree(plan)
    done = {one.leaf for one in plan.schedules[place].actions}
    found = set()
    for link in tree.links:
        below = {leaf for leaf in done if link.kind == "hand_over" and _stands_below(tree, leaf, link.second)}
        found |= {min(below)} if below else set()
    return found


def _stands_below(tree: GroundedTree, node: int, above: int) -> bool:
    while node > above:
        node = tree.nodes[node].parent
    return node == above


def room_for_one(plan: Plan) -> set[str]:
    """Shared resources with room for one."""
    return {resource.id for resource in plan.brief.world.resources if resource.capacity == 1}


@breaks("resource_overfull")
def on_the_way_at_once(plan: Plan) -> Iterator[Plan]:
    """A robot is on its way through what another holds on its own way, and what has room for one."""
    narrow = room_for_one(plan)
    world = plan.brief.world
    for place, _, number, leg in travelled(plan):
        for other in plan.schedules[place].legs:
            shared = {*world.passed(leg.via)} & {*world.passed(other.via)} & narrow
            if other.robot != leg.robot and shared and min(leg.end_s - leg.start_s, other.end_s - other.start_s) > 1:
                end_s = round(other.start_s + leg.end_s - leg.start_s, 3)
                yield with_leg(plan, place, number, start_s=other.start_s, end_s=end_s)


@breaks("resource_overfull")
def held_at_once(plan: Plan) -> Iterator[Plan]:
    """An action that fills a shared resource is put to the same time as another that holds it."""
    tree, narrow = grounded_tree(plan), room_for_one(plan)
    for place, schedule, number, done in scheduled(plan):
        for other in schedule.actions:
            shared = {*tree.action(done.leaf).holds} & {*tree.action(other.leaf).holds} & narrow
            if other.robot != done.robot and shared and min(done.end_s - done.start_s, other.end_s - other.start_s) > 1:
                end_s = round(other.start_s + done.end_s - done.start_s, 3)
                yield with_done(plan, place, number, start_s=other.start_s, end_s=end_s)


# Travel.


@breaks("leg_missing")
def leg_dropped(plan: Plan) -> Iterator[Plan]:
    for place, schedule, number, leg in travelled(plan):
        if leg.distance_m > 0.01:
            yield with_schedule(plan, place, legs=without(schedule.legs, number))


@breaks("leg_missing")
def move_without_a_leg(plan: Plan) -> Iterator[Plan]:
    """Even one of 0 m."""
    for place, schedule, number, leg in travelled(plan):
        if moves(plan, leg.leaf):
            yield with_schedule(plan, place, legs=without(schedule.legs, number))


@breaks("leg_extra")
def leg_added(plan: Plan) -> Iterator[Plan]:
    for place, schedule, _, leg in travelled(plan):
        yield with_schedule(plan, place, legs=(*schedule.legs, leg))
        yield with_schedule(plan, place, legs=(*schedule.legs, replace(leg, leaf=0)))
        yield with_schedule(plan, place, legs=(*schedule.legs, replace(leg, leaf=9999)))


@breaks("leg_origin_wrong")
def leg_from_elsewhere(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in travelled(plan):
        yield with_leg(plan, place, number, origin=replace(leg.origin, x_m=leg.origin.x_m + 1))
        yield with_leg(plan, place, number, origin=replace(leg.origin, floor="attic"))
        yield with_leg(plan, place, number, origin=replace(leg.origin, frame="odom"))


@breaks("leg_destination_wrong")
def leg_to_elsewhere(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in travelled(plan):
        yield with_leg(plan, place, number, destination=replace(leg.destination, y_m=leg.destination.y_m - 1))
        if leg.origin != leg.destination:
            yield with_leg(plan, place, number, destination=leg.origin)


@breaks("leg_understated")
def leg_shortened(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in travelled(plan):
        if leg.distance_m > 0.01:
            yield with_leg(plan, place, number, distance_m=leg.distance_m * 0.99)
            yield with_leg(plan, place, number, distance_m=0.0)


@breaks("leg_without_way")
def leg_into_nowhere(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in travelled(plan):
        yield with_leg(plan, place, number, destination=Position(leg.destination.x_m, leg.destination.y_m, "attic"))


@breaks("leg_too_fast")
def leg_hurried(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in travelled(plan):
        if leg.end_s - leg.start_s > 0.01:
            yield with_leg(plan, place, number, start_s=round(leg.end_s - (leg.end_s - leg.start_s) * 0.5, 3))


@breaks("leg_too_fast")
def fleet_slowed(plan: Plan) -> Iterator[Plan]:
    for kind in used_types(plan):
        if "max_speed_mps" in kind.limits and plan.schedules[0].legs:
            speed = kind.limits["max_speed_mps"]
            travels = any(
                leg.distance_m > 0.1
                for s in plan.schedules
                for leg in s.legs
                if plan.brief.fleet.type_of[leg.robot] is kind
            )
            if travels:
                yield with_kind(plan, kind.id, limits={**kind.limits, "max_speed_mps": speed / 10})


@breaks("leg_at_wrong_time")
def leg_late(plan: Plan) -> Iterator[Plan]:
    """It ends long after the action that it leads to."""
    for place, schedule, number, leg in travelled(plan):
        over_s = max((done.end_s for done in schedule.actions if done.leaf == leg.leaf), default=0.0)
        yield with_leg(plan, place, number, end_s=max(over_s, leg.end_s) + 500)


@breaks("leg_via_broken")
def leg_through_nothing(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in travelled(plan):
        yield with_leg(plan, place, number, via=("narnia",))
        if len(leg.via) > 2:
            yield with_leg(plan, place, number, via=leg.via[:1] + leg.via[2:])
        if leg.via:
            yield with_leg(plan, place, number, distance_m=leg.distance_m * 0.9)


@breaks("leg_via_broken")
def leg_by_no_road(plan: Plan) -> Iterator[Plan]:
    """The road nodes are left out, or the way leaves the road before its last node or joins it after its first."""
    for place, _, number, leg in travelled(plan):
        if leg.via:
            yield with_leg(plan, place, number, via=())
        if len(leg.via) > 1 and leg.origin != leg.destination:
            yield with_leg(plan, place, number, via=leg.via[:-1], distance_m=leg.distance_m + 1000)
            yield with_leg(plan, place, number, via=leg.via[1:], distance_m=leg.distance_m + 1000)


@breaks("move_too_short")
def blind_move_hurried(plan: Plan) -> Iterator[Plan]:
    for place, schedule, number, done in scheduled(plan):
        legs = {(leg.robot, leg.leaf) for leg in schedule.legs}
        if moves(plan, done.leaf) and (done.robot, done.leaf) not in legs and done.end_s - done.start_s > 1:
            yield with_done(plan, place, number, end_s=round(done.end_s - 1, 3))


# How much.


@breaks("budget_exceeded")
def budget_cut(plan: Plan) -> Iterator[Plan]:
    for kind in used_types(plan):
        if "energy_j" in plan.brief.terms.refilled(kind):
            continue  # a level, and no budget
        if not kind.uses_per_m or not any(
            plan.brief.fleet.type_of[leg.robot] is kind for s in plan.schedules for leg in s.legs
        ):
            continue
        if kind.robots:
            robots: tuple[Robot, ...] = tuple(replace(robot, remaining={"energy_j": 1.0}) for robot in kind.robots)
            yield with_kind(plan, kind.id, robots=robots)
        else:
            yield with_kind(plan, kind.id, limits={**kind.limits, "energy_j": 1.0})


@breaks("total_budget_exceeded")
def total_budget_cut(plan: Plan) -> Iterator[Plan]:
    for kind in used_types(plan):
        if kind.uses_per_m and any(
            plan.brief.fleet.type_of[leg.robot] is kind for s in plan.schedules for leg in s.legs
        ):
            yield with_kind(plan, kind.id, total_limits={"energy_j": 1.0})


@breaks("mission_budget_exceeded")
def mission_budget_cut(plan: Plan) -> Iterator[Plan]:
    for kind in used_types(plan):
        if kind.uses_per_m and any(
            plan.brief.fleet.type_of[leg.robot] is kind for s in plan.schedules for leg in s.legs
        ):
            yield with_brief(plan, fleet=replace(plan.brief.fleet, total_limits={"energy_j": 1.0}))
    if plan.brief.fleet.total_limits:
        yield with_brief(plan, fleet=replace(plan.brief.fleet, total_limits={"energy_j": 5.0}))


@breaks("stock_exceeded")
def stock_cut(plan: Plan) -> Iterator[Plan]:
    scene = plan.brief.scene
    if scene is not None and scene.stock:
        yield with_brief(plan, scene=replace(scene, stock={"kits": 2.0}))
        yield with_brief(plan, scene=replace(scene, stock={"energy_j": 20.0}))


@breaks("makespan_wrong")
def makespan_changed(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        for shift in (-0.5, 0.5):
            yield with_schedule(plan, place, makespan_s=schedule.makespan_s + shift)


@breaks("bound_above_makespan")
def bound_raised(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        certificate = replace(schedule.certificate, bound=schedule.makespan_s + 1)
        yield with_schedule(plan, place, certificate=certificate)


@breaks("optimality_unfounded")
def optimality_claimed(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        for certificate in (
            replace(schedule.certificate, claim="bounded"),
            replace(schedule.certificate, claim="proven", bound=schedule.makespan_s - 1),
        ):
            yield with_schedule(plan, place, status="optimal", certificate=certificate)


@breaks("schedule_certificate_unfounded")
def proof_of_the_merely_feasible(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        yield with_schedule(plan, place, status="feasible", certificate=replace(schedule.certificate, claim="proven"))
        empty = replace(
            schedule, actions=(), legs=(), assignments=(), makespan_s=0.0, reasons=(WHY,), status="infeasible"
        )
        plans = list(plan.schedules)
        plans[place] = replace(empty, certificate=replace(schedule.certificate, claim="unproven"))
        yield replace(plan, schedules=tuple(plans))


@breaks("solver_word_unfounded")
def a_solver_s_word_for_something_else(plan: Plan) -> Iterator[Plan]:
    assert plan.ranking is not None
    word = replace(plan.ranking.certificate, claim="solver_word", method="cp_sat")
    yield replace(plan, ranking=replace(plan.ranking, status="partial", certificate=word))
    for place, schedule in schedules(plan):
        certificate = replace(schedule.certificate, claim="solver_word", method="cp_sat", bound=None)
        yield with_schedule(plan, place, status="feasible", certificate=certificate)


@breaks("claim_unfounded")
def a_solver_s_word_called_a_bound(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        certificate = replace(schedule.certificate, claim="bounded", method="cp_sat")
        yield with_schedule(plan, place, status="feasible", certificate=certificate)
        certificate = replace(schedule.certificate, claim="solver_word", method="critical_path")
        yield with_schedule(plan, place, status="feasible", certificate=certificate)


# Fronts and choices


def with_options(plan: Plan, options: list[Option], **changes: Any) -> Plan:
    """The plan with these options on its front, numbered anew."""
    assert plan.front is not None
    numbered = tuple(
        replace(one, alternative=replace(one.alternative, rank=rank), schedule=replace(one.schedule, rank=rank))
        for rank, one in enumerate(options, start=1)
    )
    return replace(plan, front=replace(plan.front, options=numbered, **changes))


def with_chosen(plan: Plan, **changes: Any) -> Plan:
    assert plan.chosen is not None
    return replace(plan, chosen=replace(plan.chosen, option=replace(plan.chosen.option, **changes)))


def feasible(schedule: Schedule) -> Schedule:
    """The schedule, no longer called the shortest."""
    certificate = Certificate(claim="bounded", method="critical_path", bound=schedule.makespan_s / 2)
    return replace(schedule, status="feasible", certificate=certificate)


@breaks("front_uncalled")
def front_of_nothing(plan: Plan) -> Iterator[Plan]:
    if plan.front is not None:
        yield with_options(plan, [])
        yield replace(plan, outcome="exhausted")


@breaks("front_dominated")
def front_turned(plan: Plan) -> Iterator[Plan]:
    """The fastest first; or an option twice; or one that is slower than its listed self."""
    options = list(plan.front.options) if plan.front is not None else []
    if len(options) > 1:
        yield with_options(plan, options[::-1])
    for place, option in enumerate(options):
        yield with_options(plan, [*options[: place + 1], *options[place:]])
        slow = replace(option.schedule, makespan_s=option.schedule.makespan_s + 1)
        listed = plan.ranking.alternatives if plan.ranking is not None else ()
        if any(one.choices == option.alternative.choices for one in listed):
            yield with_options(plan, [*options[:place], replace(option, schedule=slow), *options[place + 1 :]])


@breaks("front_incomplete")
def option_dropped(plan: Plan) -> Iterator[Plan]:
    """An option less than there are; or more than there are; or, of listed alternatives, one that nothing else covers."""
    options = list(plan.front.options) if plan.front is not None else []
    for place in range(len(options) if len(options) > 1 else 0):
        left = options[:place] + options[place + 1 :]
        yield with_options(plan, left)
        if any(one.choices == options[place].alternative.choices for one in (plan.ranking or plan).alternatives):  # type: ignore[union-attr]
            yield with_options(plan, left, found=len(left))
    for found in {1, len(options) + 1} - {len(options)} if options else ():
        yield with_options(plan, options, found=found)


@breaks("front_claim_unfounded")
def proof_of_an_option_without_one(plan: Plan) -> Iterator[Plan]:
    """An option is proven, and its schedule no longer; or the front is and an option is not; or by a method that nobody knows."""
    options = list(plan.front.options) if plan.front is not None else []
    for place, option in enumerate(options):
        if option.certificate.claim == "proven":
            loose = replace(option, schedule=feasible(option.schedule))
            yield with_options(plan, [*options[:place], loose, *options[place + 1 :]])
    for place, option in enumerate(options):
        magic = replace(option, certificate=replace(option.certificate, method="magic"))
        yield with_options(plan, [*options[:place], magic, *options[place + 1 :]])
        if plan.front is not None and plan.front.certificate.claim == "proven":
            unproven = replace(option, certificate=replace(option.certificate, claim="unproven"))
            yield with_options(plan, [*options[:place], unproven, *options[place + 1 :]])


@breaks("chosen_missing")
def choice_dropped_or_uncalled(plan: Plan) -> Iterator[Plan]:
    if plan.chosen is not None:
        yield replace(plan, chosen=None)
        yield replace(plan, brief=replace(plan.brief, objective="utility"))
    elif plan.outcome == "delivered":
        yield replace(plan, brief=replace(plan.brief, objective="makespan"))


@breaks("chosen_worth_wrong")
def worth_changed(plan: Plan) -> Iterator[Plan]:
    if plan.chosen is not None:
        for by in (1.0, -1.0, 0.01):
            yield replace(plan, chosen=replace(plan.chosen, worth=plan.chosen.worth + by))


@breaks("chosen_beaten")
def choice_of_a_slower_one(plan: Plan) -> Iterator[Plan]:
    """Where the fastest is to be chosen, a slower one of the front, or of the list, is."""
    if plan.chosen is None or plan.brief.objective != "makespan":
        return
    pairs = [(one.alternative, one.schedule) for one in (plan.front.options if plan.front is not None else ())]
    pairs += zip(plan.ranking.alternatives if plan.ranking is not None else (), plan.schedules, strict=True)
    for alternative, schedule in pairs:
        if schedule.actions and schedule.makespan_s > plan.chosen.worth:
            certificate = replace(plan.chosen.option.certificate, claim="unproven", bound=None)
            slower = with_chosen(
                plan,
                alternative=replace(alternative, rank=1, certificate=plan.chosen.option.alternative.certificate),
                schedule=replace(schedule, rank=1),
                certificate=certificate,
            )
            assert slower.chosen is not None
            yield replace(slower, chosen=replace(slower.chosen, worth=schedule.makespan_s))


@breaks("chosen_claim_unfounded")
def choice_overclaimed(plan: Plan) -> Iterator[Plan]:
    """The bound says that the choice cannot be; or a proof names what ended it, or rests on a schedule that is not proven."""
    if plan.chosen is None:
        return
    option, certificate = plan.chosen.option, plan.chosen.option.certificate
    if certificate.bound is not None:
        by = -1.0 if plan.brief.objective.startswith("weighted") else 1.0
        yield with_chosen(plan, certificate=replace(certificate, bound=plan.chosen.worth + by))
        yield with_chosen(plan, certificate=replace(certificate, bound=None))
        yield with_chosen(plan, certificate=replace(certificate, claim="unproven"))
    yield with_chosen(plan, certificate=replace(certificate, method="magic"))
    if certificate.claim == "proven":
        yield with_chosen(plan, certificate=replace(certificate, limit=SearchLimit("stopped")))
        if plan.brief.objective != "weighted-sum":
            yield with_chosen(plan, schedule=feasible(option.schedule))


@breaks("claim_unfounded")
def proof_by_magic(plan: Plan) -> Iterator[Plan]:
    """Every certificate, and a schedule that is called optimal by a method that nobody knows."""
    ranking = plan.ranking
    assert ranking is not None
    yield with_ranking(plan, certificate=replace(ranking.certificate, method="magic"))
    for place, alternative in alternatives(plan):
        yield with_alternative(plan, place, certificate=replace(alternative.certificate, method="magic"))
    for place, schedule in schedules(plan):
        yield with_schedule(plan, place, certificate=replace(schedule.certificate, method="magic"))
        proven = Certificate(claim="proven", method="magic", bound=schedule.makespan_s)
        yield with_schedule(plan, place, status="optimal", certificate=proven)


@breaks("claim_unfounded")
def delay_called_optimal(plan: Plan) -> Iterator[Plan]:
    """The last action is put off by 10 s, and the schedule is called optimal by a documented method; nobody travels."""
    if plan.brief.scene is not None:
        return
    for place, schedule in schedules(plan):
        last = max(schedule.actions, key=lambda done: (done.end_s, done.leaf))
        number, end_s = schedule.actions.index(last), last.end_s + 10
        late = with_done(plan, place, number, start_s=last.start_s + 10, end_s=end_s)
        proven = Certificate(claim="proven", method="critical_path", bound=end_s)
        yield with_schedule(late, place, status="optimal", makespan_s=end_s, certificate=proven)


@breaks("impossibility_unproven")
def impossibility_invented(plan: Plan) -> Iterator[Plan]:
    """A mission that can be done is said to be impossible: with nothing to show, with schedules dropped, or half of it."""
    bare = replace(plan, outcome="cannot_be_done", reasons=(WHY,), ranking=None, schedules=())
    yield bare
    yield replace(bare, grounding=None)
    yield replace(bare, tree=None, grounding=None, digests={"brief": "0" * 64})
    for place, schedule in schedules(plan):
        idle = replace(
            schedule,
            status="infeasible",
            certificate=Certificate(claim="proven", method="reachability"),
            assignments=(),
            actions=(),
            legs=(),
            makespan_s=0.0,
            reasons=(WHY,),
        )
        others = [replace(idle, rank=other.rank) for other in plan.schedules]
        others[place] = replace(idle, rank=schedule.rank, status="unknown")
        yield replace(plan, outcome="cannot_be_done", reasons=(WHY,), schedules=tuple(others))


@breaks("outcome_contradicted")
def outcome_of_another_stage(plan: Plan) -> Iterator[Plan]:
    for outcome in ("incomplete", "provider_failed"):
        yield replace(plan, outcome=outcome, ranking=None, schedules=(), reasons=(WHY,))


@breaks("reason_invented")
def reason_made_up(plan: Plan) -> Iterator[Plan]:
    yield replace(plan, outcome="exhausted", ranking=None, schedules=(), reasons=(WHY,))
    yield replace(plan, outcome="cannot_be_done", reasons=(WHY,))


# Parts of a mission.


@breaks("partial_unsaid")
def part_passed_off_as_the_whole(plan: Plan) -> Iterator[Plan]:
    if plan.partial is not None:
        yield replace(plan, outcome="delivered", reasons=())
        yield replace(plan, partial=None)
    elif plan.outcome == "delivered":
        yield replace(plan, outcome="partial", reasons=(WHY,))


@breaks("grounding_differs")
def part_grounded_as_the_whole(plan: Plan) -> Iterator[Plan]:
    """What was left out stands in the mission tree again, and nothing is said of it."""
    if plan.partial is not None:
        yield replace(plan, outcome="delivered", reasons=(), partial=None, tree=plan.partial.whole)


@breaks("part_not_of_whole")
def other_parts_left_out(plan: Plan) -> Iterator[Plan]:
    """Another part is named, none, or the root; or what is left of the mission loses a link or a name."""
    partial, tree = plan.partial, plan.tree
    if partial is None or tree is None:
        return
    others = [node.id for node in tree.nodes[1:]] + [partial.whole.root.id]
    for other in others:
        yield replace(plan, partial=replace(partial, left_out=(*partial.left_out, LeftOut(other, 1.0))))
    yield replace(plan, partial=replace(partial, left_out=()))
    yield replace(plan, partial=replace(partial, left_out=(LeftOut("nobody", 1.0),)))
    if tree.links:
        yield replace(plan, tree=replace(tree, links=tree.links[1:]))


@breaks("part_weight_wrong")
def part_weighed_wrongly(plan: Plan) -> Iterator[Plan]:
    if plan.partial is not None:
        first, *others = plan.partial.left_out
        yield replace(plan, partial=replace(plan.partial, kept=plan.partial.kept + 0.5))
        yield replace(plan, partial=replace(plan.partial, total=plan.partial.total + 0.5))
        lighter = (LeftOut(first.node, first.weight / 2), *others)
        yield replace(plan, partial=replace(plan.partial, left_out=lighter))


@breaks("part_not_largest")
def part_too_small(plan: Plan) -> Iterator[Plan]:
    """The mission could have been done with a robot that is there again, and still the part is said to be the largest."""
    if plan.partial is not None and plan.brief.without:
        yield with_brief(plan, without=())


# Ways home.


@breaks("own_leg_missing")
def return_dropped(plan: Plan) -> Iterator[Plan]:
    for place, schedule, number, leg in returning(plan):
        if leg.distance_m > 0.01:
            yield with_schedule(plan, place, returns=without(schedule.returns, number))


@breaks("return_extra")
def return_doubled(plan: Plan) -> Iterator[Plan]:
    for place, schedule, _, leg in returning(plan):
        yield with_schedule(plan, place, returns=(*schedule.returns, leg))


@breaks("return_extra")
def return_unasked(plan: Plan) -> Iterator[Plan]:
    """Nobody asks for it, or it is of a robot that does nothing."""
    for place, schedule, number, _ in returning(plan):
        yield replace(plan, brief=replace(plan.brief, return_home=False))
        busy = {done.robot for done in schedule.actions}
        for robot in plan.brief.fleet.robots.keys() - busy:
            yield with_return(plan, place, number, robot=robot)
        break


@breaks("own_leg_misplaced")
def return_elsewhere(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in returning(plan):
        yield with_return(plan, place, number, origin=replace(leg.origin, x_m=leg.origin.x_m + 1))
        yield with_return(plan, place, number, destination=replace(leg.destination, y_m=leg.destination.y_m - 1))
        yield with_return(plan, place, number, destination=replace(leg.destination, frame="odom"))


@breaks("own_leg_without_way")
def return_into_nowhere(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in returning(plan):
        yield with_return(plan, place, number, destination=replace(leg.destination, floor="attic"))


@breaks("own_leg_understated")
def return_shortened(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in returning(plan):
        if leg.distance_m > 0.01:
            yield with_return(plan, place, number, distance_m=leg.distance_m * 0.99)


@breaks("own_leg_too_fast")
def return_hurried(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in returning(plan):
        if leg.end_s - leg.start_s > 0.01:
            yield with_return(plan, place, number, start_s=round((leg.start_s + leg.end_s) / 2, 3))


@breaks("own_leg_at_wrong_time")
def return_before_the_end(plan: Plan) -> Iterator[Plan]:
    for place, schedule, number, leg in returning(plan):
        ends = [one.end_s for one in schedule.actions if one.robot == leg.robot]
        ends += [one.end_s for one in schedule.recharges if one.robot == leg.robot]
        early_s = leg.start_s - max(ends) + 0.5  # it may wait for room on its way
        yield with_return(
            plan, place, number, start_s=round(leg.start_s - early_s, 3), end_s=round(leg.end_s - early_s, 3)
        )


@breaks("own_leg_via_broken")
def return_through_nothing(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in returning(plan):
        yield with_return(plan, place, number, via=("narnia",))
        if leg.via:
            yield with_return(plan, place, number, via=())


@breaks("return_late")
def home_after_the_deadline(plan: Plan) -> Iterator[Plan]:
    for _, schedule in schedules(plan):
        if schedule.returns:
            over_s = max(leg.end_s for leg in schedule.returns)
            yield replace(plan, brief=replace(plan.brief, deadline_s=over_s - 0.01))


@breaks("time_off_grid")
def return_between_ticks(plan: Plan) -> Iterator[Plan]:
    for place, _, number, leg in returning(plan):
        yield with_return(plan, place, number, end_s=leg.end_s + 0.0004)


@breaks("schedule_unsorted")
def returns_reversed(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        if len({leg.start_s for leg in schedule.returns}) > 1:
            yield with_schedule(plan, place, returns=schedule.returns[::-1])


# Visits to chargers.


@breaks("recharge_unknown")
def refilled_nowhere(plan: Plan) -> Iterator[Plan]:
    """At a charger that there is not, or by a robot that does nothing."""
    for place, _, number, visit in refilled(plan):
        yield with_visit(plan, place, number, charger="narnia")
        leg = None if visit.leg is None else replace(visit.leg, robot="hauler-1")
        yield with_visit(plan, place, number, robot="hauler-1", leg=leg)


@breaks("recharge_not_allowed")
def charger_for_others(plan: Plan) -> Iterator[Plan]:
    """A charger that a robot visits serves all types but its own."""
    scene = plan.brief.scene
    for _, _, _, visit in refilled(plan):
        own = plan.brief.fleet.type_of[visit.robot].id
        others = tuple(kind.id for kind in plan.brief.fleet.types if kind.id != own)
        assert scene is not None
        closed = tuple(replace(one, types=others) if one.id == visit.charger else one for one in scene.chargers)
        yield with_brief(plan, scene=replace(scene, chargers=closed))


@breaks("recharge_overlap")
def refilled_on_the_way(plan: Plan) -> Iterator[Plan]:
    for place, _, number, visit in refilled(plan):
        if visit.leg is not None and visit.leg.end_s - visit.leg.start_s > 0.01:
            yield with_visit(plan, place, number, start_s=visit.leg.start_s)


@breaks("recharge_too_fast")
def refilled_in_half_the_time(plan: Plan) -> Iterator[Plan]:
    for place, _, number, visit in refilled(plan):
        if visit.end_s - visit.start_s > 0.01:
            yield with_visit(plan, place, number, end_s=round((visit.start_s + visit.end_s) / 2, 3))


@breaks("charger_crowded")
def charger_not_waited_for(plan: Plan) -> Iterator[Plan]:
    for place, _, number, visit in refilled(plan):
        if visit.leg is not None and visit.start_s - visit.leg.end_s > 0.01:
            lasts_s = visit.end_s - visit.start_s
            yield with_visit(plan, place, number, start_s=visit.leg.end_s, end_s=round(visit.leg.end_s + lasts_s, 3))


@breaks("level_below_nothing")
def refilled_too_little(plan: Plan) -> Iterator[Plan]:
    """A robot takes in nine tenths of what it lacks, whatever it took in."""
    stock_of = {charger.id: charger.stock for charger in plan.brief.world.chargers}
    for place, schedule in schedules(plan):
        for robot, stock in dict.fromkeys((visit.robot, stock_of[visit.charger]) for visit in schedule.recharges):
            own = [
                number
                for number, visit in enumerate(schedule.recharges)
                if (visit.robot, stock_of[visit.charger]) == (robot, stock)
            ]
            taken = sum(schedule.recharges[number].amount for number in own)
            lacking = used(plan, schedule, robot, stock) - _held_at_first(plan, robot, stock)
            if lacking > 0.1:
                damaged = plan
                for number in own:
                    amount = 0.9 * lacking * schedule.recharges[number].amount / taken
                    damaged = with_visit(damaged, place, number, amount=amount)
                yield damaged


def used(plan: Plan, schedule: Schedule, robot: str, stock: str) -> float:
    """What a robot uses of a stock, ways to chargers and home included."""
    metres = sum(leg.distance_m for leg in schedule.legs if leg.robot == robot)
    metres += sum(leg.distance_m for leg in own_legs(schedule) if leg.robot == robot)
    tree = grounded_tree(plan)
    acting = sum(tree.action(done.leaf).uses.get(stock, 0.0) for done in schedule.actions if done.robot == robot)
    return acting + metres * plan.brief.fleet.type_of[robot].uses_per_m.get(stock, 0.0)


def own_legs(schedule: Schedule) -> list[OwnLeg]:
    """Ways to chargers and home."""
    return [*schedule.returns, *(visit.leg for visit in schedule.recharges if visit.leg is not None)]


def _held_at_first(plan: Plan, robot: str, stock: str) -> float:
    kind = plan.brief.fleet.type_of[robot]
    return kind.budget(plan.brief.fleet.robots[robot], stock) or 0.0


@breaks("level_above_full")
def refilled_too_much(plan: Plan) -> Iterator[Plan]:
    for place, _, number, visit in refilled(plan):
        yield with_visit(plan, place, number, amount=visit.amount + 1000)


@breaks("own_leg_missing")
def charger_reached_by_no_way(plan: Plan) -> Iterator[Plan]:
    for place, _, number, visit in refilled(plan):
        if visit.leg is not None and visit.leg.distance_m > 0.01:
            yield with_visit(plan, place, number, leg=None)


@breaks("own_leg_misplaced")
def charger_reached_by_another(plan: Plan) -> Iterator[Plan]:
    for place, _, number, visit in refilled(plan):
        if visit.leg is not None:
            others = sorted(plan.brief.fleet.robots.keys() - {visit.robot})
            for other in others:
                yield with_visit(plan, place, number, leg=replace(visit.leg, robot=other))


@breaks("own_leg_at_wrong_time")
def refilled_before_it_is_there(plan: Plan) -> Iterator[Plan]:
    for place, _, number, visit in refilled(plan):
        if visit.leg is not None:
            yield with_visit(plan, place, number, leg=replace(visit.leg, end_s=round(visit.start_s + 0.5, 3)))


@breaks("schedule_unsorted")
def visits_reversed(plan: Plan) -> Iterator[Plan]:
    for place, schedule in schedules(plan):
        if len({visit.start_s for visit in schedule.recharges}) > 1:
            yield with_schedule(plan, place, recharges=schedule.recharges[::-1])
