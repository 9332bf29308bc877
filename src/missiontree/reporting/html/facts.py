"""What a plan came to, in the words that stand at the top of the page."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from missiontree.mission.alternative import Ranking
from missiontree.mission.plan import Outcome, Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.front.rows import choice_in_words
from missiontree.reporting.html.quantity import count, number
from missiontree.reporting.html.times import lasts
from missiontree.reporting.known import by_word
from missiontree.reporting.text import best_scheduled

Tone = Literal["good", "bad", "open"]


@dataclass(frozen=True, slots=True)
class Headline:
    """
    The outcome at a glance.

    Parameters
    ----------
    word
        The outcome in one or two words.
    tone
        ``good``, ``bad``, or ``open``: nothing is decided.
    sentence
        What it means.
    """

    word: str
    tone: Tone
    sentence: str


_REFUSED: dict[Outcome, Headline] = {
    "partial": Headline(
        "In part only",
        "bad",
        "The mission cannot be done as a whole. This is a plan for the part of it that can be done.",
    ),
    "cannot_be_done": Headline("Cannot be done", "bad", "With this team and these routines there is no way to do it."),
    "incomplete": Headline(
        "Incomplete", "open", "Not every part of the mission is understood or built, so nothing is planned."
    ),
    "exhausted": Headline(
        "Nothing found", "open", "Nothing was found with the time and effort given. Nothing is excluded either."
    ),
    "provider_failed": Headline("Not planned", "bad", "The language model could not be used."),
}


def headline(plan: Plan) -> Headline:
    """The outcome; of a delivered plan, what its best alternative comes to."""
    if plan.outcome != "delivered":
        return _REFUSED[plan.outcome]
    best = best_scheduled(plan) if plan.chosen is None else plan.chosen.option.schedule
    if best is None or plan.ranking is None:
        return Headline("Planned", "good", "The mission has a plan.")
    robots = len({assignment.robot for assignment in best.assignments})
    return Headline(
        "Planned",
        "good",
        " ".join(
            (
                f"{count(robots, 'robot')} {'does' if robots == 1 else 'do'} it in {lasts(best.makespan_s)}.",
                *_standing(plan, plan.ranking, best),
            )
        ),
    )


def _standing(plan: Plan, ranking: Ranking, best: Schedule) -> Iterator[str]:
    """How it stands to all others."""
    if plan.chosen is not None:
        yield f"It is chosen by {choice_in_words(plan, plan.chosen)}."
        return
    yield _ranked(ranking, best.rank)
    yield from _as_good(plan, best)


def _ranked(ranking: Ranking, rank: int) -> str:
    """How many ways there are, and what is known of their order."""
    ways = len(ranking.alternatives)
    if ways == 1:
        return "It is the only way there is." if ranking.status == "exact" else "It is the only way that was found."
    known = "their order is proven" if ranking.status == "exact" else "their order is not wholly proven"
    place = "the best" if rank == 1 else f"number {rank}, the best that has a schedule,"
    return f"It is {place} of {ways} alternatives; {known}."


def _as_good(plan: Plan, best: Schedule) -> Iterator[str]:
    """The shortest schedule among the alternatives of the same utility, if it is shorter than the best one's."""
    assert plan.ranking is not None
    utility = {alternative.rank: alternative.utility for alternative in plan.ranking.alternatives}
    equal = [one for one in plan.schedules if one.actions and utility.get(one.rank) == utility.get(best.rank)]
    shortest = min(equal, key=lambda one: (one.makespan_s, one.rank))
    if shortest.makespan_s < best.makespan_s:
        yield f"Alternative {shortest.rank} is of the same utility and takes {lasts(shortest.makespan_s)}."


@dataclass(frozen=True, slots=True)
class Fact:
    """
    A key figure.

    Parameters
    ----------
    name, value
        What it is, and how much.
    note
        What is known of it; empty if nothing is to be added.
    """

    name: str
    value: str
    note: str = ""


def facts(plan: Plan, rank: int) -> tuple[Fact, ...]:
    """Key figures of an alternative."""
    assert plan.ranking is not None
    alternative = plan.ranking.alternatives[rank - 1]
    schedule = next((one for one in plan.schedules if one.rank == rank), None)
    team = plan.brief.fleet.robots
    found = [Fact(plan.brief.aim.worth, number(alternative.utility), utility_note(plan, rank))]
    if schedule is not None and schedule.actions:
        busy = {assignment.robot for assignment in schedule.assignments}
        found = [
            Fact("makespan", lasts(schedule.makespan_s), makespan_note(schedule)),
            *found,
            Fact("robots", f"{len(busy)} of {len(team)}", _travel(schedule)),
        ]
    return tuple(found)


def utility_note(plan: Plan, rank: int) -> str:
    """How the utility stands to that of the neighbouring rank."""
    assert plan.ranking is not None
    alternatives = plan.ranking.alternatives
    own = alternatives[rank - 1].utility
    if rank > 1:
        behind = alternatives[0].utility - own
        return f"{number(behind)} below the best" if behind > 0 else "equal to the best"
    if len(alternatives) == 1:
        return "no other alternative" if plan.ranking.status == "exact" else ""
    ahead = own - alternatives[1].utility
    return f"{number(ahead)} above the next" if ahead > 0 else "the next is equal"


def makespan_note(schedule: Schedule) -> str:
    """What is known of the shortest makespan."""
    if schedule.status == "optimal":
        return f"none is shorter, by {schedule.certificate.method.replace('_', ' ')}"
    if by_word(schedule):
        return "optimal by the solver's word"
    bound = schedule.certificate.bound
    word = " by the solver's word" if schedule.certificate.claim == "solver_word" else ""
    return "" if bound is None else f"none is below {lasts(bound)}{word}"


def _travel(schedule: Schedule) -> str:
    metres = sum(leg.distance_m for leg in schedule.ways)
    return f"{number(round(metres, 1))} m of travel" if metres else ""
