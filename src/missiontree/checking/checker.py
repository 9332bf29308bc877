"""The last word: every rule that a plan must keep, listed once."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from missiontree.checking import (
    abilities,
    budgets,
    chosen,
    claims,
    durations,
    estimates,
    front,
    grounding,
    holding,
    inputs,
    makespan,
    meeting,
    mission_tree,
    notes,
    order,
    outcome,
    own_legs,
    part,
    proofs,
    provenance,
    ranking,
    recharges,
    roles,
    selection,
    sharing,
    terms,
    times,
    travel,
    uses,
    witness,
)
from missiontree.checking.case import Case, Rule
from missiontree.checking.fault import Fault
from missiontree.checking.regrounding import Regrounding
from missiontree.mission.as_ranking import as_ranking
from missiontree.mission.certificate import Certificate
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.rechecking import recheck

_PLAN_RULES: tuple[Rule, ...] = (
    inputs.digest_mismatch,
    inputs.digest_unknown,
    provenance.transcript_missing,
    provenance.transcript_damaged,
    provenance.author_contradicted,
    provenance.transcript_of_another_mission,
    mission_tree.tree_missing,
    mission_tree.leaf_open,
    mission_tree.routine_unknown,
    mission_tree.argument_wrong,
    mission_tree.entity_unknown,
    mission_tree.entity_clash,
    mission_tree.resource_unknown,
    mission_tree.precedence_circular,
    grounding.grounding_impossible,
    grounding.grounding_differs,
    grounding.grounding_notes_differ,
    estimates.estimates_differ,
    notes.note_dropped,
    notes.remark_dropped,
    notes.entity_unsaid,
    notes.assumption_missing,
    abilities.type_unknown,
    abilities.capability_missing,
    abilities.quality_differs,
    estimates.estimate_unsaid,
    abilities.routine_not_followed,
    abilities.resource_excluded,
    terms.left_out,
    abilities.kind_refused,
    abilities.need_unmet,
    abilities.quality_below_minimum,
    abilities.zone_forbidden,
    abilities.action_differs,
    sharing.held_unknown,
    selection.choice_dangling,
    selection.choice_missing,
    selection.choice_double,
    selection.choice_unreached,
    selection.choice_order,
    roles.role_type_missing,
    roles.role_type_extra,
    roles.role_type_differs,
    roles.role_order,
    ranking.utility_wrong,
    ranking.rank_wrong,
    ranking.ranking_unsorted,
    ranking.alternative_double,
    ranking.team_repeated,
    witness.witness_incomplete,
    witness.witness_broken,
    witness.alternative_unstaffable,
    times.alternative_late,
    uses.limit_use_missing,
    uses.limit_use_wrong,
    claims.ranking_status_unfounded,
    claims.search_limit_unfounded,
    claims.rank_unproven,
    claims.bound_below_utility,
    claims.claim_refuted,
    part.partial_unsaid,
    part.part_not_of_whole,
    part.part_weight_wrong,
    part.part_not_largest,
    outcome.nothing_delivered,
    outcome.delivered_unsaid,
    outcome.impossibility_unproven,
    outcome.outcome_contradicted,
    outcome.reason_missing,
    outcome.reason_invented,
    outcome.reason_uncalled,
    outcome.schedule_astray,
    outcome.schedule_not_empty,
)
SCHEDULE_RULES: tuple[Rule, ...] = (
    selection.action_missing,
    selection.action_extra,
    selection.action_double,
    roles.assignment_missing,
    roles.assignment_extra,
    roles.robot_unknown,
    roles.robot_type_wrong,
    roles.action_robot_differs,
    terms.robot_left_out,
    terms.required_idle,
    terms.max_in_use_exceeded,
    roles.team_shares_robot,
    roles.same_robot_broken,
    roles.different_robot_broken,
    durations.time_off_grid,
    durations.duration_wrong,
    durations.joint_broken,
    durations.schedule_unsorted,
    order.role_out_of_order,
    order.precedence_broken,
    order.until_broken,
    meeting.hand_over_missed,
    meeting.hand_over_unfit,
    times.release_broken,
    times.deadline_missed,
    times.robot_away,
    holding.robot_overlap,
    holding.holding_broken,
    sharing.resource_overfull,
    travel.leg_missing,
    travel.leg_extra,
    travel.leg_origin_wrong,
    travel.leg_destination_wrong,
    travel.leg_without_way,
    travel.leg_understated,
    travel.leg_too_fast,
    travel.leg_at_wrong_time,
    travel.leg_via_broken,
    travel.move_too_short,
    own_legs.own_leg_missing,
    own_legs.return_extra,
    own_legs.own_leg_misplaced,
    own_legs.own_leg_without_way,
    own_legs.own_leg_understated,
    own_legs.own_leg_too_fast,
    own_legs.own_leg_at_wrong_time,
    own_legs.own_leg_via_broken,
    own_legs.return_late,
    recharges.recharge_unknown,
    recharges.recharge_not_allowed,
    recharges.recharge_overlap,
    recharges.recharge_too_fast,
    recharges.charger_crowded,
    recharges.level_below_nothing,
    recharges.level_above_full,
    budgets.budget_exceeded,
    budgets.total_budget_exceeded,
    budgets.mission_budget_exceeded,
    budgets.stock_exceeded,
    makespan.makespan_wrong,
    makespan.bound_above_makespan,
    makespan.optimality_unfounded,
    makespan.schedule_certificate_unfounded,
    makespan.solver_word_unfounded,
    proofs.claim_unfounded,
)
"""Those that look at schedules beside the alternatives they belong to."""
_CHOICE_RULES: tuple[Rule, ...] = (
    front.front_uncalled,
    front.front_dominated,
    front.front_incomplete,
    front.front_claim_unfounded,
    chosen.chosen_missing,
    chosen.chosen_worth_wrong,
    chosen.chosen_beaten,
    chosen.chosen_claim_unfounded,
)
RULES: tuple[Rule, ...] = (*_PLAN_RULES, *SCHEDULE_RULES, *_CHOICE_RULES)
"""Every rule, in the order of its findings. The name of the function is the code of the rule."""

_OF_ALTERNATIVES = {module.__name__ for module in (selection, roles, ranking, witness, times, uses)}
OPTION_RULES: tuple[Rule, ...] = (
    notes.assumption_missing,
    *(rule for rule in _PLAN_RULES if rule.__module__ in _OF_ALTERNATIVES),
    *SCHEDULE_RULES,
)
"""What the options of a front, and what is chosen, must keep as alternatives and schedules."""
_UNJUDGED = Certificate(claim="unproven", method="enumeration")


def check(plan: Plan, known: Regrounding | None = None) -> tuple[Reason, ...]:
    """
    Check a plan against its inputs.

    The checker shares no code with allocators and schedulers, and works out selections, utilities, places and distances afresh. What
    it finds no fault with is looked at a second time by :func:`missiontree.rechecking.recheck`, which shares no code with it either,
    so that a plan is sound only if both say so.

    Parameters
    ----------
    plan
        Any plan, however damaged: what is wrong is answered, never raised.
    known
        What :func:`missiontree.checking.regrounding.regrounding` made of its tree beforehand, so that nobody has to wait for that
        when time is up. Default: nothing.

    Returns
    -------
    tuple of Reason
        Findings, each naming rule, node and robot; empty if the plan is sound.
    """
    return _checked(plan, RULES, known)


def check_schedules(plan: Plan) -> tuple[Reason, ...]:
    """
    Check the schedules of a plan alone, whatever its ranking and its record may claim.

    Parameters
    ----------
    plan
        Its fleet need not be the one that the ranking was made for: a schedule is held against the fleet that the plan has.
    """
    ranking = plan.ranking
    if ranking is not None:
        alternatives = tuple(replace(one, certificate=_UNJUDGED) for one in ranking.alternatives)
        ranking = replace(ranking, alternatives=alternatives, status="partial", certificate=_UNJUDGED)
    return _checked(replace(plan, ranking=ranking), SCHEDULE_RULES)


def _checked(plan: Plan, rules: tuple[Rule, ...], known: Regrounding | None = None) -> tuple[Reason, ...]:
    case = Case(plan, known)
    findings = tuple(_reason(rule, fault) for rule in rules for fault in rule(case))
    return findings or tuple(_of_options(plan)) or tuple(recheck(plan))


def _of_options(plan: Plan) -> Iterator[Reason]:
    """Findings on the options of the front and on what is chosen."""
    front = plan.front.options if plan.front is not None else ()
    chosen = (plan.chosen.option,) if plan.chosen is not None else ()
    anyone = replace(plan, brief=replace(plan.brief, diverse=False)) if plan.brief.diverse else plan
    for where, options in (("On the front, ", front), ("In what is chosen, ", chosen)):
        if options:
            case = Case(as_ranking(anyone, options))
            yield from (_reason(rule, fault, where) for rule in OPTION_RULES for fault in rule(case))


def _reason(rule: Rule, fault: Fault, where: str = "") -> Reason:
    message = where + fault.message
    return Reason(
        rule=rule.__name__,
        message=message[:1].upper() + message[1:],
        node=fault.node,
        robot=fault.robot,
        found=fault.found,
        needed=fault.needed,
    )
