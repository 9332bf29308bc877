"""Loose expectations, and those that mean nothing."""

import re
from typing import Any

import pytest

from missiontree.evaluation.loose import Loose


def test_they_are_told_as_they_are_written() -> None:
    loose = Loose(
        must=("Search(*)", "Reach(Anna)"), must_not=("Follow(*)",), order=("1 < 2",), entities=("Anna", "Cup")
    )
    assert str(loose) == "must Search(*); Reach(Anna) | must not Follow(*) | entities Anna, Cup | 1 < 2"
    assert [call.arguments for call in (*loose.calls, *loose.refused)] == [("*",), ("Anna",), ("*",)]


def test_entities_alone_are_enough() -> None:
    assert str(Loose(entities=("Anna",))) == "entities Anna"


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"must_not": ("Follow(*)",)}, "something must be done"),
        ({}, "something must be done"),
        ({"must": ("Search",)}, "'Search' is not of the form"),
        ({"must": ("Search(A)",), "order": ("1 < 2",)}, "'1 < 2' names routine 2; must has 1"),
        ({"must": ("Search(A)", "Reach(A)"), "order": ("1 < 2", "2 < 1")}, "contradicts"),
        ({"must": ("Search(A)",), "must_not": ("Follow(A) by tele_robot",)}, "does not look at"),
        ({"must": ("Search(A)",), "must_not": ("Search(A)",)}, "in must and in must_not"),
        ({"entities": (" ",)}, "a name without words"),
    ],
)
def test_what_means_nothing_is_refused(given: dict[str, Any], says: str) -> None:
    with pytest.raises(ValueError, match=re.escape(says)):
        Loose(**given)
