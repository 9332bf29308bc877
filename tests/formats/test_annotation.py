"""Annotations in words."""

from collections.abc import Mapping
from typing import Any, Literal

import pytest

from missiontree.formats.annotation import a_noun, in_words, required_of
from missiontree.mission.area import Corner
from missiontree.mission.fleet import Capability, RobotType
from missiontree.mission.position import Position
from missiontree.mission.value import Count, Id, NonNegative, Positive
from missiontree.mission.ways import OccupancyGrid

AN_ID = "an id (a letter, then up to 63 letters, digits, '_' or '-')"


@pytest.mark.parametrize(
    ("annotation", "words"),
    [
        (NonNegative, "a number, at least 0"),
        (Positive, "a number above 0"),
        (Count, "a whole number, at least 1"),
        (Id | None, AN_ID),
        (float | str | None, "a number, or text"),
        (bool, "true or false"),
        (Literal["a", "b"], "one of 'a', 'b'"),
        (tuple[Id, ...], f"a list, each entry {AN_ID}"),
        (Corner, "a list of 2: a number, a number"),
        (Mapping[Id, NonNegative], f"a mapping, each key {AN_ID}, each value a number, at least 0"),
        (Position | None, "a mapping with the fields x_m, y_m, floor, frame"),
        (Capability | NonNegative, "a number, at least 0, or a mapping with the fields quality, duration, cost"),
    ],
)
def test_in_words(annotation: Any, words: str) -> None:
    assert in_words(annotation) == words


def test_classes_have_names_that_people_say() -> None:
    assert (a_noun(RobotType), a_noun(OccupancyGrid)) == ("a robot type", "an occupancy grid")


def test_required_fields_are_those_without_a_default() -> None:
    assert required_of(RobotType) == ("id",)
    assert required_of(OccupancyGrid) == ("rows", "cell_m")
