"""``missiontree compare``: what each allocator loses, and missions that cannot be compared."""

from __future__ import annotations

import json
from pathlib import Path

from tests.cli.running import Shell


def test_json_stays_json_when_the_mission_is_not_understood(shell: Shell) -> None:
    ran = shell("compare", "lorem ipsum dolor", "--json")
    assert ran.code == 5
    answer = json.loads(ran.out)
    assert answer["outcome"] == "incomplete"
    assert "lorem" in answer["reasons"][0]["message"]


def errands(folder: Path) -> Path:
    """
    Three errands for one drone of 10 J. Each has a good way for 10 J and a poor one for nothing: 1 or 0.9, 1 or 0.2, 5 or 0.1.

    One errand at most is done well. Best is to spend it on the third: 0.9 + 0.2 + 5 = 6.1. Then come the second,
    0.9 + 1 + 0.1 = 2, the first, 1 + 0.2 + 0.1 = 1.3, and none, 0.9 + 0.2 + 0.1 = 1.2.
    """
    fleet = {
        "types": [
            {
                "id": "drone",
                "count": 1,
                "capabilities": {"a": 1, "b": 0.9, "c": 1, "d": 0.2, "e": 5, "f": 0.1},
                "limits": {"energy_j": 10},
            }
        ]
    }

    def way(rating: str, energy_j: int) -> dict[str, object]:
        step = {"name": rating, "text": rating, "uses": {"energy_j": energy_j}}
        return {"name": rating, "roles": [{"name": "doer", "rating": rating, "actions": [step]}]}

    routines = [
        {
            "id": name,
            "purpose": f"{name} for {{agent}}",
            "arguments": [{"name": "agent", "kinds": ["person"]}],
            "branches": [way(good, 10), way(poor, 0)],
        }
        for name, good, poor in (("First", "a", "b"), ("Second", "c", "d"), ("Third", "e", "f"))
    ]
    mission = {
        "mission": "Run the errands",
        "routines": ["routines.json"],
        "entities": [{"id": "Anna", "kind": "person"}],
        "goals": [{"do": f"{routine['id']}(Anna)"} for routine in routines],
        "fleet": "fleet.json",
    }
    files = {"fleet": fleet, "routines": {"routines": routines}, "mission": mission}
    for name, value in files.items():
        (folder / f"{name}.json").write_text(json.dumps(value), encoding="utf-8")
    return folder / "mission.json"


def test_what_pruning_loses_under_a_budget_is_told_in_number_and_utility(shell: Shell, tmp_path: Path) -> None:
    """
    With two ways kept, Algorithm 1 has after two errands 0.9 + 1 and 1 + 0.2, both with the energy spent: 0.9 + 0.2 is gone.

    It ends with 2 and 1.3 where 6.1 and 2 are best: it lost the 6.1, and its own best is 4.1 below.
    """
    mission = errands(tmp_path)
    ran = shell("compare", str(mission), "-k", "2", "--json")
    assert ran.code == 0, ran
    runs = {run["allocator"]: run for run in json.loads(ran.out)}
    for name in ("exact", "exhaustive"):
        assert runs[name]["utilities"] == [6.1, 2.0]
        assert (runs[name]["lost"], runs[name]["best_loss"]) == ([], 0.0)
    assert runs["pruned"]["utilities"] == [2.0, 1.3]
    assert (runs["pruned"]["lost"], runs["pruned"]["best_loss"]) == ([6.1], 4.1)
    row = next(
        line for line in shell("compare", str(mission), "-k", "2").out.splitlines() if line.startswith("pruned ")
    )
    assert row.split()[1:8] == ["2", "2,", "1.3", runs["pruned"]["status"], "1:", "6.1", "4.1"]


def test_an_allocator_that_finds_nothing_lost_all(shell: Shell, tmp_path: Path) -> None:
    """With one way kept it spends the energy twice, and has nothing left."""
    mission = errands(tmp_path)
    ran = shell("compare", str(mission), "-k", "1", "--json")
    pruned = next(run for run in json.loads(ran.out) if run["allocator"] == "pruned")
    assert (pruned["utilities"], pruned["lost"], pruned["best_loss"]) == ([], [6.1], None)
    row = next(
        line for line in shell("compare", str(mission), "-k", "1").out.splitlines() if line.startswith("pruned ")
    )
    assert row.split()[-4:-2] == ["all", str(pruned["examined"])]


def test_without_budgets_pruning_loses_nothing(shell: Shell) -> None:
    """A sum's best need only the best of each part."""
    ran = shell("compare", "Find the cat and then find the dog", "-k", "3", "--json")
    assert "best loss" not in shell("compare", "Find the cat and then find the dog", "-k", "3").out
    assert {(tuple(run["lost"]), run["best_loss"]) for run in json.loads(ran.out)} == {((), 0.0)}
