"""A suite is loaded with what its missions speak of, and a mission that speaks of anything else is refused at its line."""

from dataclasses import replace
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


LOOSE = """\
format: suite/1
setting: home
scene: scene.yaml
missions:
  - id: home-01
    say: Find Anna.
    must: [Search(Anna), Follow(*)]
    must_not: [Reach(*)]
    order: [2 ~ 1]
    entities: [anna]
  - id: home-02
    say: Find Anna.
    fleet: fleets/small.yaml
    scene: empty.yaml
    declined: impossible
    because: search
    twin: home-01
    removed: everybody who searches
"""
SMALL = "format: fleet/1\ntypes:\n  - {id: cart, capabilities: {carry: 1}, count: 1}\n"


def loose_setting(folder: Path, text: str = LOOSE) -> Path:
    path = folder / "home" / "missions.yaml"
    (folder / "home" / "fleets").mkdir(parents=True)
    path.write_text(text, encoding="utf-8")
    (folder / "home" / "scene.yaml").write_text(SCENE, encoding="utf-8")
    (folder / "home" / "empty.yaml").write_text("format: scene/1\n", encoding="utf-8")
    (folder / "home" / "fleets" / "small.yaml").write_text(SMALL, encoding="utf-8")
    return path


def test_a_mission_may_have_a_fleet_and_a_scene_of_its_own(tmp_path: Path) -> None:
    loose_setting(tmp_path)
    (home,) = load_suite(tmp_path).settings
    first, second = (home.brief(mission) for mission in home.missions)
    assert (len(first.fleet.types), list(second.fleet.by_id)) == (4, ["cart"])
    assert first.scene == home.scene
    assert second.scene is not None
    assert second.scene.all_entities == ()


@pytest.mark.parametrize(
    ("old", "new", "line", "says"),
    [
        ("Search(Anna)", "Serach(Anna)", 7, "Did you mean 'Search'?"),
        ("Reach(*)", "'Reach(*, *)'", 8, "has 2 arguments; Reach takes 1"),
        ("Search(Anna)", "Search(the cup)", 7, "may mean any of cup_1, cup_2"),
        ("[anna]", "[cup]", 10, "'cup' may mean any of cup_1, cup_2"),
        ("2 ~ 1", "1 ~ 2", 9, "Search ends by itself"),
        ("twin: home-01", "twin: home-03", 17, "no twin 'home-03'; the suite has no such mission"),
    ],
)
def test_expectations_for_another_world_are_refused_at_their_line(
    tmp_path: Path, old: str, new: str, line: int, says: str
) -> None:
    assert LOOSE.count(old) == 1
    path = loose_setting(tmp_path, LOOSE.replace(old, new))
    with pytest.raises(InputError) as refusal:
        load_suite(tmp_path)
    assert says in str(refusal.value)
    assert (refusal.value.file, refusal.value.line) == (str(path), line)


def test_a_twin_that_is_to_be_declined_itself_is_none(tmp_path: Path) -> None:
    third = "  - id: home-03\n    say: Dance.\n    declined: impossible\n    because: dance\n"
    loose_setting(tmp_path, LOOSE.replace("twin: home-01", "twin: home-03") + third)
    with pytest.raises(InputError, match="that is to be declined, too"):
        load_suite(tmp_path)


def test_a_twin_may_stand_in_another_setting(tmp_path: Path) -> None:
    loose_setting(tmp_path, LOOSE.replace("twin: home-01", "twin: farm-01"))
    setting(tmp_path, "farm")
    assert load_suite(tmp_path).ids == {"farm": ("farm-01",), "home": ("home-01", "home-02")}


def test_a_fleet_of_its_own_that_is_missing_is_named(tmp_path: Path) -> None:
    loose_setting(tmp_path, LOOSE.replace("fleets/small.yaml", "fleets/none.yaml"))
    with pytest.raises(InputError, match=r"none\.yaml"):
        load_suite(tmp_path)


def test_a_scene_of_its_own_that_does_not_fit_is_refused_with_the_mission(tmp_path: Path) -> None:
    """The small fleet's cart starts at a place that only the setting's scene could have."""
    loose_setting(tmp_path)
    fleet = SMALL.replace("count: 1", "count: 1, place: dock")
    (tmp_path / "home" / "fleets" / "small.yaml").write_text(fleet, encoding="utf-8")
    with pytest.raises(InputError, match="'dock', which the scene does not have") as refusal:
        load_suite(tmp_path)
    assert "of home-02 do not fit together" in refusal.value.hint


def test_the_digest_is_of_what_a_verdict_depends_on(tmp_path: Path) -> None:
    """Words, expectations, fleet, scene: yes. The note: no. Whether trees are planned to their end: yes."""
    loose_setting(tmp_path)
    (home,) = load_suite(tmp_path).settings
    first, second = home.missions
    digest = home.digest(first)
    assert digest == home.digest(replace(first, note="Why not?"))
    others = [
        home.digest(second),
        home.digest(replace(first, say="Find Anna!")),
        home.digest(replace(first, must_not=())),
        home.digest(first, whole=True),
        replace(home, scene=None).digest(first),
        replace(home, fleet=home.fleets["fleets/small.yaml"]).digest(first),
    ]
    assert len({digest, *others}) == 7
