"""A schedule as bars of characters, on one scale, with an axis."""

from __future__ import annotations

from collections.abc import Iterator

from rich.table import Table
from rich.text import Text

from missiontree.reporting.escape import one_line
from missiontree.reporting.gantt.content import Content, Row, SharedRow
from missiontree.reporting.gantt.time import in_words, ticks

WORK = "█▓"
"""Two shades, in turn, so that two actions in a row can be told apart."""
MOVE = "═"
WAY, WAIT, AWAY, REFILL = "─", "·", "╱", "+"
HELD = "▒░"
"""The same for who holds a shared resource."""
MAX_ROBOTS = 100
MAX_SHARED = 20
_WIDTH = (24, 72)
_LEAST_NAME = 12
_LIT, _PLAIN = "bold red", "green"


def bars(content: Content, width: int) -> Table:
    """
    A line of bars for each robot, and the axis below.

    Parameters
    ----------
    content
        What is shown.
    width
        Characters that the whole may take.
    """
    low, high = _WIDTH
    room = max(_LEAST_NAME, width - low - 2)
    names = [short(one_line(row.robot), room) for row in content.rows[:MAX_ROBOTS]]
    shared_names = [short(row.name, room) for row in content.shared[:MAX_SHARED]]
    cells = min(high, max(low, width - max(map(len, [*names, *shared_names])) - 2))
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column(no_wrap=True)
    table.add_column(no_wrap=True)
    for name, row in zip(names, content.rows, strict=False):
        table.add_row(Text(name, style="cyan"), _line(row, content.makespan_s, cells))
    if len(content.rows) > MAX_ROBOTS:
        table.add_row("", Text(f"… and {len(content.rows) - MAX_ROBOTS} more robots", style="dim"))
    for shared in content.shared[:MAX_SHARED]:
        table.add_row(Text(short(shared.name, room), style="cyan"), _held(shared, content.makespan_s, cells))
    if len(content.shared) > MAX_SHARED:
        table.add_row("", Text(f"… and {len(content.shared) - MAX_SHARED} more shared resources", style="dim"))
    table.add_row("", Text(axis(content.makespan_s, cells), style="dim"))
    return table


def _held(row: SharedRow, makespan_s: float, cells: int) -> Text:
    """When a shared resource is held, in turn by whom; by how many where it is held by more than one."""
    many, characters = [0] * cells, [" "] * cells
    for number, hold in enumerate(row.holds):
        first = min(_cell(hold.start_s, makespan_s, cells), cells - 1)
        for cell in range(first, max(first + 1, _cell(hold.end_s, makespan_s, cells))):
            many[cell] += 1
            characters[cell] = HELD[number % 2] if many[cell] == 1 or row.capacity == 1 else str(min(9, many[cell]))
    return Text("".join(characters), style="dim")


def short(name: str, room: int) -> str:
    """A name of at most so many characters, cut in its middle, since names of robots differ at their ends."""
    if len(name) <= room:
        return name
    back = (room - 1) // 2
    return f"{name[: room - 1 - back]}…{name[len(name) - back :]}"


def axis(makespan_s: float, cells: int) -> str:
    """Times at the characters where they are, as many as there is room for; the makespan at the end."""
    end = in_words(makespan_s)
    line = [" "] * cells
    line[cells - len(end) :] = end
    if not makespan_s:
        return "".join(line)
    free = 0
    for tick in ticks(makespan_s, max(1, cells // 12)):
        start = _cell(tick.time_s, makespan_s, cells)
        if free <= start and start + len(tick.label) < cells - len(end):
            line[start : start + len(tick.label)] = tick.label
            free = start + len(tick.label) + 1
    return "".join(line)


def signs(content: Content, critical: str) -> str:
    """What the characters mean, those that occur."""
    parts = []
    if any(not bar.moves for row in content.rows for bar in row.bars):
        parts.append(f"{WORK} action")
    if any(bar.moves for row in content.rows for bar in row.bars):
        parts.append(f"{MOVE} move")
    if any(row.ways for row in content.rows):
        parts.append(f"{WAY} travel")
    if any(row.refills for row in content.rows):
        parts.append(f"{REFILL} refilling")
    if any(row.waits for row in content.rows):
        parts.append(f"{WAIT} waiting")
    if any(row.away for row in content.rows):
        parts.append(f"{AWAY} takes no part")
    if content.shared:
        parts.append(f"{HELD} a shared resource is held")
    if content.chain:
        parts.append(f"{critical} critical chain: any delay of it delays the end")
    return "   ".join(parts)


def _line(row: Row, makespan_s: float, cells: int) -> Text:
    """What a robot does, a character for each stretch of time; what is short stands in front, and is never lost."""
    stretches = sorted(_stretches(row), key=lambda one: (one[0] - one[1], one[0]))
    characters, styles = [" "] * cells, [""] * cells
    for start, end, character, style in stretches:
        first = min(_cell(start, makespan_s, cells), cells - 1)
        last = max(first + 1, _cell(end, makespan_s, cells))
        characters[first:last] = character * (last - first)
        styles[first:last] = [style] * (last - first)
    line = Text()
    for character, style in zip(characters, styles, strict=True):
        line.append(character, style=style)
    return line


def _stretches(row: Row) -> Iterator[tuple[float, float, str, str]]:
    for away in row.away:
        yield away.start_s, away.end_s, AWAY, "dim"
    for wait in row.waits:
        yield wait.start_s, wait.end_s, WAIT, "dim"
    for way in row.ways:
        yield way.start_s, way.end_s, WAY, _LIT if way.lit else _PLAIN
    for refill in row.refills:
        yield refill.start_s, refill.end_s, REFILL, _LIT if refill.lit else _PLAIN
    for number, bar in enumerate(row.bars):
        yield bar.start_s, bar.end_s, MOVE if bar.moves else WORK[number % 2], _LIT if bar.lit else _PLAIN


def _cell(time_s: float, makespan_s: float, cells: int) -> int:
    return round(time_s / makespan_s * cells) if makespan_s else 0
