"""Routes that share a road, drawn side by side: no line hides another."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise, product

Point = tuple[float, float]

LANE = 4.5
WIDEST = 30.0
"""All lanes of a road together; above that they move closer."""
_ANGLE, _ASIDE = 0.01, 1.5
"""Lines that differ by less, in radians and units of the picture, count as one."""
_FAN = 12.0
_MITRE = 7.0
"""How far a corner may stick out; sharper ones are cut off."""
_SHORT = 0.01


@dataclass(frozen=True, slots=True)
class Line:
    """
    A way in the picture.

    Parameters
    ----------
    owner
        Number of the robot.
    points
        At least two.
    """

    owner: int
    points: tuple[Point, ...]


@dataclass(frozen=True, slots=True)
class _Segment:
    line: int
    owner: int
    start: Point
    end: Point
    angle: float
    aside: float
    low: float
    high: float
    forward: bool


def side_by_side(lines: Sequence[Line]) -> list[list[Point]]:
    """
    Move lines aside where several owners take the same way, each to a lane of its own.

    Lanes are in order of the owners, to the right of whoever comes first; ends stay where they are, so that routes meet at places.
    One owner's ways to and fro share a lane. Linear in the number of segments for lines on roads.
    """
    segments = [segment for number, line in enumerate(lines) for segment in _segments(number, line)]
    shift = _shifts(segments)
    own: list[list[tuple[_Segment, float]]] = [[] for _ in lines]
    for segment, aside in zip(segments, shift, strict=True):
        own[segment.line].append((segment, aside))
    return [_moved(line.points, parts) for line, parts in zip(lines, own, strict=True)]


def _segments(number: int, line: Line) -> Iterator[_Segment]:
    points = [(round(x, 2), round(y, 2)) for x, y in line.points]
    for start, end in pairwise(points):
        dx, dy = end[0] - start[0], end[1] - start[1]
        if math.hypot(dx, dy) <= _SHORT:
            continue
        forward = dx > 0 or (dx == 0 and dy > 0)
        ux, uy = (dx, dy) if forward else (-dx, -dy)
        length = math.hypot(ux, uy)
        ux, uy = ux / length, uy / length
        along = sorted((start[0] * ux + start[1] * uy, end[0] * ux + end[1] * uy))
        aside = start[1] * ux - start[0] * uy
        yield _Segment(number, line.owner, start, end, math.atan2(uy, ux), aside, along[0], along[1], forward)


def _shifts(segments: Sequence[_Segment]) -> list[float]:
    """How far each segment goes aside, to the right of its canonical direction in a picture, where y grows downwards."""
    shift = [0.0] * len(segments)
    for members in _carriers(segments):
        for overlapping in _runs(segments, members):
            owners = sorted({segments[member].owner for member in overlapping})
            if len(owners) < 2:
                continue
            lane = min(LANE, WIDEST / (len(owners) - 1))
            first = min(overlapping)
            sign = 1.0 if segments[first].forward else -1.0
            place = {owner: (index - (len(owners) - 1) / 2) * lane * sign for index, owner in enumerate(owners)}
            for member in overlapping:
                shift[member] = place[segments[member].owner]
    return shift


def _carriers(segments: Sequence[_Segment]) -> list[list[int]]:
    """Segments on one straight line together."""
    parent = list(range(len(segments)))

    def root(member: int) -> int:
        while parent[member] != member:
            parent[member] = parent[parent[member]]
            member = parent[member]
        return member

    buckets: dict[tuple[int, int], list[int]] = {}  # of those alike, the first stands for all
    for index, segment in enumerate(segments):
        cell = (math.floor(segment.angle / _ANGLE), math.floor(segment.aside / _ASIDE))
        alike = [
            other
            for across, up in product((-1, 0, 1), repeat=2)
            for other in buckets.get((cell[0] + across, cell[1] + up), ())
            if _alike(segment, segments[other])
        ]
        for other in alike:
            parent[root(index)] = root(other)
        if not alike:
            buckets.setdefault(cell, []).append(index)
    groups: dict[int, list[int]] = {}
    for index in range(len(segments)):
        groups.setdefault(root(index), []).append(index)
    return list(groups.values())


def _alike(first: _Segment, second: _Segment) -> bool:
    return abs(first.angle - second.angle) <= _ANGLE and abs(first.aside - second.aside) <= _ASIDE


def _runs(segments: Sequence[_Segment], members: Sequence[int]) -> Iterator[list[int]]:
    """Of segments on one line, those that overlap, directly or by way of others."""
    run: list[int] = []
    reach = -math.inf
    for member in sorted(members, key=lambda one: (segments[one].low, one)):
        if run and segments[member].low >= reach - 1.0:
            yield run
            run = []
        run.append(member)
        reach = max(reach, segments[member].high) if len(run) > 1 else segments[member].high
    if run:
        yield run


def _moved(points: Sequence[Point], parts: Sequence[tuple[_Segment, float]]) -> list[Point]:
    """A line through its lanes; its ends stay."""
    if not parts:
        return [points[0], points[-1]]
    if all(aside == 0.0 for _, aside in parts):
        return [parts[0][0].start, *(segment.end for segment, _ in parts)]
    moved = [_aside(segment.start, segment, aside) for segment, aside in parts]
    ends = [_aside(segment.end, segment, aside) for segment, aside in parts]
    line = [parts[0][0].start, _towards(moved[0], ends[0], parts[0][1])]
    for index in range(len(parts) - 1):
        line.extend(_corner(moved[index], ends[index], moved[index + 1], ends[index + 1]))
    return [*line, _towards(ends[-1], moved[-1], parts[-1][1]), parts[-1][0].end]


def _aside(point: Point, segment: _Segment, aside: float) -> Point:
    ux, uy = math.cos(segment.angle), math.sin(segment.angle)
    return (point[0] - uy * aside, point[1] + ux * aside)


def _towards(point: Point, other: Point, aside: float) -> Point:
    """A little way on from a point, where a lane has fanned out."""
    length = math.dist(point, other)
    if aside == 0.0 or length == 0.0:
        return point
    share = min(_FAN, length / 3) / length
    return (point[0] + share * (other[0] - point[0]), point[1] + share * (other[1] - point[1]))


def _corner(start: Point, end: Point, after: Point, last: Point) -> list[Point]:
    """Where one lane goes over into the next: at their crossing, or straight across if that is off."""
    if math.dist(end, after) <= _SHORT:
        return [end]
    (ax, ay), (bx, by) = (end[0] - start[0], end[1] - start[1]), (last[0] - after[0], last[1] - after[1])
    turn = ax * by - ay * bx
    if abs(turn) > 0.2 * math.hypot(ax, ay) * math.hypot(bx, by):
        share = ((after[0] - start[0]) * by - (after[1] - start[1]) * bx) / turn
        crossing = (start[0] + share * ax, start[1] + share * ay)
        if math.dist(crossing, end) <= _MITRE:
            return [crossing]
    return [end, after]
