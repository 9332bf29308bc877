"""Robots that the mission leaves out, or asks for throughout, are taken out of its words."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.clauses import clauses_of
from missiontree.authoring.reading.exclusions import Standing, robots_restricted, standing_orders
from missiontree.authoring.reading.words import words_of_text
from missiontree.mission.fleet import Capability, Fleet, RobotType
from tests.authoring.reading.heard import LEXICON, only_by

ABLE = {"search": Capability(quality=1.0)}
FLEET = Fleet(
    types=(
        RobotType(id="drone", label="Drone", count=2, capabilities=ABLE),
        RobotType(id="crawler", label="Crawler", count=1, capabilities=ABLE),
        RobotType(id="tele_robot", label="Tele-Robot", count=1, capabilities=ABLE),
    )
)
DRONE, CRAWLER = ("drone",), ("crawler",)


def standing(text: str, *known: str) -> Standing:
    return standing_orders(words_of_text(text), FLEET, LEXICON, frozenset(known))


def spoken(made: Standing) -> str:
    """The words that are left, without signs."""
    return " ".join(word.text for word in made.words if word.text not in {",", ".", "!"})


@pytest.mark.parametrize(
    "text",
    [
        "Find the cat without the drone.",
        "Find the cat, but not with the drone.",
        "Find the cat but do not use the drone.",
        "Find the cat, and don't use drones for this.",
        "Without using the drone, find the cat.",
        "Find the cat using no drones.",
        "Find the cat by any robot but the drone.",
        "Find the cat, the drone must not be used.",
        "Find the cat with any robot other than the drone.",
    ],
)
def test_left_out_in_a_sentence_is_left_out_in_that_sentence(text: str) -> None:
    made = standing(f"{text} Go to the gate.")
    assert spoken(made).lower() == "find the cat go to the gate"
    assert (made.without(0), made.without(1)) == (DRONE, ())


@pytest.mark.parametrize(
    "text",
    [
        "Find the cat. Do not use the drone. Go to the gate.",
        "Do not use the drone. Find the cat. Go to the gate.",
        "The drone is not available. Find the cat. Go to the gate.",
        "Find the cat. Please do not use the drones at all. Go to the gate.",
        "Find the cat. No drones. Go to the gate.",
        "Find the cat. Go to the gate. And never use the drone!",
    ],
)
def test_left_out_in_a_sentence_of_its_own_is_left_out_throughout(text: str) -> None:
    made = standing(text)
    assert made.left_out_throughout == DRONE
    assert made.left_out == {}
    assert all(made.without(number) == DRONE for number in range(4))
    assert spoken(made) == "Find the cat Go to the gate"


@pytest.mark.parametrize(
    "text",
    [
        "Find the cat with neither the drone nor the crawler",
        "Find the cat without the drone or the crawler",
        "Find the cat using neither drones nor crawlers",
        "Find the cat without the drone and without the crawler",
        "Find the cat with any robot except the drone and the crawler",
    ],
)
def test_several_are_left_out_at_once(text: str) -> None:
    made = standing(text)
    assert made.without(0) == (*DRONE, *CRAWLER)
    assert spoken(made) == "Find the cat"


def test_what_one_sentence_and_the_mission_leave_out_adds_up() -> None:
    made = standing("Find the cat without the crawler. Go to the gate. Do not use the drone.")
    assert made.without(0) == (*CRAWLER, *DRONE)
    assert made.without(1) == DRONE


@pytest.mark.parametrize(
    "text", ["Send any robot but the drone to find the cat.", "Use any robot except the drone to find the cat."]
)
def test_any_robot_but_one_is_still_a_robot_that_is_sent(text: str) -> None:
    made = standing(text)
    assert spoken(made).split(maxsplit=1)[1] == "a robot to find the cat"
    assert made.without(0) == DRONE


@pytest.mark.parametrize(
    "text",
    [
        "Only use drones. Find the cat.",
        "Find the cat. Use only the drone.",
        "Find the cat. Use the drone for everything.",
        "Find the cat. Only use the drone for this mission.",
        "Find the cat and use the drone for all tasks.",
        "Find the cat, only using the drone.",
    ],
)
def test_only_these_are_asked_for_throughout(text: str) -> None:
    made = standing(text)
    assert made.asked_throughout == DRONE
    assert made.left_out_throughout == ()
    assert spoken(made) == "Find the cat"


@pytest.mark.parametrize(
    "text",
    [
        "Do not use the drone to find the cat.",  # whether the cat is to be found is left open
        "Use only the drone to find the cat.",  # said of one task
        "Find the cat using only the drone.",
        "Use the drone to find the cat.",
        "Find the cat without the balloon.",
        "Find the cat without noise.",
        "Find the cat.",
        "The drone must find the cat.",
        "",
    ],
)
def test_words_that_are_kept(text: str) -> None:
    assert standing(text) == Standing(words_of_text(text))


def test_what_the_scene_calls_so_is_no_robot() -> None:
    text = "Find the cat without the drone"
    assert standing(text, "drone").words == words_of_text(text)


def test_fleet_without_a_name_of_its_own_changes_nothing() -> None:
    names = frozenset({"drone", "drones"})
    fleet = Fleet(types=FLEET.types[:1])
    words = words_of_text("Find the cat without the drone")
    assert standing_orders(words, fleet, LEXICON, names) == Standing(words)


def test_label_of_several_words_is_known_however_it_is_written() -> None:
    for name in ("tele_robot", "tele robot", "Tele-Robot", "tele-robots"):
        assert standing(f"Find the cat without the {name}").without(0) == ("tele_robot",)


def test_clauses_get_what_is_said_of_their_sentence() -> None:
    clauses = clauses_of(words_of_text("find the cat. go to the gate"), LEXICON)
    made = Standing((), {0: CRAWLER}, DRONE, ("tele_robot",))
    first, second = robots_restricted(clauses, made)
    assert (first.without, second.without) == ((*CRAWLER, *DRONE), DRONE)
    assert first.asked == second.asked == (("tele_robot",),)


def test_robot_that_a_clause_asks_for_itself_is_kept_if_the_mission_allows_it() -> None:
    (clause,) = clauses_of(words_of_text("find the cat"), LEXICON)
    made = Standing((), {}, (), (*DRONE, "tele_robot"))
    assert robots_restricted([only_by(clause, "drone")], made)[0].asked == (DRONE,)
    assert robots_restricted([clause], Standing(()))[0].asked == ()
    # One that the mission does not allow is a second naming, and two namings are not understood.
    assert robots_restricted([only_by(clause, "crawler")], made)[0].asked == (CRAWLER, (*DRONE, "tele_robot"))
