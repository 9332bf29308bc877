"""What "one", "the other crate" and "the second" stand for."""

from __future__ import annotations

import pytest

from missiontree.authoring.methods.mention import Mention, UnclearError
from missiontree.authoring.reading.ones import picked, with_noun
from missiontree.authoring.reading.phrase import Phrase
from tests.authoring.reading.heard import mention

RED, BLUE = mention("Red Crate"), mention("Blue Crate")
BALL = mention("Ball")
CRATES = tuple(mention(f"Crate {number}") for number in (1, 2, 3))
ONE = Phrase(name="blue one", text="the blue one", determined=True)
OTHER = Phrase(name="crate", text="the other crate", determined=True, other=True)
OTHERS = Phrase(name="crates", text="the other crates", determined=True, other=True)


def labels(mentions: tuple[Mention, ...]) -> list[str]:
    return [one.label for one in mentions]


def test_one_is_one_of_what_was_spoken_of() -> None:
    assert with_noun(ONE, [[(RED,)]]).name == "blue crate"
    assert with_noun(Phrase(name="one", text="the one", determined=True), [[(RED,)]]).name == "crate"


def test_number_of_a_thing_is_no_noun() -> None:
    assert with_noun(ONE, [[(CRATES[0],)]]).name == "blue crate"


@pytest.mark.parametrize(
    "phrase",
    [
        Phrase(name="blue crate", text="the blue crate", determined=True),
        Phrase(name="it", text="it", pronoun="thing"),
        Phrase(name="", text=""),
    ],
)
def test_other_phrases_stay_as_they_are(phrase: Phrase) -> None:
    assert with_noun(phrase, [[(RED,)]]) == phrase


def test_what_stood_in_the_same_slot_goes_before_others_and_what_stands_beside_before_both() -> None:
    """Bring the ball to the red crate, then the small one to the blue one."""
    said = [[(BALL,), (RED,)]]
    assert with_noun(ONE, said, slot=0).name == "blue ball"
    assert with_noun(ONE, said, slot=1).name == "blue crate"
    assert with_noun(ONE, said, slot=0, beside=(BLUE,)).name == "blue crate"


def test_the_nearest_clause_goes_first() -> None:
    assert with_noun(ONE, [[(BALL,)], [(RED,)]]).name == "blue crate"


def test_what_has_an_adjective_is_rather_told_apart_by_another() -> None:
    """Find the red crate and the ball, then the blue one: a crate, since nobody said which ball."""
    assert with_noun(ONE, [[(RED, BALL)]]).name == "blue crate"


@pytest.mark.parametrize(
    ("said", "question"),
    [
        ([[(mention("Bag"), BALL)]], "may mean bag or ball; say which"),
        ([[(mention("Crates", plural=True),)]], "which of Crates"),
        ([[(mention("Anna", "person", determined=False),)]], "not clear what 'the blue one' means"),
        ([], "not clear what 'the blue one' means"),
    ],
)
def test_one_may_be_a_question(said: list[list[tuple[Mention, ...]]], question: str) -> None:
    with pytest.raises(UnclearError, match=question):
        with_noun(ONE, said)


def test_ordinal_counts_within_the_group() -> None:
    second = Phrase(name="crate", text="the second crate", determined=True, ordinal=2)
    assert labels(picked(second, CRATES, [])) == ["Crate 2"]
    with pytest.raises(UnclearError, match="there are 1"):
        picked(second, CRATES[:1], [])


def test_the_other_of_two_is_the_one_that_was_not_named() -> None:
    assert labels(picked(OTHER, CRATES[:2], [[(CRATES[0],)]])) == ["Crate 2"]


def test_the_others_are_all_that_were_not_named_one_by_one() -> None:
    # All three were named together first, which tells none of them apart.
    assert labels(picked(OTHERS, CRATES, [[CRATES], [(CRATES[1],)]])) == ["Crate 1", "Crate 3"]


@pytest.mark.parametrize(
    ("said", "question"),
    [
        ([[CRATES]], "other than which"),
        ([[(one,)] for one in CRATES], "other than which"),
        ([[(CRATES[0],)]], "may be any of Crate 2, Crate 3"),
    ],
)
def test_the_other_may_be_a_question(said: list[list[tuple[Mention, ...]]], question: str) -> None:
    with pytest.raises(UnclearError, match=question):
        picked(OTHER, CRATES, said)
