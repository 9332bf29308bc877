"""Straight lines, and the shortest way round what is closed."""

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.estimation.access import Access, ClosedArea
from missiontree.estimation.leg import Blocked, Leg
from missiontree.estimation.shortest import ShortestTree
from missiontree.estimation.straight import StraightWays
from missiontree.mission.area import Area
from missiontree.mission.position import Position

Corners = tuple[tuple[float, float], ...]
SQUARE: Corners = ((1, -1), (3, -1), (3, 1), (1, 1))


def ways(*polygons: Corners) -> StraightWays:
    areas = tuple(ClosedArea(f"keep-out k{i}", Area(corners=corners)) for i, corners in enumerate(polygons))
    return StraightWays(Access(areas, (), ()))


def metres(leg: Leg | Blocked) -> float:
    assert isinstance(leg, Leg), leg
    return leg.distance_m


def test_nothing_between_is_euclid() -> None:
    # 3-4-5
    assert ways().leg(Position(0, 0), Position(3, 4)) == Leg(5)


def test_round_a_square_by_two_corners() -> None:
    # (0, 0) to the corner (1, 1) is sqrt 2, along the side 2, and sqrt 2 again to (4, 0)
    assert metres(ways(SQUARE).leg(Position(0, 0), Position(4, 0))) == pytest.approx(2 + 2 * math.sqrt(2))


def test_a_lop_sided_start_goes_round_the_nearer_side() -> None:
    # from (0, 0.5) over the top: hypot(1, 0.5) + 2 + sqrt 2; below it would be hypot(1, 1.5) + 2 + sqrt 2
    found = metres(ways(SQUARE).leg(Position(0, 0.5), Position(4, 0)))
    assert found == pytest.approx(math.hypot(1, 0.5) + 2 + math.sqrt(2))


def test_out_of_a_cup() -> None:
    cup: Corners = ((0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3))
    # from (1.5, 1.5) to (4, 1.5): over the arm's inner corner (2, 3), its outer corner (3, 3), then down:
    # hypot(0.5, 1.5) + 1 + hypot(1, 1.5)
    expected = math.hypot(0.5, 1.5) + 1 + math.hypot(1, 1.5)
    assert metres(ways(cup).leg(Position(1.5, 1.5), Position(4, 1.5))) == pytest.approx(expected)


def test_overlapping_areas_count_as_one() -> None:
    wide: Corners = ((0, -1), (4, -1), (4, 1), (0, 1))
    tall: Corners = ((1, -3), (3, -3), (3, 3), (1, 3))
    # a plus sign, from (-1, 2) to (5, 2): hypot(2, 1) to (1, 3), 2 along the top, hypot(2, 1) down again
    found = metres(ways(wide, tall).leg(Position(-1, 2), Position(5, 2)))
    assert found == pytest.approx(2 + 2 * math.hypot(2, 1))


def test_along_an_edge_is_free() -> None:
    assert metres(ways(SQUARE).leg(Position(0, 1), Position(4, 1))) == 4


def test_no_way_between_areas_that_share_an_edge() -> None:
    upper: Corners = ((1, 0), (3, 0), (3, 2), (1, 2))
    lower: Corners = ((1, -2), (3, -2), (3, 0), (1, 0))
    # not along y = 0 (4 m), but over the top: hypot(1, 2) + 2 + hypot(1, 2)
    found = metres(ways(upper, lower).leg(Position(0, 0), Position(4, 0)))
    assert found == pytest.approx(2 + 2 * math.sqrt(5))


def test_inside_a_closed_area_is_blocked_by_name() -> None:
    for leg in (
        ways(SQUARE).leg(Position(2, 0), Position(9, 9)),
        ways(SQUARE).leg(Position(9, 9), Position(2, 0)),
    ):
        assert isinstance(leg, Blocked)
        assert leg.reason.rule == "unreachable"
        assert leg.reason.message == "(2, 0) is inside keep-out k0, which is closed to the robot."


def test_a_ring_cuts_off_what_is_in_it() -> None:
    ring = (((0, 0), (5, 0), (5, 1), (0, 1)), ((0, 4), (5, 4), (5, 5), (0, 5)))
    sides = (((0, 1), (1, 1), (1, 4), (0, 4)), ((4, 1), (5, 1), (5, 4), (4, 4)))
    leg = ways(*ring, *sides).leg(Position(2, 2), Position(9, 2))
    assert isinstance(leg, Blocked)
    # the straight line to the right leaves through the right side, area k3
    assert leg.reason.message == "(9, 2) is cut off from (2, 2) by keep-out k3."


