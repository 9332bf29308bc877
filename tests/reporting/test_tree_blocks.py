"""What stands in columns, and what does not."""

from __future__ import annotations

from hypothesis import given

from missiontree.reporting.tree.blocks import MOST_ACTIONS, blocks_of
from missiontree.reporting.tree.shape import Shape
from tests.reporting.shapes import shapes
from tests.reporting.tree_builders import Sprout, routine, shape, step, task


@given(shapes(80))
def test_every_node_is_in_one_block_and_blocks_form_the_same_tree(drawn: Shape) -> None:
    blocks = blocks_of(drawn)
    assert sorted(node for members in blocks.members for node in members) == list(range(len(drawn.nodes)))
    assert blocks.members[0] == (0,)
    for block, members in enumerate(blocks.members):
        assert all(blocks.of[node] == block for node in members)
        if len(members) > 1:
            assert not any(drawn.children[node] or node in drawn.frames for node in members)
        below = tuple(node for child in blocks.children[block] for node in blocks.members[child])
        assert below == (drawn.children[members[0]] if len(members) == 1 else ())
        assert all(child > block for child in blocks.children[block])


def columns(root: Sprout, frames: tuple[str, ...] = ()) -> list[list[str]]:
    """Labels, block by block, without the root."""
    drawn = shape(root, frames=frames)
    return [[drawn.nodes[node].label for node in members] for members in blocks_of(drawn).members[1:]]


def test_actions_of_one_role_stand_in_a_column_in_their_order() -> None:
    tree = shape(task("all", step("a"), step("b"), step("c"), routine("d")))
    blocks = blocks_of(tree)
    assert blocks.members == ((0,), (1, 2, 3), (4,))
    assert blocks.ordered == (False, True, False)
    assert not blocks.hangs(1)
    assert [blocks.above(node) for node in (1, 2, 3, 4)] == [None, 1, 2, None]


def test_actions_of_several_roles_and_options_are_side_by_side_in_a_small_tree() -> None:
    assert columns(task("all", step("a", role=0), step("b", role=1))) == [["a"], ["b"]]
    assert columns(task("one of", step("a"), step("b"), gate="xor")) == [["a"], ["b"]]


def test_long_sequences_take_several_columns_of_nearly_equal_height() -> None:
    steps = [step(f"s{number}") for number in range(MOST_ACTIONS + 3)]  # 15: 7 and 8
    assert list(map(len, columns(task("all", *steps)))) == [7, 8]


def test_leaves_of_a_large_tree_stand_in_columns_that_hang_on_a_line() -> None:
    """41 nodes: columns of up to three. Seven leaves take three columns of two, two and three."""
    parts = [task(f"t{number}", *(routine(f"r{number}.{leaf}") for leaf in range(7))) for number in range(5)]
    drawn = shape(task("all", *parts))
    assert len(drawn.nodes) == 41
    blocks = blocks_of(drawn)
    assert [len(blocks.members[child]) for child in blocks.children[1]] == [2, 2, 3]
    assert all(blocks.hangs(child) for child in blocks.children[1])


def test_many_siblings_take_about_as_many_columns_as_rows() -> None:
    def heights(count: int) -> list[int]:
        return list(map(len, columns(task("all", *(routine(f"r{number}") for number in range(count))))))

    assert heights(12) == [1] * 12
    assert heights(13) == [3, 3, 3, 4]  # the root of 13 is 3.6: at most four rows
    assert heights(16) == [4] * 4
    assert heights(60) == [7, 8] * 4  # at most eight rows


def test_a_task_between_leaves_and_a_framed_leaf_stand_alone() -> None:
    leaves = [routine(f"x{number}") for number in range(7)]
    others = task("others", *(task(f"t{number}", routine(f"y{number}")) for number in range(20)))
    inner = task("t", step("a"))
    assert columns(task("all", *leaves[:2], inner, *leaves[2:5], others))[:3] == [
        ["x0", "x1"],
        ["t"],
        ["x2", "x3", "x4"],
    ]
    assert columns(task("all", *leaves[:4], others), frames=("x1",))[:3] == [["x0"], ["x1"], ["x2", "x3"]]
