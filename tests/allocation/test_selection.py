"""What choices select."""

from __future__ import annotations

from missiontree.allocation.flat import flatten
from missiontree.allocation.selection import Selection, select
from missiontree.mission.estimate import Weights
from tests.builders import and_, grounded, leaf, trivial_fleet, xor_


def test_choices_nodes_and_leaves_in_preorder() -> None:
    # 0 and, 1 xor, 2 a, 3 b, 4 xor, 5 impossible xor, 6 c
    tree = grounded(and_(xor_(leaf("a"), leaf("b")), xor_(xor_(), leaf("c"))))
    possible = [True] * 7
    possible[5] = False
    # Node 4 has one possible child, so that its choice need not be named.
    selection = select(flatten(tree, trivial_fleet(), Weights()), {1: 1}, possible)
    assert selection == Selection(choices=((1, 3), (4, 6)), nodes=(0, 1, 3, 4, 6), leaves=(3, 6))
