"""Scores derived by hand from 2PR / (P + R)."""

from random import Random
from typing import Any

import pytest

from missiontree.evaluation.differences import differences
from missiontree.evaluation.expected import Expected
from missiontree.evaluation.score import score
from missiontree.mission.tree import Link, MissionTree
from tests.evaluation.trees import brief, leaf, task, tree


def scored(made: MissionTree, *plan: Any, order: tuple[str, ...] = ()) -> float:
    return score(Expected(plan=plan, order=order), made, brief())


def test_the_same_is_1_and_nothing_in_common_is_0() -> None:
    made = tree(leaf("s", "Search(cat)"), leaf("t", "Transport(cat, mom)"), links=[Link("s", "t")], new=["Cat", "Mom"])
    assert scored(made, "Search(Cat)", "Transport(Cat, Mom)", order=("1 < 2",)) == 1.0
    assert scored(made, "Follow(Cat)") == 0.0


def test_an_order_that_is_missing_costs_its_part() -> None:
    """The plan says 3 things, the tree 2, both of which the plan says: P = 1, R = 2/3, 2PR / (P + R) = 0.8."""
    made = tree(leaf("s", "Search(cat)"), leaf("t", "Transport(cat, mom)"), new=["Cat", "Mom"])
    assert scored(made, "Search(Cat)", "Transport(Cat, Mom)", order=("1 < 2",)) == pytest.approx(0.8)


def test_a_routine_that_is_missing_takes_its_order_along() -> None:
    """Of 3 things 1 is there, and nothing else: P = 1, R = 1/3, the score is 0.5."""
    made = tree(leaf("s", "Search(cat)"), new=["Cat"])
    assert scored(made, "Search(Cat)", "Transport(Cat, Mom)", order=("1 < 2",)) == pytest.approx(0.5)


def test_what_is_too_much_costs_as_well() -> None:
    """The tree says 2 things, 1 of them right: P = 1/2, R = 1, the score is 2/3."""
    made = tree(leaf("s", "Search(cat)"), leaf("f", "Follow(cat)"), new=["Cat"])
    assert scored(made, "Search(Cat)") == pytest.approx(2 / 3)


def test_only_what_does_not_follow_is_counted_but_what_follows_is_known() -> None:
    """
    Three routines in a row, 5 things: 3 routines and 2 orders. The tree has the first before each of the others, which the plan
    says, too: P = 5/5. Of the plan's orders 1 < 2 is kept and 2 < 3 is not: R = 4/5. The score is 8/9.
    """
    made = tree(
        leaf("a", "Reach(a)"),
        leaf("b", "Reach(b)"),
        leaf("c", "Reach(c)"),
        links=[Link("a", "b"), Link("a", "c")],
        new=["A", "B", "C"],
    )
    assert scored(made, "Reach(A)", "Reach(B)", "Reach(C)", order=("1 < 2", "2 < 3")) == pytest.approx(8 / 9)


def test_a_choice_that_is_not_left_is_one_thing() -> None:
    """The plan says 2 routines and that they exclude each other; the tree does both: P = 1, R = 2/3."""
    made = tree(leaf("a", "Reach(a)"), leaf("b", "Reach(b)"), new=["A", "B"])
    assert scored(made, {"xor": ["Reach(A)", "Reach(B)"]}) == pytest.approx(0.8)
    chosen = tree(task("c", "xor", leaf("a", "Reach(a)"), leaf("b", "Reach(b)")), new=["A", "B"])
    assert scored(chosen, {"xor": ["Reach(A)", "Reach(B)"]}) == 1.0


def test_robot_types_are_one_thing_of_those_who_restrict_them() -> None:
    """The plan says a routine and who may do it, the tree only the routine: P = 1, R = 1/2. With others named: P = R = 1/2."""
    free, other = tree(leaf("a", "Reach(a)"), new=["A"]), tree(leaf("a", "Reach(a)", "tele_robot"), new=["A"])
    assert scored(free, "Reach(A) by social_robot") == pytest.approx(2 / 3)
    assert scored(other, "Reach(A) by social_robot") == pytest.approx(1 / 2)
    assert scored(other, "Reach(A) by tele_robot") == 1.0


