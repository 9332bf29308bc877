"""
Ways to damage a sound plan, each with the rule of either checker that it breaks.

A way yields the plan damaged at one place after another, and nothing where the plan has no such place. Whatever it yields is wrong:
the amount that a limit is cut to is less than what is used, a leg that is hurried is faster than its robot.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from benchmarks import own_way_damages as own
from missiontree.formats.inputs import input_digests
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.mission.tree import MissionNode
from tests.checking import damages as known
from tests.checking.damages import (
    grounded_tree,
    scheduled,
    schedules,
    travelled,
    with_brief,
    with_kind,
    with_leg,
    with_schedule,
)

Damage = Callable[[Plan], Iterator[Plan]]


@dataclass(frozen=True, slots=True)
class Way:
    """
    A way to damage a plan.

    Parameters
    ----------
    name
        What is done.
    damage
        Does it.
    rule, core_rule
        Rules of the first and of the second checker that it breaks.
    """

    name: str
    damage: Damage
    rule: str
    core_rule: str


def precedence_reversed(plan: Plan) -> Iterator[Plan]:
    """What comes second is put before what comes first, in one schedule."""
    tree = grounded_tree(plan)
    for place, schedule in schedules(plan):
        for link in tree.links:
            first, second = below(plan, schedule, link.first), below(plan, schedule, link.second)
            if link.kind != "precedence" or not first or not second:
                continue
            end_s = max(done.end_s for done in schedule.actions if done.leaf in first)
            start_s = min(done.start_s for done in schedule.actions if done.leaf in second)
            if end_s > 0.01:
                moved = tuple(
                    replace(done, start_s=round(done.start_s - start_s, 3), end_s=round(done.end_s - start_s, 3))
                    if done.leaf in second
                    else done
                    for done in schedule.actions
                )
                yield with_schedule(plan, place, actions=moved)


def option_proven_by_nothing(plan: Plan) -> Iterator[Plan]:
    """A proven option of a front is given a schedule that is not proven shortest."""
    options = list(plan.front.options) if plan.front is not None else []
    for place, option in enumerate(options):
        if option.certificate.claim == "proven":
            loose = replace(option, schedule=known.feasible(option.schedule))
            yield known.with_options(plan, [*options[:place], loose, *options[place + 1 :]])


def below(plan: Plan, schedule: Schedule, node: int) -> set[int]:
    """Scheduled leaves below a node."""
    nodes, found = grounded_tree(plan).nodes, set()
    for done in schedule.actions:
        above = done.leaf
        while above not in {node, -1}:
            above = nodes[above].parent
        if above == node:
            found.add(done.leaf)
    return found


def leg_of_no_length(plan: Plan) -> Iterator[Plan]:
    """A leg between different places is said to have no length; on a grid, between places at least two cells apart."""
    scene = plan.brief.scene
    least_m = 2 * math.sqrt(2) * scene.grid.cell_m if scene is not None and scene.grid is not None else 0.01
    for place, _, number, leg in travelled(plan):
        straight_m = math.hypot(leg.origin.x_m - leg.destination.x_m, leg.origin.y_m - leg.destination.y_m)
        if straight_m > least_m and leg.distance_m > 0.01:
            yield with_leg(plan, place, number, distance_m=0.0)


def slower_than_it_drives(plan: Plan) -> Iterator[Plan]:
    """The type of a robot that travels is only half as fast as the robot drives."""
    for _, _, _, leg in travelled(plan):
        kind, lasts_s = plan.brief.fleet.type_of[leg.robot], leg.end_s - leg.start_s
        if "max_speed_mps" in kind.limits and leg.distance_m > 0.1 and lasts_s > 0.1:
            speed = leg.distance_m / lasts_s / 2
            yield with_kind(plan, kind.id, limits={**kind.limits, "max_speed_mps": speed})


def kinds_narrowed(plan: Plan) -> Iterator[Plan]:
    """No routine, or no branch, takes the entities that it is called with, and kinds are enforced."""
    if plan.brief.check_kinds:
        yield from known.kinds_narrowed(plan)


def more_quality_asked(plan: Plan) -> Iterator[Plan]:
    """More is asked of all actions, of those that a capability rates, or of those of a routine, than anybody can do."""
    yield with_brief(plan, min_quality=99.0)
    tree = grounded_tree(plan)
    for name in dict.fromkeys(tree.action(leaf).capability for leaf, _ in known.leaves(plan)):
        yield with_brief(plan, min_quality={name: 99.0})
    for name in dict.fromkeys(node.routine for _, node in staffed(plan) if node.routine is not None):
        yield with_brief(plan, min_quality={name: 99.0})


def type_excluded(plan: Plan) -> Iterator[Plan]:
    """A routine that somebody is to do is for nobody."""
    for place, node in staffed(plan):
        yield known.with_nodes(plan, place, replace(node, resources=()))


def staffed(plan: Plan) -> Iterator[tuple[int, MissionNode]]:
    """Calls of routines that there are actions for; a call that nobody can do has none."""
    done = {node.source for _, node in known.leaves(plan)}
    yield from ((place, node) for place, node in known.calls(plan) if node.id in done)


def quality_raised(plan: Plan) -> Iterator[Plan]:
    """A scheduled action is better than its type."""
    for _, _, _, done in scheduled(plan):
        action = grounded_tree(plan).action(done.leaf)
        estimate = replace(action.estimate, quality=action.estimate.quality + 0.25)
        yield known.with_action(plan, done.leaf, estimate=estimate)


def used(plan: Plan, schedule: Schedule) -> Mapping[tuple[str, str], float]:
    """What each robot uses of each budget, travel included."""
    amounts: dict[tuple[str, str], float] = {}
    for done in schedule.actions:
        for name, amount in grounded_tree(plan).action(done.leaf).uses.items():
            amounts[done.robot, name] = amounts.get((done.robot, name), 0.0) + amount
    for leg in schedule.legs:
        for name, per_m in plan.brief.fleet.type_of[leg.robot].uses_per_m.items():
            amounts[leg.robot, name] = amounts.get((leg.robot, name), 0.0) + per_m * leg.distance_m
    return {key: amount for key, amount in amounts.items() if amount > 0.1}


def budget_cut(plan: Plan) -> Iterator[Plan]:
    """A robot's type has nine tenths of what the robot uses; of what it can refill there is no budget."""
    for _, schedule in schedules(plan):
        for (robot, name), amount in used(plan, schedule).items():
            kind = plan.brief.fleet.type_of[robot]
            if name in plan.brief.terms.refilled(kind):
                continue
            changes: dict[str, Any] = {"limits": {**kind.limits, name: 0.9 * amount}}
            if kind.robots:
                changes["robots"] = tuple(replace(one, remaining={}) for one in kind.robots)
            yield with_kind(plan, kind.id, **changes)


