"""Expected plans: numbers of routines, groups, and what a plan may not hold."""

import re
from typing import Any

import pytest

from missiontree.evaluation.expected import Expected, Group


def test_nested_routines_are_numbered_as_they_are_written() -> None:
    plan = Expected(
        plan=("Search(A)", {"xor": ["Reach(B)", {"and": ["Reach(C)", "Reach(D)"]}]}, "Reach(E)"), order=("1 < 5",)
    )
    assert [call.arguments[0] for call in plan.calls] == ["A", "B", "C", "D", "E"]
    assert plan.shape == Group("and", (0, Group("xor", (1, Group("and", (2, 3)))), 4))
    assert str(plan) == "Search(A); xor(Reach(B); and(Reach(C); Reach(D))); Reach(E) | 1 < 5"
    assert hash(plan) == hash(Expected(plan=plan.plan, order=plan.order))


@pytest.mark.parametrize(
    ("plan", "order", "says"),
    [
        ([], (), "at least one routine"),
        ([7], (), "'7' is no entry"),
        ([{"or": ["Reach(A)", "Reach(B)"]}], (), "'or' does not make a group"),
        ([{"xor": ["Reach(A)"]}], (), "at least two"),
        ([{"xor": "Reach(A)"}], (), "needs a list"),
        ([{}], (), "does not make a group"),
        ([["Reach(A)", "Reach(B)"]], (), "a list stands in a list"),
        (["Reach(A)"], ("1 < 2",), "'1 < 2' names routine 2; the plan has 1"),
        (["Transport(A, *)"], (), "'Transport(A, *)' leaves an argument open"),
        (["Reach(A)", "Reach(B)"], ("1 < 2", "1 < 2"), "stands twice"),
        (["Reach(A)", "Reach(B)"], ("1 < 2", "1<2"), "'1<2' stands twice"),
        (["Reach(A)", "Reach(B)", "Reach(C)"], ("1 < 2", "2 < 3", "3 < 1"), "contradicts"),
    ],
)
def test_a_plan_that_means_nothing_is_refused(plan: list[Any], order: tuple[str, ...], says: str) -> None:
    with pytest.raises(ValueError, match=re.escape(says)):
        Expected(plan=tuple(plan), order=order)
