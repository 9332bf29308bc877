"""Who does what when, robot by robot: a bar for the eye and a list for the hand."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from typing import NamedTuple

from rich.console import Group
from rich.table import Table
from rich.text import Text

from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule, TravelLeg
from missiontree.reporting.escape import one_line

BAR_WIDTH = 48
MAX_ROWS = 200


class Row(NamedTuple):
    """A stretch of a robot's time."""

    robot: str
    start_s: float
    end_s: float
    text: str
    moving: bool


def timeline(schedule: Schedule, plan: Plan) -> Group:
    """The bars of all robots on one scale, then each robot's list."""
    rows = sorted(timeline_rows(schedule, plan), key=lambda row: (row.robot, row.start_s, row.end_s))
    by_robot = {robot: list(own) for robot, own in groupby(rows, key=lambda row: row.robot)}
    return Group(_bars(by_robot, schedule.makespan_s), Text(""), _lists(by_robot))


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
        yield Row(action.robot, action.start_s, action.end_s, text, action.leaf in moves)
    for leg in schedule.legs:
        if leg.leaf not in moves and leg.distance_m > 0:
            yield Row(leg.robot, leg.start_s, leg.end_s, f"travel {_way(leg)}", True)


def _way(leg: TravelLeg) -> str:
    """How far, and by which nodes of the road graph."""
    return f"{leg.distance_m:.1f} m" + (f" via {', '.join(leg.via)}" if leg.via else "")


def _bars(by_robot: dict[str, list[Row]], makespan_s: float) -> Table:
    table = Table.grid(padding=(0, 2, 0, 0))
    for robot, rows in by_robot.items():
        cells = [" "] * BAR_WIDTH
        for row in rows:
            first = int(row.start_s / makespan_s * BAR_WIDTH) if makespan_s else 0
            last = max(first + 1, round(row.end_s / makespan_s * BAR_WIDTH)) if makespan_s else 1
            cells[first:last] = ("─" if row.moving else "█") * (min(last, BAR_WIDTH) - first)
        table.add_row(Text(one_line(robot), style="cyan"), Text("".join(cells[:BAR_WIDTH]), style="green"))
    scale = f"{makespan_s:.0f} s"
    table.add_row("", Text(f"0{scale:>{BAR_WIDTH - 1}}", style="dim"))
    return table


def _lists(by_robot: dict[str, list[Row]]) -> Table:
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column()
    table.add_column(justify="right", no_wrap=True)
    table.add_column(justify="right", no_wrap=True)
    table.add_column()
    shown = 0
    for robot, rows in by_robot.items():
        for index, row in enumerate(rows):
            if shown == MAX_ROWS:
                left = sum(len(own) for own in by_robot.values()) - shown
                table.add_row("", "", "", Text(f"… and {left} more rows; --json has them all", style="dim"))
                return table
            shown += 1
            name = Text(one_line(robot) if index == 0 else "", style="cyan")
            start, end = Text(f"{row.start_s:.1f}"), Text(f"{row.end_s:.1f} s")
            table.add_row(name, start, end, Text(one_line(row.text), style="dim" if row.moving else ""))
    return table
