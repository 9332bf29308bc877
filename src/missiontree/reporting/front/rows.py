"""What there is to say of each option of a front, and of the choice."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.alternative import Alternative
from missiontree.mission.front import Chosen, Front, Option
from missiontree.mission.objective import IN_WORDS, WEIGHTED
from missiontree.mission.plan import Plan
from missiontree.reporting.gantt.time import in_words
from missiontree.reporting.team.lines import team_lines


@dataclass(frozen=True, slots=True)
class Row:
    """
    An option of a front.

    Parameters
    ----------
    number
        Its place on the front, from 1.
    utility
        As people read it.
    makespan_s
        In seconds.
    team
        Who does what, a line per role; of a long list what sets it apart from the first.
    known
        What is known of it.
    listed
        Rank of its alternative in the ranking; None if it is not among those listed.
    chosen
        Whether it is what the objective of the mission chooses.
    """

    number: int
    utility: str
    makespan_s: float
    team: tuple[str, ...]
    known: str
    listed: int | None
    chosen: bool


def rows_of(plan: Plan) -> tuple[Row, ...]:
    """The options of the front, from the best staffed to the fastest; none if there is no front."""
    if plan.front is None or plan.grounding is None:
        return ()
    first = plan.front.options[0].alternative if plan.front.options else None
    return tuple(
        Row(
            number=option.alternative.rank,
            utility=f"{option.alternative.utility:g}",
            makespan_s=option.schedule.makespan_s,
            team=tuple(team_lines(plan.grounding.tree, option.alternative, plan, first)),
            known="proven" if option.certificate.claim == "proven" else "found",
            listed=listed_rank(plan, option.alternative),
            chosen=plan.chosen is not None and plan.chosen.option.alternative.choices == option.alternative.choices,
        )
        for option in plan.front.options
    )


def listed_rank(plan: Plan, alternative: Alternative) -> int | None:
    """Rank of an alternative in the ranking; None if it is not listed."""
    listed = plan.ranking.alternatives if plan.ranking is not None else ()
    return next((one.rank for one in listed if one.choices == alternative.choices), None)


def front_in_words(front: Front) -> str:
    """How many options there are, and what is known of all others."""
    count = len(front.options)
    plans = f"{count} plans" if count != 1 else "one plan"
    some = f"{plans} of {front.found} found" if front.found > count else plans
    if front.certificate.claim == "proven":
        return f"{some}, proven to be all" if front.found == count else f"{some}, all of which are proven"
    limit = front.certificate.limit
    ended = "" if limit is None else f", ended by {limit.in_words}"
    return f"{some}; there may be others{ended}"


def choice_in_words(plan: Plan, chosen: Chosen) -> str:
    """What is chosen by what, and what is known of it."""
    option, objective = chosen.option, plan.brief.objective
    comes_to = f", worth {chosen.worth:g}" if objective in WEIGHTED else ""
    rank = listed_rank(plan, option.alternative)
    which = "an alternative that is not listed" if rank is None else f"alternative {rank}"
    length = in_words(option.schedule.makespan_s)
    return f"{IN_WORDS[objective]}: {which}, utility {option.alternative.utility:g}, {length}{comes_to} ({_claim(plan, option)})"


def _claim(plan: Plan, option: Option) -> str:
    certificate = option.certificate
    if certificate.claim == "proven":
        return "proven best"
    if certificate.bound is None:
        return "not proven best"
    weighted = plan.brief.objective in WEIGHTED
    if not weighted and certificate.bound >= option.schedule.makespan_s:
        return "none is faster, proven"
    return f"none is {'above' if weighted else 'below'} {certificate.bound:g}{'' if weighted else ' s'}, proven"
