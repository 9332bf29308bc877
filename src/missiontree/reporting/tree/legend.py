"""What the signs of a drawn tree mean: only those that it shows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import get_args

from missiontree.mission.tree import LINK_KINDS, Gate
from missiontree.reporting.palette import INK, PAPER, RED
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.text_box import text_width, wrapped
from missiontree.reporting.tree.cards import NOTE_SIZE
from missiontree.reporting.tree.ink import EDGE_WIDTH, GLOW, LINK_STYLES, line_colour, link_line
from missiontree.reporting.tree.marks import MARK_HEIGHT, MARK_WIDTH, gate_mark, tick
from missiontree.reporting.tree.shape import Shape, State

ROW, SIGN, AFTER_SIGN, BETWEEN = 22.0, 40.0, 8.0, 26.0
LEAST_WIDTH, MOST_WIDTH = 560.0, 1100.0
"""Lines of the legend are as wide as the tree, within these bounds."""


@dataclass(frozen=True, slots=True)
class Entry:
    """
    A sign and what it means.

    Parameters
    ----------
    sign
        Name of the sign; empty for words alone.
    words
        Its meaning.
    """

    sign: str
    words: str

    @property
    def width(self) -> float:
        """Room that it takes."""
        return (SIGN + AFTER_SIGN if self.sign else 0.0) + text_width(self.words, NOTE_SIZE)


def legend_of(shape: Shape, has_order: bool, chosen: str = "", folded: str = "") -> list[Entry]:
    """
    The entries that a tree needs.

    Parameters
    ----------
    shape
        The tree as it is drawn.
    has_order
        Whether some column shows what one robot does, one after the other.
    chosen, folded
        What is lit, and how much is folded, in words; empty if nothing is.
    """
    gates = {node.gate for node, below in zip(shape.nodes, shape.children, strict=True) if len(below) > 1}
    entries = []
    if chosen:
        entries.append(Entry("lit", chosen))
        if any(node.state == "quiet" for node in shape.nodes):
            entries.append(Entry("quiet", "not chosen"))
    if "and" in gates:
        entries.append(Entry("and", "all of them are done"))
    if "xor" in gates or any(node.gate == "xor" for node in shape.nodes):
        entries.append(Entry("xor", "exactly one of them is done"))
    kinds = {kind for _, _, kind in shape.links} | ({"precedence"} if has_order else set())
    entries += [Entry(kind, LINK_STYLES[kind].meaning) for kind in LINK_KINDS if kind in kinds]
    if shape.frames:
        entries.append(Entry("frame", "an attached routine"))
    if folded:
        entries += [Entry("pile", line) for line in wrapped(folded, NOTE_SIZE, MOST_WIDTH - SIGN, 3)[:1]]
    return entries


def in_lines(entries: Sequence[Entry], tree_width: float) -> list[list[Entry]]:
    """The entries, line by line."""
    width = min(max(tree_width, LEAST_WIDTH), MOST_WIDTH)
    lines: list[list[Entry]] = []
    taken = width
    for entry in entries:
        if taken + entry.width > width or not lines:
            lines.append([])
            taken = 0.0
        lines[-1].append(entry)
        taken += entry.width + BETWEEN
    return lines


def width_of(lines: Sequence[Sequence[Entry]]) -> float:
    """Width of the widest line."""
    return max((sum(entry.width + BETWEEN for entry in line) - BETWEEN for line in lines), default=0.0)


def legend_lines(lines: Sequence[Sequence[Entry]], left: float, top: float) -> Iterator[str]:
    """The legend at its place."""
    for line in lines:
        x, middle = left, top + ROW / 2
        for entry in line:
            yield from _sign(entry.sign, x, middle)
            at = x + (SIGN + AFTER_SIGN if entry.sign else 0.0)
            yield f'<text class="mt-words" x="{n(at)}" y="{n(middle + 4)}" fill="{INK}">{entry.words}</text>'
            x += entry.width + BETWEEN
        top += ROW


def _sign(sign: str, x: float, y: float) -> Iterator[str]:
    for gate in get_args(Gate):
        if sign == gate:
            yield f'<g text-anchor="middle">{gate_mark(x + MARK_WIDTH / 2, y - MARK_HEIGHT / 2, gate, "plain")}</g>'
    for kind in LINK_KINDS:
        if sign == kind:
            yield from link_line(kind, ((x + 3, y), (x + SIGN - 4, y)), "plain")
    if sign == "lit":
        yield f'<path class="mt-glow" d="M{n(x)} {n(y)} L{n(x + SIGN)} {n(y)}" stroke="{GLOW}" stroke-width="9"/>'
        yield _stroke(x, y, "lit")
        yield from tick(x + SIGN / 2, y)
    elif sign == "quiet":
        yield _stroke(x, y, "quiet")
    elif sign == "frame":
        yield _plate("mt-frame", x + 2, y - 7, (SIGN - 6, 14.0), f'fill="none" stroke="{RED}" stroke-width="1.5"')
    elif sign == "pile":
        for place in (2, 1, 0):
            at = 2.5 * place
            yield _plate("mt-pile", x + 5 + at, y - 8 + at, (24.0, 11.0), f'fill="{PAPER}" stroke="{INK}"')


def _plate(name: str, x: float, y: float, size: tuple[float, float], style: str) -> str:
    return f'<rect class="{name}" x="{n(x)}" y="{n(y)}" width="{n(size[0])}" height="{n(size[1])}" rx="3" {style}/>'


def _stroke(x: float, y: float, state: State) -> str:
    width, colour = EDGE_WIDTH[state], line_colour(state)
    return (
        f'<path class="mt-edge" d="M{n(x)} {n(y)} L{n(x + SIGN)} {n(y)}" stroke="{colour}" stroke-width="{n(width)}"/>'
    )
