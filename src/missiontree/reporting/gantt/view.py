"""Who does what when, as a picture: a Gantt chart with robots as rows, in SVG."""

from __future__ import annotations

from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.gantt import axis, shared
from missiontree.reporting.gantt.content import Bar, Content, Row
from missiontree.reporting.gantt.labels import MAX_NOTES, Letterer
from missiontree.reporting.gantt.layout import MARGIN, MAX_ROWS, Scale, density_of, gutter_of, shown
from missiontree.reporting.gantt.page import Chart
from missiontree.reporting.gantt.reading import content_of
from missiontree.reporting.gantt.words import without_schedule
from missiontree.reporting.references import refuse_dangling

MIN_WIDTH = 480.0


def gantt_svg(plan: Plan, rank: int, *, width: float = 1100.0) -> str:
    """
    The schedule of an alternative as a picture.

    Robots are rows, in the order of the fleet. A role is a soft band, an action a bar in the hue of its robot, a way is striped,
    waiting is dotted and says for what. Joint work is joined across rows; arrows tell what comes first where robots differ, on
    one row that is left to right. Shared resources stand below the robots, with who holds them when. The critical chain is
    outlined and marked. Every bar carries its exact times as a title. Equal plans give equal bytes. Beyond 200 robots or 2,000
    actions the picture sums up, and says so.

    Parameters
    ----------
    plan
        A plan, delivered or not.
    rank
        Rank of the alternative. If it has no schedule, the picture says why in words.
    width
        Width of the picture in pixels, at least 480, default 1100.

    Raises
    ------
    InputError
        If the plan points at nodes or roles that it does not hold.
    """
    refuse_dangling(plan)
    wide, prefix = max(width, MIN_WIDTH), f"mt-gantt-{rank}"
    schedule = next((one for one in plan.schedules if one.rank == rank), None)
    if schedule is None or not any(one.end_s for one in schedule.actions):
        return without_schedule(plan, rank, schedule, wide, prefix)
    chart = _chart(plan, schedule, wide, prefix)
    return "\n".join(chart.lines()) + "\n"


def _chart(plan: Plan, schedule: Schedule, width: float, prefix: str) -> Chart:
    content = content_of(plan, schedule)
    density = density_of(min(len(content.rows), MAX_ROWS))
    left = MARGIN + max(gutter_of(content.rows, density), shared.gutter_of(content.shared))
    right = width - MARGIN - axis.end_width(content.makespan_s) / 2
    scale = Scale(left, right, content.makespan_s)
    drawn = shown(content, scale)
    letterer = Letterer(scale, density)
    goals = [_goals(row, content, scale) for row in drawn.rows]
    lettered = [letterer.lettered(row, own) for row, own in zip(drawn.rows, goals, strict=True)]
    unfit = [(at, index) for at, one in enumerate(lettered) for index in one.unfit] if density.notes else []
    longest = sorted(unfit, key=lambda one: _weight(drawn.rows[one[0]].bars[one[1]]))[:MAX_NOTES]
    numbers = {one: number for number, one in enumerate(sorted(longest), start=1)}
    words = []
    for at, (row, one) in enumerate(zip(drawn.rows, lettered, strict=True)):
        own = {index: number for (where, index), number in numbers.items() if where == at}
        words.append([*one.words, *(letterer.numbered(row, own, goals[at]) if density.notes else ())])
    said = [*drawn.said, *shared.words_for(content.shared)]
    if len(unfit) > len(longest):
        said.append(
            f"{len(unfit) - len(longest):,} shorter actions have no number; every bar tells its words as a tooltip"
        )
    if not density.notes:
        said.append("words are left out where they do not fit; every bar tells its own as a tooltip")
    numbered = [(number, drawn.rows[at].bars[index]) for (at, index), number in numbers.items()]
    return Chart(plan, schedule, content, drawn.rows, words, numbered, said, scale, density, width, prefix)


def _goals(row: Row, content: Content, scale: Scale) -> list[float]:
    """Where arrows may end in a row, coming from the left."""
    held = {order.second for order in content.orders if not order.to_end}
    return [scale.x(bar.start_s) for bar in row.bars if bar.leaf in held]


def _weight(bar: Bar) -> tuple[bool, float]:
    """How much a bar asks for a number: first those of the critical chain, then the longest."""
    return not bar.lit, bar.start_s - bar.end_s
