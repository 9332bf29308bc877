"""Seconds become ticks: rounded up, float noise forgiven."""

from __future__ import annotations

import pytest

from missiontree.mission.ticks import seconds, ticks


@pytest.mark.parametrize(
    ("duration_s", "count"),
    [
        (0.0, 0),
        (1.0, 1000),
        (0.0001, 1),  # a tenth of a tick is a whole one: rounded up
        (1.0001, 1001),
        (0.1 + 0.2, 300),  # 0.30000000000000004 is meant as 0.3
        (86_400.0 * 3 + 0.1 + 0.2, 259_200_300),  # noise grows with the number: three days and 0.3 s
    ],
)
def test_durations_round_up_and_forgive_float_noise(duration_s: float, count: int) -> None:
    assert ticks(duration_s) == count


def test_sums_of_tenths_do_not_drift() -> None:
    """Ten thousand tenths, added as floats, are 1,000 s and not a tick more."""
    assert ticks(sum([0.1] * 10_000)) == 1_000_000


def test_ticks_survive_the_way_to_seconds_and_back() -> None:
    assert [ticks(seconds(count)) for count in range(0, 100_000, 7)] == list(range(0, 100_000, 7))