def type_total_cut(plan: Plan) -> Iterator[Plan]:
    """A type has nine tenths of what its robots use together."""
    for _, schedule in schedules(plan):
        totals: dict[tuple[str, str], float] = {}
        for (robot, name), amount in used(plan, schedule).items():
            key = plan.brief.fleet.type_of[robot].id, name
            totals[key] = totals.get(key, 0.0) + amount
        for (type_id, name), total in totals.items():
            yield with_kind(plan, type_id, total_limits={name: 0.9 * total})


def _totals(plan: Plan, schedule: Schedule) -> Mapping[str, float]:
    totals: dict[str, float] = {}
    for (_, name), amount in used(plan, schedule).items():
        totals[name] = totals.get(name, 0.0) + amount
    return totals


def mission_total_cut(plan: Plan) -> Iterator[Plan]:
    """The mission may use nine tenths of what its robots use."""
    for _, schedule in schedules(plan):
        for name, total in _totals(plan, schedule).items():
            yield with_brief(plan, fleet=replace(plan.brief.fleet, total_limits={name: 0.9 * total}))


def stock_cut(plan: Plan) -> Iterator[Plan]:
    """There is nine tenths in stock of what the robots take."""
    for _, schedule in schedules(plan) if plan.brief.scene is not None else ():
        for name, total in _totals(plan, schedule).items():
            assert plan.brief.scene is not None
            yield with_brief(plan, scene=replace(plan.brief.scene, stock={name: 0.9 * total}))


