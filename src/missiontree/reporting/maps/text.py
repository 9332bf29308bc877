"""The map of a plan for the terminal: a grid of characters, and who goes where by what way."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from missiontree.mission.plan import Plan
from missiontree.reporting.escape import one_line
from missiontree.reporting.maps.characters import CLOSED, PARTLY, ROAD, SHARED, SIGNS, UNSURE, WALL, CharacterMap
from missiontree.reporting.maps.content import content_of
from missiontree.reporting.maps.layout import MapLayout, layout_of
from missiontree.reporting.maps.legend import metres_walked
from missiontree.reporting.maps.routes import Route, routes_of
from missiontree.reporting.maps.stops import called, length_of, stops_of
from missiontree.reporting.maps.things import MapContent
from missiontree.reporting.references import refuse_dangling

NARROWEST = 24
MOST_ROWS = 40


def map_view(plan: Plan, rank: int | None = None, width: int = 100) -> Group | None:
    """
    The map of a plan as characters; None if nothing has a position.

    Parameters
    ----------
    plan
        The plan.
    rank
        Rank of the alternative whose routes are told below; None (default) for none.
    width
        Characters of a line.

    Raises
    ------
    InputError
        If the plan points at nodes or roles that it does not hold.
    """
    refuse_dangling(plan)
    content = content_of(plan)
    layout = layout_of(content, plan)
    if layout is None:
        return None
    routes, _ = routes_of(plan, rank, content.scene)
    return Group(*_parts(content, layout, routes, max(width, NARROWEST)))


def _parts(content: MapContent, layout: MapLayout, routes: Sequence[Route], width: int) -> Iterator[RenderableType]:
    for panel in layout.panels:
        page = CharacterMap(content, layout, panel, routes, width)
        if layout.titled:
            yield Text(f"floor {panel.floor}", style="bold")
        yield from map(Text, page.lines())
        yield Text(page.scale(), style="dim")
    for line in _packed(_key(content, routes), width):
        yield Text(line, style="dim")
    if content.missing:
        missing = (f"{one_line(one.label) or one.id}{f' ({one.note})' if one.note else ''}" for one in content.missing)
        yield Text(f"position unknown: {', '.join(missing)}")
    if routes:
        yield Text("")
        yield _itineraries(routes, content)


def _key(content: MapContent, routes: Sequence[Route]) -> list[str]:
    """What the characters mean, those that occur."""
    kinds = {thing.kind: "" for thing in content.things if thing.kind != "node"}
    names = {"object": "thing", "lift": content.floor_words}
    words = [f"{SIGNS[kind]} {names.get(kind, kind)}" for kind in SIGNS if kind in kinds]
    words += [f"{UNSURE} position unknown, planned here"] if any(not thing.sure for thing in content.things) else []
    words += [f"{WALL} wall"] if content.scene.grid is not None else []
    closed = [shown for shown in content.areas if shown.role == "keep_out"]
    words += [f"{CLOSED} keep-out"] if any(shown.closed_to is None for shown in closed) else []
    words += [f"{PARTLY} {one_line(shown.label)}: {shown.closed_words}" for shown in closed if shown.closed_words]
    words += [f"{ROAD} road"] if content.roads else []
    letters = [route.letter.lower() for route in routes if route.distance_m and len(route.letter) == 1]
    if letters:
        words.append(f"{letters[0]}{f'–{letters[-1]}' if len(letters) > 1 else ''} ways of robots")
    words += [f"{SHARED} ways of several"] if len(routes) > 1 else []
    return words


def _packed(words: Sequence[str], width: int) -> Iterator[str]:
    """Words in lines, none torn."""
    line = ""
    for word in words:
        longer = f"{line}   {word}" if line else word
        if line and len(longer) > width:
            yield line
            longer = word
        line = longer
    if line:
        yield line


def _itineraries(routes: Sequence[Route], content: MapContent) -> Table:
    """Each robot with its stops."""
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column(no_wrap=True)
    table.add_column()
    length_s = length_of(routes)
    for route in routes[:MOST_ROWS]:
        start = f"from {called(None, route.start, content)}: " if route.start is not None else "start not known: "
        far = f"; {metres_walked(route.distance_m)} in all" if route.distance_m else ""
        name = Text.assemble((route.letter, "bold cyan"), " ", one_line(route.robot))
        table.add_row(name, Text(f"{start}{', '.join(stops_of(route, content, length_s))}{far}"))
    if len(routes) > MOST_ROWS:
        table.add_row("", Text(f"and {len(routes) - MOST_ROWS} robots more", style="dim"))
    return table
