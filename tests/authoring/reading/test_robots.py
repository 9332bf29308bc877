"""Robots named by the mission become marks, and marks become the clause's robots."""

from __future__ import annotations

import pytest

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clauses import clauses_of
from missiontree.authoring.reading.robots import named_robots, robots_carried, robots_marked
from missiontree.authoring.reading.words import words_of_text
from missiontree.mission.fleet import Capability, Fleet, Robot, RobotType

LEXICON = Lexicon()
FLEET = Fleet(
    types=(
        RobotType(id="tele_robot", label="Tele-Robot", count=2, capabilities={"search": Capability(quality=1.0)}),
        RobotType(
            id="scooter",
            label="Mobile Scooter",
            robots=(Robot(id="max"),),
            capabilities={"reach": Capability(quality=1.0)},
        ),
    )
)


def robots_of(text: str) -> list[tuple[str, tuple[str, ...]]]:
    words = robots_marked(words_of_text(text), FLEET, LEXICON, frozenset())
    return [(clause.text, clause.robots) for clause in robots_carried(clauses_of(words, LEXICON))]


@pytest.mark.parametrize(
    "text",
    [
        "find the cat with the tele-robot",
        "find the cat using a Tele Robot",
        "with the tele-robot, find the cat",
        "use tele_robot to find the cat",
        "send the tele-robot to find the cat",
        "the tele-robot should please find the cat",
        "tele-robot: find the cat",
        "tele-robot, find the cat",
    ],
)
def test_every_way_of_naming_a_robot_leaves_the_same_clause(text: str) -> None:
    assert [(text.removeprefix("please "), robots) for text, robots in robots_of(text)] == [
        ("find the cat", ("tele_robot",))
    ]


def test_robot_that_is_sent_somewhere_goes_there() -> None:
    assert robots_of("send the tele-robot to the gate") == [("go to the gate", ("tele_robot",))]


def test_name_of_the_only_robot_of_a_type_stands_for_the_type() -> None:
    assert robots_of("go to the gate with max") == [("go to the gate", ("scooter",))]
    # One of two robots of a type cannot be said by its type, so its name is left where it stands.
    assert robots_of("go to the gate with tele_robot-1") == [("go to the gate with tele_robot-1", ())]


def test_robot_named_before_the_verb_does_what_is_joined_by_and_until_another_is_named_or_the_sentence_ends() -> None:
    assert robots_of("use the tele-robot to find the cat and follow it. Go home") == [
        ("find the cat", ("tele_robot",)),
        ("follow it", ("tele_robot",)),
        ("Go home", ()),
    ]
    assert robots_of("the tele-robot must find the cat and the mobile scooter must follow it")[1] == (
        "follow it",
        ("scooter",),
    )


def test_robot_named_behind_does_only_that() -> None:
    assert robots_of("find the cat with the tele-robot and follow it") == [
        ("find the cat", ("tele_robot",)),
        ("follow it", ()),
    ]


def test_robot_that_is_told_nothing_leaves_a_clause_of_its_own() -> None:
    assert robots_of("find the cat. With the tele-robot.") == [("find the cat", ()), ("With the tele-robot", ())]


def test_what_the_scene_calls_so_is_no_robot() -> None:
    words = words_of_text("find the cat with max")
    assert robots_marked(words, FLEET, LEXICON, frozenset({"max"})) == words


def test_nobody_can_write_a_mark() -> None:
    assert robots_of("find the cat @tele_robot")[0][1] == ()


def test_plurals_are_known_so_that_they_can_be_refused() -> None:
    names = named_robots(FLEET, frozenset())
    assert [shown for shown, _, _ in names.within(["the", "tele-robots", "and", "max"])] == ["Tele-Robot", "max"]
