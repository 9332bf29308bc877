"""The allocators agree wherever they should, on random trees with fleets: in CI 1,200 of them, in the campaign 20,000."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given, settings

from benchmarks import allocation_agreement
from benchmarks.allocation_agreement import judge, numbered_case
from benchmarks.random_trees import Case
from missiontree.allocation import ALLOCATORS
from tests.strategies import cases

PARTS, PER_PART = 8, 150


@pytest.mark.parametrize("part", range(PARTS))
def test_allocators_agree_on_numbered_trees(part: int) -> None:
    """Values, choices and order; statuses, bounds, certificates and witnesses too."""
    for index in range(part * PER_PART, (part + 1) * PER_PART):
        _, faults = judge(numbered_case(2026, index))
        assert faults == [], f"case {index}"


@settings(max_examples=60)
@given(cases())
def test_allocators_agree_on_drawn_trees(case: Case) -> None:
    assert judge(case)[1] == []


def test_the_numbered_trees_hold_what_they_should() -> None:
    """A campaign over trees without ties, refusals or infeasible missions would show little."""
    drawn = [judge(numbered_case(7, index))[0] for index in range(100)]
    refusing = [truth for truth in drawn if truth.examined > len(truth.alternatives) > 0]
    tied = [truth for truth in drawn if len({entry.utility for entry in truth.alternatives}) < len(truth.alternatives)]
    assert min(len(refusing), len(tied), sum(not truth.alternatives for truth in drawn)) >= 5


def test_the_campaign_goes_on_where_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    state = tmp_path / "state.json"
    for count in ("4", "6"):
        monkeypatch.setattr("sys.argv", ["campaign", "--count", count, "--seed", "3", "--state", str(state)])
        allocation_agreement.main()
        assert json.loads(state.read_text(encoding="utf-8"))["done"] == int(count)
    assert "| trees | 6 |" in capsys.readouterr().out
    monkeypatch.setattr("sys.argv", ["campaign", "--seed", "4", "--state", str(state)])
    with pytest.raises(SystemExit, match="belongs to seed 3"):
        allocation_agreement.main()


def test_what_is_shipped() -> None:
    assert list(ALLOCATORS) == ["exact", "pruned", "pruned_as_printed", "exhaustive"]
