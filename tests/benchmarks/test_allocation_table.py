"""The table of allocators and their peers: its rows, its files, its lines, and what it says of a contradiction."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from benchmarks.allocation import ROWS, Files, Row, disagreements, gap, line, main, name_of, rows_of, same
from benchmarks.contenders import Question, answer_of, installed
from benchmarks.million import million_table
from benchmarks.peer_model import Answer
from tests.formats.tree_files import small


def test_a_file_of_the_folder_takes_the_place_of_a_generated_one(tmp_path: Path) -> None:
    data, made = tmp_path / "data", tmp_path / "made"
    data.mkdir()
    made.mkdir()
    (data / "mission_30_3_1.json").write_text("{}", encoding="utf-8")
    files = Files(data, made)
    assert files.file(("mission", 30, 3, 1)) == data / "mission_30_3_1.json"
    generated = files.file(("mission", 30, 3, 2))
    assert generated == made / "mission_30_3_2.json"
    assert json.loads(generated.read_text(encoding="utf-8"))["robots"] == 3


def test_other_files_of_the_folder_are_rows_of_their_own(tmp_path: Path) -> None:
    for name in ("mission_300_6_4.json", "mine.json", "notes.txt"):
        (tmp_path / name).write_text("{}", encoding="utf-8")
    rows = rows_of(tmp_path)
    assert rows[: len(ROWS)] == ROWS
    assert [(row.name, row.instances) for row in rows[len(ROWS) :]] == [("mine", (tmp_path / "mine.json",))]


def test_a_gap_is_that_of_the_best_value() -> None:
    """(110 - 100) / 100; a value below 1 counts as 1."""
    assert gap(Answer(values=[100.0, 90.0], bound=110.0)) == pytest.approx(0.1)
    assert gap(Answer(values=[0.0], bound=0.5)) == 0.5
    assert gap(Answer(values=[], bound=5.0)) is None
    assert gap(Answer(values=[5.0])) is None


def test_a_line_tells_means_and_the_worst() -> None:
    answers = [
        Answer(values=[10.0], bound=10.0, proven=True, seconds=1.0),
        Answer(values=[20.0], bound=25.0, seconds=2.0),
        Answer(seconds=6.0, note="did not stop"),
    ]
    assert (
        line("work", "exact", answers)
        == "| work | exact | 3 | 1 | 2 | 3.000 | 2.000 | 6.000 | 15.0 | 17.5 | 25.000 % | did not stop"
    )


def test_lists_that_are_proven_and_differ_are_named() -> None:
    row = Row("two", (("mission", 30, 3, 1), ("mission", 30, 3, 2)))
    proven, unproven = Answer(values=[9.0, 8.0], proven=True), Answer(values=[7.0])
    other = Answer(values=[9.0, 7.0], proven=True)
    assert list(disagreements(row, {"exact": [proven, proven], "highs": [proven, unproven]})) == []
    (told,) = disagreements(row, {"exact": [proven, proven], "highs": [proven, other]})
    assert told.startswith("DIFFERENT PROOFS for mission_30_3_2.json")


def test_values_are_equal_but_for_rounding() -> None:
    assert same([1e9, 5.0], [1e9 + 1e-4, 5.0])
    assert not same([5.0], [5.0, 4.0])
    assert not same([5.0], [6.0])


def test_ours_are_asked_like_everybody(tmp_path: Path) -> None:
    """17 under budgets (:mod:`tests.formats.tree_files`), and 19 without."""
    file = tmp_path / "tree.json"
    file.write_text(json.dumps(small()), encoding="utf-8")
    assert installed("exact")
    for budgets, values in ((True, [17.0]), (False, [19.0, 17.0])):
        answer = answer_of("exact", Question(file, 10, budgets, 30.0, 0))
        assert (answer.values, answer.bound, answer.proven) == (values, values[0], True)
        assert not answer_of("pruned", Question(file, 1, True, 30.0, 0)).proven


def test_the_command_prints_machine_seed_and_rows(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    (tmp_path / "mine.json").write_text(json.dumps(small()), encoding="utf-8")
    monkeypatch.setattr(
        sys, "argv", ["allocation", "--only", "mine", "--data", str(tmp_path), "--no-peers", "--limit", "30"]
    )
    main()
    out = capsys.readouterr().out.splitlines()
    assert "missiontree" in out[0]
    assert out[1] == "Seed 0; limits of 30 s."
    assert [row.split(" | ")[:4] for row in out if row.startswith("| mine")] == [
        ["| mine", "exact", "1", "1"],
        ["| mine", "pruned", "1", "0"],
    ]


def test_a_row_that_there_is_not_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["allocation", "--only", "nothing"])
    with pytest.raises(SystemExit):
        main()


def test_the_door_is_measured_from_outside(tmp_path: Path) -> None:
    """Both runs of the command are processes of their own, here with a tree of five nodes."""
    file = tmp_path / "tree.json"
    file.write_text(json.dumps(small()), encoding="utf-8")
    without, within = million_table(file).splitlines()[2:]
    assert without.startswith("| 5 | 2 | --no-budgets | exact | 2 | 19 | 0.000 % |")
    assert within.startswith("| 5 | 2 | --time-limit 2 | exact | 1 | 17 | 0.000 % |")


def test_names_of_files_tell_their_instance() -> None:
    assert name_of(("uniform", 50, 3, 2)) == "uniform_50_3_2.json"
