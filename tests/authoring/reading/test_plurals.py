"""One and several of a noun."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.plurals import SAME, is_plural, plural, singular

PAIRS = {
    "crate": "crates",
    "box": "boxes",
    "bus": "buses",
    "glass": "glasses",
    "church": "churches",
    "dish": "dishes",
    "house": "houses",
    "horse": "horses",
    "vase": "vases",
    "nurse": "nurses",
    "axe": "axes",
    "gas": "gases",
    "canvas": "canvases",
    "city": "cities",
    "baby": "babies",
    "lorry": "lorries",
    "key": "keys",
    "toy": "toys",
    "trolley": "trolleys",
    "shoe": "shoes",
    "glove": "gloves",
    "bridge": "bridges",
    "pie": "pies",
    "knife": "knives",
    "shelf": "shelves",
    "wolf": "wolves",
    "calf": "calves",
    "loaf": "loaves",
    "mouse": "mice",
    "goose": "geese",
    "ox": "oxen",
    "child": "children",
    "person": "people",
    "man": "men",
    "woman": "women",
    "fireman": "firemen",
    "human": "humans",
    "sheep": "sheep",
    "staff": "staff",
    "dog": "dogs",
}


@pytest.mark.parametrize(("one", "several"), PAIRS.items())
def test_there_and_back(one: str, several: str) -> None:
    assert plural(one) == several
    assert singular(several) == one
    assert is_plural(several)
    assert is_plural(one) is (one in SAME)


@pytest.mark.parametrize("noun", PAIRS)
def test_doing_it_twice_changes_nothing(noun: str) -> None:
    assert plural(plural(noun)) == plural(noun)
    assert singular(singular(noun)) == singular(noun)


@pytest.mark.parametrize("name", ["Anna's", "bus", "glass", "tennis", "gas", "walrus", "omen", "crate", "chess"])
def test_an_s_at_the_end_is_not_always_a_plural(name: str) -> None:
    assert not is_plural(name)


def test_the_last_word_tells() -> None:
    assert is_plural("red crates")
    assert not is_plural("crates depot")
    assert is_plural("RED CRATES")
