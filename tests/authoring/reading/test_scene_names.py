"""Who of the scene is called so."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.authoring.methods.mention import UnclearError
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.scene_names import SceneNames
from missiontree.mission.entity import Entity
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene

SCENE = Scene(
    places=(
        Entity(id="hall", kind="place", label="Great Hall", aliases=("foyer",)),
        Entity(id="ward_3", kind="place", label="Ward 3"),
        Entity(id="ward_4", kind="place", label="Ward 4"),
    ),
    entities=(
        Entity(id="brown", kind="person", label="Anna Brown"),
        Entity(id="kid", kind="child", label="Tim"),
        Entity(id="crate_red", label="Crate 1", traits=("red",), place="hall"),
        Entity(id="crate_blue", label="Crate 2", traits=("blue",), place="ward_3"),
        Entity(id="rex", kind="dog", label="Rex", position=Position(1, 1)),
        Entity(id="fido", kind="dog", label="Fido"),
    ),
    kinds={"dog": "animal", "child": "person"},
)
NAMES = SceneNames(SCENE, complete=True)


def phrase(name: str, **fields: object) -> Phrase:
    return replace(Phrase(name=name, text=f"the {name}", determined=True), **fields)  # type: ignore[arg-type]


def called(name: str, **fields: object) -> list[str]:
    return [entity.id for entity in NAMES.called(phrase(name, **fields))]


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("hall", ["hall"]),  # by id
        ("Great Hall", ["hall"]),  # by label
        ("foyer", ["hall"]),  # by alias
        ("ward_3", ["ward_3"]),
        ("ward 3", ["ward_3"]),
        ("child", ["kid"]),  # by kind
        ("Anna", ["brown"]),  # by the first name of a person
        ("red crate", ["crate_red"]),  # by a trait
        ("Brown's crate", ["crate_red", "crate_blue"]),  # whose they are, the scene does not say
        ("green crate", []),
        ("object", []),  # "the object" may be anything
        ("cellar", []),
    ],
)
def test_one_is_called_by_name_alias_kind_or_trait(name: str, expected: list[str]) -> None:
    assert called(name) == expected


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("crates", ["crate_red", "crate_blue"]),
        ("wards", ["ward_3", "ward_4"]),
        ("dogs", ["rex", "fido"]),
        ("people", ["brown", "kid"]),
        ("animals", ["rex", "fido"]),
        ("places", ["hall", "ward_3", "ward_4"]),
        ("things", ["crate_red", "crate_blue"]),
        ("red crates", ["crate_red"]),
        ("cellars", []),
    ],
)
def test_all_of_a_noun_are_each_of_those(name: str, expected: list[str]) -> None:
    assert called(name, every=True) == expected


def test_the_other_one_is_one_of_all_of_that_noun() -> None:
    assert called("crate", other=True) == ["crate_red", "crate_blue"]


def test_what_is_said_of_several_chooses_among_them() -> None:
    assert called("crate", states=("blue",)) == ["crate_blue"]
    assert called("crate", description="that is blue") == ["crate_blue"]
    assert called("dog", lost=True) == ["fido"]  # where Rex is, the scene knows
    assert called("crate", states=("heavy",)) == ["crate_red", "crate_blue"]
    with pytest.raises(UnclearError, match="does not say which of Crate 1, Crate 2 are heavy"):
        called("crates", every=True, states=("heavy",))


def at(name: str, description: str, *, complete: bool = True, every: bool = False) -> list[str]:
    names, wanted = SceneNames(SCENE, complete), phrase(name, description=description, every=every)
    return [entity.id for entity in names.at_place(names.called(wanted), wanted)]


def test_where_they_are_said_to_be_chooses_too() -> None:
    assert at("crate", "in the great hall") == ["crate_red"]
    assert at("crate", "in ward 3") == ["crate_blue"]
    assert at("dog", "in the hall") == ["rex", "fido"]  # where the dogs are, nobody knows
    assert at("cellar", "in the hall") == []
    with pytest.raises(UnclearError, match="the scene has Crate 1 and Crate 2 elsewhere, not at Ward 4"):
        at("crate", "in ward 4")


def test_place_that_the_scene_does_not_have_leaves_several_open() -> None:
    assert at("crate", "in the attic") == ["crate_red", "crate_blue"]
    with pytest.raises(UnclearError, match="does not say which of crates are 'in the attic'"):
        at("crates", "in the attic", every=True)
    assert at("crates", "in the attic", every=True, complete=False) == ["crate_red", "crate_blue"]


@pytest.mark.parametrize(
    ("name", "expected"),
    [("crate 3", ["crate_red", "crate_blue"]), ("green crate", ["crate_red", "crate_blue"]), ("crate", [])],
)
def test_alike_is_what_has_the_same_noun(name: str, expected: list[str]) -> None:
    assert [entity.id for entity in NAMES.alike(phrase(name))] == expected


def test_slip_in_a_name_is_asked_for() -> None:
    with pytest.raises(UnclearError, match=r"called 'Fiddo'; did you mean Fido\?"):
        NAMES.refuse_misspelt(phrase("Fiddo"))
    NAMES.refuse_misspelt(phrase("Otto"))
    NAMES.refuse_misspelt(phrase("crate 3"))  # numbers are never slips


def test_several_of_which_there_are_none_are_asked_for_if_somebody_wrote_down_what_there_is() -> None:
    with pytest.raises(UnclearError, match="has no 'cats'; its animals are Rex, Fido"):
        NAMES.refuse_none(phrase("cats", every=True))
    NAMES.refuse_none(phrase("cat"))
    SceneNames(SCENE, complete=False).refuse_none(phrase("cats", every=True))
