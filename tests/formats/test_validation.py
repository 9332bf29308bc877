"""Plain data becomes a value strictly, and of several faults the first in the document is told."""

import re

import pytest

from missiontree.errors import InputError
from missiontree.formats.document import read_text
from missiontree.formats.reader import parse
from missiontree.formats.validation import to_value
from missiontree.mission.fleet import Capability, DurationModel
from missiontree.mission.position import Position


def test_whole_numbers_are_taken_where_any_number_is_and_become_it() -> None:
    position = to_value(parse("x_m: 1\ny_m: 2.5"), Position)
    assert position == Position(1, 2.5)
    assert isinstance(position.x_m, float)


@pytest.mark.parametrize("text", ["x_m: '1'\ny_m: 2", "x_m: true\ny_m: 2", "x_m: [1]\ny_m: 2", "x_m: 1\ny_m:"])
def test_nothing_is_taken_for_a_number_that_is_none(text: str) -> None:
    with pytest.raises(InputError, match="a number"):
        to_value(parse(text), Position)


def test_what_a_value_refuses_at_birth_is_refused_in_a_file() -> None:
    with pytest.raises(InputError, match="a number above 0"):
        to_value(parse("quality: 1\nduration: {scale: 0}"), Capability)
    with pytest.raises(ValueError, match="scale must be above 0"):
        DurationModel(scale=0)


def test_the_first_fault_is_told_and_the_others_counted() -> None:
    text = "types:\n- id: a\n  count: x\n  colour: red\n- id: b\n  count: -1\n"
    with pytest.raises(InputError, match=re.escape("types[0].count")) as caught:
        read_text(text, "fleet")
    assert "2 more faults further down." in caught.value.hint


def test_one_wrong_capability_is_one_fault_though_it_may_be_written_in_two_ways() -> None:
    with pytest.raises(InputError) as caught:
        read_text("types:\n- id: cart\n  count: 2\n" + "  capabilities: {carry: true}\n", "fleet")
    assert "more fault" not in str(caught.value)
