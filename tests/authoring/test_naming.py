import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.authoring.naming import make_id
from missiontree.mission.value import ID_PATTERN


@pytest.mark.parametrize(
    ("label", "made"),
    [
        ("Locate the Lost Child", "locate-the-lost-child"),
        ("Search(Child)", "search-child"),
        ("ReachAndTransport(cat, safe area)", "reach-and-transport-cat-safe-area"),
        ("Über die Brücke", "uber-die-brucke"),
        ("2nd floor", "floor"),
        ("迷子を探す", "task"),
        ("42", "task"),
        # Words are kept whole: with "seven" there would be 43 letters, above 40.
        ("one two three four five six and yet again seven", "one-two-three-four-five-six-and-yet"),
    ],
)
def test_ids_are_readable(label: str, made: str) -> None:
    assert make_id(label, (), "task").startswith(made)


def test_taken_ids_are_numbered_from_two() -> None:
    assert make_id("Find", {"find"}, "task") == "find-2"
    assert make_id("Find", {"find", "find-2"}, "task") == "find-3"


@given(st.text(max_size=80), st.integers(min_value=0, max_value=4))
def test_any_label_makes_an_id_that_is_new_and_well_formed(label: str, before: int) -> None:
    taken: set[str] = set()
    for _ in range(before):
        taken.add(make_id(label, taken, "task"))
    made = make_id(label, taken, "task")
    assert made not in taken
    assert re.fullmatch(ID_PATTERN, made, re.ASCII)
