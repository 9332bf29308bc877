"""What stands below a Gantt chart: the words of numbered actions, who is idle, what is left out, and what the signs mean."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from missiontree.reporting.gantt.away import away_sign
from missiontree.reporting.gantt.bars import diamonds, stripes
from missiontree.reporting.gantt.content import Bar, Content, Row
from missiontree.reporting.gantt.layout import BOLD, MARGIN
from missiontree.reporting.gantt.links import WASH
from missiontree.reporting.gantt.time import span
from missiontree.reporting.palette import BLUE, HAIR, INK, MUTED, RED, VIOLET
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import text
from missiontree.reporting.text_box import text_width, wrapped

SIZE = 11.0
LINE = 17.0
SIGN = 30.0
_COLUMN = (150.0, 520.0)
_GAP = 26.0


class Block(NamedTuple):
    """Lines of a picture, and how high they are together."""

    lines: Sequence[str]
    height: float


def notes(
    numbered: Sequence[tuple[int, Bar]], makespan_s: float, handing: Mapping[int, str], top: float, width: float
) -> Block:
    """The list of numbered actions with their times in the unit of the axis, and who hands over to whom, in columns, read downwards."""
    if not numbered:
        return Block((), 0.0)
    digits = text_width(str(numbered[-1][0]), SIZE) * BOLD
    entries = [(str(number), bar.label, "".join(_more(bar, makespan_s, handing))) for number, bar in numbered]
    low, high = _COLUMN
    widest = max(digits + 8 + text_width(label + when, SIZE) for _, label, when in entries)
    wide = min(max(low, widest), high, width - 2 * MARGIN)
    columns = max(1, int((width - 2 * MARGIN + _GAP) / (wide + _GAP)))
    rows = -(-len(entries) // columns)
    lines = []
    for place, (number, label, when) in enumerate(entries):
        x, y = MARGIN + place // rows * (wide + _GAP), top + LINE * (place % rows) + 12
        lines.append(text(x + digits, y, number, size=SIZE, anchor="end", bold=True))
        short = wrapped(label, SIZE, wide - digits - 7.5 - text_width(when, SIZE), 1)[0]
        lines.append(text(x + digits + 8, y, short + when, size=SIZE))
    return Block(lines, LINE * rows + 8)


def _more(bar: Bar, makespan_s: float, handing: Mapping[int, str]) -> Iterator[str]:
    """What the list says of an action beside its words."""
    if bar.way:
        yield f" · {bar.way}"
    yield f" ({span(bar.start_s, bar.end_s, makespan_s)})"
    if bar.leaf in handing:
        yield f", {handing[bar.leaf]}"


def remarks(said: Sequence[str], top: float, width: float) -> Block:
    """Sentences, wrapped, one below the other."""
    found = [line for words in said for line in wrapped(words, SIZE, width - 2 * MARGIN, 3)]
    lines = [
        text(MARGIN, top + LINE * place + 12, line, size=SIZE, fill=MUTED, kind="mt-muted")
        for place, line in enumerate(found)
    ]
    return Block(lines, LINE * len(found) + (6 if found else 0))


def idle_words(idle: Sequence[str], most: int = 12) -> list[str]:
    """Who has nothing to do, in a sentence; of many, the first few by name."""
    if not idle:
        return []
    more = f" and {len(idle) - most:,} more" if len(idle) > most else ""
    return [f"Idle: {', '.join(idle[:most])}{more}"]


def legend(content: Content, rows: Sequence[Row], top: float, width: float, prefix: str, *, arrows: bool) -> Block:
    """Signs that occur in the chart, with their meaning, in as many lines as they need; ``arrows``: quiet ones are drawn."""
    lines: list[str] = []
    x, y = MARGIN, top
    for sign, words in _signs(content, rows, prefix, arrows=arrows):
        needed = SIGN + 7 + text_width(words, SIZE)
        if x > MARGIN and x + needed > width - MARGIN:
            x, y = MARGIN, y + LINE + 3
        lines.append(f'<g transform="translate({n(x)} {n(y)})">{sign}</g>')
        lines.append(text(x + SIGN + 7, y + 12, words, size=SIZE, fill=MUTED, kind="mt-muted"))
        x += needed + 20
    return Block(lines, y + LINE - top)


def _signs(content: Content, rows: Sequence[Row], prefix: str, *, arrows: bool) -> Iterator[tuple[str, str]]:
    """Signs, 30 by 16, in the hue of the first row that has such a thing."""
    bars = [(row, bar) for row in rows for bar in row.bars]
    yield (
        _box(rows[0], f'fill="{rows[0].livery.hue.tint}" class="mt-tint"', 1, 14),
        "a role, for which the robot is held",
    )
    if at := next((row for row, bar in bars if not bar.moves), None):
        yield _box(at, f'fill="{at.livery.hue.fill}" class="mt-fill" stroke="{at.livery.hue.deep}"', 2, 12), "an action"
    if at := next((row for row, bar in bars if bar.moves), None):
        foot = f'<rect x="1" y="10" width="28" height="4" fill="url(#{stripes(prefix, at.livery)})"/>'
        yield (
            _box(at, f'fill="#ffffff" class="mt-paper" stroke="{at.livery.hue.deep}"', 2, 12) + foot,
            "an action that is a move",
        )
    if at := next((row for row in rows if row.ways), None):
        yield (
            _box(at, f'fill="url(#{stripes(prefix, at.livery)})" stroke="{at.livery.hue.deep}"', 4, 8),
            "travel",
        )
    if at := next((row for row in rows if row.refills), None):
        yield (
            _box(at, f'fill="#ffffff" class="mt-paper" stroke="{at.livery.hue.deep}" stroke-dasharray="3 1.6"', 2, 12)
            + f'<path class="mt-line" d="M11 8 H19 M15 4 V12" fill="none" stroke="{at.livery.hue.deep}" stroke-width="2"/>',
            "refilling at a charger",
        )
    if at := next((row for row in rows if row.waits), None):
        dots = f'stroke="{at.livery.hue.deep}" stroke-width="2" stroke-dasharray="0.1 5" stroke-linecap="round"'
        yield f'<path class="mt-line" d="M2 8 H29" fill="none" {dots}/>', "waiting"
    if arrows:
        yield _arrow(BLUE, 1.4, "mt-link"), "comes first"
    if any(due.time_s <= content.makespan_s for row in rows for due in row.dues):
        yield _DUE, "a deadline of something in the row"
    if any(row.away for row in rows):
        yield away_sign(prefix), "the robot takes no part"
    if content.joint:
        yield _JOINT, "done together"
    if content.chain:
        yield _OUTLINE + diamonds([(7, 3)]), "the critical chain: any delay of it delays the end"
    if any(order.lit for order in content.orders):
        yield _arrow(INK, 2.4, "mt-critical"), "where it goes on"


_JOINT = (
    f'<rect class="mt-joint mt-fill" x="4" y="1" width="22" height="14" fill="{VIOLET}" fill-opacity="{WASH}"/>'
    f'<path class="mt-joint mt-line" d="M5 1 V15 M25 1 V15" fill="none" stroke="{VIOLET}" stroke-width="2" '
    'stroke-dasharray="5 2"/>'
)
_DUE = (
    f'<path class="mt-line" d="M18 1 V15" fill="none" stroke="{RED}" stroke-width="1.6"/>'
    f'<path class="mt-fill" d="M18 1 l-7 3.5 l7 3.5 Z" fill="{RED}"/>'
)
_OUTLINE = (
    '<rect class="mt-critical mt-line" x="2" y="3" width="26" height="11" rx="2" fill="none" '
    f'stroke="{INK}" stroke-width="2.4"/>'
)


def _box(row: Row, style: str, y: float, height: float) -> str:
    return f'<g class="mt-hue-{row.livery.number}"><rect x="1" y="{n(y)}" width="28" height="{n(height)}" rx="2" {style}/></g>'


def _arrow(colour: str, width: float, kind: str) -> str:
    return (
        f'<path class="{kind} mt-line" d="M2 8 H23" fill="none" stroke="{colour}" stroke-width="{n(width)}"/>'
        f'<path class="{kind} mt-fill" d="M29 8 L23 5 V11 Z" fill="{colour}"/>'
    )


def rule(y: float, width: float) -> str:
    """A hairline from margin to margin."""
    return f'<path class="mt-hair" d="M{n(MARGIN)} {n(y)} H{n(width - MARGIN)}" stroke="{HAIR}" stroke-width="1"/>'