def released_later(plan: Plan) -> Iterator[Plan]:
    """A scheduled action may start half a second after it does."""
    nodes = grounded_tree(plan).nodes
    for _, _, _, done in scheduled(plan):
        later = replace(nodes[done.leaf], release_s=done.start_s + 0.5, deadline_s=None)
        yield known.with_grounded(plan, nodes=(*nodes[: done.leaf], later, *nodes[done.leaf + 1 :]))


def comes_later(plan: Plan) -> Iterator[Plan]:
    """A robot comes half a second after it starts an action."""
    for _, _, _, done in scheduled(plan):
        yield _there(plan, done.robot, available_from_s=done.start_s + 0.5, available_until_s=None)


def leaves_earlier(plan: Plan) -> Iterator[Plan]:
    """A robot leaves half a second before it ends an action."""
    for _, _, _, done in scheduled(plan):
        if done.end_s > 1:
            yield _there(plan, done.robot, available_from_s=None, available_until_s=done.end_s - 0.5)


def _there(plan: Plan, robot: str, **times: float | None) -> Plan:
    """The plan with other times of a robot's type, which hold for all of its robots."""
    kind = plan.brief.fleet.type_of[robot]
    robots = tuple(replace(one, available_from_s=None, available_until_s=None) for one in kind.robots)
    return with_kind(plan, kind.id, robots=robots, **times)


def with_its_digests(damaged: Plan) -> Plan:
    """The plan with digests of the inputs that it carries now, so that nothing but the rule in question tells."""
    return replace(damaged, digests=input_digests(damaged.brief, damaged.tree))


