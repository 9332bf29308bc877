"""The checker on plans that constraint programming made: maps, fleets, moved entities, joint work, links, budgets."""

from __future__ import annotations

import pytest

from missiontree.checking import check
from tests.checking.missions import random_mission
from tests.checking.plans import made


@pytest.mark.parametrize("part", range(4))
def test_random_missions_pass_and_are_no_longer_than_greedy_ones(part: int) -> None:
    """Five missions each; none that greedy schedules is called impossible, and none is longer."""
    for seed in range(10 * part, 10 * part + 5):
        tree, brief = random_mission(seed)
        greedy, best = made(tree, brief), made(tree, brief, scheduler="cpsat")
        assert check(best) == ()
        for its, ours in zip(greedy.schedules, best.schedules, strict=True):
            if its.status in {"optimal", "feasible"}:
                assert ours.status in {"optimal", "feasible"}
                assert ours.makespan_s <= its.makespan_s
                assert (ours.certificate.bound or 0.0) >= (its.certificate.bound or 0.0)
