"""Readings that fit the words and that nobody can have meant."""

from __future__ import annotations

import pytest

from missiontree.authoring.methods.mention import Mention, UnclearError
from missiontree.authoring.methods.outline import Outline, leaf_of
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.refusals import Refusals
from missiontree.authoring.reading.words import words_of_text
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene
from missiontree.routines.library import built_in
from tests.authoring.reading.heard import hearing

YARD = Scene(
    places=(Entity(id="hall", kind="place"), Entity(id="shed", kind="place")),
    entities=(
        Entity(id="vase", place="hall"),
        Entity(id="blue_box", label="Blue Box"),
        Entity(id="toy", label="Toy Robot"),
    ),
)
BARE, SCENIC = hearing().refusals, hearing(YARD).refusals


def phrases(text: str, refusals: Refusals = BARE) -> tuple[Phrase, ...]:
    read = refusals.phrases.phrases(words_of_text(text))
    assert read is not None
    return read


def of_scene(name: str, kind: str = "object") -> Mention:
    return Mention(name, name, name, kind, new=False)


def test_each_and_its_own_are_several_errands() -> None:
    each, owner = phrases("each parcel"), phrases("its owner")
    with pytest.raises(UnclearError, match="not clear who 'its owner' is for each one of 'each parcel'"):
        BARE.each_its_own({"thing": each, "place": owner})
    BARE.each_its_own({"thing": each, "place": phrases("the hall")})
    BARE.each_its_own({"thing": phrases("the parcel"), "place": owner})


def test_second_place_of_a_description_is_no_second_thing() -> None:
    with pytest.raises(UnclearError, match="not clear what goes with 'in the park'"):
        BARE.two_places(phrases("the child in the park and the forest"))
    BARE.two_places(phrases("the child in the park and the dog"))
    BARE.two_places(phrases("the park and the forest"))


def test_place_that_only_says_where_must_be_where_the_scene_has_it() -> None:
    search = built_in().by_id["Search"]
    vase, hall, shed = of_scene("vase"), of_scene("hall", "place"), of_scene("shed", "place")
    outline = Outline([leaf_of(search, (vase,))])
    SCENIC.other_places(outline, {"target": (vase,), "site": (hall,)})
    with pytest.raises(UnclearError, match="the scene has vase elsewhere, not at shed"):
        SCENIC.other_places(outline, {"target": (vase,), "site": (shed,)})
    # A place that is used itself does not say where anything is.
    used = Outline([leaf_of(search, (vase,)), leaf_of(search, (shed,))])
    SCENIC.other_places(used, {"target": (vase,), "site": (shed,)})
    # Where the blue box is, the scene does not say.
    box = of_scene("blue_box")
    SCENIC.other_places(Outline([leaf_of(search, (box,))]), {"target": (box,), "site": (shed,)})


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("the girl with the red shoes and hat", "hat"),
        ("the man with a beard and glasses", "glasses"),
        ("the woman in jeans and a jacket", "a jacket"),
        ("the box of nuts and bolts", "bolts"),
        ("the owner of the dog and the cat", "the cat"),
    ],
)
def test_last_of_a_list_may_belong_to_the_description_before_it(text: str, other: str) -> None:
    with pytest.raises(UnclearError, match=f"whether '{other}' belongs to"):
        BARE.belongings(phrases(text))


@pytest.mark.parametrize(
    "text", ["the girl with the red hat", "the man with the hat and the woman", "the hall with the stage and the lab"]
)
def test_list_whose_last_stands_by_itself(text: str) -> None:
    BARE.belongings(phrases(text))


def test_second_of_two_may_be_the_name_of_the_first() -> None:
    with pytest.raises(
        UnclearError, match="whether 'Mr Rossi' is 'the driver' or somebody else; say 'and' if they are two"
    ):
        BARE.apposition(phrases("the driver, Mr Rossi"), ["find", "the", "driver", ",", "mr", "rossi"])
    BARE.apposition(phrases("the driver and Mr Rossi"), ["find", "the", "driver", "and", "mr", "rossi"])
    BARE.apposition(
        phrases("the driver, Mr Rossi, the cook"), ["the", "driver", ",", "mr", "rossi", ",", "the", "cook"]
    )
    BARE.apposition(phrases("the box, the crate"), ["the", "box", ",", "the", "crate"])


@pytest.mark.parametrize("text", ["unit 3", "the blorp", "crate 4"])
def test_what_is_evacuated_may_be_a_place_or_somebody(text: str) -> None:
    with pytest.raises(UnclearError, match=f"'{text}' may be a place, or somebody; say 'the people in {text}'"):
        BARE.evacuated(phrases(text))


@pytest.mark.parametrize("text", ["the hall", "bus 2", "the nurses", "everyone", "them", "Anna", "the crate"])
def test_who_is_evacuated_is_known(text: str) -> None:
    BARE.evacuated(phrases(text))


def new(label: str) -> Mention:
    return Mention(label, label, label, "animal")


@pytest.mark.parametrize("label", ["Bigger Bear", "Tallest Bear", "Oldest", "Hungriest of the Bears"])
def test_bigger_or_biggest_of_those_named_is_nobody_new(label: str) -> None:
    said = [((new("Bear 1"), new("Bear 2")),)]
    with pytest.raises(UnclearError, match=f"not clear which one '{label}' is"):
        BARE.compared([new(label)], said)


def test_tallest_of_those_who_were_not_named_is_a_name() -> None:
    BARE.compared([new("Tallest Bear")], [((new("Lion 1"),),)])
    BARE.compared([new("Older Brother")], [])
    BARE.compared([of_scene("Bigger Bear", "animal")], [])  # the scene has it


def test_what_it_is_for_is_no_place_to_go() -> None:
    with pytest.raises(UnclearError, match="'to drink' may say what it is for"):
        BARE.done_there(phrases("drink"))
    BARE.done_there(phrases("the drink"))
    BARE.done_there(phrases("school"))
