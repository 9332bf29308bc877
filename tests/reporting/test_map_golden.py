"""The maps that are kept show what they are kept for; that they are drawn as before is told by all golden pictures together."""

from __future__ import annotations

from missiontree.reporting.maps.content import content_of
from tests.reporting.golden import PICTURES
from tests.reporting.golden_maps import SAMPLES
from tests.reporting.golden_trees import planned


def test_the_maps_that_are_kept_are_of_every_kind_of_ground() -> None:
    museum, clinic, airport, harbour = (content_of(planned(name)) for name in SAMPLES)
    assert museum.scene.grid is not None
    assert {shown.role for shown in museum.areas} == {"search_area"}
    assert len(clinic.floors) == 2
    assert any(thing.kind == "lift" for thing in clinic.things)
    assert {shown.role for shown in airport.areas} == {"zone", "keep_out"}
    assert all(shown.closed_to for shown in harbour.areas)
    assert all(f"map-{name}-alternative-1.svg" in PICTURES for name in SAMPLES)
