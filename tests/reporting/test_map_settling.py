"""
Many labels at once: whoever has other places makes room for one that has none, and who matters more comes first.

Marks stand in a lane of 24 units' height, labels are 60 by 14. Of a mark at (100, 100) with walls on its left, above and below, only the
place right of it is free, from 108 to 168; of one at (180, 100) with a wall on its right, only the place left of it, from 112 to 172.
"""

from __future__ import annotations

from missiontree.reporting.maps.boxes import Box
from missiontree.reporting.maps.labels import Ground, Placed
from missiontree.reporting.maps.settling import Wish, settle

LEFT_WALL, RIGHT_WALL = Box(0, 88, 94, 112), Box(186, 88, 400, 112)
ABOVE, BELOW = Box(0, 0, 400, 88), Box(0, 112, 400, 200)


def ground(*walls: Box) -> Ground:
    found = Ground(Box(0, 0, 400, 200))
    for wall in walls:
        found.take(wall)
    return found


def wish(found: Ground, x: float, *, weight: int = 0, farthest: float = 0.0) -> Wish:
    mark = Box(x - 5, 95, x + 5, 105)
    found.mark(mark)
    return Wish(mark, 60, 14, weight, farthest)


def lefts(places: list[Placed | None]) -> list[float | None]:
    return [None if place is None else place.box.left for place in places]


def test_each_of_the_two_has_one_place_and_both_places_meet() -> None:
    """What the other tests rest on."""
    lane = ground(LEFT_WALL, RIGHT_WALL, ABOVE, BELOW)
    assert lefts(settle(lane, [wish(lane, 100)])) == [108]
    lane = ground(LEFT_WALL, RIGHT_WALL, ABOVE, BELOW)
    assert lefts(settle(lane, [wish(lane, 180)])) == [112]


def test_of_two_that_want_the_only_place_the_one_that_matters_more_gets_it() -> None:
    for first, second, settled in ((1, 0, [None, 112]), (0, 1, [108, None]), (1, 1, [108, None])):
        lane = ground(LEFT_WALL, RIGHT_WALL, ABOVE, BELOW)
        wishes = [wish(lane, 100, weight=first), wish(lane, 180, weight=second)]
        assert lefts(settle(lane, wishes)) == settled


def test_one_that_has_another_place_leaves_the_only_place_to_the_other() -> None:
    """There is room above and below the right one: it likes them less, but comes first and would take the other's."""
    walls = (Box(0, 88, 90, 112), Box(215, 0, 400, 200), Box(0, 0, 150, 88), Box(0, 112, 150, 200))
    lane = ground(*walls)
    assert lefts(settle(lane, [wish(lane, 180)])) == [112]  # alone, it stands where the other's label would be
    lane = ground(*walls)
    first, second = settle(lane, [wish(lane, 180), wish(lane, 96)])
    assert lefts([second]) == [104]
    assert first is not None
    assert first.box.bottom < 95 or first.box.top > 105


def test_who_is_left_over_goes_far_if_that_is_the_only_room() -> None:
    """Above the left mark is a gap of ten units in the wall, too narrow for a label and wide enough for the line to one."""
    lane = ground(LEFT_WALL, RIGHT_WALL, Box(0, 60, 95, 88), Box(105, 60, 400, 88), BELOW)
    near, far = settle(lane, [wish(lane, 180), wish(lane, 100, farthest=128.0)])
    assert lefts([near]) == [112]
    assert far is not None
    assert far.box.bottom < 60
    assert far.leader is not None
