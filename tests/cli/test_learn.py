"""``missiontree learn``: from a plan or a tree on disk to a method that is used."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from missiontree.cli.exits import Exit
from missiontree.formats.document import read_file, write_text
from tests.builders import reunite_tree
from tests.cli.running import Shell

ROOT = Path(__file__).parents[2]
SHOWN = re.compile(
    r'```sh\nmissiontree plan "([^"]*)" --out plan.json\nmissiontree learn plan.json ?([^\n]*)\n```\n\n```(?:yaml|text)\n(.*?)```',
    re.DOTALL,
)


def planned(shell: Shell, mission: str, *more: str) -> None:
    ran = shell("plan", mission, "--quiet", "--out", "plan.json", *more)
    assert ran.code in {Exit.DELIVERED, Exit.INCOMPLETE}, ran.err


def test_a_plan_is_learned_and_the_method_is_used(shell: Shell) -> None:
    planned(shell, "Rescue the child from the barn")
    ran = shell("learn", "plan.json", "--as", "out_of_there", "--out", "learned.yaml")
    assert (ran.code, ran.out) == (Exit.DELIVERED, "")
    assert "method out_of_there is written to learned.yaml" in ran.err
    used = shell("plan", "Rescue the nurse from the hospital", "--methods", "learned.yaml")
    assert used.code == Exit.DELIVERED
    assert "method out_of_there, <rescue> {person} from {place}" in " ".join(used.out.split())
    assert "ReachAndTransport(Nurse, Safe Area)" in used.out


def test_without_a_file_the_method_is_printed_as_a_file_that_can_be_read(shell: Shell) -> None:
    planned(shell, "Reunite mom with her lost child")
    ran = shell("learn", "plan.json")
    assert (ran.code, ran.err) == (Exit.DELIVERED, "")
    assert ran.out.startswith("format: methods/1\nmethods:\n  - id: learned_reunite\n")
    assert "Locate {the full person_2}" in ran.out
    Path("printed.yaml").write_text(ran.out, encoding="utf-8")
    assert "method learned_reunite" in shell("plan", "Reunite dad with his lost son", "--methods", "printed.yaml").out


def test_a_second_method_goes_behind_the_first_and_one_of_the_same_id_is_refused(shell: Shell) -> None:
    planned(shell, "Find the keys")
    assert shell("learn", "plan.json", "--as", "one", "--out", "m.yaml").code == Exit.DELIVERED
    before = Path("m.yaml").read_text(encoding="utf-8")
    again = shell("learn", "plan.json", "--as", "one", "--out", "m.yaml")
    assert again.code == Exit.BAD_INPUT
    assert "method 'one' is in the file already" in again.err
    assert "--as ID" in again.err
    assert Path("m.yaml").read_text(encoding="utf-8") == before
    assert shell("learn", "plan.json", "--as", "two", "--says", "retrieve {keys}", "--out", "m.yaml").code == 0
    after = Path("m.yaml").read_text(encoding="utf-8")
    assert after.startswith(before)
    assert "method two" in shell("plan", "Retrieve the wallet", "--methods", "m.yaml").out


def test_in_a_folder_it_says_how_the_method_is_listed_unless_it_is(shell: Shell) -> None:
    Path("mission.yaml").write_text("mission: Find the keys\nmethods: []\n", encoding="utf-8")
    planned(shell, "mission.yaml")
    assert "listed in mission.yaml: methods: [FILE]" in shell("learn", "plan.json").err
    Path("methods").mkdir()
    ran = shell("learn", "plan.json", "--out", "methods/learned.yaml")
    assert "listed in mission.yaml: methods: [methods/learned.yaml]" in ran.err
    assert shell("learn", "plan.json", "--as", "b", "--out", "methods/learned.yaml", "--quiet").err == ""
    Path("mission.yaml").write_text("mission: Find the wallet\nmethods: [methods/learned.yaml]\n", encoding="utf-8")
    assert "listed" not in shell("learn", "plan.json", "--as", "c", "--out", "methods/learned.yaml").err
    assert "method learned_search" in shell("plan").out


def test_a_tree_file_is_learned_with_the_fleet_and_the_scene_of_the_folder(shell: Shell) -> None:
    Path("tree.json").write_text(write_text(reunite_tree(), "tree"), encoding="utf-8")
    ran = shell("learn", "tree.json")
    assert ran.code == Exit.DELIVERED, ran.err
    assert "says: ['<reunite> {person} with {person_2}']" in ran.out
    Path("mission.yaml").write_text("mission: Find anna\nscene: scene.yaml\n", encoding="utf-8")
    Path("scene.yaml").write_text("entities: [{id: anna, kind: person, label: Anna, position: {x_m: 1, y_m: 1}}]\n")
    planned(shell, "mission.yaml")
    plan = read_file(Path("plan.json"), "plan")
    Path("tree.json").write_text(write_text(plan.tree, "tree"), encoding="utf-8")
    ran = shell("learn", "tree.json")
    assert ran.code == Exit.DELIVERED, ran.err
    assert "- {do: Search(person)}" in ran.out
    Path("mission.yaml").unlink()
    ran = shell("learn", "tree.json")  # without the scene nobody knows who that is
    assert ran.code == Exit.BAD_INPUT
    assert "anna" in ran.err


@pytest.mark.parametrize(
    ("mission", "arguments", "words"),
    [
        ("Recommend best Italian restaurants in the area", [], "the tree has no routine"),
        ("Blorp the frobnicator", [], "the plan has no tree: its outcome is incomplete"),
        ("Find the keys, then bring them to Anna", [], "the mission has 2 parts"),
        ("Find the keys", ["--says", "get {thing}"], "{keys} for Keys"),
        ("Find the keys", ["--says", "{keys}"], "does not begin with a verb"),
        ("Find the keys", ["--as", "a b"], "--as 'a b' is no id"),
        ("Find the keys", ["--as", ""], "--as '' is no id"),
        ("Find the keys", ["--says", ""], "--says '' is no pattern"),
        ("Find the keys", ["--says", " "], "is no pattern"),
        ("Find the keys", ["--as", "rescue"], "'rescue' is the id of a built-in method"),
        ("Find the three crates", [], "'the three crates' names several at once"),
        ("Find the keys", ["--out", "nowhere/m.yaml"], "the file cannot be written"),
        ("Find the keys", ["--out", "plan.json"], "plan.json"),
    ],
)
def test_what_cannot_be_learned_is_refused_in_words(
    shell: Shell, mission: str, arguments: list[str], words: str
) -> None:
    shell("plan", mission, "--quiet", "--out", "plan.json")
    before = Path("plan.json").read_text(encoding="utf-8")
    ran = shell("learn", "plan.json", *arguments)
    assert (ran.code, ran.out) == (Exit.BAD_INPUT, "")
    assert words in ran.err
    assert Path("plan.json").read_text(encoding="utf-8") == before


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (None, "there is no such file"),
        ("", "the file is empty"),
        ("[1, 2]", "plan.json:1"),
        ("{", "plan.json"),
        ('{"format": "fleet/1", "types": []}', "this is a fleet file, a plan file was expected"),
        ('{"format": "tree/1", "objective": "x"}', "needs the field 'nodes'"),
    ],
)
def test_a_file_that_is_neither_a_plan_nor_a_tree_is_refused(shell: Shell, text: str | None, words: str) -> None:
    if text is not None:
        Path("plan.json").write_text(text, encoding="utf-8")
    ran = shell("learn", "plan.json")
    assert ran.code == Exit.BAD_INPUT
    assert words in ran.err


def test_a_plan_of_formal_goals_is_learned_by_a_pattern_that_is_given(shell: Shell) -> None:
    goals = (
        "mission: Tidy up\ngoals: [{do: Search(keys), name: a}, {do: 'ReachAndTransport(keys, Anna)', after: [a]}]\n"
    )
    Path("mission.yaml").write_text(goals, encoding="utf-8")
    planned(shell, "mission.yaml")
    refused = shell("learn", "plan.json")
    assert refused.code == Exit.BAD_INPUT
    assert "--says" in refused.err
    ran = shell("learn", "plan.json", "--says", "make sure that {anna} has {keys}", "--out", "m.yaml")
    assert ran.code == Exit.DELIVERED, ran.err
    used = shell("plan", "Make sure that Tom has the wallet", "--methods", "m.yaml")
    assert "ReachAndTransport(Wallet, Tom)" in used.out


def test_the_how_to_shows_what_is_printed(shell: Shell) -> None:
    page = (ROOT / "docs/how-to/learn-a-method.md").read_text(encoding="utf-8")
    for mission, arguments, shown in SHOWN.findall(page):
        planned(shell, mission)
        ran = shell("learn", "plan.json", *shlex.split(arguments))
        assert (ran.out or ran.err) == shown
    assert len(SHOWN.findall(page)) == 2
