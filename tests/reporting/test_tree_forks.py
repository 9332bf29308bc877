"""Where edges run, and how much room there is for them."""

from __future__ import annotations

import pytest

from missiontree.reporting.tree.forks import MOST_ALIGNED, MOST_DROP, is_marked
from missiontree.reporting.tree.marks import MARK_BELOW, MARK_HEIGHT
from missiontree.reporting.tree.placing import Placed, draft_of, placed
from missiontree.reporting.tree.rows import FRAME_PADDING
from tests.reporting.tree_builders import Sprout, routine, shape, step, task
from tests.reporting.tree_geometry import box_of


def drawn(root: Sprout) -> Placed:
    return placed(draft_of(shape(root)))


def test_and_is_marked_over_several_parts_and_xor_over_any() -> None:
    tree = shape(task("a", task("b", routine("c")), task("d", routine("e"), gate="xor"), routine("f")))
    assert [is_marked(tree, node) for node in range(6)] == [True, False, False, True, False, False]


def test_edges_part_below_the_mark_and_turn_down_above_their_boxes() -> None:
    tree = drawn(task("a", routine("b"), routine("c")))
    [fork] = tree.forks
    assert fork.foot == (tree.rows.x[0], box_of(tree, 0).bottom)
    assert fork.at == (tree.rows.x[0], tree.rows.bottoms[0] + MARK_BELOW + MARK_HEIGHT)
    for branch, child in zip(fork.branches, (1, 2), strict=True):
        assert branch.over == (tree.rows.x[child], tree.rows.tops[1] - FRAME_PADDING)
        assert branch.end == (tree.rows.x[child], box_of(tree, child).top)
        assert branch.tick_at == branch.over
        assert branch.path().count("L") == 2


def test_the_room_below_a_fork_grows_with_its_width_up_to_a_bound() -> None:
    def room(count: int) -> float:
        tree = drawn(task("all", *(task(f"t{number}", routine(f"r{number}")) for number in range(count))))
        return tree.rows.tops[1] - tree.rows.bottoms[0]

    assert room(2) < room(12) < room(30) == room(60)
    assert room(60) == pytest.approx(MARK_BELOW + MARK_HEIGHT + MOST_DROP + FRAME_PADDING)


def test_only_the_first_action_of_a_robot_has_an_edge_of_its_own() -> None:
    tree = drawn(task("a", step("b"), step("c"), routine("d")))
    [fork] = tree.forks
    assert [branch.child for branch in fork.branches] == [1, 3]
    assert fork.ways == 2


def test_boxes_in_a_column_hang_on_one_line() -> None:
    """45 leaves stand in columns: of each column, the first edge goes the whole way, the next ones from turn to turn."""
    tree = drawn(task("all", *(routine(f"r{number}") for number in range(45))))
    [fork] = tree.forks
    first, second, third, *_ = fork.branches
    assert first.turn is not None
    assert second.turn is not None
    assert first.before is None
    assert (second.before, third.before) == (first.turn, second.turn)
    assert first.turn[0] == second.turn[0] < box_of(tree, 1).left
    assert second.end == (box_of(tree, 2).left, tree.rows.y[2])
    assert second.path(whole=True).count("L") == 3
    assert second.path(whole=False).count("L") == 2
    assert second.turn[0] < second.tick_at[0] < second.end[0]


def test_a_mark_stands_near_its_box_in_a_row_that_is_much_higher() -> None:
    """A, B and C share a row: C's many words make it high, so that A's mark would stand far below A; B is a little lower than C only."""
    long = "Guide everybody who is in the building to the assembly point by the gate, then count them twice and report"
    tree = drawn(
        task(
            "all",
            task("A", routine("a1"), routine("a2")),
            task(long, routine("b1"), routine("b2")),
            task(long[:-11] + ".", routine("c1"), routine("c2")),
        )
    )
    high = tree.rows.bottoms[1]
    marks = {fork.node: fork for fork in tree.forks if tree.rows.level[fork.node] == 1}
    for node, fork in marks.items():
        below = high - box_of(tree, node).bottom
        assert fork.mark_top == (high if below <= MOST_ALIGNED else box_of(tree, node).bottom) + MARK_BELOW
        assert fork.foot[1] < fork.mark_top
        assert fork.mark_top + MARK_HEIGHT <= fork.at[1]
    near = [fork.mark_top < high for fork in marks.values()]
    assert near == [True, False, False]
