"""``missiontree explain`` at the command line."""

from __future__ import annotations

import json
from pathlib import Path

from tests.cli.running import Shell


def test_a_goal_that_no_routine_serves_is_named(shell: Shell) -> None:
    done = shell("explain", "--sample", "restaurants")
    assert done.code == 1
    assert "needs the capability recommend, which no routine has" in done.out


def test_json_is_a_document_of_its_own(shell: Shell) -> None:
    done = shell("explain", "--sample", "restaurants", "--json")
    told = json.loads(done.out)
    assert (told["format"], told["outcome"]) == ("explanation/1", "cannot_be_done")
    assert told["causes"][0]["stage"] == "authoring"


def test_a_plan_stands_in_the_place_of_its_mission(shell: Shell, tmp_path: Path) -> None:
    file = tmp_path / "plan.json"
    shell("plan", "--sample", "restaurants", "--out", str(file))
    assert "capability recommend" in shell("explain", str(file)).out
