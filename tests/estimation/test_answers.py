"""Questions are asked once, written down, and answered again in their estimator's place."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.errors import InputError
from missiontree.estimation.answers import ReadingOut, WritingDown
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Capability

ONE = Capability(1.0)
NUMBERS = st.sampled_from([0.0, 0.1, 1.0, 60.0])
QUESTIONS = st.tuples(
    st.sampled_from(["cart", "drone"]),
    st.sampled_from(["lift", "look"]),
    st.sampled_from(["", "dock"]),
    st.none() | NUMBERS,
    NUMBERS,
    NUMBERS,
    NUMBERS,
)


class Counting:
    """Answers with a number that no other question gets."""

    def __init__(self) -> None:
        self.asked = 0

    def estimate(self, *question: Any, **about: str) -> Estimate:
        self.asked += 1
        return Estimate(self.asked)


def ask(estimator: Any, question: tuple[Any, ...]) -> Estimate:
    robot_type, action, at, *numbers = question
    said = estimator.estimate(ONE, *numbers, robot_type=robot_type, action=action, rating="carry", at=at)
    assert isinstance(said, Estimate)
    return said


@given(st.lists(QUESTIONS, max_size=20))
def test_what_is_read_out_is_what_was_said(questions: list[tuple[Any, ...]]) -> None:
    source = Counting()
    written = WritingDown(source)
    said = [ask(written, question) for question in questions]
    assert source.asked == len(set(questions)) == len(written.answers)
    reading = ReadingOut(written.answers)
    assert [ask(reading, question) for question in questions] == said
    again = WritingDown(reading)
    for question in questions:
        ask(again, question)
    assert again.answers == written.answers


def test_what_was_never_asked_has_no_answer() -> None:
    with pytest.raises(InputError, match="no estimate of action 'lift' by robot type 'cart' at 'dock'"):
        ask(ReadingOut(()), ("cart", "lift", "dock", 1.0, 0.0, 0.0, 0.0))
