"""Links that others imply are dropped, and no others."""

from __future__ import annotations

from itertools import pairwise, product

from hypothesis import given
from hypothesis import strategies as st

from missiontree.authoring.composing.reduction import MAX_PAIRS, without_implied
from missiontree.authoring.methods.outline import Outline, Piece
from missiontree.routines.library import built_in

SEARCH = built_in().by_id["Search"]


def leaf(name: str) -> Piece:
    return Piece(name, SEARCH)


def links_of(outline: Outline) -> list[tuple[str, str]]:
    return [(first.label, second.label) for first, second, _ in outline.links]


def outlined(pieces: list[Piece], links: list[tuple[Piece, Piece]]) -> Outline:
    outline = Outline(pieces)
    for first, second in links:
        outline.link(first, second)
    return outline


def test_the_long_way_makes_the_short_one_needless() -> None:
    a, b, c = leaf("a"), leaf("b"), leaf("c")
    outline = outlined([a, b, c], [(a, c), (a, b), (b, c)])
    assert without_implied(outline, []) == []
    assert links_of(outline) == [("a", "b"), ("b", "c")]


def test_what_nobody_said_may_make_what_was_said_needless_and_stays() -> None:
    """Find the visitor and guide her, then bring the crate: the search before the guiding, which is before the bringing."""
    find, guide, bring = leaf("find"), leaf("guide"), leaf("bring")
    outline = outlined([find, guide, bring], [(find, bring), (guide, bring)])
    assert without_implied(outline, [(find, guide)]) == [(find, guide)]
    assert links_of(outline) == [("guide", "bring")]


def test_a_link_between_tasks_orders_all_that_they_hold() -> None:
    a, b, c = leaf("a"), leaf("b"), leaf("c")
    first, second = Piece("first", pieces=[a, b]), Piece("second", pieces=[c])
    outline = outlined([first, second], [(first, second), (a, c)])
    without_implied(outline, [])
    assert links_of(outline) == [("first", "second")]


def test_nothing_follows_by_way_of_what_may_not_be_done() -> None:
    """If the other way is chosen, b is not done, and only the direct link keeps a before c."""
    a, b, other, c = leaf("a"), leaf("b"), leaf("other"), leaf("c")
    either = Piece("either", pieces=[b, other], gate="xor")
    outline = outlined([a, either, c], [(a, b), (b, c), (a, c)])
    without_implied(outline, [])
    assert ("a", "c") in links_of(outline)


def test_a_circle_and_a_great_many_links_are_left_alone() -> None:
    a, b = leaf("a"), leaf("b")
    circle = outlined([a, b], [(a, b), (b, a)])
    without_implied(circle, [])
    assert len(circle.links) == 2
    many = [leaf(str(number)) for number in range(100)]
    # 50 x 50 pairs are more than are looked at.
    wide = Outline(many, [(one, other, "precedence") for one, other in product(many[:50], many[50:])])
    assert len(wide.links) > MAX_PAIRS
    without_implied(wide, [])
    assert len(wide.links) == 2500


def test_until_is_no_order() -> None:
    a, b = leaf("a"), leaf("b")
    outline = outlined([a, b], [(a, b)])
    outline.link(a, b, "until")
    without_implied(outline, [])
    assert len(outline.links) == 2


@given(st.sets(st.tuples(st.integers(0, 6), st.integers(0, 6)).filter(lambda pair: pair[0] < pair[1])))
def test_the_same_leaves_stay_in_the_same_order(pairs: set[tuple[int, int]]) -> None:
    """Whatever the links, their closure is the same before and after, and none that is left is implied by the rest."""
    leaves = [leaf(str(number)) for number in range(7)]
    outline = outlined(leaves, [(leaves[a], leaves[b]) for a, b in sorted(pairs)])
    without_implied(outline, [])
    kept = {(int(a), int(b)) for a, b in links_of(outline)}
    assert closure(kept) == closure(pairs)
    assert all(closure(kept - {pair}) != closure(pairs) for pair in kept)


def closure(pairs: set[tuple[int, int]]) -> set[tuple[int, int]]:
    found = set(pairs)
    for middle, first, second in product(range(7), repeat=3):
        if {(first, middle), (middle, second)} <= found:
            found.add((first, second))
    return found


def test_a_long_chain_stays_as_it_is() -> None:
    leaves = [leaf(str(number)) for number in range(100)]
    outline = outlined(leaves, list(pairwise(leaves)))
    without_implied(outline, [])
    assert len(outline.links) == 99
