"""Comparing two ways of doing a subtree without spelling them out."""

from __future__ import annotations

from missiontree.allocation.item import LONG_DESCENT, Item, choices_of


def ranked(*items: Item) -> tuple[Item, ...]:
    """Give ranks to the items of one list, best first."""
    for rank, item in enumerate(items):
        item.rank = rank
    return items


def test_utility_comes_before_choices() -> None:
    assert Item(2, Item(2), xor=7, place=1) < Item(1, Item(1), xor=7, place=0)


def test_equal_utilities_go_by_the_chosen_child() -> None:
    assert Item(1, Item(1), xor=7, place=0) < Item(1, Item(1), xor=7, place=1)
    assert not Item(1, Item(1), xor=7, place=1) < Item(1, Item(1), xor=7, place=0)


def test_the_left_part_decides_before_the_right() -> None:
    # Left: 5 by child 1 is ranked before 3 by child 0. Right: 4, then 2. Both sums are 7; child 0 comes first.
    better, worse = ranked(Item(5, Item(5), xor=1, place=1), Item(3, Item(3), xor=1, place=0))
    high, low = ranked(Item(4, Item(4), xor=9, place=0), Item(2, Item(2), xor=9, place=1))
    assert Item(7, worse, high) < Item(7, better, low)


def test_with_the_same_left_part_the_right_decides() -> None:
    left = Item(1)
    first, second = ranked(Item(4, Item(4), xor=9, place=0), Item(4, Item(4), xor=9, place=1))
    assert Item(5, left, first) < Item(5, left, second)


def test_choices_are_collected_from_all_parts() -> None:
    item = Item(3, Item(1, Item(1), xor=1, place=2), Item(2, Item(2, Item(2), xor=5, place=0), xor=4, place=1))
    assert choices_of(item) == {1: 2, 4: 1, 5: 0}


def test_a_long_descent_is_remembered() -> None:
    """Two chains of different utility that differ at the bottom only; the second comparison need not go there again."""
    first, second = Item(1, Item(1), xor=1, place=0), Item(2, Item(2), xor=1, place=1)
    settled = Item(0)
    for _ in range(3 * LONG_DESCENT):
        first, second = Item(first.utility, first, settled), Item(second.utility, second, settled)
    extra, none = ranked(Item(1, Item(1), xor=9, place=0), Item(0, Item(0), xor=9, place=1))
    assert Item(2, first, extra) < Item(2, second, none)
    assert first.remembered == {second: True}
