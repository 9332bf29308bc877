"""Why a schedule takes as long as it does, for the page: the parts of its critical chain."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.called import called
from missiontree.reporting.critical.chain import chain_of
from missiontree.reporting.critical.parts import parts_of
from missiontree.reporting.critical.view import both_ends, more_of, title_of
from missiontree.reporting.html.times import between

MOST_PARTS = 12


@dataclass(frozen=True, slots=True)
class Length:
    """
    The parts of a chain.

    Parameters
    ----------
    title
        What the time goes into.
    parts
        When, who, what, and what it waits for; of a long chain those at both ends.
    more
        How many parts are not listed.
    """

    title: str
    parts: tuple[tuple[str, str, str, str], ...]
    more: int


def length(plan: Plan, schedule: Schedule) -> Length | None:
    """Why a schedule with actions takes so long; None if nothing takes time."""
    parts = parts_of(plan, schedule)
    if not parts:
        return None
    told = [part for part in both_ends(parts, MOST_PARTS) if part is not None]
    rows = tuple(
        (between(part.start_s, part.end_s, schedule.makespan_s), part.robot, part.what, more_of(part)) for part in told
    )
    return Length(title_of(chain_of(plan, schedule), called(plan, schedule.rank)), rows, len(parts) - len(told))
