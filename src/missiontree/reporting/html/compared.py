"""Alternatives side by side, as far as a page holds them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from missiontree.reporting.html.quantity import number
from missiontree.reporting.html.times import lasts
from missiontree.reporting.team.table import doers_in_words
from missiontree.reporting.team.view import Column, TeamView

MOST_COMPARED = 12
MOST_TASKS = 80


@dataclass(frozen=True, slots=True)
class Cell:
    """What an alternative comes to in some respect, or does about a task; and whether the first one does otherwise."""

    text: str
    other: bool = False


@dataclass(frozen=True, slots=True)
class Compared:
    """
    Alternatives side by side.

    Parameters
    ----------
    ranks
        Ranks, in order.
    rows
        What they come to: a name, and a cell per rank.
    tasks
        Tasks that are not done alike in all of them: a name, and a cell per rank.
    alike
        How many tasks are done alike in all of them.
    left_out
        How many tasks that differ are not listed.
    more
        How many alternatives there are beyond these.
    """

    ranks: tuple[int, ...]
    rows: tuple[tuple[str, tuple[Cell, ...]], ...]
    tasks: tuple[tuple[str, tuple[Cell, ...]], ...]
    alike: int
    left_out: int
    more: int


def compared(view: TeamView) -> Compared:
    """The first alternatives of a view, and the first tasks in which they differ."""
    columns = view.columns[:MOST_COMPARED]
    differing = [task for task in view.tasks if task.differs]
    return Compared(
        ranks=tuple(column.rank for column in columns),
        rows=tuple((name, tuple(cells)) for name, *cells in _rows(columns) if any(cell.text for cell in cells)),
        tasks=tuple(
            (task.label, tuple(Cell(doers_in_words(doers), doers.differs) for doers in task.doers[:MOST_COMPARED]))
            for task in differing[:MOST_TASKS]
        ),
        alike=len(view.tasks) - len(differing),
        left_out=max(0, len(differing) - MOST_TASKS),
        more=len(view.columns) - len(columns),
    )


def _rows(columns: tuple[Column, ...]) -> Iterator[tuple[str, *tuple[Cell, ...]]]:
    yield "utility", *(Cell(number(column.utility)) for column in columns)
    yield "makespan", *(Cell(lasts(column.makespan_s) if column.makespan_s is not None else "–") for column in columns)
    yield "robots", *(Cell(str(column.robots) if column.robots is not None else "") for column in columns)
    yield "travel", *(Cell(f"{number(round(column.travel_m, 1))} m" if column.travel_m else "") for column in columns)
    yield "known", *(Cell(column.known) for column in columns)
    yield "chosen", *(Cell("; ".join(column.choices)) for column in columns)
