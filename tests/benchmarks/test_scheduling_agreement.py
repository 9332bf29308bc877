"""A sample of the campaign: the schedulers against an oracle that tries everything."""

from __future__ import annotations

import pytest

from benchmarks.campaign import made
from benchmarks.scheduling_agreement import CAMPAIGN

SEED, SAMPLE, PARTS = 11, 1_000, 10


@pytest.mark.parametrize("part", range(PARTS))
def test_no_claim_is_refuted(part: int) -> None:
    """Every rule is drawn many times; what is said of makespans, bounds, proofs and impossibility holds, and no gap is left."""
    size = SAMPLE // PARTS
    state = made(CAMPAIGN, SEED, part * size, (part + 1) * size)
    assert state.violations == {}
    assert state.rows["possible"]["missions"] > size // 3
