"""Shared resources in a Gantt chart: below the robots a row for each, and in it who holds it when."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from missiontree.mission.grounded import GroundedTree
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.reporting.critical.spans import ms
from missiontree.reporting.escape import one_line, xml_safe
from missiontree.reporting.gantt.content import Hold, SharedRow
from missiontree.reporting.gantt.layout import BOLD, MARGIN, Scale
from missiontree.reporting.gantt.time import exact
from missiontree.reporting.palette import MUTED, Livery
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import middle_cut, text
from missiontree.reporting.text_box import text_width

LANE = 16.0
PAD = 6.0
NAME, SIZE = 11.5, 10.0
MAX_LANES = 8
MAX_SHARED = 40


def shared_rows(tree: GroundedTree, schedule: Schedule, scene: Scene, looks: Mapping[str, Livery]) -> list[SharedRow]:
    """A row for each resource that something holds, in the order of the scene."""
    rows = []
    for resource in scene.resources:
        free: list[int] = []  # by lane
        holds: list[Hold] = []
        for start_s, end_s, robot, what in sorted(_held(tree, schedule, scene, resource.id)):
            lane = next((lane for lane, until in enumerate(free) if until <= ms(start_s)), len(free))
            free[lane : lane + 1] = [ms(end_s)]
            times = f"{exact(start_s)} to {exact(end_s)} ({exact(end_s - start_s)})"
            title = f"{robot} holds {one_line(resource.label)}\n{what}\n{times}"
            holds.append(Hold(start_s, end_s, robot, looks.get(robot, Livery(0)), lane, title))
        if holds:
            rows.append(SharedRow(one_line(resource.label), resource.capacity, len(free), holds))
    return rows


def _held(
    tree: GroundedTree, schedule: Schedule, scene: Scene, resource: str
) -> Iterator[tuple[float, float, str, str]]:
    """From when to when, by whom, and for what: actions that name it, and ways along roads and by lifts that do."""
    for one in schedule.actions:
        if resource in tree.action(one.leaf).holds:
            yield one.start_s, one.end_s, one.robot, one_line(tree.action(one.leaf).text)
    for leg in schedule.legs:
        action = tree.action(leg.leaf)
        if resource in scene.passed(leg.via) and not (action.moves and resource in action.holds):
            text = one_line(action.text)
            yield leg.start_s, leg.end_s, leg.robot, text if action.moves else f"on the way to: {text}"
    for home in schedule.returns:
        if resource in scene.passed(home.via):
            yield home.start_s, home.end_s, home.robot, "on the way home"


def height_of(row: SharedRow) -> float:
    """How high a row is."""
    return max(34.0, min(row.lanes, MAX_LANES) * LANE + 2 * PAD)


def gutter_of(rows: Sequence[SharedRow]) -> float:
    """Width of the column that the names of resources need; as wide as that of long robots' names at most."""
    names = [max(text_width(row.name, NAME) * BOLD, text_width(_kind(row), SIZE)) for row in drawn(rows)]
    return min(225.0, max(names, default=0.0)) + 20.0 if names else 0.0


def _kind(row: SharedRow) -> str:
    return f"shared, room for {row.capacity}"


def drawn(rows: Sequence[SharedRow]) -> Sequence[SharedRow]:
    """Rows that are drawn: the first few."""
    return rows[:MAX_SHARED]


def words_for(rows: Sequence[SharedRow]) -> list[str]:
    """What is left out, in words."""
    said = []
    if len(rows) > MAX_SHARED:
        said.append(f"and {len(rows) - MAX_SHARED} more shared resources, which are not drawn")
    if any(row.lanes > MAX_LANES for row in drawn(rows)):
        said.append(f"of a shared resource no more than {MAX_LANES} robots are drawn at a time")
    return said


def lines(rows: Sequence[SharedRow], scale: Scale, top: float, prefix: str, name_size: float) -> Iterator[str]:
    """The rows, one below the other."""
    for row in rows:
        height = height_of(row)
        middle, room = top + height / 2, scale.left - MARGIN - 19.5
        yield '<g class="mt-shared">'
        yield text(
            MARGIN + 11,
            middle - 2.5,
            middle_cut(row.name, min(NAME, name_size) * BOLD, room),
            size=min(NAME, name_size),
            bold=True,
        )
        kind = middle_cut(_kind(row), SIZE, room)
        yield text(MARGIN + 11, middle + 11, kind, size=SIZE, kind="mt-muted", fill=MUTED)
        first = middle - min(row.lanes, MAX_LANES) * LANE / 2
        for hold in row.holds:
            if hold.lane < MAX_LANES:
                yield from _hold(hold, scale, first + hold.lane * LANE, prefix)
        yield "</g>"
        top += height


def _hold(hold: Hold, scale: Scale, top: float, prefix: str) -> Iterator[str]:
    left, right = scale.span(hold.start_s, hold.end_s)
    hue = hold.livery.hue
    yield (
        f'<g class="mt-hue-{hold.livery.number}"><rect class="mt-fill" x="{n(left)}" y="{n(top + 1)}" width="{n(right - left)}" '
        f'height="{n(LANE - 2)}" rx="2" fill="{hold.livery.paint(prefix)}" stroke="{hue.deep}"><title>{xml_safe(hold.title)}</title></rect>'
    )
    if text_width(hold.robot, SIZE) + 6 <= right - left:
        ring = hue.fill if hold.livery.hatch else ""
        middle = (left + right) / 2
        yield text(
            middle, top + LANE / 2 + 3.6, hold.robot, size=SIZE, fill=hue.on, kind="mt-on", anchor="middle", halo=ring
        )
    yield "</g>"
