"""Polygons: what is inside, and which segments pass through."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from missiontree.estimation.polygon import TOLERANCE_M, Polygon, distance_to_segment, pierced

SQUARE = Polygon([(0, 0), (2, 0), (2, 2), (0, 2)])
# A U that is open at the top: arms from x 0 to 1 and from 2 to 3, floor up to y 1.
CUP = Polygon([(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)])


@pytest.mark.parametrize(
    ("point", "inside"),
    [((1, 1), True), ((3, 1), False), ((2, 1), False), ((0, 0), False), ((1, 1e-9), False), ((1, 1e-3), True)],
)
def test_the_edge_belongs_to_the_outside(point: tuple[float, float], inside: bool) -> None:
    assert SQUARE.holds(point) is inside


@pytest.mark.parametrize(
    ("point", "inside"), [((0.5, 2), True), ((1.5, 2), False), ((2.5, 2), True), ((1.5, 0.5), True)]
)
def test_the_gap_of_a_concave_polygon_is_outside(point: tuple[float, float], inside: bool) -> None:
    assert CUP.holds(point) is inside


@pytest.mark.parametrize(
    ("start", "end"),
    [
        ((-1, 1), (3, 1)),  # straight through
        ((0, 0), (2, 2)),  # corner to corner, along the diagonal
        ((1, 1), (1, 1.5)),  # wholly inside
        ((0, 1), (1, 0)),  # from edge to edge
        ((-1, 1), (1, 1)),  # ends inside
    ],
)
def test_segments_through_the_inside_pierce(start: tuple[float, float], end: tuple[float, float]) -> None:
    assert pierced(start, end, [SQUARE]) is SQUARE
    assert pierced(end, start, [SQUARE]) is SQUARE


@pytest.mark.parametrize(
    ("start", "end"),
    [
        ((-1, 0), (3, 0)),  # along an edge and beyond
        ((0, 0), (0, 2)),  # just an edge
        ((-1, 1), (1, -1)),  # touches the corner (0, 0)
        ((-1, 1), (0, 1)),  # ends on an edge
        ((-1, 3), (3, 3)),  # passes by
        ((1, 1), (1, 1)),  # a point
    ],
)
def test_segments_that_touch_do_not_pierce(start: tuple[float, float], end: tuple[float, float]) -> None:
    assert pierced(start, end, [SQUARE]) is None
    assert pierced(end, start, [SQUARE]) is None


def test_a_segment_over_the_mouth_of_a_cup_is_free_and_one_through_its_arms_is_not() -> None:
    assert pierced((0, 3), (3, 3), [CUP]) is None
    assert pierced((1, 3), (2, 1), [CUP]) is None
    assert pierced((-1, 2), (1.5, 2), [CUP]) is CUP


def test_there_is_no_way_between_two_areas_that_share_an_edge() -> None:
    right = Polygon([(2, 0), (4, 0), (4, 2), (2, 2)])
    assert pierced((2, -1), (2, 3), [SQUARE]) is None
    assert pierced((2, -1), (2, 3), [SQUARE, right]) is not None
    apart = Polygon([(2.1, 0), (4, 0), (4, 2), (2.1, 2)])
    assert pierced((2.05, -1), (2.05, 3), [SQUARE, apart]) is None


def test_a_repeated_corner_changes_nothing() -> None:
    twice = Polygon([(0, 0), (2, 0), (2, 0), (2, 2), (0, 2), (0, 2)])
    assert pierced((-1, 1), (3, 1), [twice]) is twice
    assert pierced((2, -1), (2, 3), [twice]) is None


def test_distance_to_a_segment() -> None:
    # beside it, beyond its end (3-4-5), and from a segment that is a point
    assert distance_to_segment((1, 2), (0, 0), (2, 0)) == 2
    assert distance_to_segment((5, 4), (0, 0), (2, 0)) == 5
    assert distance_to_segment((3, 4), (0, 0), (0, 0)) == 5


grid_points = st.tuples(st.integers(-1, 7), st.integers(-1, 7))


@given(st.lists(st.integers(1, 3), min_size=3, max_size=9), st.data())
def test_piercing_agrees_with_fine_sampling(radii: list[int], data: st.DataObject) -> None:
    """A star-shaped polygon, and segments between points of a small lattice."""
    turns = [2 * math.pi * number / len(radii) for number in range(len(radii))]
    star = Polygon([(3 + r * math.cos(turn), 3 + r * math.sin(turn)) for r, turn in zip(radii, turns, strict=True)])
    start, end = data.draw(grid_points), data.draw(grid_points)
    assume(start != end)
    samples = [
        (start[0] + share * (end[0] - start[0]) / 400, start[1] + share * (end[1] - start[1]) / 400)
        for share in range(401)
    ]
    deep = any(star.covers(point) and _depth(star, point) > 10 * TOLERANCE_M for point in samples)
    if deep:
        assert pierced(start, end, [star]) is star
    if pierced(start, end, [star]) is star:
        # what pierces has a point at least nearly inside: none of 401 samples is then far from the polygon
        step = math.hypot(end[0] - start[0], end[1] - start[1]) / 400
        assert any(star.covers(point) or _depth(star, point) <= step for point in samples)


def _depth(polygon: Polygon, point: tuple[float, float]) -> float:
    return min(distance_to_segment(point, *edge) for edge in polygon.edges)