def test_lasting_until_is_one_thing() -> None:
    """2 routines and the until; the tree has another order instead: P = R = 2/3."""
    made = tree(leaf("f", "Follow(a)"), leaf("r", "Reach(b)"), links=[Link("f", "r")], new=["A", "B"])
    assert scored(made, "Follow(A)", "Reach(B)", order=("1 ~ 2",)) == pytest.approx(2 / 3)


def test_bound_robots_that_nobody_asked_for_are_one_thing_too_much() -> None:
    """2 routines and the bond: P = 2/3, R = 1."""
    links = [Link("a", "b", "same_robot")]
    made = tree(leaf("a", "Reach(a)"), leaf("b", "Reach(b)"), links=links, new=["A", "B"])
    assert scored(made, "Reach(A)", "Reach(B)") == pytest.approx(0.8)


def test_equal_routines_are_matched_for_the_best() -> None:
    """The second visit comes first here; nothing is amiss."""
    made = tree(
        leaf("a", "Reach(a)"),
        leaf("s", "Search(b)"),
        leaf("c", "Reach(a)"),
        links=[Link("c", "s"), Link("s", "a")],
        new=["A", "B"],
    )
    assert scored(made, "Reach(A)", "Search(B)", "Reach(A)", order=("1 < 2", "2 < 3")) == 1.0


def test_fewer_of_a_kind_are_matched_for_the_best() -> None:
    """The plan says 3 routines and 2 orders; the tree has the last visit and its order: P = 3/3, R = 3/5, the score is 3/4."""
    made = tree(leaf("s", "Search(b)"), leaf("a", "Reach(a)"), links=[Link("s", "a")], new=["A", "B"])
    assert scored(made, "Reach(A)", "Search(B)", "Reach(A)", order=("1 < 2", "2 < 3")) == pytest.approx(0.75)


def test_names_are_matched_with_words_left_out() -> None:
    made = tree(leaf("a", "Reach(injured_worker)"), new=["Injured Worker"])
    assert scored(made, "Reach(Worker)") == 1.0


CALLS = ("Reach(a)", "Reach(b)", "Search(a)", "Follow(b)")


def drawn(rng: Random) -> tuple[Expected, MissionTree]:
    """A plan of up to three routines and perhaps a choice, and a tree that differs from it here and there, or not at all."""
    calls = rng.choices(CALLS, k=rng.randint(1, 3))
    types = [rng.choice(("", "", "tele_robot")) for _ in calls]
    choice = rng.random() < 0.3
    count = len(calls) + 2 * choice
    apart = (count - 1, count) if choice else None
    pairs = [(a, b) for a in range(1, count) for b in range(a + 1, count + 1) if (a, b) != apart]
    order = [pair for pair in pairs if rng.random() < 0.4]
    plan: list[Any] = [
        call.replace("(a", "(A").replace("(b", "(B") + (f" by {name}" if name else "")
        for call, name in zip(calls, types, strict=True)
    ]
    plan += [{"xor": ["Reach(A)", "Search(B)"]}] if choice else []

    def sometimes(given: Any, other: Any) -> Any:
        return other if rng.random() < 0.1 else given

    leaves = [
        leaf(f"n{n}", sometimes(call, rng.choice(CALLS)), *sometimes((name,) if name else (), ("social_robot",)))
        for n, (call, name) in enumerate(zip(calls, types, strict=True), start=1)
    ]
    options = (leaf(f"n{count - 1}", "Reach(a)"), leaf(f"n{count}", "Search(b)")) if choice else ()
    children = [*leaves, *([task("c", sometimes("xor", "and"), *options)] if choice else [])]
    links = [Link(f"n{a}", f"n{b}") for a, b in pairs if ((a, b) in order) != (rng.random() < 0.1)]
    expected = Expected(plan=tuple(plan), order=tuple(f"{a} < {b}" for a, b in order))
    return expected, tree(*children, links=links, new=["A", "B"])


def test_the_score_is_1_exactly_if_nothing_differs() -> None:
    """In 1,000 pairs of plans and trees drawn by a seed, hundreds of either kind."""
    alike = 0
    for seed in range(1_000):
        expected, made = drawn(Random(seed))  # noqa: S311
        same = differences(expected, made, brief()) == ()
        near = score(expected, made, brief())
        assert 0 <= near <= 1
        assert (near == 1) == same, seed
        alike += same
    assert 200 < alike < 800
