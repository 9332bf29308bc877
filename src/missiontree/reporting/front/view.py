"""The front in a terminal."""

from __future__ import annotations

from rich.table import Table
from rich.text import Text

from missiontree.mission.plan import Plan
from missiontree.reporting.escape import one_line
from missiontree.reporting.front.rows import rows_of
from missiontree.reporting.gantt.time import in_words


def front_table(plan: Plan) -> Table:
    """A row per option."""
    table = Table(box=None, padding=(0, 2, 0, 0), header_style="dim")
    for name in ("#", plan.brief.aim.worth, "makespan", "team", "listed as", "known"):
        right = name in {"#", plan.brief.aim.worth, "makespan"}
        table.add_column(name, justify="right" if right else "left", no_wrap=name != "team")
    for row in rows_of(plan):
        table.add_row(
            str(row.number),
            row.utility,
            in_words(row.makespan_s),
            Text("\n".join(one_line(line) for line in row.team)),
            "-" if row.listed is None else f"alternative {row.listed}",
            f"{row.known}\nchosen" if row.chosen else row.known,
        )
    return table
