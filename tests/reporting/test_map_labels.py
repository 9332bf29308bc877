"""Labels never cover each other or a mark, and stand as near as they can."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.reporting.maps.boxes import Box
from missiontree.reporting.maps.labels import LEADER_FROM, Ground, Placed
from missiontree.reporting.maps.settling import Wish, settle

PAGE = Box(0, 0, 400, 300)


def spot(x: float, y: float, radius: float = 5) -> Box:
    return Box(x - radius, y - radius, x + radius, y + radius)


@st.composite
def labelled(draw: st.DrawFn) -> tuple[Ground, list[Wish]]:
    """Up to forty marks that do not cover each other, with labels of all sizes."""
    marks: list[Box] = []
    for x, y in draw(st.lists(st.tuples(st.integers(0, 400), st.integers(0, 300)), max_size=40)):
        if not any(spot(x, y).meets(other) for other in marks):
            marks.append(spot(x, y))
    sizes = st.tuples(st.integers(10, 160), st.sampled_from((14, 28, 90)), st.integers(0, 2))
    wishes = [Wish(mark, *draw(sizes), farthest=draw(st.sampled_from((8.0, 200.0)))) for mark in marks]
    return page(marks), wishes


def page(marks: list[Box]) -> Ground:
    ground = Ground(PAGE)
    for mark in marks:
        ground.mark(mark)
    return ground


@settings(max_examples=40)
@given(labelled())
def test_no_label_covers_a_label_a_mark_or_a_leader_and_none_is_outside(case: tuple[Ground, list[Wish]]) -> None:
    ground, wishes = case
    placed = settle(ground, wishes)
    shown = [one for one in placed if one is not None]
    for first, second in combinations(shown, 2):
        assert not any(a.meets(b) for a in first.covers() for b in second.covers())
    for wish, one in zip(wishes, placed, strict=True):
        if one is not None:
            assert one.box.within(PAGE)
            assert one.box.right - one.box.left == pytest.approx(wish.width)
            assert one.box.bottom - one.box.top == pytest.approx(wish.height)
            assert not any(box.meets(other.mark) for box in [one.box] for other in wishes)


def test_a_leader_keeps_its_whole_width_off_other_labels() -> None:
    """The third label goes far off, and its leader would graze the labels of the first and the fourth."""
    wishes = [
        Wish(spot(0, 55), 10, 14, 0, 8.0),
        Wish(spot(26, 0), 10, 14, 0, 8.0),
        Wish(spot(0, 0), 10, 14, 1, 200.0),
        Wish(spot(16, 0), 10, 14, 0, 8.0),
    ]
    shown = [one for one in settle(page([wish.mark for wish in wishes]), wishes) if one is not None]
    for first, second in combinations(shown, 2):
        assert not any(a.meets(b) for a in first.covers() for b in second.covers())


@settings(max_examples=10)
@given(labelled())
def test_equal_wishes_are_settled_equally(case: tuple[Ground, list[Wish]]) -> None:
    _, wishes = case
    marks = [wish.mark for wish in wishes]
    assert settle(page(marks), wishes) == settle(page(marks), wishes)


def one(*wishes: Wish) -> list[Placed]:
    placed = settle(page([wish.mark for wish in wishes]), wishes)
    found = [label for label in placed if label is not None]
    assert len(found) == len(wishes)
    return found


def test_a_label_alone_stands_right_of_its_mark_without_a_line() -> None:
    """Mark from 95 to 105, a gap of 3: from 108 on, level with it."""
    (label,) = one(Wish(spot(100, 100), 60, 14, 0))
    assert label.box == Box(108, 93, 168, 107)
    assert label.leader is None


def test_at_the_right_edge_a_label_stands_on_the_other_side() -> None:
    (label,) = one(Wish(spot(380, 100), 60, 14, 0))
    assert label.box.right <= 375


def test_a_label_keeps_off_a_line_that_is_discouraged() -> None:
    ground = page([spot(100, 100)])
    ground.discourage([(100, 100), (300, 100)], 0.5)
    label = ground.place(spot(100, 100), 60, 14)
    assert label is not None
    assert not label.box.top < 100 < label.box.bottom or label.box.right < 100


def test_a_label_that_had_to_go_far_has_a_line_that_ends_at_it() -> None:
    marks = [spot(200, 150)] + [spot(200 + x, 150 + y) for x in (-24, -12, 0, 12, 24) for y in (-24, -12, 12, 24)]
    ground = page(marks)
    label = ground.place(marks[0], 60, 14)
    assert label is not None
    assert label.leader is not None
    start, end = label.leader
    assert abs(start[0] - 200) <= 5 + 1e-9
    assert label.box.left <= end[0] <= label.box.right
    assert label.box.top <= end[1] <= label.box.bottom
    assert (end[0] - start[0]) ** 2 + (end[1] - start[1]) ** 2 >= LEADER_FROM**2


def test_who_matters_more_keeps_its_place() -> None:
    """Room for one: a page 120 wide and 20 high with two marks; the second mark's label has weight 0."""
    ground = Ground(Box(0, 0, 120, 20))
    marks = [spot(50, 10), spot(62, 10)]
    for mark in marks:
        ground.mark(mark)
    placed = settle(ground, [Wish(marks[0], 50, 16, 2, 8.0), Wish(marks[1], 50, 16, 0, 8.0)])
    assert placed[1] is not None


def test_labels_make_way_for_each_other() -> None:
    """The first would like the right side best, the only side that is left to the second."""
    left, right = Wish(spot(100, 100), 40, 14, 1), Wish(spot(128, 100), 60, 14, 1)
    labels = one(left, right)
    assert labels[1].box == Box(136, 93, 196, 107)
    assert labels[0].leader is None


def test_a_label_without_room_is_not_placed() -> None:
    ground = Ground(Box(0, 0, 50, 20))
    ground.mark(spot(25, 10))
    assert ground.place(spot(25, 10), 200, 14) is None
