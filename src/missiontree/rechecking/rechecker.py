"""The second opinion: every core rule on every alternative of a plan and its schedule."""

from __future__ import annotations

from dataclasses import replace

from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.rechecking import (
    abilities,
    amounts,
    claims,
    home,
    options,
    parts,
    refilling,
    selection,
    sharing,
    staffing,
    times,
    travel,
    windows,
    worth,
)
from missiontree.rechecking.facts import Facts, broken
from missiontree.rechecking.shortest import Ways

OFFERED = (worth.quality_is_the_types, worth.good_enough, abilities.able, abilities.in_allowed_zones)
CHOSEN = (selection.one_child_per_xor, selection.choices_in_preorder)
ALTERNATIVE = (
    worth.utility_is_the_sum,
    staffing.types_of_roles,
    staffing.required_types,
    staffing.enough_for_teams,
    staffing.witnessed_team,
    amounts.witnessed_amounts,
    amounts.least_amounts,
    claims.bound_of_the_alternative,
)
STAFFED = (staffing.robots_of_roles, staffing.scheduled_team, times.every_action_once)
TIMED = (
    *times.TIME_RULES,
    *windows.WINDOW_RULES,
    *travel.TRAVEL_RULES,
    sharing.shared_resources,
    *home.HOME_RULES,
    *refilling.REFILL_RULES,
    amounts.scheduled_amounts,
    claims.bound_of_the_schedule,
)

CORE_RULES = {
    "core_ability": "a type does what it is able to, by capability, limits, kinds of arguments and resources",
    "core_actions": "every selected action is scheduled once, and nothing else is",
    "core_available": "a robot is busy only while it takes part",
    "core_best": "nothing that the plan shows is better by the objective than what is chosen, or beats an option of the front",
    "core_budget": "no robot uses more of a budget than it has",
    "core_claims": "no bound contradicts what is shown, and what is called optimal is proven",
    "core_deadline": "nothing ends after it is due",
    "core_different_robots": "joint roles, and nodes linked so, have different robots",
    "core_duration": "an action lasts as long as it takes",
    "core_grid": "times are whole milliseconds",
    "core_hand_over": "who hands over ends when and where the taker starts",
    "core_holding": "a robot takes one role at a time",
    "core_home": "where robots return, who did something goes home after it, in time and no faster than it is",
    "core_joint": "joint actions start and end together",
    "core_level": "of what it can refill a robot has no less than nothing, and no more than it holds",
    "core_makespan": "the makespan is the latest end",
    "core_max_in_use": "no more robots of a type take part than may",
    "core_min_quality": "every action is as good as the mission asks",
    "core_mission_total": "the team uses no more than the mission may",
    "core_order": "the actions of a role run in order",
    "core_partial": "a plan for a part of the mission says so, and is one for all that it does not leave out",
    "core_precedence": "what comes first ends before what comes after starts",
    "core_quality": "an action has the quality of its type",
    "core_ranks": "the better alternative stands first, and teams differ where they are to",
    "core_refill": "robots refill between roles, at chargers that serve them, have room, and give no more than they can",
    "core_release": "nothing starts before its release",
    "core_require": "who must take part does",
    "core_same_robot": "nodes for one robot are done by one robot",
    "core_schedules": "there is a schedule for each alternative, whole or empty as it says",
    "core_selection": "a reached XOR has one child, a reached AND all",
    "core_shared": "a shared resource is held by no more robots at a time than it has room for",
    "core_staffing": "every role has one robot, of its type",
    "core_stock": "the mission takes no more than there is",
    "core_travel": "a robot comes from where it was, and no faster than it is",
    "core_type_total": "the robots of a type use no more than they may together",
    "core_types": "every role has one type, that of its actions",
    "core_until": "what lasts until another ends does",
    "core_utility": "the utility is the sum over the selected actions, or their mean or least as the mission asks",
    "core_without": "who is left out takes no part",
    "core_zone": "nobody works in a zone that it may not enter",
}


def recheck(plan: Plan) -> list[Reason]:
    """
    Everything in a plan that breaks a core rule; empty if nothing does.

    It looks at the meaning of a plan: selection, staffing, times, travel, amounts, utilities and ranks. Whether trees, proofs and
    records of a plan are what they should be is left to :func:`missiontree.checking.check`. Ways are tested against the least
    length that they could have; what keep-outs, zones and blocked cells add to it is left to the first, too.

    Returns
    -------
    list of Reason
        Faults, each naming a rule of ``CORE_RULES``, and the node and the robot concerned. A rule is not tested where what it rests
        on is broken: without a selection no staffing, without the staffing no times.
    """
    found = list(parts.part_of_the_mission(plan))
    if plan.grounding is None or plan.ranking is None:
        return found
    alternatives = plan.ranking.alternatives
    found += list(worth.ranks_in_order(alternatives, plan.brief.accumulate))
    found += worth.teams_differ(alternatives) if plan.brief.diverse else ()
    expected = plan.outcome in {"delivered", "partial"} or plan.schedules
    if expected and [one.rank for one in plan.schedules] != [one.rank for one in alternatives]:
        found.append(broken("core_schedules", "the schedules do not stand beside the alternatives, one for each."))
    ways = Ways(_world(plan))
    for alternative in alternatives:
        schedule = next((one for one in plan.schedules if one.rank == alternative.rank), None)
        if schedule is not None and schedule.status in {"infeasible", "unknown"}:
            if schedule.actions or schedule.legs or schedule.recharges or schedule.returns or schedule.assignments:
                found.append(broken("core_schedules", f"the schedule of rank {alternative.rank} says there is none."))
            schedule = None
        facts = Facts(plan.brief, plan.tree, plan.grounding.tree, alternative, schedule, ways)
        if alternative is alternatives[0]:  # what is offered is the same for all of them
            found += [one for rule in OFFERED for one in rule(facts)]
        found += _one(facts)
    for name, shown in options.shown(plan):
        for option in shown:
            facts = Facts(plan.brief, plan.tree, plan.grounding.tree, option.alternative, option.schedule, ways)
            found += [replace(one, message=f"{name}: {one.message}") for one in _one(facts)]
    return found or [one for rule in options.OPTION_RULES for one in rule(plan)]


def _world(plan: Plan) -> Scene:
    """The scene with what the operator declares and the author introduces; without the latter if it does not fit."""
    try:
        return plan.brief.world.extended(plan.tree.entities if plan.tree is not None else ())
    except ValueError:
        return plan.brief.world


def _one(facts: Facts) -> list[Reason]:
    """Faults of one alternative and its schedule."""
    found = [one for rule in CHOSEN for one in rule(facts)]
    if found:
        return found
    found = [one for rule in ALTERNATIVE for one in rule(facts)]
    if facts.schedule is None:
        return found
    staffed = [one for rule in STAFFED for one in rule(facts)]
    known = facts.brief.fleet.robots
    if set(facts.leaves) != set(facts.start_ms) or any(robot not in known for robot in facts.robot_of_role.values()):
        return found + staffed
    return found + staffed + [one for rule in TIMED for one in rule(facts)]
