"""The alternatives side by side in a terminal; below one another where it is narrow."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from rich.console import Console, ConsoleOptions, RenderableType
from rich.table import Table
from rich.text import Text

from missiontree.mission.plan import Plan
from missiontree.reporting.maps.legend import metres_walked
from missiontree.reporting.team.limits import LimitUse
from missiontree.reporting.team.view import Column, Doers, Task, TeamView, team_view
from missiontree.reporting.text import seconds

MOST_COLUMNS = 6
MOST_TASKS = 60
MOST_LIMITS = 4
LEAST_COLUMN = 18
DIFFERS = "≠"


def team_table(plan: Plan) -> RenderableType | None:
    """
    The alternatives of a plan side by side, for a terminal of any width; None if it has none.

    What is done otherwise than in the first alternative is marked. Of many tasks only those that differ are listed, and the rest is
    counted.
    """
    view = team_view(plan)
    return None if view is None else TeamTable(view)


@dataclass(frozen=True, slots=True)
class TeamTable:
    """
    A view of alternatives that takes the form for which there is room.

    Parameters
    ----------
    view
        What is shown.
    """

    view: TeamView

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> Iterator[RenderableType]:
        """Side by side if every alternative gets a readable column, else one after the other."""
        columns = self.view.columns[:MOST_COLUMNS]
        beside = options.max_width >= LEAST_COLUMN * (len(columns) + 1)
        yield _beside(self.view, columns) if beside else _below(self.view, columns)
        if len(self.view.columns) > len(columns):
            yield Text(f"and {len(self.view.columns) - len(columns)} alternatives more", style="dim")
        if any(task.differs for task in self.view.tasks):
            yield Text(f"{DIFFERS} otherwise than in alternative {columns[0].rank}", style="dim")


def _beside(view: TeamView, columns: Sequence[Column]) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0), header_style="bold")
    table.add_column("", style="dim", overflow="fold")
    for column in columns:
        table.add_column(f"alternative {column.rank}", overflow="fold")
    for name, texts in _rows(columns):
        table.add_row(name, *texts)
    listed = _listed(view)
    for task in listed:
        table.add_row(Text(task.label), *(_cell(task.doers[place]) for place in range(len(columns))))
    if len(listed) < len(view.tasks):
        table.add_row(f"and {len(view.tasks) - len(listed)} tasks more", *[""] * len(columns))
    return table


def _below(view: TeamView, columns: Sequence[Column]) -> Table:
    table = Table.grid(padding=(0, 1, 0, 0))
    table.add_column(style="dim", overflow="fold")
    table.add_column(overflow="fold")
    listed = _listed(view)
    for place, column in enumerate(columns):
        if place:
            table.add_row("", "")
        table.add_row(Text(f"alternative {column.rank}", style="bold"), "")
        for name, texts in _rows(columns):
            if texts[place].plain:
                table.add_row(name, texts[place])
        for task in listed if place == 0 else [task for task in listed if task.doers[place].differs]:
            table.add_row(Text(task.label), _cell(task.doers[place]))
        if place and not any(task.doers[place].differs for task in view.tasks):
            table.add_row("", Text(f"who does what as in {columns[0].rank}", style="dim"))
    return table


def _listed(view: TeamView) -> list[Task]:
    """All tasks, or of many those that differ."""
    if len(view.tasks) <= MOST_TASKS:
        return list(view.tasks)
    return [task for task in view.tasks if task.differs][:MOST_TASKS]


def _rows(columns: Sequence[Column]) -> Iterator[tuple[str, list[Text]]]:
    """What alternatives come to, a row for each thing that any of them has."""
    rows = {
        "utility": [_utility(column) for column in columns],
        "makespan": [seconds(column.makespan_s) if column.makespan_s is not None else "-" for column in columns],
        "known": [column.known for column in columns],
        "robots": [str(column.robots) if column.robots is not None else "" for column in columns],
        "travel": [metres_walked(column.travel_m) if column.travel_m else "" for column in columns],
        "chosen": ["\n".join(column.choices) for column in columns],
        "limits": ["\n".join(_limits(column.limits)) for column in columns],
    }
    for name, texts in rows.items():
        if any(texts):
            yield name, [Text(text) for text in texts]


def _utility(column: Column) -> str:
    words = f"{column.utility:g}"
    if column.tied:
        words += f", tied with {', '.join(map(str, column.tied))}"
    return words if not column.behind else f"{words}, {column.behind:g} less"


def _limits(limits: Sequence[LimitUse]) -> Iterator[str]:
    """The limits that are nearest to being used up."""
    for limit in sorted(limits, key=lambda one: -one.share)[:MOST_LIMITS]:
        lead = "at least " if limit.at_least else ""
        yield f"{limit.who}: {limit.name} {lead}{limit.used:,.6g} of {limit.allowed:,.6g}"
    if len(limits) > MOST_LIMITS:
        yield f"and {len(limits) - MOST_LIMITS} more"


def _cell(doers: Doers) -> Text:
    words = doers_in_words(doers)
    return Text(f"{DIFFERS} {words}", style="bold") if doers.differs else Text(words)


def doers_in_words(doers: Doers) -> str:
    """Who does a task, by which way, with which robots: ``2 × Scout: scout-1, scout-2 (carry)``; a dash if nobody does it."""
    if not doers.types:
        return "–"
    counts = {name: doers.types.count(name) for name in doers.types}
    words = ", ".join(name if count == 1 else f"{count} × {name}" for name, count in counts.items())
    if doers.robots:
        words += f": {', '.join(dict.fromkeys(doers.robots))}"
    return f"{words} ({doers.way})" if doers.way else words
