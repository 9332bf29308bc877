"""The documented methods are those that allocators and schedulers name, and the page lists them."""

from __future__ import annotations

from pathlib import Path

import pytest

from missiontree.checking.methods import BOUND_PROOFS, IMPOSSIBILITY_PROOFS, RANKING_PROOFS, SEARCHES
from tests.checking.missions import random_mission
from tests.checking.plans import made

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "checks.md"


def test_the_page_lists_every_method() -> None:
    page = PAGE.read_text(encoding="utf-8")
    assert [
        name
        for name in sorted(RANKING_PROOFS | BOUND_PROOFS | IMPOSSIBILITY_PROOFS | SEARCHES)
        if f"`{name}`" not in page
    ] == []


@pytest.mark.parametrize("allocator", ["exact", "exhaustive", "pruned"])
def test_every_method_that_solvers_name_is_documented(allocator: str) -> None:
    """Forty missions: no certificate of theirs rests on a method that the checker does not know."""
    for seed in range(40):
        plan = made(*random_mission(seed), allocator=allocator)
        assert plan.ranking is not None
        certificates = [plan.ranking.certificate, *(each.certificate for each in plan.ranking.alternatives)]
        assert {certificate.method for certificate in certificates} <= RANKING_PROOFS
        found = {schedule.certificate.method for schedule in plan.schedules}
        assert found <= BOUND_PROOFS | IMPOSSIBILITY_PROOFS | SEARCHES
