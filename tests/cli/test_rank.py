"""``missiontree rank``: trees in columns and plans, what is told of them, and with which exit code."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from benchmarks.trees import instance
from tests.cli.running import Shell
from tests.formats.tree_files import small


def written(folder: Path, data: dict[str, Any]) -> str:
    (folder / "tree.json").write_text(json.dumps(data), encoding="utf-8")
    return "tree.json"


def test_the_best_are_told_with_bound_gap_and_proof_and_every_limit(shell: Shell, tmp_path: Path) -> None:
    """Robot 0 may use 8 and leaf 2 uses 4 of it, so leaf 3, which uses 5, is out; 10 + 7 remain."""
    ran = shell("rank", written(tmp_path, small()))
    assert ran.code == 0
    lines = [" ".join(line.split()) for line in ran.out.splitlines()]
    assert lines[0] == "5 nodes, 3 leaves, 2 robots, 2 limits"
    assert "1 alternative, best first (every rank proven)" in lines
    assert any(line.startswith("1 17 17 0 proven, by") for line in lines)
    assert "robot-0-1 consumption 4 8 50 %" in lines
    assert "robot-1-1 consumption 1 3 33.3 %" in lines
    assert "not kept: what the file says of disjoint robots, at 1 AND (--disjoint keeps it)" in ran.err


def test_json_tells_choices_uses_and_what_was_asked_for(shell: Shell, tmp_path: Path) -> None:
    ran = shell("rank", written(tmp_path, small()), "--json", "--seed", "3", "--time-limit", "30")
    told = json.loads(ran.out)
    assert ran.err == ""
    assert (told["status"], told["k"], told["seed"], told["time_limit_s"]) == ("exact", 10, 3, 30.0)
    (only,) = told["alternatives"]
    assert (only["utility"], only["chosen"], only["gap"], only["certificate"]["claim"]) == (17.0, [4], 0.0, "proven")
    assert [(use["who"], use["used"], use["limit"]) for use in only["uses"]] == [
        ("robot-0-1", 4.0, 8.0),
        ("robot-1-1", 1.0, 3.0),
    ]


def test_without_budgets_the_better_leaf_is_taken(shell: Shell, tmp_path: Path) -> None:
    told = json.loads(shell("rank", written(tmp_path, small()), "--no-budgets", "--json").out)
    assert [one["utility"] for one in told["alternatives"]] == [19.0, 17.0]
    assert told["alternatives"][0]["uses"] == []
    assert told["limits"] == 0


def test_k_cuts_the_list(shell: Shell, tmp_path: Path) -> None:
    told = json.loads(shell("rank", written(tmp_path, small()), "--no-budgets", "--json", "--k", "1").out)
    assert [one["utility"] for one in told["alternatives"]] == [19.0]
    assert told["certificate"]["bound"] == 19.0


def test_disjoint_robots_are_kept_if_asked_for(shell: Shell, tmp_path: Path) -> None:
    """Leaves 2 and 3 are both robot 0's, so without budgets too only leaf 4 is left."""
    told = json.loads(shell("rank", written(tmp_path, small()), "--no-budgets", "--disjoint", "--json").out)
    assert [one["chosen"] for one in told["alternatives"]] == [[4]]
    assert told["not_kept"] == ""


def test_allocators_agree_where_nothing_couples(shell: Shell, tmp_path: Path) -> None:
    file = written(tmp_path, instance("uniform", 30, 3, 5))
    values = {
        name: [
            one["utility"]
            for one in json.loads(shell("rank", file, "--no-budgets", "--json", "--allocator", name).out)[
                "alternatives"
            ]
        ]
        for name in ("exact", "pruned", "exhaustive")
    }
    assert values["exact"] == values["pruned"] == values["exhaustive"] != []


def test_a_mission_that_cannot_be_staffed_is_told_with_the_proof(shell: Shell, tmp_path: Path) -> None:
    """Leaf 2 uses 4, and robot 0 may use 3."""
    ran = shell("rank", written(tmp_path, small() | {"budget": [3, 3]}))
    assert ran.code == 1
    assert "No alternative (proven that there is none)" in ran.out
    assert "(proven, by" in " ".join(ran.out.split())
    assert "consumption" in ran.out


def test_nothing_found_and_nothing_proven_has_a_code_of_its_own(shell: Shell, tmp_path: Path) -> None:
    """Algorithm 1 keeps the best way alone, which robot 0 cannot afford."""
    tight = instance("mission", 300, 6, 0)
    ran = shell("rank", written(tmp_path, tight), "--allocator", "pruned", "--k", "1")
    assert ran.code == 3
    assert "No alternative (none found, none excluded)" in ran.out


