"""The tidy layout: what makes a drawn tree readable, argued on random trees."""

from collections import defaultdict
from collections.abc import Sequence
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.reporting.tree.layout import Layout, tidy_layout

GAP = 2.0


def children_of(parents: Sequence[int]) -> list[list[int]]:
    below: list[list[int]] = [[] for _ in parents]
    for node, parent in enumerate(parents):
        if parent >= 0:
            below[parent].append(node)
    return below


@st.composite
def trees(draw: st.DrawFn) -> list[list[int]]:
    """Trees of up to 40 nodes: lists of children, parents first."""
    size = draw(st.integers(1, 40))
    return children_of([-1, *(draw(st.integers(0, node - 1)) for node in range(1, size))])


@st.composite
def boxes(draw: st.DrawFn) -> tuple[list[list[int]], list[float]]:
    """A tree and a width per node; whole numbers, so that halves and quarters are exact."""
    children = draw(trees())
    return children, draw(st.lists(st.integers(1, 20).map(float), min_size=len(children), max_size=len(children)))


def rows(layout: Layout) -> list[list[int]]:
    """Nodes of each level, in the order of their numbers."""
    found: dict[int, list[int]] = defaultdict(list)
    for node, level in enumerate(layout.level):
        found[level].append(node)
    return [found[level] for level in sorted(found)]


def in_order(children: list[list[int]]) -> list[list[int]]:
    """Nodes of each level from left to right, as the order of siblings has it."""
    result, row = [], [0]
    while row:
        result.append(row)
        row = [child for node in row for child in children[node]]
    return result


@given(boxes())
def test_boxes_of_a_level_keep_their_order_and_their_distance(drawn: tuple[list[list[int]], list[float]]) -> None:
    children, widths = drawn
    layout = tidy_layout(children, widths, GAP)
    for row in in_order(children):
        for left, right in pairwise(row):
            room = layout.x[right] - widths[right] / 2 - layout.x[left] - widths[left] / 2
            assert room >= GAP - 1e-9


@given(boxes())
def test_parents_stand_over_the_middle_of_their_children(drawn: tuple[list[list[int]], list[float]]) -> None:
    children, widths = drawn
    layout = tidy_layout(children, widths, GAP)
    for node, below in enumerate(children):
        if below:
            assert layout.x[node] == pytest.approx((layout.x[below[0]] + layout.x[below[-1]]) / 2)


@given(boxes())
def test_levels_are_depths_and_the_width_is_what_the_boxes_need(drawn: tuple[list[list[int]], list[float]]) -> None:
    children, widths = drawn
    layout = tidy_layout(children, widths, GAP)
    assert [sorted(row) for row in in_order(children)] == rows(layout)
    assert min(x - width / 2 for x, width in zip(layout.x, widths, strict=True)) == pytest.approx(0)
    assert max(x + width / 2 for x, width in zip(layout.x, widths, strict=True)) == pytest.approx(layout.width)


@given(boxes(), boxes())
def test_equal_subtrees_look_equal_wherever_they_stand(
    subtree: tuple[list[list[int]], list[float]], other: tuple[list[list[int]], list[float]]
) -> None:
    """The same subtree twice below one root, and once more two levels down, with another tree between them."""
    children: list[list[int]] = [[], []]
    widths = [3.0, 5.0]
    copies = []
    for grown, parent in ((subtree, 0), (other, 0), (subtree, 0), (subtree, 1)):
        start = len(children)
        children += [[start + child for child in below] for below in grown[0]]
        widths += grown[1]
        children[parent].append(start)
        if grown is subtree:
            copies.append(start)
    children[0].append(1)
    layout = tidy_layout(children, widths, GAP)
    shapes = [[layout.x[copy + node] - layout.x[copy] for node in range(len(subtree[0]))] for copy in copies]
    assert shapes[0] == pytest.approx(shapes[1])
    assert shapes[0] == pytest.approx(shapes[2])


@given(boxes())
def test_a_mirrored_tree_is_laid_out_as_the_mirror_image(drawn: tuple[list[list[int]], list[float]]) -> None:
    children, widths = drawn
    layout = tidy_layout(children, widths, GAP)
    mirror = tidy_layout([below[::-1] for below in children], widths, GAP)
    assert [layout.width - x for x in layout.x] == pytest.approx(list(mirror.x))


