"""Maps whose pictures are kept: a grid, roads on two floors, open ground, and areas that are closed to some only."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

from missiontree.reporting.maps.view import map_svg
from tests.reporting.golden_trees import planned

SAMPLES = {
    "museum": "a grid with walls, and somebody who may be anywhere in an area",
    "clinic": "roads on two floors, joined by a lift",
    "airport": "open ground with zones, and areas that nobody enters",
    "harbour": "areas that are closed to some robot types only",
}


def pictures() -> Iterator[tuple[str, Callable[[], str]]]:
    """Names of files, and how their content is made."""
    for name in SAMPLES:
        yield f"map-{name}-alternative-1.svg", partial(_map, name, 1)
    yield "map-airport.svg", partial(_map, "airport", None)


def _map(name: str, rank: int | None) -> str:
    svg = map_svg(planned(name), rank)
    assert svg is not None, "everything in these samples has a position"
    return svg
