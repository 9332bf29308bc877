"""``--accumulate`` and ``--diverse``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from tests.cli.running import Shell

DOOR: dict[str, Any] = {
    "kind": [2, 1, 0, 0, 0],
    "parent": [-1, 0, 0, 1, 1],
    "robot": [0, 0, 1, 0, 0],
    "utility": [0, 0, 10, 6, 6],
    "robots": 2,
}
"""Leaf 2 by robot 1 gives 10; or leaves 3 and 4 by robot 0 give 6 each. By sum 12, 10; by mean 10, 6."""


def test_rank_by_mean_and_least(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "door.json").write_text(json.dumps(DOOR), encoding="utf-8")
    values = {}
    for how in ("sum", "mean", "min"):
        told = json.loads(shell("rank", "door.json", "--accumulate", how, "--json").out)
        assert (told["accumulate"], told["diverse"], told["status"]) == (how, False, "exact")
        values[how] = [one["utility"] for one in told["alternatives"]]
    assert values == {"sum": [12, 10], "mean": [10, 6], "min": [10, 6]}
    screen = " ".join(shell("rank", "door.json", "--accumulate", "mean").out.split())
    assert "# mean utility bound gap known 1 10 10 0 proven, by dinkelbach" in screen


def test_rank_by_team_speaks_of_other_teams(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "door.json").write_text(json.dumps(DOOR), encoding="utf-8")
    one = shell("rank", "door.json", "--diverse", "-k", "1").out
    assert "1 alternative of different teams, best first (every rank proven)" in one
    assert "Other teams: nothing above 12, proven by team partition." in one
    every = shell("rank", "door.json", "--diverse").out
    assert "Other teams: There are no more teams. (proven, by team partition)" in every


def test_rank_takes_the_aim_of_a_plan_unless_another_is_given(shell: Shell) -> None:
    shell("plan", "--sample", "rescue", "--accumulate", "mean", "--diverse", "--out", "plan.json", "--quiet")
    told = json.loads(shell("rank", "plan.json", "--json").out)
    assert (told["accumulate"], told["diverse"]) == ("mean", True)
    assert [one["utility"] for one in told["alternatives"]] == [0.86, 0.44]
    other = json.loads(shell("rank", "plan.json", "--accumulate", "sum", "--not-diverse", "--json").out)
    assert [one["utility"] for one in other["alternatives"]] == [8.6, 6.5, 6.5, 4.4]


def test_compare_leaves_out_who_ranks_by_sums_alone(shell: Shell) -> None:
    told = json.loads(shell("compare", "--sample", "rescue", "--accumulate", "mean", "--json").out)
    assert [(run["allocator"], run["utilities"]) for run in told] == [
        ("exact", [0.86, 0.65, 0.65, 0.44]),
        ("exhaustive", [0.86, 0.65, 0.65, 0.44]),
    ]


def test_bad_words_are_refused_with_what_is_accepted(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "door.json").write_text(json.dumps(DOOR), encoding="utf-8")
    for ran in (
        shell("plan", "Find the cat", "--accumulate", "average"),
        shell("rank", "door.json", "--accumulate", "average"),
    ):
        assert ran.code == 2
        assert "--accumulate average" in ran.err
        assert "sum, mean or min" in ran.err
    ran = shell("rank", "door.json", "--diverse", "--allocator", "pruned")
    assert ran.code == 2
    assert "exact or exhaustive" in ran.err
