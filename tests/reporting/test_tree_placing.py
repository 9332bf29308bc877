"""What makes a drawn tree readable, argued on random trees with everything at its place."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import replace
from itertools import combinations, pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.reporting.text_box import text_width
from missiontree.reporting.tree.placing import Placed, draft_of, placed
from missiontree.reporting.tree.routes import LINK_SIZE, LINK_WORDS
from missiontree.reporting.tree.rows import FRAME_PADDING
from missiontree.reporting.tree.shape import Shape
from tests.reporting.shapes import shapes
from tests.reporting.tree_geometry import NEAR, Box, box_of, crosses, edges_of, passes

LARGE = 70  # from 41 nodes on, tasks and routines stand in columns too


def drawn(shape: Shape) -> Placed:
    return placed(draft_of(shape), 560.0)


@given(shapes(LARGE))
def test_boxes_do_not_overlap_anywhere_on_the_page(shape: Shape) -> None:
    tree = drawn(shape)
    boxes = [box_of(tree, node) for node in range(len(shape.nodes))]
    for one, other in combinations(boxes, 2):
        assert not one.meets(other)


@given(shapes(LARGE))
def test_levels_are_kept(shape: Shape) -> None:
    """A node's level is its depth; each level lies wholly below the one above, columns begin at its top."""
    tree = drawn(shape)
    blocks = tree.rows.blocks
    assert len(tree.rows.tops) == max(tree.rows.level) + 1
    assert tree.rows.bottoms[-1] <= tree.rows.height
    for node, below in enumerate(shape.children):
        for child in below:
            assert tree.rows.level[child] == tree.rows.level[node] + 1
            assert box_of(tree, child).top > box_of(tree, node).bottom + 10
    for members in blocks.members:
        first = box_of(tree, members[0])
        level = tree.rows.level[members[0]]
        assert tree.rows.tops[level] - NEAR <= first.top
        assert first.bottom <= tree.rows.bottoms[level] + NEAR
        if len(members) > 1:
            assert first.top == pytest.approx(tree.rows.tops[level])


@given(shapes(LARGE))
def test_siblings_keep_their_order_from_left_to_right_and_in_columns_from_the_top_down(shape: Shape) -> None:
    tree = drawn(shape)
    for below in shape.children:
        for one, other in pairwise(below):
            if tree.rows.blocks.of[one] == tree.rows.blocks.of[other]:
                assert tree.rows.x[one] == tree.rows.x[other]
                assert box_of(tree, one).bottom < box_of(tree, other).top
            else:
                assert box_of(tree, one).right < box_of(tree, other).left


@given(shapes(LARGE))
def test_parents_stand_over_the_middle_of_their_parts(shape: Shape) -> None:
    tree = drawn(shape)
    for node, below in enumerate(shape.children):
        if below:
            assert tree.rows.x[node] == pytest.approx((tree.rows.x[below[0]] + tree.rows.x[below[-1]]) / 2)


@given(shapes(12, links=0), shapes(12, links=0))
def test_equal_subtrees_have_equal_shapes_wherever_they_stand(subtree: Shape, other: Shape) -> None:
    """The same subtree twice below a root, and once more two levels further down, with another tree between them."""
    root = replace(subtree.nodes[0], label="Root", gate="and", kind="task", team=(), state="plain")
    nodes, children = [root, root], [[1], []]
    copies = []
    for grown, parent in ((subtree, 0), (other, 0), (subtree, 0), (subtree, 1)):
        start = len(nodes)
        nodes += [replace(node, role=None) for node in grown.nodes]
        children += [[start + child for child in below] for below in grown.children]
        children[parent].append(start)
        if grown is subtree:
            copies.append(start)
    tree = drawn(Shape(tuple(nodes), tuple(map(tuple, children)), ()))
    if any(len(tree.rows.blocks.members[tree.rows.blocks.of[copy]]) > 1 for copy in copies):
        return  # a bare leaf that shares a column with its neighbour: no subtree
    offsets = [[tree.rows.x[copy + node] - tree.rows.x[copy] for node in range(len(subtree.nodes))] for copy in copies]
    assert offsets[0] == pytest.approx(offsets[1])
    assert offsets[0] == pytest.approx(offsets[2])


@given(shapes(LARGE))
def test_edges_of_the_tree_do_not_cross(shape: Shape) -> None:
    stretches = list(edges_of(drawn(shape)))
    for (_, _, one), (_, _, other) in combinations(stretches, 2):
        assert not crosses(one, other)


@given(shapes(LARGE))
def test_edges_of_the_tree_pass_over_no_box(shape: Shape) -> None:
    tree = drawn(shape)
    boxes = [box_of(tree, node) for node in range(len(shape.nodes))]
    for parent, child, (start, end) in edges_of(tree):
        for node, box in enumerate(boxes):
            if node not in {parent, child}:
                assert not passes(start, end, box)


