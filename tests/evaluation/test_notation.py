"""The short notation of suites: what it stands for, and how it is refused."""

import pytest

from missiontree.evaluation.notation import Order, PlannedCall, call_from, order_from


def test_calls_are_read() -> None:
    assert call_from("Reach( Anna  Berg )") == PlannedCall(routine="Reach", arguments=("Anna Berg",))
    assert call_from("Transport(Bed, Ward 3) by a_bot,b_bot") == PlannedCall(
        routine="Transport", arguments=("Bed", "Ward 3"), by=("a_bot", "b_bot")
    )
    assert call_from("Search(Cat) not  by a_bot") == PlannedCall(
        routine="Search", arguments=("Cat",), not_by=("a_bot",)
    )


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("Search Cat", "'Search Cat' is not of the form"),
        ("Transport(Bed", "square brackets"),
        ("Search(Cat) with a_bot", "is not of the form"),
        ("Search(Cat) by", "is not of the form"),
        ("Search()", "without a name"),
        ("Transport(Bed, )", "without a name"),
        ("Search(Cat) by the bot", "must be an id"),
    ],
)
def test_what_is_no_call_is_refused_with_its_text(text: str, says: str) -> None:
    with pytest.raises(ValueError, match="'") as refusal:
        call_from(text)
    assert repr(text) in str(refusal.value)
    assert says in str(refusal.value)


def test_order_is_read() -> None:
    assert order_from("1 < 2") == Order(1, 2, "<")
    assert order_from("3~10") == Order(3, 10, "~")


@pytest.mark.parametrize("text", ["1 > 2", "a < b", "1 <", "1 < 1", "0 < 1", "1 < 2 < 3"])
def test_what_is_no_order_is_refused_with_its_text(text: str) -> None:
    with pytest.raises(ValueError, match="'") as refusal:
        order_from(text)
    assert repr(text) in str(refusal.value)
