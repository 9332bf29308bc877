"""Options read as alternatives of a plan, so that whatever looks at alternatives and schedules can look at them, too."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.mission.alternative import Alternative, Ranking
from missiontree.mission.certificate import Certificate
from missiontree.mission.front import Option
from missiontree.mission.plan import Plan

OPTION = "epsilon_constraint"
"""Method in the certificate of every option's alternative, which claims nothing."""


def as_ranking(plan: Plan, options: Sequence[Option]) -> Plan:
    """
    The plan with these options in place of its alternatives and schedules, and nothing claimed of others.

    Parameters
    ----------
    plan
        The plan.
    options
        Some of its options, such as those of its front.
    """
    detail = "These are options, not a ranking."
    ranking = Ranking(
        alternatives=tuple(option.alternative for option in options),
        status="partial" if options else "unknown",
        certificate=Certificate(claim="unproven", method="pool", detail=detail),
    )
    schedules = tuple(option.schedule for option in options)
    return replace(plan, ranking=ranking, schedules=schedules, chosen=None, front=None)


def options_of(plan: Plan) -> tuple[Option, ...]:
    """All options of a plan: those of its front, then the chosen one."""
    front = plan.front.options if plan.front is not None else ()
    return front if plan.chosen is None else (*front, plan.chosen.option)


def is_option(alternative: Alternative) -> bool:
    """Whether an alternative is that of an option, and its rank no rank among all alternatives."""
    return alternative.certificate.method == OPTION