def test_floors_are_not_joined() -> None:
    leg = ways().leg(Position(0, 0), Position(0, 0, floor="first"))
    assert isinstance(leg, Blocked)
    assert leg.reason.message == "Nothing joins floor ground and floor first."
    assert "lift" in leg.reason.hint


def test_a_floor_minds_only_its_own_areas() -> None:
    up = ClosedArea("keep-out up", Area(corners=SQUARE, floor="first"))
    assert metres(StraightWays(Access((up,), (), ())).leg(Position(0, 0), Position(4, 0))) == 4


lattice = st.integers(0, 8)
boxes = st.lists(
    st.tuples(lattice, lattice, st.integers(1, 4), st.integers(1, 4)).map(
        lambda b: ((b[0], b[1]), (b[0] + b[2], b[1]), (b[0] + b[2], b[1] + b[3]), (b[0], b[1] + b[3]))
    ),
    max_size=4,
)
points = st.builds(Position, st.integers(-1, 13), st.integers(-1, 13))


@given(boxes, points, points, points)
def test_ways_are_symmetric_no_shorter_than_euclid_and_keep_the_triangle_inequality(
    drawn: list[Corners], a: Position, b: Position, c: Position
) -> None:
    model = ways(*drawn)
    legs = [model.leg(start, end) for start, end in ((a, b), (b, a), (b, c), (a, c))]
    assert isinstance(legs[0], Leg) == isinstance(legs[1], Leg)
    if isinstance(legs[0], Leg) and isinstance(legs[1], Leg):
        assert legs[0].distance_m == pytest.approx(legs[1].distance_m)
        assert legs[0].distance_m >= math.hypot(a.x_m - b.x_m, a.y_m - b.y_m) - 1e-9
    if isinstance(legs[0], Leg) and isinstance(legs[2], Leg):
        assert metres(legs[3]) <= legs[0].distance_m + legs[2].distance_m + 1e-6


@given(boxes, points, points)
def test_boxes_agree_with_a_graph_over_all_corners_and_exact_clipping(
    drawn: list[Corners], a: Position, b: Position
) -> None:
    """A shortest way bends at corners only: a full graph over them, with a test of sight of another kind."""
    found = ways(*drawn).leg(a, b)
    reference = _over_corners(drawn, (a.x_m, a.y_m), (b.x_m, b.y_m))
    if reference is None:
        assert isinstance(found, Blocked)
    else:
        assert metres(found) == pytest.approx(reference)


def _over_corners(drawn: list[Corners], a: tuple[float, float], b: tuple[float, float]) -> float | None:
    spots = [a, b, *{corner for box in drawn for corner in box}]
    if any(_in_union(spot, drawn) for spot in (a, b)):
        return None

    def neighbours(node: int) -> list[tuple[int, float]]:
        return [
            (other, math.dist(spots[node], spots[other]))
            for other in range(len(spots))
            if other != node and _clear(spots[node], spots[other], drawn)
        ]

    return ShortestTree(0, neighbours).cost(1)


def _in_union(spot: tuple[float, float], drawn: list[Corners]) -> bool:
    return any(low[0] < spot[0] < high[0] and low[1] < spot[1] < high[1] for low, _, high, _ in drawn)


def _clear(start: tuple[float, float], end: tuple[float, float], drawn: list[Corners]) -> bool:
    """By exact clipping of the segment against every box (Liang and Barsky), pieces joined up by hand."""
    breaks = {0.0, 1.0}
    run = (end[0] - start[0], end[1] - start[1])
    for low, _, high, _ in drawn:
        for axis in (0, 1):
            breaks |= {(side[axis] - start[axis]) / run[axis] for side in (low, high) if run[axis]}
    shares = sorted(share for share in breaks if 0 <= share <= 1)
    for first, last in pairwise(shares):
        if last - first < 1e-9:
            continue
        x, y = (start[axis] + (first + last) / 2 * run[axis] for axis in (0, 1))
        both = [(x - side * run[1], y + side * run[0]) for side in (1e-7, -1e-7)]
        if all(_in_union(point, drawn) for point in both):
            return False
    return True
