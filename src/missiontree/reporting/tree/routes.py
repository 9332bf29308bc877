"""The way of a link in a drawn tree: where it leaves and reaches its nodes, and what it runs along between rows."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.mission.tree import LinkKind

LANE_ENDS = 12.0
LINK_SIZE = 10.0
LINK_WORDS: dict[LinkKind, str] = {
    "precedence": "",
    "same_robot": "same robot",
    "different_robot": "different robots",
    "until": "until",
    "hand_over": "hands over",
}


@dataclass(frozen=True, slots=True)
class Anchor:
    """
    Where a link leaves or reaches its node.

    Parameters
    ----------
    node
        The node.
    x
        Where the line goes up or down from here.
    side
        1 for the lower edge or the right side, -1 for the upper edge or the left side.
    upright
        The line leaves through the lower or upper edge; else through a side, and turns at ``x``.
    shift
        Of a side: how far below the middle.
    """

    node: int
    x: float
    side: int
    upright: bool
    shift: float = 0.0


@dataclass(slots=True)
class Run:
    """
    A level stretch between two rows.

    Parameters
    ----------
    gap
        The level above it.
    start, end
        From where to where.
    room
        What it needs for itself, a word on it included.
    lane
        Number of its lane, from above.
    """

    gap: int
    start: float
    end: float
    room: tuple[float, float]
    lane: int = 0


@dataclass(frozen=True, slots=True)
class Route:
    """
    The way of one link, before rows have their places.

    Parameters
    ----------
    kind
        Kind of the link.
    start, end
        Its ends.
    runs
        Level stretches from the first to the last; none if the ends are side by side or one above the other.
    """

    kind: LinkKind
    start: Anchor
    end: Anchor
    runs: tuple[Run, ...] = ()


def in_lanes(runs: Sequence[Run]) -> int:
    """Give runs lanes in which none lies on another, short ones above; how many lanes there are."""
    lanes: list[list[tuple[float, float]]] = []
    for run in sorted(runs, key=lambda run: (run.room[1] - run.room[0], run.room[0])):
        taken = (run.room[0] - LANE_ENDS, run.room[1] + LANE_ENDS)
        run.lane = next((number for number, lane in enumerate(lanes) if _fits(taken, lane)), len(lanes))
        if run.lane == len(lanes):
            lanes.append([])
        insort(lanes[run.lane], taken)
    return len(lanes)


def _fits(wanted: tuple[float, float], lane: Sequence[tuple[float, float]]) -> bool:
    """Whether there is room in a lane, whose stretches are in order and lie apart."""
    at = bisect_left(lane, wanted)
    return (at == 0 or lane[at - 1][1] <= wanted[0]) and (at == len(lane) or wanted[1] <= lane[at][0])
