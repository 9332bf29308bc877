"""Why a schedule is as long as it is, and which robot would shorten it, on the screen or as JSON."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from missiontree.cli.interrupt import controlled
from missiontree.cli.screen import show

if TYPE_CHECKING:
    from missiontree.mission.plan import Plan


def show_length(plan: Plan, rank: int, time_limit_s: float, as_json: bool, colour: bool | None) -> None:
    """
    Print the answer.

    Parameters
    ----------
    plan, rank
        An alternative that has a schedule.
    time_limit_s
        Seconds that scheduling it anew may take.
    as_json, colour
        As the other commands take them.

    Raises
    ------
    InputError
        If the plan points at nodes or roles that it does not hold, or the time limit is none.
    """
    from missiontree.explaining.shortening import why_so_long
    from missiontree.formats.document import write_text
    from missiontree.reporting.critical.view import why_view
    from missiontree.reporting.references import refuse_dangling

    refuse_dangling(plan)
    with controlled(time_limit_s, plan.provenance.seed) as control:
        why = why_so_long(plan, rank, control)
    if as_json:
        typer.echo(write_text(why, "why_so_long"), nl=False)
    else:
        schedule = next(one for one in plan.schedules if one.rank == rank)
        show(why_view(why, plan, schedule), colour)
