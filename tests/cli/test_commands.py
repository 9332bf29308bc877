"""The main paths of every command."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

import jsonschema
import pytest

from missiontree.mission.control import Control
from tests.cli.running import Shell


def test_a_plan_is_shown_kept_checked_and_shown_again(shell: Shell, tmp_path: Path) -> None:
    made = shell("plan", "Reunite mom with her lost child", "--out", "plan.json", "--record", "dialogue.jsonl")
    assert made.code == 0
    assert "5.6" in made.out
    assert "written to plan.json" in made.err
    assert shell("check", "plan.json").out == "sound: plan.json keeps every rule\n"
    shown = shell("show", "plan.json", "--tree", "tree.svg")
    assert shown.out == made.out
    assert (tmp_path / "tree.svg").read_text(encoding="utf-8").startswith("<svg")
    dialogue = (tmp_path / "dialogue.jsonl").read_text(encoding="utf-8")
    assert shell("show", "plan.json", "--transcript").out == dialogue
    again = shell("plan", "Reunite mom with her lost child", "--model", "recorded:dialogue.jsonl", "--json")
    assert again.code == 0
    assert json.loads(again.out)["tree"] == json.loads((tmp_path / "plan.json").read_text())["tree"]


def test_json_on_the_screen_is_the_file_and_fits_the_schema(shell: Shell, tmp_path: Path) -> None:
    ran = shell("plan", "--sample", "rescue", "--json", "--out", "plan.json")
    assert ran.err == ""
    assert ran.out == (tmp_path / "plan.json").read_text(encoding="utf-8")
    jsonschema.validate(json.loads(ran.out), json.loads(shell("schema", "plan").out))


def test_a_damaged_plan_is_found_out(shell: Shell, tmp_path: Path) -> None:
    shell("plan", "--sample", "reunite", "--out", "plan.json", "--quiet")
    plan = json.loads((tmp_path / "plan.json").read_text())
    plan["schedules"][0]["actions"][0]["end_s"] += 1
    plan["ranking"]["alternatives"][0]["utility"] = 9
    (tmp_path / "plan.json").write_text(json.dumps(plan))
    ran = shell("check", "plan.json", "--json")
    assert ran.code == 6
    rules = {finding["rule"] for finding in json.loads(ran.out)["findings"]}
    assert {"utility_wrong", "duration_wrong"} <= rules
    assert "faults found in plan.json" in shell("check", "plan.json").out


def test_quiet_with_a_file_prints_nothing(shell: Shell) -> None:
    ran = shell("plan", "--sample", "reunite", "--quiet", "--out", "plan.json")
    assert (ran.code, ran.out, ran.err) == (0, "", "")


def test_init_writes_a_folder_in_which_plan_alone_works(shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    assert shell("init", "site").code == 0
    monkeypatch.chdir("site")
    ran = shell("plan")
    assert ran.code == 0
    for name in ("mission.yaml", "fleet.yaml", "scene.yaml", "routines/inspect.yaml", "methods/make_safe.yaml"):
        assert name in ran.err
    by_words = shell("plan", "Stow the toolbox in the tool shed")
    assert by_words.code == 0
    assert "make_safe" in by_words.out
    assert "fleet.yaml" in by_words.err
    twice = shell("init")
    assert twice.code == 2
    assert "Nothing was written" in twice.err


def test_schemas_are_listed_printed_and_written(shell: Shell, tmp_path: Path) -> None:
    kinds = shell("schema").out.split()
    assert {"fleet", "scene", "routines", "mission", "tree", "plan"} <= set(kinds)
    assert shell("schema", "--out", "schemas").code == 0
    for kind in kinds:
        schema = json.loads((tmp_path / "schemas" / f"{kind}.schema.json").read_text(encoding="utf-8"))
        jsonschema.Draft202012Validator.check_schema(schema)


def test_compare_says_what_the_papers_algorithm_loses(shell: Shell, tmp_path: Path) -> None:
    # Two jobs at 60 J each and one robot of each type with 100 J: the strong one cannot do both. Kept to rho = 1 after each
    # child, Algorithm 1 knows only strong + strong, which the budget refuses; exact finds strong + weak = 3 * (1.0 + 0.5).
    (tmp_path / "fleet.yaml").write_text(
        "types:\n"
        "  - {id: strong, count: 1, capabilities: {inspect: 1}, limits: {energy_j: 100}}\n"
        "  - {id: weak, count: 1, capabilities: {inspect: 0.5}, limits: {energy_j: 100}}\n"
    )
    (tmp_path / "routines.yaml").write_text(
        "routines:\n  - id: Inspect\n    purpose: Inspect {target}.\n    verbs: [inspect]\n"
        "    arguments: [{name: target, kinds: [object]}]\n    branches:\n      - name: look\n        roles:\n"
        "          - name: eye\n            rating: inspect\n            actions:\n"
        "              - {name: look, text: 'Look at {target}', duration_s: 1, uses: {energy_j: 60}}\n"
    )
    ran = shell(
        *("compare", "Inspect the pump and inspect the valve", "--fleet", "fleet.yaml", "--routines", "routines.yaml"),
        *("-k", "1", "--json"),
    )
    runs = {run["allocator"]: run for run in json.loads(ran.out)}
    assert runs["exact"]["utilities"] == runs["exhaustive"]["utilities"] == [1.5]
    assert runs["exact"]["status"] == "exact"
    assert runs["pruned"]["utilities"] == []
    assert runs["pruned"]["lost"] == [1.5]


def test_the_same_words_give_the_same_bytes_whatever_the_hash_seed(tmp_path: Path) -> None:
    texts = set()
    for seed in ("0", "1", "random"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        command = [sys.executable, "-m", "missiontree", "plan", "--sample", "site", "--json"]
        texts.add(subprocess.run(command, capture_output=True, check=True, env=environment).stdout)
    assert len(texts) == 1


def test_ctrl_c_stops_long_work_with_what_it_has(shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    """The first Ctrl-C is a stop token, so planning returns; with nothing to keep the code is 130."""

    def interrupted(self: Control) -> bool:
        if threading.current_thread() is threading.main_thread():
            signal.raise_signal(signal.SIGINT)
        return self.stop()

    monkeypatch.setattr(Control, "ended", interrupted)
    ran = shell("plan", "--sample", "rescue")
    assert ran.code in {0, 3, 130}
    assert "Traceback" not in ran.err


def test_colour_is_for_terminals_and_those_who_ask(shell: Shell) -> None:
    assert "\x1b[" not in shell("plan", "--sample", "reunite").out
    assert "\x1b[" in shell("plan", "--sample", "reunite", "--colour").out


def test_the_order_of_each_robot_is_told_without_a_clock(shell: Shell) -> None:
    shell("plan", "--sample", "reunite", "--out", "plan.json", "--quiet")
    lines = shell("show", "plan.json", "--order", "1").out.splitlines()
    assert lines[:4] == [
        "tele_robot-1",
        "1. Get search path to find Child",
        "2. Detect Child",
        "3. Report detection of Child to server",
    ]
    assert shell("show", "plan.json", "--order", "9").code == 2


def test_an_interruption_is_told_in_words(shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(self: Control) -> bool:
        raise KeyboardInterrupt

    monkeypatch.setattr(Control, "ended", interrupted)
    ran = shell("plan", "--sample", "rescue")
    assert (ran.code, ran.out) == (130, "")
    assert "interrupted" in ran.err