WAYS = (
    Way("choice left out", known.choice_dropped, "choice_missing", "core_selection"),
    Way("second child of an XOR", known.choice_doubled, "choice_double", "core_selection"),
    Way("child of another node", known.choice_astray, "choice_dangling", "core_selection"),
    Way("choice where nothing is reached", known.choice_elsewhere, "choice_unreached", "core_selection"),
    Way("role filled by another type", known.role_type_changed, "role_type_differs", "core_types"),
    Way("role type left out", known.role_type_dropped, "role_type_missing", "core_types"),
    Way("utility changed", known.utility_changed, "utility_wrong", "core_utility"),
    Way("quality raised", quality_raised, "quality_differs", "core_quality"),
    Way("neighbours in rank swapped", known.neighbours_swapped, "ranking_unsorted", "core_ranks"),
    Way("alternative listed twice", known.alternative_repeated, "alternative_double", "core_ranks"),
    Way("bound below the utility", known.bound_lowered, "bound_below_utility", "core_claims"),
    Way("bound above the makespan", known.bound_raised, "bound_above_makespan", "core_claims"),
    Way("witness of another type", known.witness_of_wrong_type, "witness_broken", "core_staffing"),
    Way("witness cut", known.witness_cut, "witness_incomplete", "core_staffing"),
    Way("front turned round", known.front_turned, "front_dominated", "core_best"),
    Way("option proven by nothing", option_proven_by_nothing, "front_claim_unfounded", "core_best"),
    Way("choice of a slower one", known.choice_of_a_slower_one, "chosen_beaten", "core_best"),
    Way("worth of the choice changed", known.worth_changed, "chosen_worth_wrong", "core_best"),
    Way("schedule left out", known.schedule_lost, "schedule_astray", "core_schedules"),
    Way("action left out", known.action_dropped, "action_missing", "core_actions"),
    Way("action twice", known.action_doubled, "action_double", "core_actions"),
    Way("action that is not selected", known.action_added, "action_extra", "core_actions"),
    Way("role without a robot", known.assignment_dropped, "assignment_missing", "core_staffing"),
    Way("robot that there is not", known.robot_misnamed, "robot_unknown", "core_staffing"),
    Way("robot of another type", known.robot_of_other_type, "robot_type_wrong", "core_staffing"),
    Way("action by another robot", known.action_handed_over, "action_robot_differs", "core_staffing"),
    Way("one robot in two joint roles", known.team_in_one, "team_shares_robot", "core_different_robots"),
    Way("same-robot link split", known.same_robot_split, "same_robot_broken", "core_same_robot"),
    Way("different-robot link joined", known.different_robot_joined, "different_robot_broken", "core_different_robots"),
    Way("robot left out takes part", known.robot_withdrawn, "robot_left_out", "core_without"),
    Way("required robot or type idle", known.idler_required, "required_idle", "core_require"),
    Way("too many of a type in use", known.fewer_in_use, "max_in_use_exceeded", "core_max_in_use"),
    Way("less quality than asked", more_quality_asked, "quality_below_minimum", "core_min_quality"),
    Way("kinds of arguments narrowed", kinds_narrowed, "kind_refused", "core_ability"),
    Way("needs of roles raised", known.needs_raised, "need_unmet", "core_ability"),
    Way("type excluded by its routine", type_excluded, "resource_excluded", "core_ability"),
    Way("zone closed", known.zone_closed, "zone_forbidden", "core_zone"),
    Way("time between ticks", known.time_between_ticks, "time_off_grid", "core_grid"),
    Way("action shortened", known.action_shortened, "duration_wrong", "core_duration"),
    Way("action stretched", known.action_stretched, "duration_wrong", "core_duration"),
    Way("joint work torn apart", known.joint_shifted, "joint_broken", "core_joint"),
    Way("action before its turn", known.action_before_its_turn, "role_out_of_order", "core_order"),
    Way("precedence reversed", precedence_reversed, "precedence_broken", "core_precedence"),
    Way("until missed", known.open_end_missed, "until_broken", "core_until"),
    Way("follower too late", known.follower_too_late, "until_broken", "core_until"),
    Way("robot in two places", known.two_roles_at_once, "robot_overlap", "core_holding"),
    Way("role within a role", known.role_within_a_role, "holding_broken", "core_holding"),
    Way("taken over late", known.taken_over_late, "hand_over_missed", "core_hand_over"),
    Way("taken over elsewhere", known.taken_over_elsewhere, "hand_over_unfit", "core_hand_over"),
    Way("on the way at once", known.on_the_way_at_once, "resource_overfull", "core_shared"),
    Way("shared resource held at once", known.held_at_once, "resource_overfull", "core_shared"),
    Way("leg left out", known.leg_dropped, "leg_missing", "core_travel"),
    Way("leg of another action", known.leg_added, "leg_extra", "core_travel"),
    Way("leg from elsewhere", known.leg_from_elsewhere, "leg_origin_wrong", "core_travel"),
    Way("leg to elsewhere", known.leg_to_elsewhere, "leg_destination_wrong", "core_travel"),
    Way("leg to another floor", known.leg_into_nowhere, "leg_without_way", "core_travel"),
    Way("leg of no length", leg_of_no_length, "leg_understated", "core_travel"),
    Way("leg at twice the speed", known.leg_hurried, "leg_too_fast", "core_travel"),
    Way("robots half as fast", slower_than_it_drives, "leg_too_fast", "core_travel"),
    Way("leg that ends before it starts", own.leg_backwards, "leg_at_wrong_time", "core_travel"),
    Way("leg too late", known.leg_late, "leg_at_wrong_time", "core_travel"),
    Way("way home left out", known.return_dropped, "own_leg_missing", "core_home"),
    Way("way home twice", known.return_doubled, "return_extra", "core_home"),
    Way("way home that nobody asks for", known.return_unasked, "return_extra", "core_home"),
    Way("way home from or to elsewhere", known.return_elsewhere, "own_leg_misplaced", "core_home"),
    Way("way home shortened", known.return_shortened, "own_leg_understated", "core_home"),
    Way("way home at twice the speed", known.return_hurried, "own_leg_too_fast", "core_home"),
    Way("way home before the last action is over", known.return_before_the_end, "own_leg_at_wrong_time", "core_home"),
    Way("home after the deadline", known.home_after_the_deadline, "return_late", "core_home"),
    Way("visit to a charger that there is not", known.refilled_nowhere, "recharge_unknown", "core_refill"),
    Way("charger that serves others", known.charger_for_others, "recharge_not_allowed", "core_refill"),
    Way("refilled on the way", known.refilled_on_the_way, "recharge_overlap", "core_refill"),
    Way("refilled in half the time", known.refilled_in_half_the_time, "recharge_too_fast", "core_refill"),
    Way("charger not waited for", known.charger_not_waited_for, "charger_crowded", "core_refill"),
    Way("refilled too little", known.refilled_too_little, "level_below_nothing", "core_level"),
    Way("refilled more than it holds", known.refilled_too_much, "level_above_full", "core_level"),
    Way("charger reached by no way", known.charger_reached_by_no_way, "own_leg_missing", "core_refill"),
    Way("charger reached by another", known.charger_reached_by_another, "own_leg_misplaced", "core_refill"),
    Way("refilled before it is there", known.refilled_before_it_is_there, "own_leg_at_wrong_time", "core_refill"),
    Way("way to a charger shortened", own.charger_way_shortened, "own_leg_understated", "core_refill"),
    Way("way to a charger at twice the speed", own.charger_way_hurried, "own_leg_too_fast", "core_refill"),
    Way("way to a charger from or to elsewhere", own.charger_way_from_elsewhere, "own_leg_misplaced", "core_refill"),
    Way("way to a charger before it is free", own.charger_way_too_early, "own_leg_at_wrong_time", "core_refill"),
    Way("refilled within a role", own.refilled_within_a_role, "recharge_overlap", "core_refill"),
    Way("refilled twice at once", own.refilled_twice_at_once, "recharge_overlap", "core_refill"),
    Way("on the way home at once", own.home_at_once, "resource_overfull", "core_shared"),
    Way("on the way to a charger at once", own.charger_and_way_at_once, "resource_overfull", "core_shared"),
    Way("robot gone before it is home", own.gone_before_it_is_home, "robot_away", "core_available"),
    Way("robot on its way before it comes", own.come_after_it_set_out, "robot_away", "core_available"),
    Way("budget not for the way home", own.budget_not_for_the_way_home, "budget_exceeded", "core_budget"),
    Way("total not for own ways", own.total_not_for_own_ways, "mission_budget_exceeded", "core_mission_total"),
    Way("task after it is due", own.tasks_due_earlier, "deadline_missed", "core_deadline"),
    Way("task before its release", own.tasks_released_later, "release_broken", "core_release"),
    Way("blind move hurried", known.blind_move_hurried, "move_too_short", "core_travel"),
    Way("budget stretched", budget_cut, "budget_exceeded", "core_budget"),
    Way("budget of a type stretched", type_total_cut, "total_budget_exceeded", "core_type_total"),
    Way("budget of the mission stretched", mission_total_cut, "mission_budget_exceeded", "core_mission_total"),
    Way("stock exceeded", stock_cut, "stock_exceeded", "core_stock"),
    Way("action before its release", released_later, "release_broken", "core_release"),
    Way("action after it is due", known.nodes_due_earlier, "deadline_missed", "core_deadline"),
    Way("mission after it is due", known.due_earlier, "deadline_missed", "core_deadline"),
    Way("robot before it comes", comes_later, "robot_away", "core_available"),
    Way("robot after it has left", leaves_earlier, "robot_away", "core_available"),
    Way("part passed off as the whole", known.part_passed_off_as_the_whole, "partial_unsaid", "core_partial"),
    Way("part under the whole tree", known.part_grounded_as_the_whole, "grounding_differs", "core_partial"),
    Way("other parts left out", known.other_parts_left_out, "part_not_of_whole", "core_partial"),
    Way("makespan changed", known.makespan_changed, "makespan_wrong", "core_makespan"),
)
