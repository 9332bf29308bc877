"""Why is that alternative not the first? What it loses, task by task, each price found by planning again with that one choice."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from missiontree.briefing import Request
from missiontree.errors import InputError
from missiontree.explaining.answering import (
    MILLIONTH,
    WORKING,
    best_of,
    moved_in_words,
    named,
    side_by_side,
    verdict_of,
)
from missiontree.explaining.pinned import Found, pinned
from missiontree.explaining.tasks import moved_between, tasks_of
from missiontree.mission.alternative import Alternative
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.mission.why_not import Moved, WhyNot
from missiontree.planner import staff_and_schedule

MOST_PRICED = 8
NEAR_LIMIT = 0.9
"""Share of a limit from which on it is named."""


def why_not_rank(plan: Plan, request: Request, rank: int, control: Control) -> WhyNot:
    """
    Say why an alternative is not the first.

    Parameters
    ----------
    plan, request
        A delivered plan, and how it was made.
    rank
        Rank of the alternative; beyond those listed, more are drawn.
    control
        Time limit.

    Raises
    ------
    InputError
        If the rank is below 1, or there are fewer alternatives.
    """
    best = best_of(plan)
    assert best is not None
    alternative, schedule, proven = _of_rank(plan, request, rank, control)
    question = f"Why not alternative {rank}?"
    if alternative.choices == best[0].choices:
        first = f"Alternative {rank} is the best that has a schedule; it is the one that the plan shows first."
        if plan.chosen is not None:
            first = f"Alternative {rank} is what the objective chooses."
        return WhyNot(
            question=question,
            verdict="same",
            claim="proven" if proven else "found",
            words=(first,),
            utility=best[0].utility,
            makespan_s=best[1].makespan_s,
        )
    moved = moved_between(tasks_of(plan, best[0]), tasks_of(plan, alternative))
    if schedule.status not in WORKING:
        impossible = schedule.status == "infeasible"
        known = "has no schedule; proven" if impossible else "has no schedule that was found"
        return WhyNot(
            question=question,
            verdict="impossible" if impossible else "undecided",
            claim="proven" if impossible else "found",
            words=(f"Alternative {rank} has utility {alternative.utility:g}, and {known}.", *moved_in_words(moved)),
            reasons=schedule.reasons,
            asked_utility=alternative.utility,
            moved=moved,
            utility=best[0].utility,
            makespan_s=best[1].makespan_s,
        )
    compared = side_by_side(
        best[0].utility, alternative.utility, best[1].makespan_s, schedule.makespan_s, plan.brief.aim.worth
    )
    words = (
        f"Alternative {rank} beside {named(plan, best[0])}: {compared}.",
        *_tie(best[0], alternative),
        *moved_in_words(moved),
        *_prices(plan, request, best[0], alternative, moved, control),
        *_limits(alternative),
    )
    return WhyNot(
        question=question,
        verdict=verdict_of(
            best[0].utility, alternative.utility, best[1].makespan_s, schedule.makespan_s, plan.brief.objective
        ),
        claim="proven" if proven else "found",
        words=words,
        asked_utility=alternative.utility,
        asked_makespan_s=schedule.makespan_s,
        moved=moved,
        utility=best[0].utility,
        makespan_s=best[1].makespan_s,
    )


def _of_rank(plan: Plan, request: Request, rank: int, control: Control) -> tuple[Alternative, Schedule, bool]:
    assert plan.ranking is not None
    assert plan.grounding is not None
    assert plan.tree is not None
    if rank < 1:
        raise InputError(f"there is no alternative {rank}", accepted="a rank of 1 or more")
    ranking, schedules = plan.ranking, plan.schedules
    if rank > len(ranking.alternatives):
        more = replace(request, k=rank)
        scene = plan.brief.world.extended(plan.tree.entities)
        ranking, schedules = staff_and_schedule(plan.grounding, more, scene, control)
    if rank > len(ranking.alternatives):
        count, known = len(ranking.alternatives), "" if ranking.status == "exact" else " that were found"
        raise InputError(
            f"there is no alternative {rank}", accepted=f"1 to {count}: there are {count} alternatives{known}"
        )
    asked = ranking.alternatives[rank - 1]
    return asked, schedules[rank - 1], asked.certificate.claim == "proven"


def _tie(best: Alternative, other: Alternative) -> Iterator[str]:
    if abs(best.utility - other.utility) <= MILLIONTH:
        yield "Both are worth the same; which of them stands first is a matter of the order in which choices are listed."


def _prices(
    plan: Plan, request: Request, best: Alternative, other: Alternative, moved: tuple[Moved, ...], control: Control
) -> Iterator[str]:
    """What differences cost by themselves, the rest chosen anew, where that is not what they lose in the alternative."""
    assert plan.grounding is not None
    if not 1 < len(moved) <= MOST_PRICED:
        return
    tree = plan.grounding.tree
    for place, one in enumerate(moved):
        forbidden = [
            child
            for choice in other.choices
            if tree.nodes[choice.xor].source == one.node
            for child in tree.children[choice.xor]
            if child != choice.child
        ]
        if not forbidden:
            continue
        found: Found = pinned(plan, request, forbidden, control.part(1 / (len(moved) - place)))
        if found.alternative is not None and found.proven:
            loss = best.utility - found.alternative.utility
            if abs(loss + one.utility_change) <= MILLIONTH:
                continue
            price = f"costs {loss:g}" if loss > MILLIONTH else "costs nothing"
            yield f"{one.task} as in alternative {other.rank}, and the rest chosen anew, {price}."


def _limits(alternative: Alternative) -> Iterator[str]:
    """Limits that it nearly uses up."""
    for use in alternative.uses:
        if use.share >= NEAR_LIMIT:
            yield f"It uses {use.used:g} of {use.limit:g} {use.name}{f' of {use.who}' if use.who else ''}."
