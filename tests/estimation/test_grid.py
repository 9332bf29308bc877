"""Ways over an occupancy grid."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.estimation.access import Access, ClosedArea
from missiontree.estimation.grid import GridWays
from missiontree.estimation.leg import Blocked, Leg
from missiontree.mission.area import Area
from missiontree.mission.position import Position
from missiontree.mission.ways import OccupancyGrid

ROOT2 = math.sqrt(2)


def ways(*rows: str, cell_m: float = 1.0, areas: tuple[ClosedArea, ...] = ()) -> GridWays:
    return GridWays(OccupancyGrid(rows=rows, cell_m=cell_m), Access(areas, (), ()))


def metres(found: Leg | Blocked) -> float:
    assert isinstance(found, Leg), found
    return found.distance_m


def why(found: Leg | Blocked) -> str:
    assert isinstance(found, Blocked)
    assert found.reason.rule == "unreachable"
    return found.reason.message


def box(name: str, x: float, y: float, width: float, height: float, floor: str = "ground") -> ClosedArea:
    corners = ((x, y), (x + width, y), (x + width, y + height), (x, y + height))
    return ClosedArea(name, Area(corners=corners, floor=floor))


def test_diagonal_steps_count_root_two() -> None:
    # from the centre of the lower left cell to that of the upper right one, 3 columns and 2 rows away: 2 diagonals, 1 straight
    assert metres(ways("....", "....", "....").leg(Position(0.5, 0.5), Position(3.5, 2.5))) == 2 * ROOT2 + 1


def test_the_first_row_has_the_largest_y() -> None:
    model = ways("#.", "..")
    assert "inside a wall" in why(model.leg(Position(1.5, 0.5), Position(0.5, 1.5)))
    assert metres(model.leg(Position(0.5, 0.5), Position(1.5, 0.5))) == 1


def test_no_corner_is_cut() -> None:
    # past the wall's corner the diagonal (sqrt 2) is not taken, but two straight steps
    assert metres(ways(".#", "..").leg(Position(0.5, 1.5), Position(1.5, 0.5))) == 2


def test_the_cell_size_scales_the_way() -> None:
    # 4 straight steps of 0.5 m
    assert metres(ways(".....", cell_m=0.5).leg(Position(0.25, 0.25), Position(2.25, 0.25))) == 2


def test_points_are_joined_to_the_centres_of_their_cells() -> None:
    # 0.5 left to the centre of cell 0, 2 steps, 0.25 on from the centre of cell 2
    assert metres(ways("...").leg(Position(0, 0.5), Position(2.75, 0.5))) == 2.75


def test_two_points_of_one_cell_are_joined_straight() -> None:
    assert metres(ways("..", cell_m=10).leg(Position(1, 1), Position(4, 5))) == 5


def test_a_border_belongs_to_the_cell_right_and_above_and_the_far_border_to_the_last() -> None:
    # x = 1 is in the second cell, 0.5 from its centre; x = 3 is the end of the grid, 0.5 from the centre of the third
    assert metres(ways("#..").leg(Position(1, 0.5), Position(3, 0.5))) == 2


def test_decimal_cells_are_not_lost_to_rounding() -> None:
    # 0.3 / 0.1 is a little under 3 in floating point; the point is on the left border of the fourth cell all the same
    assert metres(ways("###..", cell_m=0.1).leg(Position(0.3, 0.05), Position(0.45, 0.05))) == pytest.approx(0.15)


def test_outside_and_on_other_floors() -> None:
    model = ways("...", "...")
    assert why(model.leg(Position(1, 1), Position(7, 1))) == (
        "(7, 1) is outside the grid, which spans x from 0 to 3 and y from 0 to 2."
    )
    assert "outside the grid" in why(model.leg(Position(-0.1, 1), Position(1, 1)))
    assert "the only floor of the grid" in why(model.leg(Position(1, 1), Position(1, 1, floor="first")))


def test_a_cell_is_closed_if_its_centre_is_in_a_closed_area() -> None:
    # closes the middle cell of three rows; the way round takes 4 straight steps, as no corner is cut
    areas = (box("keep-out pit", 1.2, 1.2, 0.6, 0.6),)
    model = ways("...", "...", "...", areas=areas)
    assert metres(model.leg(Position(0.5, 0.5), Position(2.5, 2.5))) == 4
    assert "a cell of keep-out pit" in why(model.leg(Position(0.5, 0.5), Position(1.1, 1.1)))
    # an area that holds no centre closes no cell, but nobody may stand in it
    small = ways("...", "...", "...", areas=(box("keep-out pot", 1.1, 1.1, 0.2, 0.2),))
    assert metres(small.leg(Position(0.5, 0.5), Position(2.5, 2.5))) == 2 * ROOT2
    assert "inside keep-out pot" in why(small.leg(Position(0.5, 0.5), Position(1.2, 1.2)))


def test_areas_of_other_floors_do_not_count() -> None:
    assert (
        metres(
            ways("...", areas=(box("keep-out pit", 1, 0, 1, 1, "first"),)).leg(Position(0.5, 0.5), Position(2.5, 0.5))
        )
        == 2
    )


def test_what_cuts_off_is_named() -> None:
    start, goal = Position(0.5, 0.5), Position(2.5, 0.5)
    assert why(ways(".#.").leg(start, goal)) == "No way from (0.5, 0.5) to (2.5, 0.5): walls of the grid lie between."
    closed = ways("...", areas=(box("zone ward", 1, 0, 1, 1),))
    assert why(closed.leg(start, goal)) == "No way from (0.5, 0.5) to (2.5, 0.5): closed off by zone ward."


rows = st.integers(2, 6).flatmap(
    lambda width: st.lists(st.text(alphabet="..#", min_size=width, max_size=width), min_size=2, max_size=6)
)


@given(rows, st.data())
def test_distances_agree_with_relaxing_all_pairs_of_cells(drawn: list[str], data: st.DataObject) -> None:
    """Against relaxation until nothing changes, over neighbours that are written out as the rule says."""
    height, width = len(drawn), len(drawn[0])
    cells = st.tuples(st.integers(0, width - 1), st.integers(0, height - 1))
    start, goal = data.draw(cells), data.draw(cells)

    def free(x: int, y: int) -> bool:
        return 0 <= x < width and 0 <= y < height and drawn[height - 1 - y][x] == "."

    best = {start: 0.0} if free(*start) and free(*goal) else {}
    changed = bool(best)
    while changed:
        changed = False
        for (x, y), cost in list(best.items()):
            for dx, dy in ((dx, dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1) if dx or dy):
                if free(x + dx, y + dy) and free(x + dx, y) and free(x, y + dy):
                    reached = cost + math.hypot(dx, dy)
                    if reached < best.get((x + dx, y + dy), math.inf) - 1e-9:
                        best[x + dx, y + dy] = reached
                        changed = True
    model = ways(*drawn)
    ends = [Position(x + 0.5, y + 0.5) for x, y in (start, goal)]
    there, back = model.leg(ends[0], ends[1]), model.leg(ends[1], ends[0])
    if goal not in best:
        assert isinstance(there, Blocked)
        assert isinstance(back, Blocked)
    else:
        assert metres(there) == pytest.approx(best[goal])
        assert there == back


@given(rows, st.data())
def test_no_way_is_shorter_than_euclid_and_the_triangle_inequality_holds(drawn: list[str], data: st.DataObject) -> None:
    points = st.builds(
        Position,
        st.integers(0, 4 * len(drawn[0])).map(lambda n: n / 4),
        st.integers(0, 4 * len(drawn)).map(lambda n: n / 4),
    )
    a, b, c = data.draw(points), data.draw(points), data.draw(points)
    model = ways(*drawn)
    there, on, whole = model.leg(a, b), model.leg(b, c), model.leg(a, c)
    if isinstance(there, Leg):
        assert there.distance_m >= math.hypot(a.x_m - b.x_m, a.y_m - b.y_m) - 1e-9
        if isinstance(on, Leg):
            assert metres(whole) <= there.distance_m + on.distance_m + 1e-6


def test_large_grids_forget_their_oldest_searches(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("missiontree.estimation.grid._CELLS_REMEMBERED", 30)
    model = ways(".....")  # 21 cells with the border: two searches are kept
    first = [model.leg(Position(x + 0.5, 0.5), Position(4.5, 0.5)) for x in range(4)]
    again = [model.leg(Position(x + 0.5, 0.5), Position(4.5, 0.5)) for x in range(4)]
    assert first == again == [Leg(4), Leg(3), Leg(2), Leg(1)]
    assert len(model._trees) == 2
