"""The verifier against constraints whose meaning is plain."""

from __future__ import annotations

import pytest

from missiontree.scheduling.cpsat.model import (
    Affine,
    AtMostOne,
    Clause,
    Constraint,
    Cumulative,
    ExactlyOne,
    Interval,
    Linear,
    Model,
    NoOverlap,
    Routes,
)
from missiontree.scheduling.cpsat.search import search
from missiontree.scheduling.cpsat.verify import broken


def model(*constraints: Constraint, variables: int = 4, most: int = 9) -> Model:
    """A model whose variables 1, 2, … go from 0 to ``most``; variable 0 is the literal that holds."""
    made = Model()
    for _ in range(variables):
        made.integer(0, most)
    for constraint in constraints:
        made.add(constraint)
    return made


def span(start: int, length: int, *when: int) -> Interval:
    """An interval that starts at a variable."""
    return Interval(Affine(start), Affine(None, length), Affine(start, length), when)


@pytest.mark.parametrize(
    ("constraints", "kept", "not_kept"),
    [
        pytest.param([Linear(((1, 1), (-1, 2)), 0, 3)], (5, 4, 0, 0), (5, 1, 0, 0), id="a difference within 0 to 3"),
        pytest.param([Linear(((1, 1),), 5, 9, (2,))], (1, 0, 0, 0), (1, 1, 0, 0), id="only where a literal holds"),
        pytest.param([Linear(((1, 1),), 5, 9, (-3,))], (1, 1, 0, 0), (1, 0, 0, 0), id="only where a literal does not"),
        pytest.param([Clause((1, -3))], (0, 0, 0, 0), (0, 1, 0, 0), id="one of two"),
        pytest.param([ExactlyOne((1, 2, 3))], (0, 1, 0, 0), (1, 1, 0, 0), id="exactly one, not two"),
        pytest.param([ExactlyOne((1, 2, 3))], (0, 1, 0, 0), (0, 0, 0, 0), id="exactly one, not none"),
        pytest.param([AtMostOne((1, 2))], (0, 0, 0, 0), (1, 1, 0, 0), id="at most one"),
        pytest.param(
            [Interval(Affine(1), Affine(2), Affine(3))], (1, 2, 3, 0), (1, 2, 4, 0), id="start and size are end"
        ),
        pytest.param([span(1, 3), span(2, 2), NoOverlap((0, 1))], (2, 0, 0, 0), (1, 0, 0, 0), id="one after the other"),
        pytest.param([span(1, 3), span(2, 0), NoOverlap((0, 1))], (0, 3, 0, 0), (0, 1, 0, 0), id="nothing inside"),
        pytest.param(
            [span(1, 3), span(2, 2, 3), NoOverlap((0, 1))], (0, 0, 0, 0), (0, 0, 1, 0), id="only what is there"
        ),
        pytest.param(
            [span(1, 3), span(2, 3), span(3, 3), Cumulative((0, 1, 2), 2)],
            (0, 0, 3, 0),
            (0, 1, 2, 0),
            id="two at a time",
        ),
        pytest.param(
            [Routes(((0, 1, 1), (0, 2, 2), (1, 2, 3), (1, 0, 4), (2, 0, 0)))],
            (1, 0, 1, 0),
            (1, 1, 1, 0),
            id="every node once",
        ),
        pytest.param(
            [Routes(((0, 1, 0), (1, 0, 0), (2, 3, 1), (3, 2, 2), (0, 2, 3), (3, 0, 4)))],
            (1, 0, 1, 1),
            (1, 1, 0, 0),
            id="no tour apart from node 0",
        ),
    ],
)
def test_answers_are_told_from_wrong_ones_and_the_solver_agrees(
    constraints: list[Constraint], kept: tuple[int, ...], not_kept: tuple[int, ...]
) -> None:
    """The same values, fixed, are feasible and infeasible to the solver."""
    made = model(*constraints)
    assert list(broken(made, [1, *kept])) == []
    assert len(list(broken(made, [1, *not_kept]))) == 1
    for values, verdict in ((kept, "optimal"), (not_kept, "infeasible")):
        fixed = model(*constraints)
        fixed.domains[1:] = [(value, value) for value in values]
        assert search(fixed, 60, lambda: False).verdict == verdict


def test_values_outside_their_domain_are_found() -> None:
    assert list(broken(model(variables=1), [1, 10])) == ["variable 1 is 10, not within 0 to 9"]
