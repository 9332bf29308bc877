"""Readings that fit the words and that nobody can have meant."""

from __future__ import annotations

from dataclasses import replace

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


def test_robot_is_nobody_to_whom_something_is_done() -> None:
    with pytest.raises(UnclearError, match="does things"):
        BARE.robots(phrases("the old robot"))
    with pytest.raises(UnclearError, match="'Tele-Robot' is a robot of the fleet; say who does it"):
        BARE.robots(phrases("the cat, the tele-robot"))
    BARE.robots(phrases("the cat and the dog"))
    SCENIC.robots(phrases("the toy robot", SCENIC))


def test_what_it_shall_be_done_with_is_no_description() -> None:
    with pytest.raises(UnclearError, match="'with the crane' may say who does it, and names no robot of the fleet"):
        BARE.instruments(phrases("the box with the crane"))
    BARE.instruments(phrases("the woman with the red hat"))
    BARE.instruments(phrases("the box near the crane"))


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


def test_somebody_who_comes_along_may_be_meant_as_well() -> None:
    box = replace(phrases("the green box")[0], description="with the blue box")
    with pytest.raises(UnclearError, match="not clear whether 'blue box' is meant as well; say 'and' if it is"):
        SCENIC.company([box], goes=False)
    BARE.company([box], goes=False)  # nobody knows such a box, so the words only describe
    with pytest.raises(UnclearError, match="not clear whether 'with the blue box' says who or what comes along"):
        BARE.company([box], goes=True)


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
