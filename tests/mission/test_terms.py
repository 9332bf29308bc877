"""What is asked of a mission as a whole: checked when the brief is made, and who is left then."""

from __future__ import annotations

from typing import Any

import pytest

from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.position import Position
from missiontree.mission.terms import NO_TERMS, Terms
from tests.builders import brief_of, paper_fleet

FLEET = Fleet(
    (
        RobotType(id="drone", count=3, position=Position(1, 2), max_in_use=2, capabilities={"search": 0.9}),
        RobotType(id="rover", robots=(Robot(id="red"), Robot(id="blue", remaining={"energy_j": 7}))),
    ),
    total_limits={"energy_j": 50},
)


def test_nothing_left_out_leaves_the_fleet_as_it_is() -> None:
    assert NO_TERMS.team_of(FLEET) is FLEET


def test_a_type_left_out_is_gone_and_the_total_stays() -> None:
    team = Terms(without=("rover",)).team_of(FLEET)
    assert (tuple(team.by_id), team.total_limits) == (("drone",), {"energy_j": 50})


def test_robots_left_out_leave_the_others_with_their_names_places_and_budgets() -> None:
    team = Terms(without=("drone-2", "red")).team_of(FLEET)
    drones, rovers = team.types
    assert [(robot.id, robot.position) for robot in drones.members] == [
        ("drone-1", Position(1, 2)),
        ("drone-3", Position(1, 2)),
    ]
    assert [(robot.id, robot.remaining) for robot in rovers.members] == [("blue", {"energy_j": 7})]
    assert drones.usable == 2


def test_a_type_all_of_whose_robots_are_left_out_is_gone() -> None:
    assert tuple(Terms(without=("red", "blue")).team_of(FLEET).by_id) == ("drone",)


def test_so_many_may_be_in_use_as_there_are_at_most() -> None:
    assert [kind.usable for kind in FLEET.types] == [2, 2]
    assert RobotType(id="r", count=2, max_in_use=9).usable == 2


def test_a_name_of_a_type_and_of_a_robot_means_the_type() -> None:
    fleet = Fleet((RobotType(id="solo", robots=(Robot(id="solo"), Robot(id="other"))), RobotType(id="r", count=1)))
    assert tuple(Terms(without=("solo",)).team_of(fleet).by_id) == ("r",)
    assert Terms(require=("solo",)).required_robots(fleet) == ()


def test_who_must_take_part_is_told_by_type() -> None:
    terms = Terms(require=("blue", "drone", "red", "blue"))
    assert terms.required_by_type(FLEET) == {"rover": ("blue", "red"), "drone": ("drone",)}
    assert terms.required_robots(FLEET) == ("blue", "red", "blue")


def test_of_all_minima_that_apply_the_highest_counts() -> None:
    terms = Terms(min_quality={"Search": 0.5, "search": 0.8, "SearchAndFollow": 0.6})
    assert terms.least_quality("search", ("Search", "SearchAndFollow")) == 0.8
    assert terms.least_quality("follow", ("Follow", "SearchAndFollow")) == 0.6
    assert terms.least_quality("follow", ("Follow",)) == 0
    assert Terms(min_quality=0.4).least_quality("anything", ()) == 0.4


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"without": ("ghost",)}, "without names 'ghost'"),
        ({"require": ("ghost",)}, "require names 'ghost'"),
        ({"without": ("drone", "rover")}, "leaves out every robot"),
        ({"without": ("drone-1", "drone-2", "drone-3", "rover")}, "leaves out every robot"),
        ({"without": ("rover",), "require": ("rover",)}, "'rover' is required, and left out"),
        ({"without": ("rover",), "require": ("blue",)}, "'blue' is required, and left out"),
        ({"without": ("red", "blue"), "require": ("rover",)}, "'rover' is required, and left out"),
        ({"require": ("drone-1", "drone-2", "drone-3")}, "3 robots of type 'drone' are required, and at most 2"),
        ({"min_quality": -0.1}, "min_quality must be a number, at least 0"),
        ({"min_quality": True}, "min_quality must be a number"),
        ({"min_quality": {"search": "good"}}, "min_quality.search must be a number"),
        ({"min_quality": {"Serch": 0.5}}, "min_quality names 'Serch'"),
    ],
)
def test_terms_that_cannot_be_meant_are_refused(given: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        brief_of("Mission", fleet=FLEET, **given)


def test_a_minimum_may_name_a_routine_or_a_capability() -> None:
    brief = brief_of("Mission", fleet=paper_fleet(), min_quality={"Search": 0.8, "carry": 0.5})
    assert brief.min_quality == {"Search": 0.8, "carry": 0.5}
    assert isinstance(brief.min_quality, FrozenMap)


def test_the_brief_hands_its_terms_on_with_the_stock_of_the_scene() -> None:
    brief = brief_of("Mission", fleet=FLEET, without=("red",), require=("drone",), min_quality=0.2)
    assert brief.terms == Terms(without=("red",), require=("drone",), min_quality=0.2, stock={})
    assert [robot.id for robot in brief.team.by_id["rover"].members] == ["blue"]
