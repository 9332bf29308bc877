"""Plain data is what a person would have written."""

import pytest

from missiontree.formats.plain import to_plain
from missiontree.mission.fleet import Capability, CostModel, Fleet, Robot, RobotType
from missiontree.mission.position import Position
from missiontree.mission.tree import MissionNode


def test_numbers_are_written_whole_where_they_are_and_hold_them_exactly() -> None:
    assert [repr(to_plain(number)) for number in (1.0, -0.0, 2.5, 3, 1e300)] == ["1", "0", "2.5", "3", "1e+300"]
    assert to_plain(True) is True


def test_a_capability_is_a_number_where_it_is_only_a_quality() -> None:
    assert to_plain(Capability(0.5)) == 0.5
    assert to_plain(Capability(0.5, cost=CostModel(per_m=2))) == {"quality": 0.5, "cost": {"per_m": 2}}


def test_a_label_is_left_out_where_it_is_the_id_and_only_there() -> None:
    assert to_plain(RobotType(id="a", count=1)) == {"id": "a", "count": 1}
    assert to_plain(RobotType(id="a", label="A", count=1)) == {"id": "a", "label": "A", "count": 1}
    # a tree's label has no default: it is required, so it stays even where it is the id
    assert to_plain(MissionNode(id="a", label="a")) == {"id": "a", "label": "a"}


def test_an_empty_list_stays_where_it_differs_from_none() -> None:
    assert to_plain(RobotType(id="a", count=1, zones=())) == {"id": "a", "count": 1, "zones": []}


def test_values_nest_in_lists_and_mappings() -> None:
    fleet = Fleet((RobotType(id="a", robots=(Robot(id="r", position=Position(1, 2), remaining={"e": 3}),)),))
    robot = {"id": "r", "position": {"x_m": 1, "y_m": 2}, "remaining": {"e": 3}}
    assert to_plain({"fleet": fleet}) == {"fleet": {"types": [{"id": "a", "robots": [robot]}]}}


def test_what_is_no_data_is_refused() -> None:
    with pytest.raises(TypeError, match="a set has no place in a document"):
        to_plain({1, 2})
