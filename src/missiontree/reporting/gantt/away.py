"""When a robot takes no part: before it comes and after it has left."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from missiontree.mission.fleet import Fleet
from missiontree.reporting.escape import xml_safe
from missiontree.reporting.gantt.content import Row, Stretch
from missiontree.reporting.gantt.layout import Place, Scale
from missiontree.reporting.gantt.time import exact
from missiontree.reporting.palette import QUIET
from missiontree.reporting.svg_numbers import n


def away_of(fleet: Fleet, robot: str, makespan_s: float) -> list[Stretch]:
    """Before a robot comes and after it leaves, as far as the chart goes."""
    kind = fleet.type_of.get(robot)
    if kind is None:
        return []
    since_s, until_s = kind.availability(fleet.robots[robot])
    found = []
    if since_s:
        found.append(
            Stretch(0.0, min(since_s, makespan_s), "not here yet", f"{robot} takes part from {exact(since_s)} on")
        )
    if until_s is not None and until_s < makespan_s:
        found.append(Stretch(until_s, makespan_s, "left", f"{robot} takes part until {exact(until_s)}"))
    return found


def away_pattern(rows: Sequence[Row], prefix: str) -> Iterator[str]:
    """The pattern of times in which a robot is away, if there are such."""
    if any(row.away for row in rows):
        yield (
            f'<pattern id="{prefix}-away" width="9" height="9" patternUnits="userSpaceOnUse">'
            f'<path class="mt-away mt-line" d="M-2 2 L2 -2 M0 9 L9 0 M7 11 L11 7" fill="none" stroke="{QUIET}" stroke-width="1"/>'
            "</pattern>"
        )


def hatched(row: Row, scale: Scale, place: Place, prefix: str) -> Iterator[str]:
    """The times in which the robot of a row is away, hatched over the whole height of the row."""
    for away in row.away:
        left, right = scale.x(away.start_s), scale.x(away.end_s)
        if right > left:
            yield (
                f'<rect x="{n(left)}" y="{n(place.top + 1)}" width="{n(right - left)}" height="{n(place.bottom - place.top - 2)}" '
                f'fill="url(#{prefix}-away)"><title>{xml_safe(away.title)}</title></rect>'
            )


def away_sign(prefix: str) -> str:
    """The sign for the legend."""
    return f'<rect x="1" y="2" width="28" height="12" fill="url(#{prefix}-away)" stroke="{QUIET}" stroke-width="0.8"/>'
