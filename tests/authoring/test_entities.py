import pytest

from missiontree.authoring.entities import Cast, is_said, known_kinds, nouns_said
from missiontree.mission.brief import MissionBrief


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("mom", True),
        ("Lost Child", True),
        ("child lost", False),
        ("the child", False),
        ("chil", False),
        ("", False),
        ("!", False),
    ],
)
def test_a_name_is_said_if_it_stands_there_in_whole_words(name: str, said: bool) -> None:
    assert is_said(name, "Reunite mom, with her lost child!") is said


def test_nouns_of_the_text_come_once_and_in_order() -> None:
    assert nouns_said("Take the cat to mom; mom likes the gizmo and the cat") == ("cat", "mom")


def test_kinds_are_the_base_kinds_and_the_scenes(scenic: MissionBrief) -> None:
    assert known_kinds(scenic.world) == ("person", "animal", "object", "place", "dog")


def test_the_scene_follows_what_is_introduced(scenic: MissionBrief) -> None:
    cast = Cast(scenic, ())
    assert cast.scene is scenic.world
    cast.introduce("Anna", "person")
    assert "anna" in cast.scene.by_id
    cast.introduce("Anna", "person")
    assert "anna-2" in cast.scene.by_id, "ids are unique even where names are not"


def test_ids_go_before_names(scenic: MissionBrief) -> None:
    """A second entity is labelled with the id of the first; the id means the first."""
    cast = Cast(scenic, ())
    cast.introduce("mom", "person")
    found = cast.find("mom")
    assert found is not None
    assert found.id == "mom"
