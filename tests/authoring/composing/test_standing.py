"""What stands before what, as far as links say so."""

from __future__ import annotations

from missiontree.authoring.composing.standing import StandingOrder
from missiontree.authoring.methods.outline import Outline, Piece
from tests.authoring.composing.goals import do

A, B, C, D = (do("Search", name) for name in "abcd")


def standing(pieces: list[Piece], *links: tuple[Piece, Piece]) -> StandingOrder:
    outline = Outline(pieces)
    for first, second in links:
        outline.link(first, second)
    return StandingOrder(outline)


def test_order_is_seen_from_both_ends_and_over_others() -> None:
    order = standing([A, B, C, D], (A, B), (B, C))
    assert order.between(A, B)
    assert order.between(B, A)
    assert order.between(A, C)
    assert not order.between(A, D)
    assert not order.between(A, A)


def test_link_between_tasks_orders_what_they_hold() -> None:
    first, second = Piece("first", pieces=[A, B]), Piece("second", pieces=[Piece("inner", pieces=[C])])
    order = standing([first, second, D], (first, second))
    assert order.between(A, C)
    assert order.between(C, B)
    assert not order.between(A, B)
    assert not order.between(C, D)


def test_way_may_lead_through_a_task() -> None:
    """A before the task, and something in the task before C."""
    task = Piece("task", pieces=[B])
    assert standing([A, task, C], (A, task), (B, C)).between(A, C)


def test_until_is_no_order() -> None:
    outline = Outline([A, B])
    outline.link(A, B, "until")
    assert not StandingOrder(outline).between(A, B)


def test_what_is_added_counts() -> None:
    order = standing([A, B])
    assert not order.between(A, B)
    order.add(A, B)
    assert order.between(B, A)


def test_circle_ends() -> None:
    order = standing([A, B, C], (A, B), (B, A))
    assert order.between(A, B)
    assert not order.between(A, C)
