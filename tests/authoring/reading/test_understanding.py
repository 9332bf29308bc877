"""What a clause that begins with a verb asks for."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.authoring.methods.outline import Outline
from missiontree.authoring.reading.hearing import Hearing
from missiontree.authoring.reading.outcomes import Goal, Trouble, Unserved
from missiontree.authoring.reading.understanding import Understanding
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene
from tests.authoring.reading.heard import before, clause_of, hearing, only_by

YARD = Scene(
    places=(Entity(id="shed", kind="place", label="Shed"), Entity(id="field", kind="place", label="Field")),
    entities=(Entity(id="pump", label="Pump", place="shed"),),
)


def understood(text: str, heard: Hearing | None = None) -> Goal | Unserved | Trouble:
    return Understanding(heard or hearing()).understood(clause_of(text))


def goal(text: str, heard: Hearing | None = None) -> Goal:
    found = understood(text, heard)
    assert isinstance(found, Goal), found
    return found


def question(text: str, heard: Hearing | None = None) -> str:
    found = understood(text, heard)
    assert isinstance(found, Trouble)
    return found.reason.message


def calls(made: Goal) -> list[str]:
    return [leaf.label for piece in made.outline.pieces for leaf in piece.leaves]


@pytest.mark.parametrize(
    "text",
    [
        "bring the red cup to Anna tomorrow",
        "bring the red cup to Anna and Bob",
        "bring the red cup to it",
        "bring the red cup to the hall or the lab tomorrow",
        "bring the red cup to Anna and the blue cup to tomorrow",
        "bring the red cup or tomorrow to Anna",
        "get the red cup to the lobby by singing",
        "repair the red cup",
    ],
)
def test_reading_that_fails_leaves_no_trace(text: str) -> None:
    """What was described, counted or named on the way is forgotten, so that the next clause is read as if this one had not been."""
    heard = hearing()
    before(heard, "dog", "cat", kind="animal", together=True)
    was = heard.speakers.kept()
    assert not isinstance(understood(text, heard), Goal)
    assert heard.speakers == was


def test_only_the_reading_that_is_taken_leaves_a_trace() -> None:
    """Read as one, "the lobby and Bob" are two places for one thing, which is asked for; read as two, all is clear."""
    heard = hearing()
    made = goal("bring Anna to the lobby and Bob to the lab", heard)
    assert calls(made) == ["ReachAndTransport(Anna, Lobby)", "ReachAndTransport(Bob, Lab)"]
    named = [one.label for group in heard.speakers.said[-1] for one in group]
    assert named == ["Anna", "Lobby", "Bob", "Lab"]


def test_choice_names_all_its_options() -> None:
    heard = hearing()
    made = goal("go to the lobby or the lab", heard)
    (choice,) = made.outline.pieces
    assert (choice.gate, calls(made)) == ("xor", ["Reach(Lobby)", "Reach(Lab)"])
    assert [one.label for group in heard.speakers.said[-1] for one in group] == ["Lobby", "Lab"]


@pytest.mark.parametrize(
    "text",
    [
        "find cat and dog or bird",
        "go to the lobby or quickly",
    ],
)
def test_what_an_or_leaves_open_is_asked_for(text: str) -> None:
    found = understood(text)
    assert isinstance(found, Trouble)


def test_what_is_unclear_within_an_option_is_what_is_asked() -> None:
    assert "not clear what 'it' means" in question("bring it to the lobby or the lab")


def test_robots_of_a_clause_are_those_of_all_its_parts() -> None:
    clause = only_by(clause_of("go to the lobby or the lab"), "tele_robot", without=("social_robot",))
    made = Understanding(hearing()).understood(clause)
    assert isinstance(made, Goal)
    assert {leaf.resources for piece in made.outline.pieces for leaf in piece.leaves} == {("tele_robot",)}


def test_back_is_where_it_came_from() -> None:
    heard = hearing()
    goal("bring the pump from the shed to the field", heard)
    heard.speakers.next_clause()
    made = goal("take it back", heard)
    assert calls(made) == ["ReachAndTransport(Pump, Shed)"]
    assert made.returns


def test_back_is_where_the_scene_has_it() -> None:
    heard = hearing(YARD)
    goal("bring the pump to the field", heard)
    heard.speakers.next_clause()
    assert calls(goal("take the pump back", heard)) == ["ReachAndTransport(Pump, Shed)"]


def test_back_of_several_is_said_of_the_one_that_was_taken() -> None:
    heard = hearing()
    goal("bring the pump from the shed to the field and the hose to the lab", heard)
    heard.speakers.next_clause()
    assert calls(goal("take it back", heard)) == ["ReachAndTransport(Pump, Shed)"]


def test_back_is_a_question_if_nobody_knows_from_where() -> None:
    heard = hearing()
    before(heard, "pump")
    assert "not clear where 'back' is; say where to" in question("take it back", heard)


def test_back_to_somewhere_is_no_question() -> None:
    heard = hearing()
    before(heard, "pump")
    assert calls(goal("take it back to the lab", heard)) == ["ReachAndTransport(Pump, Lab)"]


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("get Anna to the lobby by guiding her", "guide Anna to the lobby"),
        ("bring the crate to the hall by carrying it", "carry the crate to the hall"),
        ("check the door by going there", "check the door"),
    ],
)
def test_how_it_is_done_says_what_is_done(text: str, plain: str) -> None:
    made = goal(text)
    assert calls(made) == calls(goal(plain))
    assert made.clause.text == text


def test_how_that_says_something_else_is_not_passed_over() -> None:
    for text in ("get Anna to the lobby by repairing her", "find the cup by carrying it"):
        assert not isinstance(understood(text), Goal)


def test_goal_that_nobody_serves_is_understood() -> None:
    found = understood("repair the door")
    assert isinstance(found, Unserved)
    assert (found.goal, found.robots_lack) == ("repair", False)


def test_capability_that_only_those_left_out_have_is_lacking() -> None:
    clause = only_by(clause_of("warn the visitors"), without=("social_robot",))
    found = Understanding(hearing()).understood(clause)
    assert isinstance(found, Unserved)
    assert (found.goal, found.robots_lack) == ("message_display", True)


@pytest.mark.parametrize(
    ("text", "detail"),
    [
        ("bring", "'bring' lacks its object"),
        ("bring the cup", "'bring' does not go with 'the cup' alone"),
        ("find the cup tomorrow", "the verb 'find' is understood, but not 'tomorrow'"),
    ],
)
def test_what_is_left_over_is_named(text: str, detail: str) -> None:
    assert detail in question(text)


def test_in_order_links_what_is_named_one_after_the_other() -> None:
    made = Understanding.in_order(goal("find the cat, the dog and the bird"))
    assert isinstance(made, Goal)
    assert [(first.label, second.label) for first, second, _ in made.outline.links] == [
        ("Search(Cat)", "Search(Dog)"),
        ("Search(Dog)", "Search(Bird)"),
    ]
    alone = replace(made, outline=Outline(made.outline.pieces[:1]))
    found = Understanding.in_order(alone)
    assert isinstance(found, Trouble)
    assert found.reason.rule == "order_of_one"
