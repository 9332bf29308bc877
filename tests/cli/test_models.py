"""Models from the command line, over real HTTP on loopback: listed, asked, and having a tree built."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import pytest

from missiontree.cli.models import lines
from missiontree.llm.trying import TriedModel
from tests.cli.running import Shell
from tests.llm.endpoint import KEY, Endpoint
from tests.llm.endpoint_replies import Turn, error

REUNITE = "Reunite mom with her lost child"
INIT: tuple[str, Mapping[str, object]] = ("HierarchicalTree_init", {"objective": REUNITE})
SEARCH: tuple[str, Mapping[str, object]] = (
    "attachMultiSubTrees",
    {
        "parentString": REUNITE,
        "treeNames": ["SearchTree", "ReachAndTransportTree"],
        "treeArguments": [["Child"], ["Child", "Mom"]],
        "LogicalConstraint": "AND",
        "constraintPairs": [[0, 1]],
    },
)
WHOLE = [Turn("First I think.", (INIT,)), Turn("Then I call.", (SEARCH,)), Turn("All is right.")]


@pytest.fixture(autouse=True)
def _key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENAI_API_KEY", KEY)


def test_a_model_builds_a_tree_that_is_planned_checked_and_replayed(shell: Shell, tmp_path: Path) -> None:
    with Endpoint(WHOLE) as endpoint:
        given = ("--model", "openai:large", "--base-url", endpoint.url, "--record", "talk.jsonl", "--out", "plan.json")
        ran = shell("plan", REUNITE, *given)
    assert endpoint.violations == []
    assert ran.code == 0, ran.err
    assert "turn 2: 2 calls so far, 3 nodes" in ran.err
    assert "openai large: 3 turns, 2 calls, " in ran.err
    assert "openai large: 3 turns, 2 calls, " in ran.out
    assert shell("check", "plan.json").code == 0
    plan = json.loads((tmp_path / "plan.json").read_text(encoding="utf-8"))
    assert plan["provenance"]["spent"]["turns"] == 3
    header = json.loads((tmp_path / "talk.jsonl").read_text(encoding="utf-8").splitlines()[0])
    assert (header["source"], header["model"], header["endpoint"]) == ("openai", "large", endpoint.url)
    for file in ("talk.jsonl", "plan.json"):
        assert KEY not in (tmp_path / file).read_text(encoding="utf-8")
    again = json.loads(shell("plan", REUNITE, "--replay", "talk.jsonl", "--json").out)
    assert again["tree"] == plan["tree"]
    assert again["provenance"]["model"] == "large"


def test_a_key_that_the_endpoint_sends_back_is_in_no_file(shell: Shell, tmp_path: Path) -> None:
    leaky = [Turn(f"Your key is {KEY}.", (INIT,)), *WHOLE[1:]]
    with Endpoint(leaky) as endpoint:
        ran = shell("plan", REUNITE, "--model", "openai:x", "--base-url", endpoint.url, "--record", "talk.jsonl")
    assert ran.code == 0
    assert KEY not in ran.out + ran.err + (tmp_path / "talk.jsonl").read_text(encoding="utf-8")


def test_a_budget_that_runs_out_keeps_the_tree_so_far(shell: Shell, tmp_path: Path) -> None:
    with Endpoint(WHOLE) as endpoint:
        given = ("--model", "openai:x", "--base-url", endpoint.url, "--max-turns", "1", "--record", "talk.jsonl")
        ran = shell("plan", REUNITE, *given)
    assert ran.code == 3
    assert "used up its 1 turns" in " ".join(ran.out.split())
    assert (tmp_path / "talk.jsonl").exists()


def test_a_model_that_cannot_be_used_has_a_code_of_its_own(shell: Shell) -> None:
    with Endpoint(WHOLE, objection=lambda body: error(401, "who are you?")) as endpoint:
        ran = shell("plan", REUNITE, "--model", "openai:x", "--base-url", endpoint.url)
    assert ran.code == 4
    assert "The language model could not be used" in ran.out
    assert "Set OPENAI_API_KEY to a key" in " ".join(ran.out.split())


def test_the_environment_may_name_model_and_address(shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    with Endpoint(WHOLE) as endpoint:
        monkeypatch.setenv("MISSIONTREE_MODEL", "openai:large")
        monkeypatch.setenv("MISSIONTREE_BASE_URL", endpoint.url)
        ran = shell("plan", REUNITE)
    assert ran.code == 0
    assert "is set:" not in ran.err, "who names a model needs no hint at a key"


def test_one_model_is_asked_to_call(shell: Shell) -> None:
    ping, pong = ("ping", {"word": "one"}), ("pong", {"word": "two"})
    with Endpoint([Turn(calls=(ping,)), Turn(calls=(ping,)), Turn(calls=(ping, pong))]) as endpoint:
        ran = shell("models", "--model", "openai:large", "--base-url", endpoint.url)
    assert ran.code == 0
    assert ran.out.splitlines()[:2] == ["✓ openai:large calls functions.", "  several calls in one answer: yes"]


def test_a_model_that_only_talks_fails(shell: Shell) -> None:
    with Endpoint([Turn("pong!")]) as endpoint:
        ran = shell("models", "--model", "openai:small", "--base-url", endpoint.url, "--json")
    assert ran.code == 4
    assert json.loads(ran.out)["calls"] is False


def test_the_list_names_every_provider(shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("OPENAI_API_KEY")
    monkeypatch.setenv("MISSIONTREE_BASE_URL", "http://127.0.0.1:9/v1")
    named = {one["name"] for one in json.loads(shell("models", "--json").out)}
    assert named == {
        "offline",
        "recorded:FILE",
        "openai:NAME",
        "anthropic:NAME",
        "gemini:NAME",
        "ollama:NAME",
        "local:FILE.gguf",
    }


def test_what_is_not_known_of_a_model_is_not_said() -> None:
    assert lines(TriedModel("anthropic:x", calls=True)) == ["✓ anthropic:x calls functions."]