@given(shapes(LARGE, links=16))
def test_links_pass_over_no_box(shape: Shape) -> None:
    tree = drawn(shape)
    assert len(tree.arrows) == len(shape.links)
    boxes = [box_of(tree, node) for node in range(len(shape.nodes))]
    for arrow, (first, second, kind) in zip(tree.arrows, shape.links, strict=True):
        assert arrow.kind == kind
        for start, end in pairwise(arrow.points):
            assert start[0] == pytest.approx(end[0]) or start[1] == pytest.approx(end[1])
            for node, box in enumerate(boxes):
                if node not in {first, second}:
                    assert not passes(start, end, box)


@given(shapes(LARGE, links=16))
def test_links_start_and_end_at_the_edges_of_their_boxes(shape: Shape) -> None:
    tree = drawn(shape)
    for arrow, (first, second, _) in zip(tree.arrows, shape.links, strict=True):
        for (x, y), node in ((arrow.points[0], first), (arrow.points[-1], second)):
            card = tree.cards[node]
            across, down = x - tree.rows.x[node], y - tree.rows.y[node]
            if card.round:
                assert (2 * across / card.width) ** 2 + (2 * down / card.height) ** 2 == pytest.approx(1)
            else:
                at_a_side = abs(across) == pytest.approx(card.width / 2) and abs(down) < card.height / 2
                assert at_a_side or (abs(down) == pytest.approx(card.height / 2) and abs(across) < card.width / 2)


@given(shapes(LARGE, links=24))
def test_no_word_of_a_link_stands_on_another(shape: Shape) -> None:
    tree = drawn(shape)
    words = []
    for arrow in tree.arrows:
        if (text := LINK_WORDS[arrow.kind]) and not arrow.upright:
            x, y, half = *arrow.label_at, text_width(text, LINK_SIZE) / 2
            words.append(Box(x - half, y - 5, x + half, y + 5))
    for one, other in combinations(words, 2):
        assert not one.meets(other)


@given(shapes(LARGE, links=24))
def test_the_word_of_a_link_stands_where_no_other_crosses_it_if_there_is_room(shape: Shape) -> None:
    """Room is a stretch between crossings that is as long as the word and five pixels at either end; half a line off is crossed too."""
    tree = drawn(shape)
    upright = [
        (a[0], min(a[1], b[1]), max(a[1], b[1]))
        for arrow in tree.arrows
        for a, b in pairwise(arrow.points)
        if a[0] == b[0]
    ]
    for arrow in tree.arrows:
        (x, y), half = arrow.label_at, text_width(LINK_WORDS[arrow.kind], LINK_SIZE) / 2
        level = [sorted((a[0], b[0])) for a, b in pairwise(arrow.points) if a[1] == b[1] == y]
        if arrow.upright or not LINK_WORDS[arrow.kind] or not level:
            continue
        [low, high] = next(ends for ends in level if ends[0] <= x <= ends[1])
        crossings = [
            (at, top < y < bottom) for at, top, bottom in upright if top - 6 < y < bottom + 6 and low < at < high
        ]
        widest = max(b - a for a, b in pairwise([low, *sorted(at for at, _ in crossings), high]))
        hidden = [at for at, is_crossed in crossings if is_crossed and x - half < at < x + half]
        assert not hidden or widest < 2 * half + 10 + NEAR


@given(shapes(LARGE))
def test_frames_hold_their_routine_and_nothing_else(shape: Shape) -> None:
    tree = drawn(shape)
    assert sorted(tree.rows.spans) == sorted(shape.frames)
    for frame, (low, high) in tree.rows.spans.items():
        inside, stack = set(), [frame]
        while stack:
            inside.add(node := stack.pop())
            stack.extend(shape.children[node])
        lowest = max(box_of(tree, node).bottom for node in inside)
        border = Box(low, box_of(tree, frame).top - FRAME_PADDING, high, lowest + FRAME_PADDING)
        for node in range(len(shape.nodes)):
            if node in inside:
                assert border.holds(box_of(tree, node))
            else:
                assert not border.meets(box_of(tree, node))


@given(shapes(LARGE))
def test_every_level_stretch_between_rows_has_its_lane_to_itself(shape: Shape) -> None:
    lanes = defaultdict(list)
    for arrow in drawn(shape).arrows:
        if len(arrow.points) > 3:
            for start, end in pairwise(arrow.points):
                if start[1] == end[1] and not arrow.upright:
                    lanes[start[1]].append(tuple(sorted((start[0], end[0]))))
    # ends at boxes in columns may lie at the height of some lane only by chance, and then elsewhere
    for stretches in lanes.values():
        for one, other in pairwise(sorted(stretches)):
            assert one[1] <= other[0] + NEAR


@given(shapes(), st.floats(0, 4000))
def test_the_tree_stands_in_the_middle_of_a_wider_page(shape: Shape, width: float) -> None:
    draft = draft_of(shape)
    tree = placed(draft, width)
    left = min(low for low, _ in (*tree.rows.sides, *tree.rows.spans.values()))
    right = max(high for _, high in (*tree.rows.sides, *tree.rows.spans.values()))
    assert tree.rows.width >= width
    # rooms kept below columns are no wider than these, so the layout's width is theirs
    assert left == pytest.approx(tree.rows.width - right)
