"""Routes that share a way run side by side."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.reporting.maps.lanes import LANE, WIDEST, Line, side_by_side

HERE, THERE, ON = (0.0, 0.0), (100.0, 0.0), (100.0, 80.0)


def middle(line: list[tuple[float, float]], x: float = 50.0) -> float:
    """Height of a line where it passes x."""
    for (ax, ay), (bx, by) in pairwise(line):
        if min(ax, bx) <= x <= max(ax, bx) and ax != bx:
            return ay + (by - ay) * (x - ax) / (bx - ax)
    raise AssertionError(line)


def test_who_is_alone_goes_where_the_road_is() -> None:
    assert side_by_side([Line(0, (HERE, THERE, ON))]) == [[HERE, THERE, ON]]


def test_two_on_one_road_are_a_lane_apart_and_both_end_at_the_places() -> None:
    """Half a lane to each side of the road."""
    lines = side_by_side([Line(0, (HERE, THERE)), Line(1, (HERE, THERE))])
    assert [middle(line) for line in lines] == [pytest.approx(-LANE / 2), pytest.approx(LANE / 2)]
    assert {line[0] for line in lines} == {HERE}
    assert {line[-1] for line in lines} == {THERE}


def test_to_and_fro_is_one_lane() -> None:
    lines = side_by_side([Line(0, (HERE, THERE)), Line(0, (THERE, HERE)), Line(1, (HERE, THERE))])
    assert middle(lines[0]) == pytest.approx(middle(lines[1]))
    assert abs(middle(lines[0]) - middle(lines[2])) == pytest.approx(LANE)


def test_who_meets_another_keeps_to_its_own_side() -> None:
    lines = side_by_side([Line(0, (HERE, THERE)), Line(1, (THERE, HERE))])
    assert abs(middle(lines[0]) - middle(lines[1])) == pytest.approx(LANE)


def test_a_part_of_the_road_is_shared_as_well() -> None:
    """One goes from 0 to 100, the other from 40 to 60 on the same straight line."""
    lines = side_by_side([Line(0, (HERE, THERE)), Line(1, ((40.0, 0.0), (60.0, 0.0)))])
    assert abs(middle(lines[0]) - middle(lines[1])) == pytest.approx(LANE)


def test_one_road_behind_the_other_is_not_shared() -> None:
    lines = side_by_side([Line(0, (HERE, THERE)), Line(1, (THERE, (200.0, 0.0)))])
    assert [middle(lines[0]), middle(lines[1], 150)] == [0, 0]


def test_round_a_corner_the_lanes_stay_side_by_side() -> None:
    """On the way down, too, the two are a lane apart, and neither line sticks out."""
    lines = side_by_side([Line(0, (HERE, THERE, ON)), Line(1, (HERE, THERE, ON))])
    across = [x for line in lines for x, y in line[1:-1] if y > LANE]
    assert max(across) - min(across) == pytest.approx(LANE)
    assert max(x for line in lines for x, _ in line) <= 100 + LANE


def test_a_sharp_turn_does_not_stick_out() -> None:
    """Back at an angle of some 8 degrees: the lanes' crossing would be tens of units beyond the turn."""
    points = ((0.0, 0.0), (100.0, 0.0), (0.0, 14.0))
    lines = side_by_side([Line(0, points), Line(1, points)])
    assert max(x for line in lines for x, _ in line) <= 110


def test_many_lanes_move_closer() -> None:
    lines = side_by_side([Line(owner, (HERE, THERE)) for owner in range(21)])
    heights = sorted(middle(line) for line in lines)
    assert heights[-1] - heights[0] == pytest.approx(WIDEST)
    assert [b - a for a, b in pairwise(heights)] == pytest.approx([WIDEST / 20] * 20)


def test_a_line_that_goes_nowhere_stays() -> None:
    assert side_by_side([Line(0, (HERE, HERE))]) == [[HERE, HERE]]


@st.composite
def routes(draw: st.DrawFn) -> list[Line]:
    """Up to six routes of up to four owners over the roads of a grid."""
    corner = st.tuples(st.integers(0, 3), st.integers(0, 3))
    lines = []
    for _ in range(draw(st.integers(1, 6))):
        x, y = draw(corner)
        points = [(60.0 * x, 60.0 * y)]
        for sideways, step in draw(
            st.lists(st.tuples(st.booleans(), st.sampled_from((-1, 1))), min_size=1, max_size=5)
        ):
            x, y = (min(3, max(0, x + step)), y) if sideways else (x, min(3, max(0, y + step)))
            points.append((60.0 * x, 60.0 * y))
        lines.append(Line(draw(st.integers(0, 3)), tuple(points)))
    return lines


@given(routes())
def test_no_route_hides_another(lines: list[Line]) -> None:
    """Nowhere do two owners have more than a crossing in common: their lines in one direction are apart, corners aside."""
    drawn = list(zip(lines, side_by_side(lines), strict=True))
    for line, moved in drawn:
        assert math.dist(moved[0], line.points[0]) < 0.01
        assert math.dist(moved[-1], line.points[-1]) < 0.01
        for other, theirs in drawn:
            if other.owner != line.owner:
                assert _overlap(moved, theirs) <= 2 * LANE


def _overlap(first: list[tuple[float, float]], second: list[tuple[float, float]]) -> float:
    """The longest stretch that two lines with level and upright stretches have in common."""
    longest = 0.0
    for a, b in pairwise(first):
        for c, d in pairwise(second):
            for axis in (0, 1):
                level = [point[1 - axis] for point in (a, b, c, d)]
                if max(level) - min(level) < 0.5:
                    low = max(min(a[axis], b[axis]), min(c[axis], d[axis]))
                    longest = max(longest, min(max(a[axis], b[axis]), max(c[axis], d[axis])) - low)
    return longest


@settings(max_examples=20)
@given(routes())
def test_equal_routes_give_equal_lanes(lines: list[Line]) -> None:
    assert side_by_side(lines) == side_by_side(list(lines))
