"""
Where every robot, and everybody it brings along or finds, is when: data for whoever moves marks over the map.

A script needs no more than this. Let ``t`` be the time shown. Of a mover, take the last frame that is not later than ``t``; before its
first frame, or if that frame is not ``seen``, the mover is hidden. If the next frame is seen and on the same floor, the mover is between
the two, in proportion to time; else it is where the frame says. Draw it at ``(x + dx, y + dy)`` in the view box of
:func:`missiontree.reporting.maps.view.map_svg` of the same plan, rank and floor.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from missiontree.mission.plan import Plan
from missiontree.reporting.escape import one_line
from missiontree.reporting.maps.content import base_kind, content_of
from missiontree.reporting.maps.errands import Errand
from missiontree.reporting.maps.layout import MapLayout, layout_of
from missiontree.reporting.maps.routes import in_order, routes_of, schedule_of
from missiontree.reporting.maps.things import ThingKind
from missiontree.reporting.maps.tracks import Track, changing, entity_track, robot_track
from missiontree.reporting.references import refuse_dangling

MARK = 7.0
"""Radius that marks of robots are drawn with at most, if none is to cover another at its side."""
_WIDEST = 11.0


@dataclass(frozen=True, slots=True)
class Frame:
    """
    A key frame.

    Parameters
    ----------
    t_s
        When, in seconds from the start; not before the frame before it.
    x, y
        Where in the picture; 0 if not seen.
    x_m, y_m, floor
        Where on the ground, in frame ``map``; 0 and empty if not known.
    seen
        False from when on its position is not known, or it is on a floor that is not shown.
    """

    t_s: float
    x: float
    y: float
    x_m: float
    y_m: float
    floor: str
    seen: bool = True


@dataclass(frozen=True, slots=True)
class Doing:
    """What a robot does, from when to when in seconds."""

    start_s: float
    end_s: float
    text: str


@dataclass(frozen=True, slots=True)
class Mover:
    """
    Somebody or something that moves, or comes into sight.

    Parameters
    ----------
    id, label, kind
        As in fleet and scene; the label on one line.
    letter, hue
        Of robots: the letter on the map, and the number of the hue in the palette; empty and -1 for all others.
    dx, dy
        How far to draw it from where it is, so that those at one spot do not hide each other.
    frames
        In order of time; of frames at one time, the last holds from then on.
    doings
        What a robot does, in order; empty for all others.
    """

    id: str
    label: str
    kind: ThingKind
    letter: str
    hue: int
    dx: float
    dy: float
    frames: tuple[Frame, ...]
    doings: tuple[Doing, ...] = ()


@dataclass(frozen=True, slots=True)
class Motion:
    """
    An alternative in motion.

    Parameters
    ----------
    rank
        Its rank.
    end_s
        Its makespan, in seconds.
    floors
        Floors that are shown, in order.
    movers
        Robots in the order of the fleet, then entities in the order in which they are found or brought.
    """

    rank: int
    end_s: float
    floors: tuple[str, ...]
    movers: tuple[Mover, ...]

    def plain(self) -> dict[str, Any]:
        """
        The same as JSON knows it, compact.

        ``{"rank", "end", "movers": [{"id", "label", "kind", "letter", "hue", "dx", "dy", "frames", "doings"}]}`` where a frame is
        ``[t, x, y, floor]`` with the index of its floor, or ``[t]`` if not seen, and a doing is ``[start, end, text]``. Times in
        milliseconds, places in tenths of the picture's unit, as whole numbers.
        """
        number = {floor: index for index, floor in enumerate(self.floors)}
        return {
            "rank": self.rank,
            "end": _whole(self.end_s, 1000),
            "movers": [
                {
                    "id": mover.id,
                    "label": mover.label,
                    "kind": mover.kind,
                    "letter": mover.letter,
                    "hue": mover.hue,
                    "dx": round(mover.dx, 1),
                    "dy": round(mover.dy, 1),
                    "frames": [
                        [_whole(one.t_s, 1000), _whole(one.x, 10), _whole(one.y, 10), number[one.floor]]
                        if one.seen
                        else [_whole(one.t_s, 1000)]
                        for one in mover.frames
                    ],
                    "doings": [[_whole(one.start_s, 1000), _whole(one.end_s, 1000), one.text] for one in mover.doings],
                }
                for mover in self.movers
            ],
        }


def motion(plan: Plan, rank: int, *, floor: str | None = None) -> Motion | None:
    """
    Tell where everybody is when in an alternative; None if it has no schedule, or nothing has a position.

    Parameters
    ----------
    plan
        The plan.
    rank
        Rank of the alternative.
    floor
        The only floor that is shown; None (default) means all.

    Raises
    ------
    InputError
        If the plan points at nodes or roles that it does not hold.
    """
    refuse_dangling(plan)
    content = content_of(plan)
    layout = layout_of(content, plan, floor)
    schedule = schedule_of(plan, rank)
    if layout is None or schedule is None:
        return None
    routes, where = routes_of(plan, rank, content.scene)
    lines = {passage.leaf: passage.line for route in routes for passage in route.passages}
    movers = [
        Mover(
            id=route.robot,
            label=one_line(route.robot),
            kind="robot",
            letter=route.letter,
            hue=route.livery.number,
            dx=dx,
            dy=dy,
            frames=_frames(robot_track(route), layout),
            doings=tuple(
                Doing(one.start_s, one.end_s, one.text)
                if isinstance(one, Errand)
                else Doing(one.scheduled.start_s, one.scheduled.end_s, one_line(one.action.text))
                for one in in_order(route.deeds, route.errands)
            ),
        )
        for route, (dx, dy) in zip(routes, _ring(len(routes)), strict=True)
    ]
    for name in changing(where, content.scene):
        entity = content.scene.by_id[name]
        track = entity_track(name, where, lines, content.scene)
        kind = base_kind(entity, content.scene)
        label = one_line(entity.label) or name
        movers.append(Mover(name, label, kind, "", -1, MARK + 3, -MARK - 3, _frames(track, layout)))
    floors = tuple(panel.floor for panel in layout.panels)
    return Motion(rank, schedule.makespan_s, floors, tuple(movers))


def _frames(track: Track, layout: MapLayout) -> tuple[Frame, ...]:
    frames: list[Frame] = []
    for t_s, place in sorted(track, key=lambda one: one[0]):
        point = layout.at(place.x_m, place.y_m, place.floor) if place is not None else None
        if place is None or point is None:
            frame = Frame(t_s, 0.0, 0.0, place.x_m if place else 0.0, place.y_m if place else 0.0, "", seen=False)
        else:
            frame = Frame(t_s, *point, place.x_m, place.y_m, place.floor)
        if not frames or frames[-1] != frame:
            frames.append(frame)
    return tuple(frames)


def _ring(count: int) -> list[tuple[float, float]]:
    """A place beside the spot for each of so many robots; the spot itself for one alone."""
    if count < 2:
        return [(0.0, 0.0)] * count
    radius = min(_WIDEST, MARK / math.sin(math.pi / count))
    angles = (math.tau * (index + 0.5) / count - math.pi for index in range(count))
    return [(radius * math.cos(angle), radius * math.sin(angle)) for angle in angles]


def _whole(number: float, factor: int) -> int:
    return round(number * factor)
