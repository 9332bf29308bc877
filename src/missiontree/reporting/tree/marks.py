"""Marks at the forks of a drawn tree: the word of the gate, the arc over its edges, and what is chosen."""

from __future__ import annotations

import math
from collections.abc import Iterator

from missiontree.mission.tree import Gate
from missiontree.reporting.palette import PAPER
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.tree.ink import line_colour, words_colour
from missiontree.reporting.tree.links import Point
from missiontree.reporting.tree.shape import State

MARK_WIDTH, MARK_HEIGHT, MARK_BELOW = 36.0, 15.0, 3.0
ARC, ARC_DROP = 21.0, 0.62
TICK = 7.0


def gate_mark(x: float, y: float, gate: Gate, state: State) -> str:
    """The word of a gate, its upper edge at y."""
    return (
        f'<rect class="mt-pill" x="{n(x - MARK_WIDTH / 2)}" y="{n(y)}" width="{n(MARK_WIDTH)}" '
        f'height="{n(MARK_HEIGHT)}" rx="7" fill="{PAPER}" stroke="{line_colour(state)}"/>'
        f'<text x="{n(x)}" y="{n(y + 11.5)}" fill="{words_colour(state)}" stroke="none">{gate.upper()}</text>'
    )


def gate_arc(fork: Point, first: Point, last: Point, gate: Gate, state: State) -> str:
    """An arc below a fork, from its first edge to its last; flat enough to stay near the fork."""
    high = ARC * ARC_DROP

    def on(goal: Point) -> Point:
        across, down = (goal[0] - fork[0]) / ARC, (goal[1] - fork[1]) / high
        length = math.hypot(across, down) or 1.0
        return fork[0] + ARC * across / length, fork[1] + high * down / length

    (x1, y1), (x2, y2) = on(first), on(last)
    return (
        f'<path class="mt-arc mt-{gate}" d="M{n(x1)} {n(y1)} A{n(ARC)} {n(high)} 0 0 0 {n(x2)} {n(y2)}" fill="none" '
        f'stroke="{line_colour(state)}"/>'
    )


def tick(x: float, y: float) -> Iterator[str]:
    """What is chosen at an XOR: a tick in a circle, its middle at (x, y)."""
    ink = line_colour("lit")
    yield f'<circle class="mt-tick" cx="{n(x)}" cy="{n(y)}" r="{n(TICK)}" fill="{PAPER}" stroke="{ink}" stroke-width="1.4"/>'
    yield (
        f'<path class="mt-tick" d="M{n(x - 3.4)} {n(y + 0.2)} L{n(x - 1)} {n(y + 2.9)} L{n(x + 3.4)} {n(y - 2.7)}" '
        f'fill="none" stroke="{ink}" stroke-width="1.8" stroke-linecap="round" stroke-linejoin="round"/>'
    )
