"""``missiontree schedule``: three forms of instances, what is told of them, and with which exit code."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from missiontree.cli import schedule as command
from missiontree.cli.schedule import _as_plan
from missiontree.instances import read_instance, schedule_instance
from tests.cli.running import Shell
from tests.formats.test_coalitions import GOOD
from tests.formats.tree_files import small

SHOP = "2 2\n2 2 0 2 1 2 2 0 2 1 2\n2 2 0 2 1 2 2 0 2 1 2\n"


def written(folder: Path, name: str, text: str) -> str:
    (folder / name).write_text(text, encoding="utf-8")
    return name


def test_a_job_shop_is_told_with_its_proof_and_its_actions(shell: Shell, tmp_path: Path) -> None:
    """Eight seconds of work for two machines: 4 s, by load."""
    ran = shell("schedule", written(tmp_path, "shop.txt", SHOP))
    assert ran.code == 0
    lines = [" ".join(line.split()) for line in ran.out.splitlines()]
    assert lines[0] == "shop.txt, read as a flexible job shop: 15 nodes, 8 leaves, 2 robots"
    assert lines[1].startswith("Makespan 4 s, optimal, confirmed by")
    assert "machine-0 2 4 100 %" in lines
    assert any(line.startswith("0 2 machine-0 Operation 1 of job") for line in lines)


def test_coalitions_are_told_beside_what_was_published(shell: Shell, tmp_path: Path) -> None:
    """Robot 1 does task 2 alone after task 1 with robot 0: 5 + 4 + 5 + 2.5 + 10 = 26.5 s."""
    ran = shell("schedule", written(tmp_path, "mission.json", json.dumps(GOOD)))
    assert ran.code == 0
    assert "Makespan 26.5 s, optimal, confirmed by a complete search (labels)" in ran.out
    assert "Published for this instance: 24.500 s." in ran.out


def test_json_tells_choices_actions_and_what_was_asked_for(shell: Shell, tmp_path: Path) -> None:
    """Leaf 2 (3 s, robot 0), then leaf 4 (1 s, robot 1) rather than leaf 3 (2 s)."""
    ran = shell("schedule", written(tmp_path, "tree.json", json.dumps(small())), "--json", "--seed", "3", "--no-solver")
    told = json.loads(ran.out)
    assert told["known"] == "optimal, confirmed by a bound (critical path)"
    assert (told["status"], told["makespan_s"], told["bound_s"], told["claim"], told["seed"]) == (
        "optimal",
        4,
        4.0,
        "proven",
        3,
    )
    assert told["chosen"] == {"1": 4}
    assert [(deed["start_s"], deed["end_s"], deed["robot"], deed["what"]) for deed in told["actions"]] == [
        (0, 3, "robot-0", "leaf 2"),
        (3, 4, "robot-1", "leaf 4"),
    ]


def test_equal_robots_are_named_one_by_one_and_rank_refuses_them(shell: Shell, tmp_path: Path) -> None:
    file = written(tmp_path, "tree.json", json.dumps(small() | {"count": [2, 1]}))
    ran = shell("schedule", file)
    assert ran.code == 0
    assert "robot-0-1" in ran.out
    refused = shell("rank", file)
    assert refused.code == 2
    assert "count: ranking takes trees of single robots" in refused.err


def test_what_cannot_be_done_and_what_is_no_instance_have_their_codes(shell: Shell, tmp_path: Path) -> None:
    stuck = {"kind": [2], "parent": [-1], "robot": [0], "utility": [0], "robots": 1}
    ran = shell("schedule", written(tmp_path, "stuck.json", json.dumps(stuck)))
    assert (ran.code, "Cannot be done, infeasible, proven by selection" in ran.out) == (1, True)
    other = shell("schedule", written(tmp_path, "other.json", '{"a": 1}'))
    assert other.code == 2
    assert (
        "other.json:1: this is no instance of a form that is known here, but a mapping with the keys 'a'" in other.err
    )
    for name in ("empty.txt", "empty.json"):
        empty = shell("schedule", written(tmp_path, name, " \n"))
        assert empty.code == 2
        assert f"{name}: the file is empty" in empty.err
        assert "a flexible job shop (text)" in empty.err
    silent = shell("schedule", written(tmp_path, "silent.txt", "# nothing\n\n"))
    assert (silent.code, "silent.txt: the file holds nothing but comments" in silent.err) == (2, True)
    bad = shell("schedule", written(tmp_path, "bad.txt", "1 1\n1 1 5 5\n"))
    assert bad.code == 2
    assert "bad.txt:2" in bad.err
    fine = written(tmp_path, "shop.txt", SHOP)
    for option, value in (("--time-limit", "-1"), ("--bound-share", "2")):
        refused = shell("schedule", fine, option, value)
        assert (refused.code, option in refused.err) == (2, True)


def test_a_chart_is_drawn_and_the_chain_is_told(shell: Shell, tmp_path: Path) -> None:
    """Robot 1 is on the way or at work all the time: 20 s and 6.5 s."""
    file = written(tmp_path, "mission.json", json.dumps(GOOD))
    ran = shell("schedule", file, "--gantt", "chart.svg")
    assert "Why it takes 26.5 s: 6.5 s of work and 20 s on the way, one after the other" in ran.out
    assert "written to chart.svg" in ran.err
    assert "robot-1" in (tmp_path / "chart.svg").read_text(encoding="utf-8")
    chain = json.loads(shell("schedule", file, "--json").out)["critical_chain"]
    assert (chain["work_s"], chain["travel_s"], chain["waiting_s"]) == (6.5, 20.0, 0.0)
    assert {step["robot"] for step in chain["steps"]} == {"robot-1"}


def test_after_a_stop_the_chain_of_a_large_tree_is_told_only_if_it_is_to_be_drawn(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    instance = read_instance(tmp_path / written(tmp_path, "shop.txt", SHOP))
    found = schedule_instance(instance, solver=False)
    assert _as_plan(instance, found, "shop", asked_for=False, hurried=True) is not None
    monkeypatch.setattr(command, "MOST_IN_A_HURRY", 14)  # one node less than it has
    assert _as_plan(instance, found, "shop", asked_for=False, hurried=True) is None
    assert _as_plan(instance, found, "shop", asked_for=True, hurried=True) is not None
    assert _as_plan(instance, found, "shop", asked_for=False, hurried=False) is not None


def test_a_chart_that_cannot_be_drawn_is_refused_and_what_cannot_be_done_is_told_for_all_that(
    shell: Shell, tmp_path: Path
) -> None:
    refused = shell("schedule", written(tmp_path, "shop.txt", SHOP), "--gantt", "chart.doc")
    assert (refused.code, "no form of a picture" in refused.err) == (2, True)
    stuck = {"kind": [2], "parent": [-1], "robot": [0], "utility": [0], "robots": 1}
    nothing = shell("schedule", written(tmp_path, "stuck.json", json.dumps(stuck)), "--gantt", "chart.svg")
    assert (nothing.code, "Cannot be done, infeasible" in nothing.out) == (1, True)
    assert "nothing is scheduled, so nothing is drawn" in nothing.err
    assert not (tmp_path / "chart.svg").exists()


def test_more_actions_than_fit_are_counted(shell: Shell, tmp_path: Path) -> None:
    lines = "\n".join(["25 1"] + ["2 1 0 1 1 0 1"] * 25)
    ran = shell("schedule", written(tmp_path, "long.txt", lines))
    assert "50 actions; --json lists them all" in ran.out


LONG = {"kind": [1, 0, 0], "parent": [-1, 0, 0], "robot": [0, 0, 0], "utility": [0, 0, 0], "robots": 1}
"""One robot has 4 s and 3 s to do."""


def test_the_whole_chain_and_what_would_shorten_it_are_told_where_asked(shell: Shell, tmp_path: Path) -> None:
    file = written(tmp_path, "tree.json", json.dumps(LONG | {"duration": [0, 4, 3]}))
    ran = shell("schedule", file, "--why-so-long")
    assert "Why it takes 7 s: 7 s of work, one after the other" in ran.out
    lines = [line.strip() for line in ran.out.splitlines()]
    assert lines[-3:-1] == [
        "What more would bring (scheduled anew)",
        "one more robot-0: 4 s instead of 7 s (proven shortest); without it that is impossible",
    ]
    chain = json.loads(shell("schedule", file, "--why-so-long", "--json").out)["critical_chain"]
    assert chain["additions"] == [
        {
            "robots": {"robot-0": 1},
            "verdict": "shorter",
            "status": "optimal",
            "makespan_s": 4.0,
            "bound_s": 4.0,
            "claim": "proven",
            "method": "critical_path",
        }
    ]
    assert chain["untried"] == ""
    assert "additions" not in json.loads(shell("schedule", file, "--json").out)["critical_chain"]


def test_a_chain_with_more_parts_than_are_told_names_the_option_that_tells_all(shell: Shell, tmp_path: Path) -> None:
    """Twenty operations of one job, on two machines in turn: twenty parts."""
    job = " ".join(f"1 {number % 2} 1" for number in range(20))
    file = written(tmp_path, "long.txt", f"1 2\n20 {job}\n")
    assert "… 12 more; --why-so-long tells all of them" in shell("schedule", file).out
    assert "more;" not in shell("schedule", file, "--why-so-long").out


def test_what_cannot_be_done_has_no_length_to_be_told(shell: Shell, tmp_path: Path) -> None:
    stuck = {"kind": [2], "parent": [-1], "robot": [0], "utility": [0], "robots": 1}
    ran = shell("schedule", written(tmp_path, "stuck.json", json.dumps(stuck)), "--why-so-long")
    assert (ran.code, ran.err) == (1, "")


def test_a_bound_is_told_in_the_unit_of_the_makespan(shell: Shell, tmp_path: Path) -> None:
    """
    Each of three actions takes 400 s on one machine of two: 1,200 s of work, 600 s by load, and 800 s, as 400 does not divide 600.

    Without the solver nothing proves it.
    """
    file = written(tmp_path, "shop.txt", "3 2\n" + "1 2 0 400 1 400\n" * 3)
    ran = shell("schedule", file, "--no-solver", "--time-limit", "1")
    assert "Makespan 800 s, feasible; none is below 600 s (gap 25 %)" in ran.out


def test_what_takes_no_time_has_nobody_busy_and_no_chain(shell: Shell, tmp_path: Path) -> None:
    ran = shell("schedule", written(tmp_path, "zero.txt", "1 1\n1 1 0 0\n"), "--why-so-long")
    assert "Makespan 0 s, optimal" in ran.out
    assert "Why it takes" not in ran.out
    assert "busy s" not in ran.out
