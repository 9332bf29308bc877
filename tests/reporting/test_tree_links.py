"""Links by hand: straight to neighbours, else in lanes between the rows."""

from __future__ import annotations

from itertools import combinations, pairwise

import pytest

from missiontree.mission.tree import LinkKind
from missiontree.reporting.tree.links import LANE, LANES_FROM_LEAVES
from missiontree.reporting.tree.placing import Placed, draft_of, placed
from missiontree.reporting.tree.routes import Run, in_lanes
from tests.reporting.tree_builders import Sprout, routine, shape, step, task
from tests.reporting.tree_geometry import box_of, passes


def drawn(root: Sprout, *links: tuple[str, str, LinkKind]) -> Placed:
    return placed(draft_of(shape(root, links)))


def row(*links: tuple[str, str, LinkKind]) -> Placed:
    """Three leaves A, B, C (1, 2, 3) below a root."""
    return drawn(task("root", routine("A"), routine("B"), routine("C")), *links)


def test_a_precedence_between_neighbours_is_straight_and_goes_from_the_first_to_the_second() -> None:
    tree = row(("A", "B", "precedence"), ("C", "B", "precedence"))
    right, left = tree.arrows
    assert right.points == ((box_of(tree, 1).right, tree.rows.y[1]), (box_of(tree, 2).left, tree.rows.y[1]))
    assert left.points == ((box_of(tree, 3).left, tree.rows.y[1]), (box_of(tree, 2).right, tree.rows.y[1]))


def test_what_would_lie_on_a_straight_arrow_goes_round_below() -> None:
    tree = row(("A", "B", "precedence"), ("B", "A", "precedence"), ("A", "B", "until"))
    straight, *others = tree.arrows
    assert len(straight.points) == 2
    for arrow in others:
        assert len(arrow.points) == 4  # down, along, up
        assert arrow.points[1][1] >= tree.rows.bottoms[1] + LANES_FROM_LEAVES


def test_lanes_lie_apart_and_links_of_one_box_have_ends_of_their_own() -> None:
    tree = row(("A", "C", "precedence"), ("C", "A", "until"))
    levels = [arrow.points[1][1] for arrow in tree.arrows]
    assert abs(levels[0] - levels[1]) == LANE
    assert len({point for arrow in tree.arrows for point in (arrow.points[0], arrow.points[-1])}) == 4


def test_a_link_to_another_depth_passes_beside_the_branch_of_its_end() -> None:
    tree = drawn(task("root", routine("A"), task("B", task("C", routine("D"))), routine("E")), ("A", "D", "precedence"))
    [arrow] = tree.arrows
    # down from A, along to the left of B's branch, down past C, along over D, down to it
    assert arrow.points[0][1] == box_of(tree, 1).bottom
    assert arrow.points[-1][1] == box_of(tree, 4).top
    assert arrow.points[2][0] < box_of(tree, 3).left
    assert len(arrow.points) == 6


def test_upwards_is_the_way_back() -> None:
    tree = drawn(task("root", routine("A"), task("B", task("C", routine("D"))), routine("E")), ("D", "A", "precedence"))
    [arrow] = tree.arrows
    assert arrow.points[0][1] == box_of(tree, 4).top
    assert arrow.points[-1][1] == box_of(tree, 1).bottom


def test_in_a_column_a_precedence_goes_to_the_next_box_and_round_others() -> None:
    steps = task("root", step("a"), step("b"), step("c"))
    tree = drawn(steps, ("a", "b", "precedence"), ("a", "c", "precedence"), ("b", "c", "same_robot"))
    next_one, over, worded = tree.arrows
    assert next_one.points == ((tree.rows.x[1], box_of(tree, 1).bottom), (tree.rows.x[1], box_of(tree, 2).top))
    assert over.points[0][0] == over.points[-1][0] == box_of(tree, 1).right
    assert over.points[1][0] == over.points[2][0] > box_of(tree, 2).right
    assert worded.upright  # there is no room for its word but along the column
    assert worded.label_at[0] > box_of(tree, 2).right


def test_beside_a_high_column_a_link_keeps_to_the_column_not_to_the_subtree() -> None:
    """The last of seven steps stands far below its level, beside what is below its neighbour there."""
    wide = task("wide", *(routine(f"A rather long label {number}") for number in range(5)))
    sequence = [step(f"s{number}") for number in range(7)]
    for root in (task("root", *sequence, wide), task("root", wide, *sequence)):
        tree = drawn(root, ("s6", "wide", "precedence"))
        [arrow] = tree.arrows
        ends = {index for index, node in enumerate(tree.shape.nodes) if node.label in {"s6", "wide"}}
        assert box_of(tree, min(ends)).bottom != box_of(tree, max(ends)).bottom
        for start, end in pairwise(arrow.points):
            for node in range(len(tree.shape.nodes)):
                assert node in ends or not passes(start, end, box_of(tree, node))


def test_lanes_are_shared_by_what_does_not_meet() -> None:
    # 0–10, 40–50 and 80–100 lie in one lane, 5–60 needs another one; short ones come first
    runs = [Run(0, 5, 60, (5, 60)), Run(0, 0, 10, (0, 10)), Run(0, 50, 40, (40, 50)), Run(0, 100, 80, (80, 100))]
    assert in_lanes(runs) == 2
    assert [run.lane for run in runs] == [1, 0, 0, 0]


def test_lanes_keep_some_distance_between_neighbours() -> None:
    runs = [Run(0, 0, 10, (0, 10)), Run(0, 20, 30, (20, 30)), Run(0, 40, 50, (40, 50))]
    assert in_lanes(runs) == 2  # 10 apart is too little, 30 is enough
    assert [run.lane for run in runs] == [0, 1, 0]


@pytest.mark.parametrize("count", [2, 5, 9])
def test_many_links_of_one_box_leave_it_side_by_side(count: int) -> None:
    leaves = [routine(f"A leaf with a long label {number}") for number in range(count + 1)]
    links: list[tuple[str, str, LinkKind]] = [
        (leaves[0].node.label, leaf.node.label, "same_robot") for leaf in leaves[1:]
    ]
    starts = [arrow.points[0][0] for arrow in drawn(task("root", *leaves), *links).arrows]
    apart = [abs(one - other) for one, other in combinations(starts[:5], 2)]
    assert min(apart) >= 6
