"""Names that nobody knows are refused with what is accepted and the nearest match."""

from __future__ import annotations

import pytest

from missiontree.errors import InputError
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene
from missiontree.routines.arguments import check_resources, find_entities, find_routine
from missiontree.routines.library import built_in
from tests.builders import paper_fleet

SCENE = Scene(places=(Entity(id="Dock", kind="place"),), entities=(Entity(id="crate"),))


@pytest.mark.parametrize("spelling", ["Search", "SearchTree"])
def test_both_spellings_find_a_routine(spelling: str) -> None:
    assert find_routine(spelling, built_in(), "n").id == "Search"


def test_a_near_miss_is_refused_with_a_suggestion() -> None:
    with pytest.raises(InputError) as caught:
        find_routine("Searching", built_in(), "n")
    assert caught.value.where == "n"
    assert caught.value.accepted.startswith("Search, Follow")
    assert caught.value.hint == "Did you mean 'Search'?"


def test_case_alone_is_a_near_miss_too() -> None:
    with pytest.raises(InputError, match="Did you mean 'Dock'"):
        find_entities(built_in().by_id["Reach"], {"agent": "DOCK"}, SCENE, "n")


def test_entities_come_in_the_routines_order_and_places_count() -> None:
    found = find_entities(built_in().by_id["Transport"], {"location": "Dock", "agent": "crate"}, SCENE, "n")
    assert [(name, entity.id) for name, entity in found.items()] == [("agent", "crate"), ("location", "Dock")]


def test_nothing_near_gives_no_hint() -> None:
    with pytest.raises(InputError) as caught:
        find_entities(built_in().by_id["Reach"], {"agent": "zzz"}, SCENE, "n")
    assert (caught.value.hint, caught.value.where, caught.value.accepted) == ("", "n.agent", "Dock, crate")


def test_resources_must_be_types_of_the_fleet() -> None:
    check_resources(None, paper_fleet(), "n")
    check_resources(("tele_robot",), paper_fleet(), "n")
    with pytest.raises(InputError, match="robot type 'crane' is not known"):
        check_resources(("crane",), paper_fleet(), "n")
