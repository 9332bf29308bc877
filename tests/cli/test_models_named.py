"""Naming a model on the command line: keys that lie about, replays, budgets, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.running import Shell

REUNITE = "Reunite mom with her lost child"


@pytest.fixture
def recorded(shell: Shell) -> str:
    """A dialogue of the offline author, recorded."""
    assert shell("plan", REUNITE, "--record", "dialogue.jsonl", "-q").code == 0
    return "dialogue.jsonl"


def test_a_key_that_lies_about_earns_a_hint_and_no_call(shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    """Port 9 of the machine itself: a call would fail, and the plan with it."""
    monkeypatch.setenv("OPENAI_API_KEY", "sk-lying-about")
    monkeypatch.setenv("OPENAI_BASE_URL", "http://127.0.0.1:9/v1")
    ran = shell("plan", REUNITE)
    assert ran.code == 0
    assert "OPENAI_API_KEY is set: --model openai:NAME would" in ran.err
    assert "Nothing was sent." in ran.err
    assert "sk-lying-about" not in ran.err + ran.out
    assert "OPENAI_API_KEY" not in shell("plan", REUNITE, "-q").err


def test_a_replay_gives_the_plan_again(shell: Shell, recorded: str) -> None:
    first = json.loads(shell("plan", REUNITE, "--json").out)
    again = json.loads(shell("plan", REUNITE, "--replay", recorded, "--json").out)
    assert (again["tree"], again["ranking"]) == (first["tree"], first["ranking"])
    assert again["provenance"]["author"] == "recorded"


def test_a_replay_goes_before_the_model_of_the_environment(
    shell: Shell, recorded: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MISSIONTREE_MODEL", "openai:nothing")
    assert shell("plan", REUNITE, "--replay", recorded).code == 0


def test_a_replay_beside_another_author_is_refused(shell: Shell, recorded: str) -> None:
    ran = shell("plan", REUNITE, "--replay", recorded, "--model", "offline")
    assert ran.code == 2
    assert "both --model and --replay are given" in ran.err


def test_the_environment_goes_before_the_mission_file_and_the_option_before_both(
    shell: Shell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "mission.yaml").write_text(f"mission: {REUNITE}\nmodel: nobody:file\n", encoding="utf-8")
    assert "'nobody:file'" in shell("plan").err
    monkeypatch.setenv("MISSIONTREE_MODEL", "nobody:environment")
    assert "'nobody:environment'" in shell("plan").err
    assert shell("plan", "--model", "offline").code == 0


def test_no_mission_file_sets_the_address_of_an_endpoint(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "mission.yaml").write_text(f"mission: {REUNITE}\nbase_url: http://evil.example\n", encoding="utf-8")
    ran = shell("plan")
    assert ran.code == 2
    assert "base_url" in ran.err


@pytest.mark.parametrize("option", ["--max-turns", "--max-tokens", "--max-seconds"])
def test_budgets_of_nothing_are_refused(shell: Shell, option: str) -> None:
    ran = shell("plan", REUNITE, option, "0")
    assert ran.code == 2
    assert f"{option} 0" in ran.err


def test_a_model_that_there_is_not_is_refused_with_those_there_are(shell: Shell) -> None:
    ran = shell("plan", REUNITE, "--model", "gpt-x")
    assert ran.code == 2
    assert "there is no model 'gpt-x'" in ran.err
    assert "openai:NAME" in ran.err


def test_a_replay_with_other_inputs_is_a_plan_that_says_so(shell: Shell, recorded: str, tmp_path: Path) -> None:
    people = "entities: [{id: mom, kind: person}, {id: child, kind: person}]\n"
    (tmp_path / "scene.yaml").write_text(people, encoding="utf-8")
    ran = shell("plan", REUNITE, "--replay", recorded)
    assert ran.code == 0, ran.err
    assert "was recorded with another mission, fleet, scene or set of routines" in " ".join(ran.out.split())


def test_a_damaged_recording_is_named_with_its_line(shell: Shell, recorded: str, tmp_path: Path) -> None:
    lines = (tmp_path / recorded).read_text(encoding="utf-8").splitlines()
    (tmp_path / recorded).write_text("\n".join([*lines[:2], "{", *lines[3:]]), encoding="utf-8")
    ran = shell("plan", REUNITE, "--replay", recorded)
    assert ran.code == 2
    assert "dialogue.jsonl:3: the line is not JSON" in ran.err
