"""``missiontree explain`` at the command line."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

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


def test_a_repair_is_planned_shown_and_kept(shell: Shell, tmp_path: Path) -> None:
    done = shell(
        "explain", "--sample", "rescue", "--without", "transportation_robot", "--repair", "2", "--out", "plan.json"
    )
    assert done.code == 0
    assert "with a change: Give Mobile Scooter the capability carry" in " ".join(done.out.split())
    assert shell("check", "plan.json").code == 0


def test_costs_of_the_command_line_change_the_order(shell: Shell) -> None:
    arguments = ("explain", "--sample", "rescue", "--without", "transportation_robot", "--json")
    usual = json.loads(shell(*arguments).out)
    dear = json.loads(shell(*arguments, "--cost", "take_off_without=50", "--cost", "add_capability.tele_robot=1").out)
    assert usual["repairs"][0]["changes"][0]["kind"] == "take_off_without"
    assert dear["repairs"][0]["changes"][0]["target"] == "tele_robot"


@pytest.mark.parametrize(
    ("arguments", "why"),
    [
        (("--cost", "add_robot"), "bad input: --cost 'add_robot'"),
        (("--cost", "add_robot=-1"), "bad input: --cost 'add_robot=-1'"),
        (("--cost", "buy_robot=1"), "the nearest is 'add_robot'"),
        (("--repairs", "0"), "bad input: --repairs 0"),
        (("--out", "plan.json"), "--out is given without --repair"),
        (("--repair", "1"), "the mission can be done as it stands"),
    ],
)
def test_options_that_make_no_sense_are_refused(shell: Shell, arguments: tuple[str, ...], why: str) -> None:
    done = shell("explain", "--sample", "reunite", *arguments)
    assert done.code == 2
    assert why in done.err


def test_inputs_beside_a_plan_are_refused(shell: Shell) -> None:
    shell("plan", "--sample", "restaurants", "--out", "plan.json")
    done = shell("explain", "plan.json", "--no-kinds")
    assert done.code == 2
    assert "--kinds is given beside a plan, which carries its inputs" in done.err
