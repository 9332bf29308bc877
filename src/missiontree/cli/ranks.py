"""Ranks that a person names or leaves open, beside those there are."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.mission.plan import Plan


def known_rank(plan: Plan, rank: int, option: str) -> int:
    """
    The rank, if the plan has an alternative of it.

    Raises
    ------
    InputError
        With the ranks there are.
    """
    alternatives = plan.ranking.alternatives if plan.ranking is not None and plan.grounding is not None else ()
    if not 1 <= rank <= len(alternatives):
        ranks = f"1 to {len(alternatives)}" if alternatives else "the plan has no alternatives"
        raise InputError(f"{option} {rank}", accepted=ranks)
    return rank


def option_named(plan: Plan, name: str) -> Plan:
    """
    The plan with one of its options in place of its alternatives: of the front, by number, or what is chosen.

    Raises
    ------
    InputError
        With the options there are.
    """
    from missiontree.mission.as_ranking import as_ranking

    front = plan.front.options if plan.front is not None else ()
    named = {str(number): option for number, option in enumerate(front, start=1)}
    if plan.chosen is not None:
        named["chosen"] = plan.chosen.option
    if name not in named:
        accepted = ", ".join(named) or "the plan has neither a front nor a choice"
        raise InputError(f"--option {name}", accepted=accepted)
    option = named[name]
    first = replace(option, alternative=replace(option.alternative, rank=1), schedule=replace(option.schedule, rank=1))
    return as_ranking(plan, [first])


def as_chosen(plan: Plan, rank: int | None) -> Plan:
    """The plan with what its objective chooses in place of its alternatives; as it is, if that chooses nothing or a rank is named."""
    return option_named(plan, "chosen") if rank is None and plan.chosen is not None else plan


def best_rank(plan: Plan) -> int | None:
    """Rank of the best alternative that has a schedule."""
    from missiontree.reporting.text import best_scheduled

    best = best_scheduled(plan)
    return None if best is None else best.rank


def scheduled_rank(plan: Plan, rank: int | None, option: str) -> int:
    """
    The rank, or else the best one, if it has a schedule.

    Raises
    ------
    InputError
        If it has none.
    """
    if rank is None:
        best = best_rank(plan)
        if best is None:
            raise nothing(option, "no schedule")
        return best
    if not any(schedule.rank == rank and schedule.actions for schedule in plan.schedules):
        raise InputError(f"{option}: alternative {rank} has no schedule", accepted="a rank that has one")
    return rank


def nothing(option: str, what: str) -> InputError:
    """The error of asking for something that the plan does not have."""
    return InputError(f"{option}: this plan has {what}, so there is nothing to show")
