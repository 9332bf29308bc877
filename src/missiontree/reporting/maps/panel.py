"""One floor of the map: its ground, the routes, the marks, and the labels that found room."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence

from missiontree.reporting.escape import xml_safe
from missiontree.reporting.maps.area_names import area_name
from missiontree.reporting.maps.boxes import STEP, Box
from missiontree.reporting.maps.cards import card_of, draw_card, name_of
from missiontree.reporting.maps.clusters import Cluster
from missiontree.reporting.maps.ground import corners_of, ground, wall_boxes
from missiontree.reporting.maps.labels import Ground
from missiontree.reporting.maps.layout import TITLE, MapLayout, Panel
from missiontree.reporting.maps.lines import DrawnRoutes
from missiontree.reporting.maps.marks import dot, mark, mark_radius
from missiontree.reporting.maps.settling import Wish, settle
from missiontree.reporting.maps.things import MapContent
from missiontree.reporting.palette import HAIR, INK, QUIET
from missiontree.reporting.svg_numbers import n

GROUND = "#fafbfc"
"""A shade off the paper."""
CROWDED = 60
"""From so many marks on, plain places get no label that needs a line to it."""
MOST_NODES = 40
"""Up to so many road nodes are named."""
_NEAR = 8.0
_DOT, _WALL = 0.5, 0.15
_ANYWHERE = 200.0


class DrawnPanel:
    """
    The panel of a floor.

    Parameters
    ----------
    panel, layout
        Where it is.
    content, clusters, routes
        What is on it.
    """

    def __init__(
        self, panel: Panel, layout: MapLayout, content: MapContent, clusters: Sequence[Cluster], routes: DrawnRoutes
    ) -> None:
        self._panel, self._layout, self._content, self._routes = panel, layout, content, routes
        self._clusters = [cluster for cluster in clusters if cluster.floor == panel.floor]
        self.left_out = 0
        """Labels that found no room."""
        self.dots = sum(max(1, len(one.things)) for one in self._clusters if one.plain and not one.passed)
        """Things that are drawn as dots and that no route touches."""
        self.passed = sum(max(1, len(one.things)) for one in self._clusters if one.plain and one.passed)
        """Things that are drawn as dots though routes touch them."""
        self._labels = list(self._placed())

    def draw(self) -> Iterator[str]:
        """From back to front."""
        panel = self._panel
        yield '<g class="mt-map-panel" font-size="11">'
        if self._layout.titled:
            yield (
                f'<text class="mt-ink" x="{n(panel.x + 2)}" y="{n(panel.y - TITLE + 18)}" font-size="13" font-weight="bold" '
                f'fill="{INK}">floor {xml_safe(panel.floor)}</text>'
            )
        yield (
            f'<rect class="mt-map-ground" x="{n(panel.x)}" y="{n(panel.y)}" width="{n(panel.width)}" height="{n(panel.height)}" rx="6" '
            f'fill="{GROUND}" stroke="{HAIR}"/>'
        )
        yield from ground(self._content, self._layout, panel.floor)
        yield from self._routes.draw(panel.floor)
        yield from _dots([cluster for cluster in self._clusters if cluster.plain and not cluster.passed])
        for cluster in self._clusters:
            if not cluster.plain:
                yield from _marks(cluster)
            elif cluster.passed:
                yield dot(cluster.x, cluster.y, "; ".join(_told(cluster)))
        yield from self._labels
        yield "</g>"

    def _placed(self) -> Iterator[str]:
        """Labels: those of marks, then of areas and of road nodes where there is room left."""
        labels = self._label_ground()
        marked = [cluster for cluster in self._clusters if not cluster.plain]
        crowded = len(marked) > CROWDED
        wished = [(cluster, card) for cluster in marked if cluster.weight < 3 and (card := card_of(cluster))]
        wishes = [
            Wish(
                _box(cluster),
                card.width,
                card.height,
                cluster.weight,
                _NEAR if cluster.weight == 2 and crowded else _ANYWHERE,
            )
            for cluster, card in wished
        ]
        for (cluster, card), place in zip(wished, settle(labels, wishes), strict=True):
            if place is not None:
                yield from draw_card(card, place)
            elif not (yield from self._label(labels, cluster, short=True)):
                self.left_out += 1
        for shown in self._content.areas:
            if shown.role != "search_area" and shown.area.floor == self._panel.floor:
                named = yield from area_name(labels, shown, corners_of(shown, self._layout))
                self.left_out += not named
        nodes = [cluster for cluster in marked if cluster.weight == 3]
        for cluster in nodes if len(nodes) <= MOST_NODES else ():
            yield from self._label(labels, cluster)

    def _label_ground(self) -> Ground:
        """What labels have to mind."""
        panel = self._panel
        labels = Ground(Box(panel.x + 3, panel.y + 3, panel.x + panel.width - 3, panel.y + panel.height - 3))
        for cluster in self._clusters:
            if not cluster.plain:
                labels.mark(_box(cluster))
            elif cluster.passed:
                labels.discourage(((cluster.x, cluster.y), (cluster.x, cluster.y)), _DOT)
        for line in self._routes.on(panel.floor):
            labels.discourage(line, 0.5)
        for road in self._content.roads:
            start, end = self._layout.point(road.start), self._layout.point(road.end)
            if road.start.floor == panel.floor and start is not None and end is not None:
                labels.discourage((start, end), 0.12)
        for shown in self._content.areas:
            if shown.area.floor == panel.floor:
                corners = corners_of(shown, self._layout)
                labels.discourage((*corners, corners[0]), 0.1)
        grid = self._content.scene.grid
        if grid is not None and grid.floor == panel.floor:
            _off_walls(labels, wall_boxes(grid, self._layout))
        return labels

    def _label(self, labels: Ground, cluster: Cluster, *, short: bool = False) -> Generator[str, None, bool]:
        """The label of a cluster right beside it; whether there was room."""
        card = card_of(cluster, short=short)
        place = None if card is None else labels.place(_box(cluster), card.width, card.height, _NEAR)
        if card is None or place is None:
            return False
        yield from draw_card(card, place)
        return True


def _off_walls(labels: Ground, found: Sequence[Box]) -> None:
    """Keep labels off walls: one that is covered looks like an open way."""
    for wall in found:
        rows = max(1, round((wall.bottom - wall.top) / STEP))
        for row in range(rows):
            y = wall.top + (row + 0.5) * (wall.bottom - wall.top) / rows
            labels.discourage(((wall.left, y), (wall.right, y)), _WALL)


def _box(cluster: Cluster) -> Box:
    """The mark of a cluster, its question mark included."""
    radius = mark_radius(cluster.things[0].kind) if cluster.things else mark_radius("robot")
    asks = 5.0 if cluster.things and not cluster.things[0].sure else 0.0
    if asks:
        radius = mark_radius("robot")
    return Box(cluster.x - radius, cluster.y - radius - asks / 2, cluster.x + radius + asks, cluster.y + radius)


def _dots(clusters: Sequence[Cluster]) -> Iterator[str]:
    """Things without marks of their own, as one path."""
    points = [(x, y) for cluster in clusters for x, y in ((cluster.x, cluster.y), *cluster.aside)]
    if points:
        path = "".join(f"M{n(x)} {n(y)}h0" for x, y in points)
        yield f'<path class="mt-map-dots" d="{path}" fill="none" stroke="{QUIET}" stroke-width="3" stroke-linecap="round"/>'


def _marks(cluster: Cluster) -> Iterator[str]:
    """The mark of a cluster, and a dot for each of its things that stands a little aside."""
    for x, y in cluster.aside:
        yield dot(x, y)
    title = "; ".join(_told(cluster))
    yield f'<g class="mt-map-mark"><title>{xml_safe(title)}</title>'
    if cluster.things:
        thing = cluster.things[0]
        yield from mark(thing.kind, cluster.x, cluster.y, sure=thing.sure)
    elif cluster.starts:
        yield from mark("robot", cluster.x, cluster.y)
    else:
        yield dot(cluster.x, cluster.y)
    yield "</g>"


def _told(cluster: Cluster) -> Iterator[str]:
    for thing in cluster.things[:40]:
        yield f"{name_of(thing)} ({thing.note})" if thing.note else name_of(thing)
    for route in cluster.starts[:40]:
        yield f"{route.robot} starts here"
