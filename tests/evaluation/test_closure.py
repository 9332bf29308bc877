"""What follows from an order."""

from missiontree.evaluation.closure import closure


def test_what_follows_is_added() -> None:
    assert closure({(1, 2), (2, 3), (3, 4), (7, 8)}) == {(1, 2), (2, 3), (3, 4), (1, 3), (1, 4), (2, 4), (7, 8)}


def test_a_circle_puts_everybody_before_everybody() -> None:
    assert closure({(1, 2), (2, 1)}) == {(1, 2), (2, 1), (1, 1), (2, 2)}