def test_long_tables_are_cut_and_say_so(shell: Shell, tmp_path: Path) -> None:
    """One of 25 leaves beside one for each of 20 robots: 20 lines of alternatives and 5 more, the 12 tightest limits and 8 more."""
    leaves, robots = 25, 20
    tree = {
        "kind": [1, 2, *[0] * (leaves + robots)],
        "parent": [-1, 0, *[1] * leaves, *[0] * robots],
        "robot": [0, 0, *(leaf % robots for leaf in range(leaves)), *range(robots)],
        "utility": [0, 0, *range(leaves), *[0] * robots],
        "consumption": [0, 0, *[2] * (leaves + robots)],
        "robots": robots,
        "budget": [4] * robots,
    }
    ran = shell("rank", written(tmp_path, tree), "--k", "25")
    assert "… 0 5 more, down to this utility; --json lists all" in " ".join(ran.out.split())
    assert "… and 8 more, none tighter; --json lists them all" in ran.out


def test_a_plan_is_ranked_by_its_own_fleet_and_weights(shell: Shell) -> None:
    shell("plan", "--sample", "reunite", "--quiet", "--out", "plan.json")
    told = json.loads(shell("rank", "plan.json", "--json", "--k", "4").out)
    plan = json.loads(Path("plan.json").read_text(encoding="utf-8"))
    assert [one["utility"] for one in told["alternatives"]] == [
        one["utility"] for one in plan["ranking"]["alternatives"]
    ]
    assert [one["chosen"] for one in told["alternatives"]] == [
        [choice["child"] for choice in one["choices"]] for one in plan["ranking"]["alternatives"]
    ]


def test_budgets_of_a_plan_can_be_left_out(shell: Shell) -> None:
    shell("plan", "--sample", "site", "--quiet", "--out", "plan.json")
    assert json.loads(shell("rank", "plan.json", "--json").out)["limits"] > 0
    assert json.loads(shell("rank", "plan.json", "--json", "--no-budgets").out)["limits"] == 0


def test_bad_input_is_refused_before_anything_is_ranked(shell: Shell, tmp_path: Path) -> None:
    file = written(tmp_path, small())
    for arguments, words in (
        ((file, "--k", "0"), "--k 0"),
        ((file, "--allocator", "magic"), "there is no allocator 'magic'"),
        ((file, "--time-limit", "-1"), "--time-limit -1"),
        (("nowhere.json",), "nowhere.json"),
    ):
        ran = shell("rank", *arguments)
        assert (ran.code, words in ran.err) == (2, True), arguments
    broken = written(tmp_path, small() | {"parent": [-1, 0, 0, 1, 4]})
    ran = shell("rank", broken)
    assert ran.code == 2
    assert "tree.json:1: parent[4]: node 4 has parent 4" in ran.err


def test_disjoint_is_for_trees_in_columns(shell: Shell) -> None:
    shell("plan", "--sample", "reunite", "--quiet", "--out", "plan.json")
    assert shell("rank", "plan.json", "--disjoint").code == 2


def test_a_plan_without_a_grounded_tree_is_refused(shell: Shell) -> None:
    shell("plan", "lorem ipsum dolor", "--quiet", "--out", "plan.json")
    ran = shell("rank", "plan.json")
    assert ran.code == 2
    assert "no grounded tree" in ran.err


def test_what_ended_the_search_is_told(shell: Shell, tmp_path: Path) -> None:
    file = written(tmp_path, instance("mission", 300, 6, 0))
    ran = shell("rank", file, "--time-limit", "0")
    assert "The search was ended by the time limit of 0 s." in " ".join(ran.out.split())
    certificate = json.loads(shell("rank", file, "--time-limit", "0", "--seed", "7", "--json").out)["certificate"]
    assert (certificate["claim"], certificate["limit"], certificate["seed"]) == (
        "bounded",
        {"kind": "time_s", "most": 0},
        7,
    )


def test_limits_that_clash_are_told_first(shell: Shell, tmp_path: Path) -> None:
    """Either leaf uses 5: robot 0 may use 3, and robot 1 may use 4."""
    tree = {
        "kind": [2, 0, 0],
        "parent": [-1, 0, 0],
        "robot": [0, 0, 1],
        "utility": [0, 1, 1],
        "consumption": [0, 5, 5],
        "robots": 2,
        "budget": [3, 4],
    }
    ran = shell("rank", written(tmp_path, tree))
    assert ran.code == 1
    assert (
        "✗ Together these cannot be kept: consumption of type robot-0 (3, 1 robot), and consumption of type robot-1 (4, 1 robot)."
        in " ".join(ran.out.split())
    )
