"""Shared resources of a scene."""

from __future__ import annotations

import pytest

from missiontree.errors import InputError
from missiontree.formats.document import read_text
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource


def test_a_resource_has_room_for_one_and_is_called_by_its_id_unless_it_says_otherwise() -> None:
    assert SharedResource(id="lift") == SharedResource(id="lift", capacity=1, label="lift")
    assert Scene(resources=(SharedResource(id="lift", capacity=2),)).shared["lift"].capacity == 2


def test_a_name_stands_once() -> None:
    with pytest.raises(ValueError, match="shared resource 'lift' stands twice"):
        Scene(resources=(SharedResource(id="lift"), SharedResource(id="lift")))


@pytest.mark.parametrize(
    ("given", "where"),
    [
        ("{id: lift, capacity: 0}", "resources[0].capacity"),
        ("{id: lift, capacity: 1.5}", "resources[0].capacity"),
        ("{id: lift, capacity: many}", "resources[0].capacity"),
        ("{id: the lift}", "resources[0].id"),
        ("{capacity: 2}", "resources[0]"),
        ("{id: lift, room: 2}", "resources[0].room"),
    ],
)
def test_a_file_that_says_it_wrongly_is_refused_at_its_place(given: str, where: str) -> None:
    with pytest.raises(InputError) as caught:
        read_text(f"entities: []\nresources:\n- {given}\n", "scene", "scene.yaml")
    assert (caught.value.line, caught.value.where) == (3, where)