@given(boxes(), st.integers(0, 12).map(float))
def test_straight_edges_cost_neither_order_nor_distance(
    drawn: tuple[list[list[int]], list[float]], straight: float
) -> None:
    children, widths = drawn
    layout = tidy_layout(children, widths, GAP, straight=straight)
    for row in in_order(children):
        for left, right in pairwise(row):
            room = layout.x[right] - widths[right] / 2 - layout.x[left] - widths[left] / 2
            assert room >= GAP - 1e-9
    for node, below in enumerate(children):
        if below:
            assert layout.x[node] == pytest.approx((layout.x[below[0]] + layout.x[below[-1]]) / 2)
            nearest = min((abs(layout.x[child] - layout.x[node]) for child in below[1:-1]), default=0.0)
            assert nearest < 1e-9 or nearest > straight - 1e-9


def test_a_child_nearly_below_its_parent_stands_below_it() -> None:
    # leaves 4, 4 and 8 wide with 2 between: middles at 2, 8 and 16, so the second would be 1 left of the middle, 9;
    # the first gives way by 2, and everything is counted from its edge again
    children, widths = [[1, 2, 3], [], [], []], [4.0, 4.0, 4.0, 8.0]
    assert tidy_layout(children, widths, 2).x == (9, 2, 8, 16)
    assert tidy_layout(children, widths, 2, straight=1).x == (10, 2, 10, 18)
    assert tidy_layout([[3, 2, 1], [], [], []], widths, 2, straight=1).x == (12, 20, 12, 4)
    assert tidy_layout(children, widths, 2, straight=0.9).x == (9, 2, 8, 16)


@given(boxes(), st.data())
def test_frames_keep_everything_else_out(drawn: tuple[list[list[int]], list[float]], data: st.DataObject) -> None:
    children, widths = drawn
    framed = data.draw(st.sets(st.sampled_from(children[0]))) if children[0] else set()
    layout = tidy_layout(children, widths, GAP, framed, padding=1.0)
    assert sorted(layout.spans) == sorted(framed)
    for frame, (low, high) in layout.spans.items():
        inside, stack = set(), [frame]
        while stack:
            inside.add(node := stack.pop())
            stack.extend(children[node])
        for node in range(1, len(children)):
            left, right = layout.x[node] - widths[node] / 2, layout.x[node] + widths[node] / 2
            if node in inside:
                assert low + 1 - 1e-9 <= left < right <= high - 1 + 1e-9
            elif max(layout.level[member] for member in inside) >= layout.level[node]:
                assert right <= low - GAP + 1e-9 or left >= high + GAP - 1e-9


@given(boxes())
def test_the_same_tree_gets_the_same_layout(drawn: tuple[list[list[int]], list[float]]) -> None:
    children, widths = drawn
    assert tidy_layout(children, widths, GAP) == tidy_layout(children, widths, GAP)


def test_three_leaves_by_hand() -> None:
    layout = tidy_layout([[1, 2, 3], [], [], []], [4, 4, 6, 4], 2)
    # leaves 4, 6 and 4 wide with 2 between: middles at 2, 9 and 16, the root over the middle of 2 and 16
    assert layout == Layout((9, 2, 9, 16), (0, 1, 1, 1), 18, {})


def test_a_small_subtree_between_large_ones_stands_in_the_middle_of_its_room() -> None:
    # children 1 and 3 have three leaves of width 2 each, child 2 has none; all boxes 2 wide, gap 2
    children = [[1, 2, 3], [4, 5, 6], [], [7, 8, 9], [], [], [], [], [], []]
    layout = tidy_layout(children, [2.0] * 10, 2)
    # leaves at 1, 5, 9 and 13, 17, 21; their parents at 5 and 17; the small one half way
    assert layout.x[1:4] == (5, 11, 17)
    assert layout.x[0] == 11


def test_a_wide_parent_over_a_narrow_child() -> None:
    assert tidy_layout([[1], []], [10, 2], 2) == Layout((5, 5), (0, 1), 10, {})


def test_deep_and_bushy_trees_need_no_recursion() -> None:
    """A chain of 20,000 nodes, each with a leaf beside the next: copying outlines would take minutes."""
    size = 20_000
    children = [[node + 1, size + node + 1] for node in range(size - 1)] + [[] for _ in range(size + 1)]
    layout = tidy_layout(children, [1.0] * len(children), 1.0)
    assert max(layout.level) == size - 1
