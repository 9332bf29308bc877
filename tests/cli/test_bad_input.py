"""Wrong input of every kind gets a clear answer and the documented exit code, never a traceback."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.running import Shell

FLEET = "types:\n  - {id: scout, count: 1, capabilities: {search: 1, reach: 1, carry: 1}, limits: {max_speed_mps: 1}}\n"
ISLAND = """
places: [{id: gate, position: {x_m: 0, y_m: 0}}, {id: island, position: {x_m: 9, y_m: 0}}]
entities: [{id: crate, kind: object, place: island}]
roads: {roads: [{ends: [gate, island], blocked: true}]}
"""

FILES = [
    ("fleet", "types: []", ["at least one robot type"]),
    ("fleet", "", ["empty"]),
    ("fleet", "types: [", [":1"]),
    ("fleet", "types:\n  - {id: scout, count: 1}\n  - {id: scout, count: 1}", ["'scout' stands twice"]),
    ("fleet", "types:\n  - id: scout\n    count: 1\n    limits: {max_speed_mps: -2}", [":4", "max_speed_mps", "-2"]),
    (
        "fleet",
        "types:\n  - id: scout\n    count: 1\n    capabilites: {search: 1}",
        [":4", "capabilites", "capabilities"],
    ),
    ("fleet", "types:\n  - id: scout\n    count: 1\n    count: 2", ["count", "twice"]),
    ("fleet", "types:\n  - {id: scout, count: 1, limits: {max_speed_mps: '3'}}", [":2", "max_speed_mps", "number"]),
    ("fleet", "types:\n  - {id: Größe, count: 1}", [":2", "letter"]),
    ("scene", "entities:\n  - {id: hall, kind: place, capacity: 2}", ["capacity", "no stage enforces it yet"]),
    ("fleet", "a: &a [x]\nb: [*a, *a]", ["fleet.yaml"]),
    ("fleet", "!!python/object/apply:os.system ['true']", ["fleet.yaml:1"]),
    ("fleet", "\x00", ["fleet.yaml"]),
    ("scene", "entities: [{id: cat, kind: anmal}]", ["anmal"]),
    ("scene", "entities: [{id: cat, kind: animal, position: {x_m: .nan, y_m: 0}}]", ["x_m"]),
    ("scene", "entities: [{id: cat, deadline_s: 3}]", ["deadline_s"]),
    ("routines", "routines: []", ["at least one"]),
    (
        "routines",
        "routines: [{id: R, purpose: p, arguments: [{name: a, kinds: [object]}], parts: [{routine: Serch}]}]",
        ["Serch"],
    ),
    ("methods", "methods: 7", ["methods"]),
]


@pytest.mark.parametrize(("what", "text", "words"), FILES)
def test_a_bad_file_is_named_with_what_is_wrong(
    shell: Shell, tmp_path: Path, what: str, text: str, words: list[str]
) -> None:
    (tmp_path / "fleet.yaml").write_text(FLEET, encoding="utf-8")
    (tmp_path / f"{what}.yaml").write_text(text, encoding="utf-8")
    ran = shell("plan", "Find the cat", "--fleet", "fleet.yaml", f"--{what}", f"{what}.yaml")
    assert ran.code == 2, ran
    for word in [*words, f"{what}.yaml"]:
        assert word in ran.err, ran.err
    assert "Traceback" not in ran.err


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["plan"], 2, "no mission is given"),
        (["plan", "missing.yaml"], 2, "missing.yaml"),
        (["plan", "Find the cat", "--fleet", "missing.yaml"], 2, "missing.yaml"),
        (["plan", "Find the cat", "--fleet", "."], 2, "."),
        (["plan", "Find the cat", "--sample", "reunite"], 2, "one of them"),
        (["plan", "--sample", "reunion"], 2, "reunite, rescue"),
        (["plan", "Find the cat", "--weights", "1,x"], 2, "'x' is not a number"),
        (["plan", "Find the cat", "--weights", "1,-1"], 2, "at least 0"),
        (["plan", "Find the cat", "--weights", "nan"], 2, "finite"),
        (["plan", "Find the cat", "-k", "0"], 2, "at least 1"),
        (["plan", "Find the cat", "-k", "many"], 2, "a whole number is needed"),
        (["plan", "Find the cat", "--allocator", "best"], 2, "exact, pruned"),
        (["plan", "Find the cat", "--scheduler", "best"], 2, "greedy, cpsat, auto"),
        (["plan", "Find the cat", "--model", "oracle"], 2, "offline"),
        (["plan", "Find the cat", "--model", "recorded:none.jsonl"], 2, "none.jsonl"),
        (["plan", "Find the cat", "--time-limit", "-1"], 2, "at least 0"),
        (["plan", "Find the cat", "--nonsense"], 2, "--nonsense"),
        (["plan", "Find the cat", "--out", "no/such/folder.json"], 2, "cannot be written"),
        (["show", "missing.json"], 2, "missing.json"),
        (["check", "missing.json"], 2, "missing.json"),
        (["schema", "flet"], 2, "fleet"),
        (["fly"], 2, "fly"),
        (["plan", ""], 5, "mission"),
        (["plan", "   "], 5, "mission"),
        (["plan", "lorem ipsum dolor sit amet"], 5, ""),
        (["plan", "word " * 10_000], 2, "5000"),
        (["plan", "Recommend a good restaurant"], 1, "recommend"),
    ],
)
def test_a_bad_command_line_gets_words_and_a_code(shell: Shell, arguments: list[str], code: int, words: str) -> None:
    ran = shell(*arguments)
    assert ran.code == code, ran
    assert words in ran.err + ran.out
    assert "Traceback" not in ran.err + ran.out
    assert "internal error" not in ran.err


def test_an_unreachable_place_cannot_be_done_and_says_what_cuts_it_off(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "fleet.yaml").write_text(FLEET.replace("count: 1", "count: 1, place: gate"), encoding="utf-8")
    (tmp_path / "scene.yaml").write_text(ISLAND, encoding="utf-8")
    ran = shell("plan", "Go to the crate", "--fleet", "fleet.yaml", "--scene", "scene.yaml")
    assert ran.code == 1, ran
    assert "blocked" in ran.out


def test_a_cyclic_precedence_in_a_tree_file_is_refused_with_the_cycle(shell: Shell, tmp_path: Path) -> None:
    node = "{{id: {0}, label: {0}, routine: Search, arguments: {{agent: cat}}}}"
    tree = (
        "objective: x\nentities: [{id: cat, kind: animal}]\nnodes:\n"
        "  - {id: root, label: root, gate: and, children: [first_task, second_task]}\n"
        f"  - {node.format('first_task')}\n  - {node.format('second_task')}\n"
        "links: [{first: first_task, second: second_task}, {first: second_task, second: first_task}]\n"
    )
    (tmp_path / "tree.yaml").write_text(tree, encoding="utf-8")
    (tmp_path / "mission.yaml").write_text("tree: tree.yaml", encoding="utf-8")
    ran = shell("plan")
    assert ran.code == 2, ran
    assert "tree.yaml" in ran.err
    assert "first_task" in ran.out + ran.err
    assert "second_task" in ran.out + ran.err


def test_a_fleet_of_ten_thousand_robots_plans(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "fleet.yaml").write_text(FLEET.replace("count: 1", "count: 10000"), encoding="utf-8")
    ran = shell("plan", "Find the cat", "--fleet", "fleet.yaml")
    assert ran.code == 0, ran


def test_names_in_any_script_survive(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "fleet.yaml").write_text(FLEET.replace("id: scout", "id: scout, label: Späher 侦察"), encoding="utf-8")
    ran = shell("plan", "Find the cat", "--fleet", "fleet.yaml", "--no-colour")
    assert ran.code == 0, ran
    assert "Späher 侦察" in ran.out


def test_terminal_control_in_a_label_is_not_sent_to_the_terminal(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "fleet.yaml").write_text(
        FLEET.replace("id: scout", 'id: scout, label: "[red]\\e[31mScout"'), encoding="utf-8"
    )
    ran = shell("plan", "Find the cat", "--fleet", "fleet.yaml", "--no-colour")
    assert "\x1b" not in ran.out + ran.err
