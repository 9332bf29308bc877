"""Which names mean the same."""

import pytest

from missiontree.evaluation.names import ambiguous_in, may_mean, pairings, scene_id, words_of
from tests.evaluation.trees import HOUSE


def test_words_leave_out_what_does_not_tell() -> None:
    assert words_of("the Check-in Desk") == ("check", "in", "desk")
    assert words_of("Anna's red suitcase") == ("anna", "red", "suitcase")
    assert words_of("Her") == ("her",)


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        ("Worker", "Injured Worker", True),
        ("Red Suitcase", "Suitcase", True),
        ("Red Box", "Blue Box", False),  # neither is the other with words left out
        ("Ward 3", "Ward", False),  # a number tells things apart
        ("Ward 3", "Ward 4", False),
        ("Bed of Ward 3", "Ward 3", False),  # a bed, and a ward
        ("People of Ward 3", "People", False),
        ("Tool Box", "Tool", False),
    ],
)
def test_words_may_be_left_out_before_the_same_noun(one: str, other: str, same: bool) -> None:
    assert may_mean(words_of(one), words_of(other)) is same
    assert may_mean(words_of(other), words_of(one)) is same


def test_equal_names_are_paired_first_and_each_once() -> None:
    box, red, blue = ("box",), ("red", "box"), ("blue", "box")
    # The author's "box" is the suite's "box"; so its "red box" is left for the suite's "old red box".
    assert next(pairings([("old", "red", "box"), box], {"a": red, "b": box})) == {"b": box, "a": ("old", "red", "box")}
    # Two boxes of the suite cannot both be the one that the author has.
    assert all(len(pairs) <= 1 for pairs in pairings([red, blue], {"a": box}))


def test_the_scene_knows_ids_before_labels_before_aliases() -> None:
    assert scene_id("ANNA", HOUSE) == "anna"
    assert scene_id("anna berg", HOUSE) == "anna"
    assert scene_id("the nurse", HOUSE) == "anna"
    assert scene_id("Bob", HOUSE) is None
    assert scene_id("Cup", HOUSE) is None
    assert ambiguous_in("Cup", HOUSE) == ("cup_1", "cup_2")
    assert scene_id("cup_2", HOUSE) == "cup_2"
