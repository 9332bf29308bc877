"""The map of a plan as a picture: what is where, and the routes of an alternative."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from missiontree.mission.plan import Plan
from missiontree.reporting.called import called
from missiontree.reporting.escape import one_line
from missiontree.reporting.maps.clusters import clusters_of
from missiontree.reporting.maps.content import content_of
from missiontree.reporting.maps.layout import GAP, MARGIN, MapLayout, layout_of
from missiontree.reporting.maps.legend import routes_key, scale_bar
from missiontree.reporting.maps.lines import DrawnRoutes
from missiontree.reporting.maps.missing import SIDE, side_box
from missiontree.reporting.maps.panel import DrawnPanel
from missiontree.reporting.maps.routes import Route, routes_of
from missiontree.reporting.maps.signs import entries, entries_of
from missiontree.reporting.maps.stops import length_of, stops_of
from missiontree.reporting.maps.things import MapContent
from missiontree.reporting.palette import MUTED
from missiontree.reporting.references import refuse_dangling
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import opening

_LEAST_WIDTH = 420.0


def map_svg(plan: Plan, rank: int | None = None, *, floor: str | None = None) -> str | None:
    """
    Draw the map of a plan as an SVG document; None if nothing has a position.

    Zones, keep-outs, walls, roads and lifts, places, people and things, those that are missing, and where robots start. With a rank,
    the way of every robot in its colour, with a letter, its stops numbered. Floors stand side by side at one scale. Everything but the
    routes and their key is where it is in the map of any other alternative of the plan. The same plan gives the same bytes.

    Parameters
    ----------
    plan
        The plan.
    rank
        Rank of the alternative whose routes are drawn; None (default) draws none, and so does one without a schedule.
    floor
        The only floor to be drawn; None (default) means all.

    Raises
    ------
    InputError
        If the plan points at nodes or roles that it does not hold.
    """
    refuse_dangling(plan)
    content = content_of(plan)
    layout = layout_of(content, plan, floor)
    if layout is None:
        return None
    routes, _ = routes_of(plan, rank, content.scene)
    name = one_line(content.scene.label) or one_line(plan.brief.text) or "the mission"
    title = f"Map of {name}" + (f", routes of {called(plan, rank)}" if rank is not None and routes else "")
    return "\n".join(_lines(title, f"mt-map-{rank or 0}", content, layout, routes)) + "\n"


def _lines(title: str, prefix: str, content: MapContent, layout: MapLayout, routes: Sequence[Route]) -> Iterator[str]:
    drawn = DrawnRoutes(routes, layout)
    clusters = clusters_of(content.things, routes, layout)
    panels = [DrawnPanel(panel, layout, content, clusters, drawn) for panel in layout.panels]
    lost = [route for route in routes if route.start is None]
    side: list[str] = []
    width, height = layout.width, layout.height
    if content.missing or lost:
        side, side_height = side_box(content.missing, lost, width - MARGIN + GAP, layout.panels[0].y)
        width += GAP + SIDE
        height = max(height, layout.panels[0].y + side_height + MARGIN)
    width = max(width, _LEAST_WIDTH)
    foot, foot_height = _foot(content, layout, routes, _remarks(panels), height, width)
    height += foot_height
    yield opening(width, height, title, _described(content, routes), prefix)
    for panel in panels:
        yield from panel.draw()
    yield from _group("mt-map-missing", side)
    yield from _group("mt-map-foot", foot)
    yield "</svg>"


def _group(name: str, lines: Sequence[str]) -> Iterator[str]:
    if lines:
        yield f'<g class="{name}" font-size="11">'
        yield from lines
        yield "</g>"


def _foot(
    content: MapContent, layout: MapLayout, routes: Sequence[Route], remarks: Sequence[str], y: float, width: float
) -> tuple[list[str], float]:
    """Below the panels: scale and signs, what was left out, the key of the routes. And the height of all."""
    lines: list[str] = []
    x = MARGIN
    top = y - MARGIN + 8
    lines += scale_bar(layout.scale, x, top + 26)
    signs, height = entries(
        entries_of(content, [panel.floor for panel in layout.panels]), x + 176, top + 8, width - 176 - 2 * x
    )
    lines += signs
    top += max(36.0, height + 12)
    for remark in remarks:
        lines.append(f'<text class="mt-muted" x="{n(x)}" y="{n(top + 10)}" fill="{MUTED}">{remark}</text>')
        top += 20
    if routes:
        length_s = length_of(routes)
        key, height = routes_key(routes, lambda route: stops_of(route, content, length_s), x, top, width - 2 * x)
        lines += key
        top += height
    return lines, top + MARGIN - 4 - y


def _remarks(panels: Sequence[DrawnPanel]) -> list[str]:
    """What is not shown as it might be."""
    dots, left_out = sum(panel.dots for panel in panels), sum(panel.left_out for panel in panels)
    passed = sum(panel.passed for panel in panels)
    remarks = []
    if dots:
        remarks.append(f"{dots:,} things that no route touches are dots without a name.")
    if passed:
        remarks.append(f"{passed:,} things at which robots stop are small dots; their names would find no room.")
    if left_out:
        remarks.append(f"{left_out:,} {'label was' if left_out == 1 else 'labels were'} left out for want of room.")
    return remarks


def _described(content: MapContent, routes: Sequence[Route]) -> str:
    """The map in some sentences, for those who do not see it."""
    counts = (
        (sum(thing.kind == "place" for thing in content.things), "places"),
        (sum(thing.kind in {"person", "animal", "object"} for thing in content.things), "people, animals and things"),
        (len(content.missing), "of unknown position"),
        (len(content.roads), "roads"),
        (sum(shown.role == "keep_out" for shown in content.areas), "keep-outs"),
        (len(content.floors), "floors"),
    )
    shown = ", ".join(f"{what}: {count}" for count, what in counts if count)
    length_s = length_of(routes)
    ways = [f"{one.letter} is {one.robot}: {', '.join(stops_of(one, content, length_s))}." for one in routes[:8]]
    return " ".join([f"{shown}.", *ways])
