"""A suite is loaded with what its missions speak of, and a mission that speaks of anything else is refused at its line."""

from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.evaluation.suite import load_suite

HEAD = "format: suite/1\nsetting: {0}\n{1}missions:\n  - id: {0}-01\n    say: Find Anna.\n    plan:\n      - {2}\n"
SCENE = """\
format: scene/1
entities:
  - {id: anna, kind: person}
  - {id: cup_1, label: cup}
  - {id: cup_2, label: cup}
"""


def setting(folder: Path, name: str, entry: str = "Search(Anna)", more: str = "", tail: str = "") -> Path:
    path = folder / name / "missions.yaml"
    path.parent.mkdir()
    path.write_text(HEAD.format(name, more, entry) + tail, encoding="utf-8")
    return path


def test_settings_are_loaded_in_order_with_their_worlds(tmp_path: Path) -> None:
    setting(tmp_path, "home", more="scene: scene.yaml\n")
    (tmp_path / "home" / "scene.yaml").write_text(SCENE, encoding="utf-8")
    setting(tmp_path, "farm")
    suite = load_suite(tmp_path)
    farm, home = suite.settings
    assert suite.ids == {"farm": ("farm-01",), "home": ("home-01",)}
    assert (farm.scene, home.scene is None) == (None, False)
    assert set(farm.fleet.by_id) == {"mobile_scooter", "tele_robot", "transportation_robot", "social_robot"}
    assert farm.brief(farm.missions[0]).text == "Find Anna."
    assert home.brief(home.missions[0]).scene == home.scene


@pytest.mark.parametrize(
    ("entry", "says"),
    [
        ("Serach(Anna)", "Did you mean 'Search'?"),
        ("Transport(Anna)", "has 1 arguments; Transport takes 2: agent, location"),
        ("Search(Anna) by tele_robto", "Did you mean 'tele_robot'?"),
        ("Search(Anna) not by mobile_scooter, tele_robot, transportation_robot, social_robot", "leaves no robot type"),
        ("Search(the cup)", "may mean any of cup_1, cup_2"),
    ],
)
def test_a_plan_for_another_world_is_refused_at_its_line(tmp_path: Path, entry: str, says: str) -> None:
    path = setting(tmp_path, "home", entry, more="scene: scene.yaml\n")
    (tmp_path / "home" / "scene.yaml").write_text(SCENE, encoding="utf-8")
    with pytest.raises(InputError) as refusal:
        load_suite(tmp_path)
    assert says in str(refusal.value)
    assert (refusal.value.file, refusal.value.line) == (str(path), 8)


def test_lasting_until_is_for_what_has_no_end(tmp_path: Path) -> None:
    setting(tmp_path, "home", tail="      - Follow(Anna)\n    order: [1 ~ 2]\n")
    with pytest.raises(InputError, match="Search ends by itself") as refusal:
        load_suite(tmp_path)
    assert refusal.value.line == 9


def test_names_are_unique_over_the_suite(tmp_path: Path) -> None:
    setting(tmp_path, "farm")
    second = setting(tmp_path, "home")
    second.write_text(second.read_text(encoding="utf-8").replace("home-01", "farm-01"), encoding="utf-8")
    with pytest.raises(InputError, match="'farm-01' stands twice") as refusal:
        load_suite(tmp_path)
    assert (refusal.value.file, refusal.value.line) == (str(second), 4)


def test_a_folder_without_settings_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no setting"):
        load_suite(tmp_path)


def test_a_scene_that_is_missing_is_named(tmp_path: Path) -> None:
    setting(tmp_path, "home", more="scene: scene.yaml\n")
    with pytest.raises(InputError, match=r"scene\.yaml"):
        load_suite(tmp_path)
