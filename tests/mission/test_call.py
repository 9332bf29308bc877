"""A routine and its arguments, as files write them."""

from __future__ import annotations

import pytest

from missiontree.mission.call import Call, call_of


@pytest.mark.parametrize(
    ("text", "call"),
    [
        ("Search(Anna)", Call("Search", ("Anna",))),
        (" ReachAndTransport ( keys ,  Mrs Brown ) ", Call("ReachAndTransport", ("keys", "Mrs Brown"))),
        ("Weld-2(a,)", Call("Weld-2", ("a", ""))),
        ("Rest()", Call("Rest", ("",))),
    ],
)
def test_call(text: str, call: Call) -> None:
    assert call_of(text) == call


@pytest.mark.parametrize("text", ["", "Search", "Search(Anna", "(Anna)", "1st(Anna)", "Search(Anna) now"])
def test_no_call(text: str) -> None:
    assert call_of(text) is None
