"""Mission files whose goals are stated formally, on the command line."""

from __future__ import annotations

from pathlib import Path

import pytest

from missiontree.cli.exits import Exit
from missiontree.formats.document import read_file
from missiontree.mission.goal import Goal
from tests.cli.running import Shell

BARN = """format: mission/1
mission: Clear the barn
model: some-model-that-is-not-there
goals:
  - {name: save, method: rescue, slots: {victim: Anna, site: burning barn}}
  - {do: SearchAndFollow(dog), until: save, not_by: [social_robot]}
"""


def test_goals_are_planned_checked_and_kept_in_the_plan(shell: Shell) -> None:
    Path("barn.yaml").write_text(BARN, encoding="utf-8")
    ran = shell("plan", "barn.yaml", "--out", "plan.json")
    assert ran.code == Exit.DELIVERED, ran.err
    assert "goal 1: method rescue; victim = Anna, site = Burning Barn" in ran.out
    assert "goal 2: routine SearchAndFollow; agent = Dog; not by social_robot" in ran.out
    assert shell("check", "plan.json").code == Exit.DELIVERED
    plan = read_file(Path("plan.json"), "plan")
    assert plan.brief.goals[1] == Goal(do="SearchAndFollow(dog)", until="save", not_by=("social_robot",))
    assert "goals" in plan.digests


def test_goals_need_no_title(shell: Shell) -> None:
    Path("mission.yaml").write_text("goals: [{do: Search(keys)}]\n", encoding="utf-8")
    ran = shell("plan")
    assert ran.code == Exit.DELIVERED, ran.err
    assert ran.out.startswith("Plan: Search(keys)\n")


def test_words_given_in_the_folder_go_before_its_goals(shell: Shell) -> None:
    Path("mission.yaml").write_text("goals: [{do: Search(keys)}]\n", encoding="utf-8")
    ran = shell("plan", "Find the dog")
    assert ran.out.startswith("Plan: Find the dog\n")
    assert "Search(Keys)" not in ran.out


def test_a_goal_that_no_method_serves_is_incomplete_and_a_circle_is_bad_input(shell: Shell) -> None:
    Path("mission.yaml").write_text("goals: [{method: resque, slots: {victim: Anna}}]\n", encoding="utf-8")
    ran = shell("plan")
    assert ran.code == Exit.INCOMPLETE
    assert "Did you mean 'rescue'?" in ran.out
    circle = "goals:\n- {do: Reach(a), name: a, after: [b]}\n- {do: Reach(b), name: b, after: [a]}\n"
    Path("mission.yaml").write_text(circle, encoding="utf-8")
    ran = shell("plan")
    assert ran.code == Exit.BAD_INPUT
    assert "mission.yaml:3" in ran.err
    assert "circle" in ran.err


@pytest.mark.parametrize(
    ("goal", "words"),
    [
        ('{do: "Search(cow); Reach(gate)"}', "a name in a goal has no ')'"),
        ("{do: Search(keys), by: []}", "leave it out to allow all"),
    ],
)
def test_a_goal_that_is_no_goal_is_bad_input_with_its_line(shell: Shell, goal: str, words: str) -> None:
    Path("mission.yaml").write_text(f"goals:\n- {{do: Reach(a)}}\n- {goal}\n", encoding="utf-8")
    ran = shell("plan")
    assert ran.code == Exit.BAD_INPUT
    assert "mission.yaml:3" in ran.err
    assert words in " ".join(ran.err.split())


def test_a_link_to_an_option_is_told(shell: Shell) -> None:
    text = """goals:
- {task: Look, gate: xor, goals: [{do: Search(keys), name: a}, {do: Reach(cow)}]}
- {do: Follow(dog), until: a}
"""
    Path("mission.yaml").write_text(text, encoding="utf-8")
    ran = shell("plan")
    assert ran.code == Exit.DELIVERED
    assert "only if that option of 'Look' is taken" in " ".join(ran.out.split())


def test_a_robot_type_that_the_fleet_does_not_have_is_bad_input(shell: Shell) -> None:
    Path("mission.yaml").write_text("goals: [{do: Search(keys), by: [crane]}]\n", encoding="utf-8")
    ran = shell("plan")
    assert ran.code == Exit.BAD_INPUT
    assert "names robot type 'crane', which the fleet does not have" in ran.err
