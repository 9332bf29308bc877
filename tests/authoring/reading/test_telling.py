"""Clauses that ask for nothing."""

from __future__ import annotations

import pytest

from missiontree.authoring.methods.outline import Outline, leaf_of
from missiontree.authoring.reading.hearing import Hearing
from missiontree.authoring.reading.outcomes import Goal, Trouble, Unserved
from missiontree.authoring.reading.telling import Telling
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene
from missiontree.routines.library import built_in
from tests.authoring.reading.heard import clause_of, hearing, mention


def told(text: str, heard: Hearing | None = None) -> Goal | Unserved | Trouble:
    return Telling(heard or hearing()).told(clause_of(text))


def trouble(text: str, heard: Hearing | None = None) -> Trouble:
    found = told(text, heard)
    assert isinstance(found, Trouble)
    return found


def labels(heard: Hearing) -> list[str]:
    return [one.label for groups in heard.speakers.said for group in groups for one in group]


def test_danger_is_kept_with_where_it_is() -> None:
    heard = hearing()
    goal = told("There is a fire in the kitchen", heard)
    assert isinstance(goal, Goal)
    assert goal.outline.pieces == []
    assert "danger: fire" in goal.reading
    assert heard.hazards == ["fire"]
    assert labels(heard) == ["Kitchen"]


def test_who_is_stated_to_be_lost_is_lost_from_then_on() -> None:
    heard = hearing()
    goal = told("The cat and the dog are lost", heard)
    assert isinstance(goal, Goal)
    assert goal.reading.endswith("a statement; Cat, Dog: lost")
    assert heard.speakers.lost == {"Cat", "Dog"}
    assert labels(heard) == ["Cat", "Dog"]


def test_who_is_in_danger_is_not_lost() -> None:
    heard = hearing()
    assert isinstance(told("The house is on fire", heard), Goal)
    assert heard.hazards == ["fire"]
    assert heard.speakers.lost == set()


@pytest.mark.parametrize("text", ["Anna is waiting in the lobby", "Anna is thirsty", "There is a ladder in the hall"])
def test_without_a_scene_it_is_told_that_the_plan_makes_no_use_of_it(text: str) -> None:
    heard = hearing()
    goal = told(text, heard)
    assert isinstance(goal, Goal)
    (reason,) = goal.assumptions
    assert (reason.rule, reason.severity) == ("description_unused", "assumption")
    assert labels(heard)


def test_the_scene_has_the_last_word_on_where_somebody_is() -> None:
    scene = Scene(
        places=(Entity(id="lobby", kind="place"), Entity(id="attic", kind="place")),
        entities=(Entity(id="anna", kind="person", label="Anna", place="lobby"),),
    )
    goal = told("Anna is waiting in the lobby", hearing(scene))
    assert isinstance(goal, Goal)
    assert goal.assumptions == ()
    found = trouble("Anna is waiting in the attic", hearing(scene))
    assert "the scene has Anna elsewhere, not at attic" in found.reason.message


def test_robot_is_not_told_of() -> None:
    assert "is a robot of the fleet" in trouble("The tele-robot is lost").reason.message


@pytest.mark.parametrize(
    ("text", "rule", "hint"),
    [
        ("Serch the cup", "verb_unknown", "Did you mean 'search'? Begin with what is to be done"),
        ("The weather looks fine", "verb_unknown", "Begin with what is to be done"),
        ("Use the drone", "robot_unclear", "Name a robot type and what it does in one sentence"),
        ("Use the tele-robot", "robot_unclear", "'Use the Tele-Robot to find ...'"),
    ],
)
def test_why_it_is_not_understood(text: str, rule: str, hint: str) -> None:
    reason = trouble(text).reason
    assert reason.rule == rule
    assert hint in reason.hint
    assert reason.found == text


def test_statement_that_changes_nothing_is_told() -> None:
    heard = hearing()
    telling = Telling(heard)
    assert isinstance(telling.told(clause_of("The cat is lost")), Goal)
    assert isinstance(telling.told(clause_of("The house is on fire")), Goal)
    cat = leaf_of(built_in().by_id["Search"], (mention("Cat", "animal"),))
    searching = Goal(clause_of("find the cat"), Outline([cat]), "")
    assert [reason.node for reason in telling.unused_statements([searching])] == ["House"]
    assert [reason.node for reason in telling.unused_statements([])] == ["Cat", "House"]
    heard.called_for.add("fire")  # somebody was called for it
    assert [reason.node for reason in telling.unused_statements([])] == ["Cat"]


@pytest.mark.parametrize(
    ("text", "verb"), [("wax the skis", "wax"), ("paint it", "paint"), ("sample all casks", "sample")]
)
def test_order_with_a_verb_that_nobody_serves_is_not_misunderstood(text: str, verb: str) -> None:
    found = told(text)
    assert isinstance(found, Unserved)
    assert found.verb == verb


@pytest.mark.parametrize(
    "text",
    [
        "wax skis",  # may be a name
        "paint the fence is dry",  # tells something
        "blorp the box",
        "wax",
    ],
)
def test_what_may_be_no_order_is_asked_about(text: str) -> None:
    assert trouble(text).reason.rule == "verb_unknown"
