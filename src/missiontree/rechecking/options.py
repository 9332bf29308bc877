"""Options: a front on which nothing is beaten, and a choice that nothing shown is better than."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.front import Option
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Schedule
from missiontree.rechecking.facts import broken, milliseconds

RULE = "core_best"
MILLION = 1_000_000

Pair = tuple[Alternative, Schedule]


def shown(plan: Plan) -> Iterator[tuple[str, tuple[Option, ...]]]:
    """The front and the choice, as far as there are any."""
    if plan.front is not None:
        yield "front", plan.front.options
    if plan.chosen is not None:
        yield "choice", (plan.chosen.option,)


def front_in_order(plan: Plan) -> Iterator[Reason]:
    """Down the front, utility and makespan fall; and no alternative with a schedule is better in one and no worse in the other."""
    options = plan.front.options if plan.front is not None else ()
    told = [(round(one.alternative.utility * MILLION), milliseconds(one.schedule.makespan_s)) for one in options]
    for place, (above, below) in enumerate(pairwise(told), start=1):
        if not (above[0] > below[0] and above[1] > below[1]):
            yield broken(RULE, f"options {place} and {place + 1} of the front are not the better and the faster.")
    for alternative, schedule in _timed(plan):
        utility, lasts = round(alternative.utility * MILLION), milliseconds(schedule.makespan_s)
        for place, (own, own_lasts) in enumerate(told, start=1):
            if utility >= own and lasts <= own_lasts and (utility, lasts) != (own, own_lasts):
                yield broken(RULE, f"rank {alternative.rank} beats option {place} of the front.")


def choice_is_best(plan: Plan) -> Iterator[Reason]:
    """What is chosen comes to what is said, and nothing shown comes to more."""
    if plan.chosen is None or plan.grounding is None:
        return
    own = _merit(plan, plan.chosen.option.alternative, plan.chosen.option.schedule)
    others = [*_timed(plan)]
    others += [(one.alternative, one.schedule) for one in (plan.front.options if plan.front is not None else ())]
    if any(_merit(plan, *other) > own for other in others):
        yield broken(RULE, f"something shown is better by {plan.brief.objective} than what is chosen.")
    said, right = plan.chosen.worth, plan.chosen.option.schedule.makespan_s
    if plan.brief.objective in {"weighted-team", "weighted-sum"}:
        right = float(own[0] / MILLION)
    if abs(said - right) > 2 / MILLION + 1e-9 * abs(right):
        yield broken(RULE, f"what is chosen is said to come to {said}, and comes to {right}.")


def proofs_are_shown(plan: Plan) -> Iterator[Reason]:
    """What is proven of makespans rests on schedules that are proven least."""
    by_makespan = plan.brief.objective != "weighted-sum"
    for name, options in shown(plan):
        for one in options if name == "front" or by_makespan else ():
            if one.certificate.claim == "proven" and one.schedule.status != "optimal":
                yield broken(RULE, f"{name}: option {one.alternative.rank} is proven, and its schedule is not.")


OPTION_RULES = (front_in_order, choice_is_best, proofs_are_shown)


def _timed(plan: Plan) -> Iterator[Pair]:
    alternatives = plan.ranking.alternatives if plan.ranking is not None else ()
    for alternative in alternatives:
        for schedule in plan.schedules:
            if schedule.rank == alternative.rank and schedule.status in {"optimal", "feasible"}:
                yield alternative, schedule


def _merit(plan: Plan, alternative: Alternative, schedule: Schedule) -> tuple[Fraction, ...]:
    """The higher the better, part by part."""
    utility = Fraction(round(alternative.utility * MILLION))
    lasts = Fraction(milliseconds(schedule.makespan_s))
    if plan.brief.objective == "makespan":
        return -lasts, utility
    if plan.brief.objective == "utility-makespan":
        return utility, -lasts
    return (_worth(plan, alternative, schedule),)


def _worth(plan: Plan, alternative: Alternative, schedule: Schedule) -> Fraction:
    """Alpha * q - gamma * c over the selected leaves, less beta * d, in millionths."""
    assert plan.grounding is not None
    tree, weights = plan.grounding.tree, plan.brief.weights
    worth = Fraction(0)
    for leaf in selected_leaves(tree, alternative.choices):
        one = tree.action(leaf).estimate
        worth += round((weights.alpha * one.quality - weights.gamma * one.cost) * MILLION)
    ms = milliseconds(schedule.makespan_s)
    if plan.brief.objective == "weighted-sum":
        ms = sum(milliseconds(one.end_s) - milliseconds(one.start_s) for one in schedule.actions)
        legs = [leg for leg in schedule.legs if not tree.action(leg.leaf).moves]  # the leg of a move is the move
        ms += sum(milliseconds(leg.end_s) - milliseconds(leg.start_s) for leg in legs)
        own = [*schedule.returns, *(one.leg for one in schedule.recharges if one.leg is not None)]
        ms += sum(milliseconds(leg.end_s) - milliseconds(leg.start_s) for leg in own)
    return worth - Fraction(weights.beta) * 1000 * ms
