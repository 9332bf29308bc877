"""What changes cost, by default and as the user sets it."""

from __future__ import annotations

import pytest

from missiontree.mission.change import CHANGE_KINDS, Change
from missiontree.mission.costs import DEFAULT_COSTS, DEFAULTS, Costs, Price


def test_every_kind_of_change_has_a_default_cost() -> None:
    assert set(DEFAULTS) == set(CHANGE_KINDS)


def test_a_larger_number_costs_more_by_the_share_by_which_it_grows() -> None:
    # 600 J to 900 J is half as much again: 4 + 2 * 0.5.
    raised = Change(kind="raise_limit", target="rover", name="energy_j", was=600, to=900)
    assert DEFAULT_COSTS.of(raised) == 5


def test_a_number_that_was_nothing_counts_as_doubled() -> None:
    assert DEFAULT_COSTS.of(Change(kind="raise_stock", name="medkits", was=0, to=3)) == 5


def test_a_part_costs_by_the_routines_that_are_left_out() -> None:
    assert DEFAULT_COSTS.of(Change(kind="drop_part", target="find"), times=3) == 36


def test_the_user_prices_a_kind_and_single_robot_types() -> None:
    costs = Costs({"add_robot": Price(fixed=4, of={"drone": 1})})
    assert costs.of(Change(kind="add_robot", target="rover", was=1, to=2)) == 4
    assert costs.of(Change(kind="add_robot", target="drone", was=1, to=2)) == 1
    assert costs.of(Change(kind="open_way", target="a - b")) == 2


def test_a_number_alone_is_a_cost_whatever_the_size_of_the_change() -> None:
    costs = Costs({"extend_deadline": 3})
    assert costs.of(Change(kind="extend_deadline", was=60, to=600)) == 3


def test_a_kind_that_there_is_not_is_refused_with_those_there_are() -> None:
    with pytest.raises(
        ValueError,
        match=r"costs name 'buy_robot'; the nearest is 'add_robot'; changes are take_off_without, .*drop_part",
    ):
        Costs({"buy_robot": Price(fixed=1)})
