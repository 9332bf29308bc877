"""Searches stop when they are told to, keep what they have, and give the same in a process of their own."""

from __future__ import annotations

from itertools import count, pairwise

import pytest

from missiontree.scheduling.cpsat.model import Affine, Interval, Linear, Model, NoOverlap
from missiontree.scheduling.cpsat.search import Effort, Found, search

HERE, ALONE = Effort(), Effort(alone=True)


def even() -> Model:
    """Three numbers of 0 to 9, all different, each at least twice the one before: least sum 0 + 1 + 2."""
    model = Model()
    numbers = [model.integer(0, 9) for _ in range(3)]
    for small, large in pairwise(numbers):
        model.at_least(Affine(large), Affine(small), 1)
        model.add(Linear(((1, large), (-2, small)), 0, 9))
    model.objective = tuple((1, number) for number in numbers)
    return model


def endless(jobs: int = 60) -> Model:
    """One machine, jobs that are there one after the other, and a weighted sum of ends: far too many orders to be done with."""
    model = Model()
    spans, weights = [], []
    for number in range(jobs):
        takes, there = 3 + number * 7 % 11, number * 29 % 97 * 3
        start = Affine(model.integer(there, 5000))
        spans.append(model.add(Interval(start, Affine(None, takes), start + takes)))
        weights.append((1 + number * 5 % 9, start.var or 0))
    model.add(NoOverlap(tuple(spans)))
    model.objective = tuple(weights)
    return model


@pytest.mark.parametrize("effort", [HERE, ALONE, Effort(deterministic=True)], ids=["here", "alone", "deterministic"])
def test_the_least_sum_is_found_and_proven(effort: Effort) -> None:
    found = search(even(), 60, lambda: False, effort)
    assert (found.verdict, found.objective, found.bound) == ("optimal", 3, 3)
    assert sum(found.values[1:]) == 3  # the first variable is the literal that holds


@pytest.mark.parametrize("effort", [HERE, ALONE], ids=["here", "alone"])
def test_what_cannot_be_is_infeasible(effort: Effort) -> None:
    model = even()
    model.add(Linear(((1, 1),), 9, 9))
    assert search(model, 60, lambda: False, effort) == Found("infeasible")


@pytest.mark.parametrize("effort", [HERE, ALONE], ids=["here", "alone"])
def test_who_is_told_to_stop_keeps_the_best_answer(effort: Effort) -> None:
    """It is asked to stop once an answer was heard; by then nothing is proven."""
    heard: list[Found] = []
    found = search(endless(), 600, lambda: any(one.values for one in heard), effort, heard.append)
    assert found.verdict == "feasible"
    assert found.values
    assert found.objective is not None
    assert found.bound is None or found.bound < found.objective


@pytest.mark.parametrize("effort", [HERE, ALONE], ids=["here", "alone"])
def test_a_time_limit_ends_it_by_the_clock_that_is_handed_in(effort: Effort) -> None:
    """Each look at the clock is a minute: a limit of 600 s is over after ten looks, long before that in truth."""
    minutes = count(step=60)
    found = search(endless(), 600, lambda: False, effort, clock=lambda: float(next(minutes)))
    assert found.verdict in {"feasible", "unknown"}


def test_nobody_is_asked_who_has_stopped_before() -> None:
    assert search(endless(), 0.0, lambda: True).verdict in {"feasible", "unknown"}
