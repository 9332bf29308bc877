"""An alternative with everything that the page shows of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from missiontree.mission.alternative import Alternative
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.html.crew import Crew, crew
from missiontree.reporting.html.facts import Fact, facts
from missiontree.reporting.html.length import Length, length
from missiontree.reporting.html.pictures import Drawn, drawn
from missiontree.reporting.html.remarks import Remarks, remarks
from missiontree.reporting.html.thresholds import thresholds
from missiontree.reporting.html.times import lasts
from missiontree.reporting.html.timetable import Timetable, timetable
from missiontree.reporting.html.used import Used, spent
from missiontree.reporting.team.limits import limits_of
from missiontree.reporting.tree.view import tree_text

MOST_WAYS = 8
MOST_BYTES = 1_000_000
MOST_BRANCHES = 100_000
"""Characters that trees over the fleet may take; beyond, only that of the alternative that is shown at first stands on the page."""
MOST_OUTLINED = 300


@dataclass(frozen=True, slots=True)
class Way:
    """
    An alternative that can be chosen.

    Parameters
    ----------
    rank
        Its rank.
    short
        What it comes to, in a few words, for the switch.
    facts
        Its key figures.
    crew
        Who does what, and who is not needed.
    pictures
        Tree, chart and map.
    outline
        The tree in words; empty if it is too long.
    timetable
        None without a schedule.
    limits
        Limits used against allowed.
    unscheduled
        Why there is no schedule; empty if there is one.
    length
        Why the schedule takes as long as it does; None without a schedule, or if nothing takes time.
    """

    rank: int
    short: str
    facts: tuple[Fact, ...]
    crew: Crew
    pictures: Drawn
    outline: str
    timetable: Timetable | None
    limits: tuple[Used, ...]
    unscheduled: Remarks
    length: Length | None = None


def ways(plan: Plan, first: int) -> tuple[Way, ...]:
    """
    The alternatives that can be chosen on the page, in rank order.

    Parameters
    ----------
    plan
        A plan with alternatives.
    first
        Rank of the alternative that is shown at first; it is there in any case. Others follow by rank, up to eight in all and while
        their pictures keep the page small.
    """
    assert plan.ranking is not None
    order = sorted(plan.ranking.alternatives, key=lambda one: (one.rank != first, one.rank))
    found: list[Way] = []
    left = MOST_BYTES
    for alternative in order[:MOST_WAYS]:
        if found and found[-1].pictures.size > left:  # the next one will be about as large
            break
        found.append(_way(plan, alternative))
        left -= found[-1].pictures.size
    branches = [way.pictures.branches for way in found if way.pictures.branches is not None]
    if sum(len(picture.svg) for picture in branches) > MOST_BRANCHES:
        found[1:] = [replace(way, pictures=replace(way.pictures, branches=None)) for way in found[1:]]
    return tuple(sorted(found, key=lambda way: way.rank))


def _way(plan: Plan, alternative: Alternative) -> Way:
    schedule = next((one for one in plan.schedules if one.rank == alternative.rank), None)
    works = schedule is not None and bool(schedule.actions)
    return Way(
        rank=alternative.rank,
        short=lasts(schedule.makespan_s) if schedule is not None and works else "no schedule",
        facts=facts(plan, alternative.rank),
        crew=crew(plan, alternative, schedule),
        pictures=drawn(plan, alternative.rank),
        outline=outline(plan, alternative.rank),
        timetable=timetable(plan, schedule) if schedule is not None and works else None,
        limits=tuple(_limits(plan, alternative, schedule)) if schedule is not None and works else (),
        unscheduled=remarks(schedule.reasons if schedule is not None and not works else ()),
        length=length(plan, schedule) if schedule is not None and works else None,
    )


def outline(plan: Plan, rank: int | None = None) -> str:
    """The plan's tree in words, with who does what in an alternative; empty if it is too long for a page, or there is none."""
    tree = plan.tree if plan.tree is not None else plan.grounding.tree if plan.grounding is not None else None
    if tree is None or len(tree.nodes) > MOST_OUTLINED:
        return ""
    return tree_text(tree, plan=plan if rank is not None else None, rank=rank)


def _limits(plan: Plan, alternative: Alternative, schedule: Schedule) -> Iterator[Used]:
    yield from map(spent, limits_of(plan, alternative, schedule))
    if plan.tree is not None:
        yield from thresholds(plan, alternative, schedule)
