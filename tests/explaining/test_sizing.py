"""The smallest step that is enough, and when it is proven."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from missiontree.explaining.grid import at_step, last_step, step_of
from missiontree.explaining.sizing import Size, smallest
from missiontree.mission.change import Change


@given(threshold=st.integers(1, 10**7), guesses=st.lists(st.integers(-5, 10**7), max_size=4))
def test_whatever_is_guessed_the_threshold_is_found_and_proven(threshold: int, guesses: list[int]) -> None:
    assert smallest(lambda step: step >= threshold, guesses, None) == Size(threshold, True)


@given(threshold=st.integers(2, 5000), fog=st.integers(1, 50))
def test_nothing_is_proven_where_the_step_before_was_not_decided(threshold: int, fog: int) -> None:
    def enough(step: int) -> bool | None:
        return True if step >= threshold else None if step >= threshold - fog else False

    assert smallest(enough, [], None) == Size(threshold, False)


@given(threshold=st.integers(1, 10**6), spare=st.integers(0, 10**5), start=st.integers(0, 10**6))
def test_what_was_found_for_a_step_may_do_with_a_smaller_one(threshold: int, spare: int, start: int) -> None:
    size = smallest(
        lambda step: step >= threshold, [threshold + start], None, lambda step: max(threshold, step - spare)
    )
    assert size == Size(threshold, True)


@given(threshold=st.integers(2, 10**4), blind=st.integers(1, 100))
def test_a_step_that_is_not_found_again_is_not_taken(threshold: int, blind: int) -> None:
    size = smallest(lambda step: step >= threshold, [threshold + blind], None, lambda step: threshold - 1)
    assert size is not None
    assert size.step >= threshold


def test_a_good_guess_takes_two_questions() -> None:
    asked: list[int] = []

    def enough(step: int) -> bool:
        asked.append(step)
        return step >= 800

    assert smallest(enough, [800], None) == Size(800, True)
    assert asked == [800, 799]


def test_an_end_that_is_not_enough_gives_nothing() -> None:
    assert smallest(lambda step: False, [3, 99], 20) is None


def test_numbers_grow_in_thousandths_and_robots_one_by_one() -> None:
    energy = Change(kind="raise_limit", target="arm", name="energy_j", was=600.0004)
    assert at_step(energy, 1).to == 600.001
    assert step_of(energy, 105.147) < 1
    assert step_of(energy, 600.002) == 2
    assert at_step(Change(kind="add_robot", target="arm", was=2), 3).to == 5


def test_what_is_lowered_ends_at_nothing() -> None:
    quality = Change(kind="lower_min_quality", was=0.5)
    assert at_step(quality, 100).to == 0.4
    assert last_step(quality, 20) == 500
    assert at_step(quality, 501).to == 0
    assert step_of(quality, 0.3996) == 101
