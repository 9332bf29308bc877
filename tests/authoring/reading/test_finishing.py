"""The words of a clause to the clause."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.finishing import finished, says_something, without_openings
from missiontree.authoring.reading.words import MARK, Word, words_of_text
from tests.authoring.reading.heard import LEXICON, shown

DRONE = Word("the drone", f"{MARK}drone")
EITHER = Word("the drone or the crawler", f"{MARK}drone|crawler")


@pytest.mark.parametrize(
    ("text", "kept", "passed"),
    [
        ("find the cat", "find the cat", ()),
        ("please find the cat", "find the cat", ("please",)),
        ("could you please find the cat quickly", "find the cat", ("could you please", "quickly")),
        ("the robots should find the cat", "find the cat", ()),
        ("find the cat , please", "find the cat", ("please",)),
        ("the cat must be found", "find the cat", ()),
        ("have the cat found", "find the cat", ()),
    ],
)
def test_verb_comes_first_and_courtesy_is_passed_over(text: str, kept: str, passed: tuple[str, ...]) -> None:
    clause = finished(words_of_text(text), LEXICON, is_event=False)
    assert clause.text == kept
    assert clause.verb is not None
    assert clause.verb.phrase == "find"
    assert clause.passed_over == passed


def test_words_that_change_what_is_asked_for_are_kept_and_named() -> None:
    clause = finished(words_of_text("find the cat unless it is at home"), LEXICON, is_event=False)
    assert clause.decisive == ("unless",)
    assert clause.text == "find the cat unless it is at home"


def test_in_that_order_is_taken_off() -> None:
    clause = finished(words_of_text("find the cat and the dog , in that order"), LEXICON, is_event=False)
    assert (clause.text, clause.in_order) == ("find the cat and the dog", True)
    assert not finished(words_of_text("in that order"), LEXICON, is_event=False).in_order


def test_robots_before_the_verb_lead() -> None:
    words = words_of_text("find the cat")
    before = finished((DRONE, *words), LEXICON, is_event=False)
    behind = finished((*words, EITHER), LEXICON, is_event=False)
    assert (before.text, before.asked, before.leads) == ("find the cat", (("drone",),), True)
    assert (behind.text, behind.asked, behind.leads) == ("find the cat", (("drone", "crawler"),), False)


def test_robots_that_are_named_twice_are_two_namings_unless_they_are_the_same() -> None:
    words = words_of_text("find the cat")
    assert finished((DRONE, *words, EITHER), LEXICON, is_event=False).asked == (("drone",), ("drone", "crawler"))
    assert finished((DRONE, *words, DRONE), LEXICON, is_event=False).asked == (("drone",),)


def test_who_is_doing_it_is_not_said_of_an_event() -> None:
    words = words_of_text("you are looking for the cat")
    event = finished(words, LEXICON, is_event=True)
    assert event.verb is not None
    assert (event.verb.phrase, event.verb.form, event.text) == ("look for", "gerund", "looking for the cat")
    assert finished(words, LEXICON, is_event=False).verb is None


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", False),
        ("hello", False),
        ("please , thank you", False),
        ("your mission is to", False),
        ("find", True),
        ("hello cat", True),
    ],
)
def test_courtesy_says_nothing(text: str, says: bool) -> None:
    assert says_something(list(words_of_text(text)), LEXICON) is says
    assert says_something([*words_of_text(text), DRONE], LEXICON) is says  # nor does a robot that is told nothing


def test_openings_are_left_out_only_before_a_verb() -> None:
    kept, passed = without_openings(list(words_of_text("please , the robots should find the cat")), LEXICON)
    assert (shown(kept), passed) == ("find the cat", ("please",))
    kept, passed = without_openings(list(words_of_text("the robots are lost")), LEXICON)
    assert (shown(kept), passed) == ("the robots are lost", ())
    assert without_openings([], LEXICON) == ([], ())
