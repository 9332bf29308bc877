"""Where everything in a Gantt chart stands: the scale of time, the rows, how closely they are packed, who is left out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from missiontree.reporting.gantt.content import Bar, Content, Row
from missiontree.reporting.gantt.time import exact
from missiontree.reporting.text_box import text_width

MARGIN = 16.0
MIN_BAR = 2.5
BOLD = 1.08
"""Bold words take so much more room."""
MAX_ROWS = 200
MAX_BARS = 2_000
_NARROW = (3.0, 6.0, 12.0, 24.0, 48.0, 96.0)
_GUTTER = (84.0, 225.0)


FOOT = 5.0
"""Height of the stripes at the foot of a move."""


class Density(NamedTuple):
    """
    How closely rows are packed.

    Parameters
    ----------
    most
        Rows it is for.
    caption, bar, under
        Heights of the line of roles, of the bars, and of the line of numbers and metres; 0 for none.
    pad
        Above and below.
    size, caption_size, name_size
        Font sizes of actions, roles and robots.
    notes
        Whether actions whose words do not fit are numbered, with a list below.
    """

    most: int
    caption: float
    bar: float
    under: float
    pad: float
    size: float
    caption_size: float
    name_size: float
    notes: bool


DENSITIES = (
    Density(14, 18.0, 31.0, 14.0, 6.0, 11.5, 11.0, 12.5, notes=True),
    Density(45, 14.0, 16.0, 0.0, 4.0, 10.0, 9.5, 11.0, notes=False),
    Density(MAX_ROWS, 0.0, 10.0, 0.0, 2.5, 8.5, 0.0, 9.0, notes=False),
)


@dataclass(frozen=True, slots=True)
class Scale:
    """Time to pixels: 0 at ``left``, the makespan at ``right``."""

    left: float
    right: float
    makespan_s: float

    def x(self, time_s: float) -> float:
        """Where a time stands."""
        return self.left + (self.right - self.left) * time_s / self.makespan_s

    def span(self, start_s: float, end_s: float) -> tuple[float, float]:
        """Left and right of a bar, which is never too thin to be seen."""
        left = self.x(start_s)
        return left, max(self.x(end_s), left + MIN_BAR)


class Place(NamedTuple):
    """Where a row stands: its top and bottom, and those of its bars."""

    top: float
    bar_top: float
    bar_bottom: float
    bottom: float

    @property
    def middle(self) -> float:
        """The height at which ways and waits are drawn."""
        return (self.bar_top + self.bar_bottom) / 2


class Shown(NamedTuple):
    """What is drawn of the rows: all of them mostly; and in words what is not."""

    rows: Sequence[Row]
    said: Sequence[str]


def density_of(rows: int) -> Density:
    """How closely so many rows are packed."""
    return next(density for density in DENSITIES if rows <= density.most)


def gutter_of(rows: Sequence[Row], density: Density) -> float:
    """Width of the column with the robots' names."""
    names = [text_width(row.robot, density.name_size) * BOLD for row in rows]
    if density.notes:
        names += [text_width(row.kind, 10.5) for row in rows]
    low, high = _GUTTER
    return min(high, max(low, *names)) + 20.0


def shown(content: Content, scale: Scale) -> Shown:
    """Rows that are drawn: at most so many, the busiest and those of the critical chain; actions too short to tell apart as one."""
    rows, said = list(content.rows), []
    if len(rows) > MAX_ROWS:
        chain = {step.robot for step in content.chain}
        ranked = sorted(
            range(len(rows)), key=lambda index: (rows[index].robot not in chain, -_busy(rows[index]), index)
        )
        kept = [rows[index] for index in sorted(ranked[:MAX_ROWS])]
        left = [rows[index] for index in ranked[MAX_ROWS:]]
        actions = sum(len(row.bars) for row in left)
        said.append(f"and {len(left):,} more robots with {actions:,} actions, the least busy ones, which are not drawn")
        rows = kept
    whole = rows
    for narrow in _NARROW:
        if sum(len(row.bars) for row in rows) <= MAX_BARS:
            break
        rows = [_merged(row, scale, narrow) for row in whole]
    if rows is not whole:
        said.append("actions too short to tell apart are drawn as one bar")
    return Shown(rows, said)


def places(rows: Sequence[Row], under: Sequence[bool], top: float, density: Density) -> list[Place]:
    """Where the rows stand, one below the other; ``under`` says which of them need the line below the bars."""
    found = []
    for _, needed in zip(rows, under, strict=True):
        bar_top = top + density.pad + density.caption
        bar_bottom = bar_top + density.bar
        bottom = bar_bottom + (density.under if needed else 0.0) + density.pad
        found.append(Place(top, bar_top, bar_bottom, bottom))
        top = bottom
    return found


def _busy(row: Row) -> float:
    return sum(bar.end_s - bar.start_s for bar in row.bars)


def _merged(row: Row, scale: Scale, narrow: float) -> Row:
    """The row with runs of narrow bars drawn as one each."""
    bars: list[Bar] = []
    run: list[Bar] = []
    for bar in (*row.bars, None):
        left, right = scale.span(bar.start_s, bar.end_s) if bar is not None else (0.0, narrow)
        if bar is not None and right - left < narrow and (not run or left - scale.x(run[-1].end_s) < narrow):
            run.append(bar)
            continue
        bars += [_one(run)] if run else []
        run = [bar] if bar is not None and right - left < narrow else []
        bars += [bar] if bar is not None and not run else []
    return replace(row, bars=bars)


def _one(run: Sequence[Bar]) -> Bar:
    if len(run) == 1:
        return run[0]
    start, end = run[0].start_s, max(bar.end_s for bar in run)
    label = f"{len(run)} actions"
    first = "\n".join(bar.label for bar in run[:8]) + (f"\nand {len(run) - 8} more" if len(run) > 8 else "")
    title = f"{label}, {exact(start)} to {exact(end)}\n{first}"
    lit, moves = any(bar.lit for bar in run), all(bar.moves for bar in run)
    return Bar(run[0].leaf, start, end, label, "", moves, lit, title, len(run))
