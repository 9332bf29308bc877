"""The tree boiled down: what is settled shrinks to numbers, what is left to choose stays."""

from __future__ import annotations

from missiontree.allocation.core import Core, core_of, narrowed
from missiontree.allocation.flat import flatten
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.purses import purses_of
from missiontree.mission.estimate import Weights
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_


def core(root: Spec, energy: float = 5) -> Core:
    flat = flatten(grounded(root), trivial_fleet(limits={"energy_j": energy}), Weights())
    possible = structurally_possible(flat)
    return core_of(flat, possible, purses_of(flat, possible))


def test_nothing_to_choose_is_one_part() -> None:
    settled = core(
        and_(leaf("a", quality=1, uses={"energy_j": 3}), xor_(leaf("b", quality=2, uses={"energy_j": 3}), xor_()))
    )
    # 1 + 2, and two units of 3 from a purse that holds one.
    assert (settled.utility, settled.uses, settled.options) == ([3_000_000], [((0, 2),)], [()])


def test_a_way_and_what_it_amounts_to() -> None:
    # Preorder: 0 and, 1 leaf s, 2 and, 3 xor over 4 (impossible), 5 and 6; so a and b stand at the places 1 and 2.
    boiled = core(and_(leaf("s", quality=1), and_(xor_(xor_(), leaf("a", quality=2), leaf("b", uses={"energy_j": 9})))))
    (pick,) = [part for part in range(len(boiled)) if boiled.options[part]]
    assert [(option.xor, option.place) for option in boiled.options[pick]] == [(3, 1), (3, 2)]
    way, utility, used = boiled.way_under(len(boiled) - 1, {pick: 0})
    assert (way, utility, used) == ({pick: 0}, 3_000_000, {})
    way, utility, used = boiled.way_under(len(boiled) - 1, {pick: 1})
    assert (way, utility, used) == ({pick: 1}, 2_000_000, {0: 1})
    assert boiled.taken(way) == {3: 2}


def test_the_best_way_takes_the_first_of_equal_options_whatever_they_use() -> None:
    """5 or 5 with 9 J of 5, and 1 or (2 and the better of 3 and 4): 5 + 2 + 4."""
    boiled = core(
        and_(
            xor_(leaf("a", quality=5, uses={"energy_j": 9}), leaf("b", quality=5)),
            xor_(
                leaf("c", quality=1),
                and_(leaf("d", quality=2), xor_(leaf("e", quality=3), leaf("f", quality=4, uses={"energy_j": 1}))),
            ),
        )
    )
    most, taken = boiled.best()
    way, utility, used = boiled.way_under(len(boiled) - 1, taken)
    assert (most, utility, used) == (11_000_000, 11_000_000, {0: 10})
    assert [index for _, index in sorted(way.items(), key=lambda pick: boiled.options[pick[0]][0].xor)] == [0, 1, 1]


def test_nested_ands_become_one_sum() -> None:
    pairs = [xor_(leaf(f"a{n}"), leaf(f"b{n}")) for n in range(4)]
    boiled = core(and_(and_(pairs[0], pairs[1]), and_(pairs[2], pairs[3])))
    # 8 leaves, 4 picks, and the whole.
    assert len(boiled) == 13
    assert [len(parts) for parts in boiled.parts if parts] == [4]


def test_a_narrowed_core_knows_what_it_no_longer_asks() -> None:
    # Preorder: 0 and, 1 xor over 2 and 3, 4 xor over 5 and 6.
    boiled = core(
        and_(xor_(leaf("a", quality=1), leaf("b", quality=2)), xor_(leaf("c", quality=4), leaf("d", quality=8)))
    )
    kept = [[1] if options and options[0].xor == 1 else [0, 1] if options else [] for options in boiled.options]
    narrow = narrowed(boiled, kept)
    # What is left: two leaves, the pick between them, and b's 2 beside it.
    assert len(narrow) == 4
    (pick,) = [part for part in range(len(narrow)) if narrow.options[part]]
    assert narrow.way_under(len(narrow) - 1, {pick: 1})[1] == 10_000_000
    assert narrow.taken({pick: 1}) == {1: 1, 4: 1}


def test_narrowing_forgets_what_stands_below_a_lost_option() -> None:
    # Preorder: 0 xor, 1 leaf a, 2 xor over 3 and 4.
    boiled = core(xor_(leaf("a", quality=1), xor_(leaf("b", quality=2), leaf("c", quality=4))))
    narrow = narrowed(
        boiled, [[0] if options and options[0].xor == 0 else [0, 1] if options else [] for options in boiled.options]
    )
    assert (narrow.utility, narrow.options, narrow.taken({})) == ([1_000_000], [()], {0: 0})


def test_what_belongs_to_an_impossible_subtree_does_not_stand_for_the_whole() -> None:
    """The choice between a and b is boiled down after that between c and d, and falls away with its task."""
    boiled = core(
        xor_(
            and_(xor_(leaf("a", uses={"energy_j": 1}), leaf("b")), xor_()),
            xor_(leaf("c", quality=5, uses={"energy_j": 2}), leaf("d", quality=1)),
        )
    )
    # Preorder: 0 xor, 1 and, 2 xor, 3 a, 4 b, 5 impossible, 6 xor, 7 c, 8 d.
    assert [option.child for option in boiled.options[-1]] == [7, 8]
    # Two of five joules can never be too many, so no purse counts them.
    assert boiled.way_under(len(boiled) - 1, {len(boiled) - 1: 0})[1:] == (5_000_000, {})
