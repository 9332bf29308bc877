"""Times in words, and ticks: round steps, one unit per axis, never more than there is room for."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.reporting.gantt.time import exact, in_words, span, ticks


@pytest.mark.parametrize(
    ("time_s", "words"),
    [
        (0, "0 s"),
        (0.001, "0.001 s"),
        (0.3, "0.3 s"),
        (95.5, "95.5 s"),
        (212, "212 s"),
        (599.96, "600 s"),
        (600, "10 min"),
        (1246.382, "20 min 46 s"),
        (7199.6, "2 h"),
        (7_260, "2 h 1 min"),
        (3 * 86_400 + 4 * 3_600 + 60, "3 d 4 h"),
        (2e9, "23,148 d"),
    ],
)
def test_times_are_said_as_people_say_them(time_s: float, words: str) -> None:
    assert in_words(time_s) == words


def test_a_time_beside_a_longer_one_is_said_in_the_same_way() -> None:
    assert in_words(533) == "533 s"
    assert in_words(533, least=0) == "8 min 53 s"
    assert in_words(42, least=0) == "42 s"


@pytest.mark.parametrize(("time_s", "words"), [(0, "0 s"), (324.971, "324.971 s"), (20, "20 s"), (0.1, "0.1 s")])
def test_exact_times_go_to_the_millisecond(time_s: float, words: str) -> None:
    assert exact(time_s) == words


@pytest.mark.parametrize(
    ("start_s", "end_s", "makespan_s", "words"),
    [
        (0, 5, 212, "0 to 5 s"),
        (88.7, 100.08, 145.5, "88.7 to 100.1 s"),
        (0.002, 0.02, 0.3, "0.002 to 0.02 s"),
        (5, 5, 64, "at 5 s"),
        (149.7, 189.96, 719, "2:29.7 to 3:10 min"),
        (3_599.96, 3_601, 7_000, "60:00 to 60:01 min"),
        (9_004, 9_005, 5 * 3_600, "2:30:04 to 2:30:05 h"),
        (183_900, 183_900, 10 * 86_400, "at 51:05:00 h"),
    ],
)
def test_spans_are_told_in_the_unit_of_the_axis(start_s: float, end_s: float, makespan_s: float, words: str) -> None:
    assert span(start_s, end_s, makespan_s) == words


@pytest.mark.parametrize(
    ("makespan_s", "most", "labels"),
    [
        (7, 10, "0 1s 2s 3s 4s 5s 6s 7s"),
        (212, 5, "0 50s 100s 150s 200s"),
        (0.3, 3, "0 0.1s 0.2s 0.3s"),
        (1246.382, 6, "0 5min 10min 15min 20min"),
        (4 * 3_600, 4, "0 1h 2h 3h 4h"),
        (10 * 86_400, 5, "0 2d 4d 6d 8d 10d"),
        (1000 * 86_400, 5, "0 200d 400d 600d 800d 1000d"),
    ],
)
def test_ticks_are_round_and_carry_their_unit(makespan_s: float, most: int, labels: str) -> None:
    assert [tick.label.replace(" ", "") for tick in ticks(makespan_s, most)] == labels.split()


@given(st.floats(0.001, 1e12), st.integers(1, 40))
def test_there_are_never_more_steps_than_asked_for_and_none_beyond_the_end(makespan_s: float, most: int) -> None:
    found = [tick.time_s for tick in ticks(makespan_s, most)]
    assert found[0] == 0
    assert len(found) <= most + 1
    assert found[-1] <= makespan_s * (1 + 1e-6)
    gaps = [after - before for before, after in pairwise(found)]
    assert not gaps or max(gaps) - min(gaps) <= 1e-6 * max(found)
    assert not gaps or found[-1] + gaps[0] > makespan_s * (1 - 1e-6)  # no tick is missing
