"""Who does it, and who comes along."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.authoring.methods.mention import UnclearError
from missiontree.authoring.reading.doers import Doers
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.words import words_of_text
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene
from tests.authoring.reading.heard import hearing

YARD = Scene(entities=(Entity(id="blue_box", label="Blue Box"), Entity(id="toy", label="Toy Robot"), Entity(id="taxi")))
BARE, SCENIC = hearing().doers, hearing(YARD).doers


def phrases(text: str, doers: Doers = BARE) -> tuple[Phrase, ...]:
    read = doers.phrases.phrases(words_of_text(text))
    assert read is not None
    return read


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


def test_somebody_who_comes_along_may_be_meant_as_well() -> None:
    box = replace(phrases("the green box")[0], description="with the blue box")
    with pytest.raises(UnclearError, match="not clear whether 'blue box' is meant as well; say 'and' if it is"):
        SCENIC.company([box], goes=False)
    BARE.company([box], goes=False)  # nobody knows such a box, so the words only describe
    with pytest.raises(UnclearError, match="not clear whether 'with the blue box' says who or what comes along"):
        BARE.company([box], goes=True)


def test_what_is_sent_may_be_meant_to_go_by_itself() -> None:
    with pytest.raises(
        UnclearError, match="'a drone' may be meant to go there by itself, and names no robot of the fleet"
    ):
        BARE.sent(phrases("a drone"), "send")
    BARE.sent(phrases("a drone"), "bring")
    BARE.sent(phrases("the letter"), "send")


def test_who_takes_a_bus_rides() -> None:
    for text in ("the bus", "bus 4", "the escalator"):
        with pytest.raises(UnclearError, match=f"'{text}' may be the way to go there; say 'bring'"):
            BARE.ridden(phrases(text), "take")
    BARE.ridden(phrases("the bus"), "bring")
    BARE.ridden(phrases("the bag"), "take")
    SCENIC.ridden(phrases("the taxi", SCENIC), "take")


def test_what_a_routine_of_the_user_is_done_with_is_asked_about() -> None:
    with pytest.raises(UnclearError, match="whether 'with meat' says how it is done"):
        BARE.with_what(phrases("the lions with meat"))
    BARE.with_what(phrases("the lions in the yard"))


def test_who_stands_behind_together_with_may_come_along() -> None:
    words = words_of_text("go to the port together with Anna")
    with pytest.raises(UnclearError, match="whether who stands behind 'together with' comes along"):
        BARE.companions(words, ["reach"])
    BARE.companions(words, ["bring"])
