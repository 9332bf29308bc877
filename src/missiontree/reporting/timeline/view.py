"""Who does what when, robot by robot: bars for the eye and a list for the hand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from rich.console import Console, ConsoleOptions, RenderResult
from rich.table import Table
from rich.text import Text

from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Leg, Schedule
from missiontree.reporting.escape import one_line
from missiontree.reporting.gantt.content import Content
from missiontree.reporting.gantt.content import Row as Shown
from missiontree.reporting.gantt.reading import content_of
from missiontree.reporting.timeline.bars import bars, signs
from missiontree.reporting.visits import visits_of

MAX_ROWS = 200
CRITICAL = "◆"


class Row(NamedTuple):
    """A stretch of a robot's time; ``travel`` is whatever is no action."""

    robot: str
    start_s: float
    end_s: float
    text: str
    moving: bool
    leaf: int = -1
    travel: bool = False


class Timeline:
    """
    The bars of all robots on one scale, then each robot's list, as wide as the terminal has room.

    Parameters
    ----------
    schedule
        A schedule.
    plan
        The plan that it belongs to.
    """

    def __init__(self, schedule: Schedule, plan: Plan) -> None:
        self._rows = list(timeline_rows(schedule, plan))
        self._content = content_of(plan, schedule) if schedule.actions else None

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """Bars, list, and what the signs mean."""
        if self._content is None:
            return
        yield bars(self._content, options.max_width)
        yield Text("")
        yield _lists(self._content, self._rows)
        yield Text("")
        yield Text(signs(self._content, CRITICAL), style="dim")


def timeline(schedule: Schedule, plan: Plan) -> Timeline:
    """The bars of all robots on one scale, then each robot's list."""
    return Timeline(schedule, plan)


def timeline_rows(schedule: Schedule, plan: Plan) -> Iterator[Row]:
    """Actions, and the travel that is not an action of its own."""
    assert plan.grounding is not None
    tree = plan.grounding.tree
    moves = {action.leaf for action in schedule.actions if tree.action(action.leaf).moves}
    ways = {(leg.robot, leg.leaf): leg for leg in schedule.legs}
    for action in schedule.actions:
        text = tree.action(action.leaf).text
        if action.leaf in moves and (action.robot, action.leaf) in ways:
            leg = ways[action.robot, action.leaf]
            text += f" ({_way(leg)})" if leg.distance_m or leg.end_s > leg.start_s else " (already there)"
        yield Row(action.robot, action.start_s, action.end_s, text, action.leaf in moves, action.leaf)
    for leg in schedule.legs:
        if leg.leaf not in moves and (leg.distance_m > 0 or leg.end_s > leg.start_s):
            yield Row(leg.robot, leg.start_s, leg.end_s, f"travel {_way(leg)}", moving=True, leaf=leg.leaf, travel=True)
    for visits in visits_of(plan, schedule).values():
        for visit in visits:
            one = visit.recharge
            if one.leg is not None:
                text = f"travel to {visit.label}, {_way(one.leg)}"
                yield Row(one.robot, one.leg.start_s, one.leg.end_s, text, moving=True, travel=True)
            yield Row(one.robot, one.start_s, one.end_s, f"{visit.text} ({visit.levels})", moving=False, travel=True)
    for home in schedule.returns:
        yield Row(home.robot, home.start_s, home.end_s, f"travel home {_way(home)}", moving=True, travel=True)


def _way(leg: Leg) -> str:
    """How far, and by which nodes of the road graph."""
    return f"{leg.distance_m:.1f} m" + (f" via {', '.join(leg.via)}" if leg.via else "")


class _Line(NamedTuple):
    """A line of a robot's list."""

    start_s: float
    end_s: float
    text: str
    quiet: bool
    lit: bool


def _lists(content: Content, rows: list[Row]) -> Table:
    own: dict[str, list[Row]] = {}
    for row in rows:
        own.setdefault(row.robot, []).append(row)
    mates = _mates(content)
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column()
    table.add_column(width=1)
    table.add_column(justify="right", no_wrap=True)
    table.add_column(justify="right", no_wrap=True)
    table.add_column()
    lines = [
        (shown.robot, list(_lines(shown, own.get(shown.robot, []), mates, _beside(content)))) for shown in content.rows
    ]
    told = 0
    for robot, of_robot in lines:
        for index, line in enumerate(of_robot):
            if told == MAX_ROWS:
                left = sum(len(each) for _, each in lines) - told
                table.add_row("", "", "", "", Text(f"… and {left} more rows; --json has them all", style="dim"))
                return table
            told += 1
            table.add_row(
                Text(one_line(robot) if index == 0 else "", style="cyan"),
                Text(CRITICAL if line.lit else "", style="red"),
                Text(f"{line.start_s:.1f}"),
                Text(f"{line.end_s:.1f} s"),
                Text(one_line(line.text), style="dim" if line.quiet else ""),
            )
    return table


def _lines(shown: Shown, rows: list[Row], mates: dict[int, str], more: Mapping[int, str]) -> Iterator[_Line]:
    """What a robot does, travels and waits for, in order of time."""
    lit = {bar.leaf for bar in shown.bars if bar.lit}
    lit_ways = {(way.start_s, way.end_s) for way in (*shown.ways, *shown.refills) if way.lit}
    found = []
    for row in rows:
        bright = (row.start_s, row.end_s) in lit_ways if row.travel else row.leaf in lit
        beside = f", with {mates[row.leaf]}" if row.leaf in mates and not row.travel else ""
        beside += f", {more[row.leaf]}" if row.leaf in more and not row.travel else ""
        found.append(_Line(row.start_s, row.end_s, row.text + beside, row.moving, bright))
    found += [
        _Line(wait.start_s, wait.end_s, f"wait {wait.label}".rstrip(), quiet=True, lit=False) for wait in shown.waits
    ]
    found += [_Line(away.start_s, away.end_s, away.label, quiet=True, lit=False) for away in shown.away]
    yield from sorted(found, key=lambda line: (line.start_s, line.end_s))


def _beside(content: Content) -> dict[int, str]:
    """What else is told of an action: to whom it hands over, its release time, the deadline that it keeps."""
    leaves = dict.fromkeys([*content.handing, *content.times])
    told = {leaf: (content.handing.get(leaf, ""), content.times.get(leaf, "")) for leaf in leaves}
    return {leaf: ", ".join(filter(None, words)) for leaf, words in told.items()}


def _mates(content: Content) -> dict[int, str]:
    """For each action of joint work, the other robots in it."""
    who = {bar.leaf: row.robot for row in content.rows for bar in row.bars}
    return {
        leaf: ", ".join(who[mate] for mate in leaves if mate != leaf and mate in who)
        for leaves in content.joint
        for leaf in leaves
    }
