"""The file of results: what is written is read, a cut line is repaired, and what is not ours is left alone."""

from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.evaluation.ledger import line_of, read_ledger
from missiontree.evaluation.run import Run
from missiontree.mission.spent import Spent
from tests.evaluation.contestants import missions_in, run

FIRST, SECOND = run(number=1), run(number=2, right=False, reasons=("Zeile\u2028eins \ud800",), spent=None)


def written(path: Path, *runs: Run) -> Path:
    with read_ledger(path).opened() as add:
        for one in runs:
            add(one)
    return path


def test_what_is_written_is_read(tmp_path: Path) -> None:
    path = written(tmp_path / "r.jsonl", FIRST, SECOND)
    assert read_ledger(path).runs == {FIRST.key: FIRST, SECOND.key: SECOND}
    assert path.read_bytes().isascii()


def test_each_run_is_in_the_file_as_soon_as_it_is_added(tmp_path: Path) -> None:
    path = tmp_path / "r.jsonl"
    with read_ledger(path).opened() as add:
        add(FIRST)
        assert read_ledger(path).runs == {FIRST.key: FIRST}


def test_a_file_is_added_to(tmp_path: Path) -> None:
    path = written(tmp_path / "r.jsonl", FIRST)
    before = path.read_bytes()
    written(path, SECOND)
    assert path.read_bytes().startswith(before)
    assert len(read_ledger(path).runs) == 2


def test_of_two_lines_with_one_key_the_last_counts(tmp_path: Path) -> None:
    later = run(number=1, right=False)
    assert later.key == FIRST.key
    assert read_ledger(written(tmp_path / "r.jsonl", FIRST, later)).runs == {FIRST.key: later}


def test_a_last_line_cut_anywhere_is_ignored_and_taken_away(tmp_path: Path) -> None:
    """At every byte of the second line."""
    first, second = f"{line_of(FIRST)}\n".encode(), line_of(SECOND).encode()
    path = tmp_path / "r.jsonl"
    for cut in range(len(second)):
        path.write_bytes(first + second[:cut])
        assert read_ledger(path).runs == {FIRST.key: FIRST}, cut
        written(path, SECOND)
        assert path.read_bytes() == first + second + b"\n", cut


def test_a_last_line_that_lacks_only_its_end_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "r.jsonl"
    path.write_bytes(line_of(FIRST).encode())
    assert read_ledger(path).runs == {FIRST.key: FIRST}
    written(path, SECOND)
    assert list(read_ledger(path).runs.values()) == [FIRST, SECOND]


def test_an_only_line_cut_anywhere_is_a_file_of_nothing(tmp_path: Path) -> None:
    path, line = tmp_path / "r.jsonl", line_of(FIRST).encode()
    for cut in range(len(line)):
        path.write_bytes(line[:cut])
        assert read_ledger(path).runs == {}, cut


@pytest.mark.parametrize(
    ("content", "line", "says"),
    [
        (b"fleet: fleet.yaml", 1, "not JSON"),  # somebody's one-line file must not be emptied
        (b'{"a": 1}', 1, "not of the format run/1"),
        (b"{}\n", 1, "not of the format run/1"),
        (b"FIRST\n[1]\nFIRST\n", 2, "not of the format"),
        (b"FIRST\n\nFIRST\n", 2, "not JSON"),
        (b"FIRST\nFIR\nFIRST\n", 2, "not JSON"),
        (b'FIRST\n{"format":"run/1"}\n', 2, "no run"),
        (b'FIRST\n{"format":"run/2"}', 2, "not of the format"),
    ],
)
def test_what_is_not_ours_is_refused_with_its_line(tmp_path: Path, content: bytes, line: int, says: str) -> None:
    path = tmp_path / "r.jsonl"
    path.write_bytes(content.replace(b"FIRST", line_of(FIRST).encode()))
    before = path.read_bytes()
    with pytest.raises(InputError, match=says) as refusal:
        read_ledger(path)
    assert (refusal.value.line, path.read_bytes()) == (line, before)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('"kind":"right"', '"kind":"splendid"', "no verdict 'splendid'"),
        ('"status":"complete"', '"status":"done"', "with 'done'"),
        ('"score":1', '"score":2', "at most 1"),
        ('"number":1', '"number":0', "at least 1"),
        ('"turns":2', '"turns":-2', "at least 0"),
        ('"number":1', '"number":1,"more":1', "more"),
    ],
)
def test_a_run_that_none_can_be_is_refused(tmp_path: Path, old: str, new: str, says: str) -> None:
    text = line_of(FIRST)
    assert old in text
    path = tmp_path / "r.jsonl"
    path.write_text(f"{text.replace(old, new)}\n", encoding="ascii")
    with pytest.raises(InputError, match=says):
        read_ledger(path)


def test_a_file_that_cannot_be_read_or_written_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be read"):
        read_ledger(tmp_path)
    nowhere = read_ledger(tmp_path / "none" / "r.jsonl")
    with pytest.raises(InputError, match="cannot be written"), nowhere.opened():
        pass


def test_what_was_spent_comes_back(tmp_path: Path) -> None:
    spent = Spent(turns=1, calls=2, input_tokens=3, output_tokens=4, estimated=True, seconds=0.5, cost_usd=0.001)
    (back,) = read_ledger(written(tmp_path / "r.jsonl", run(spent=spent))).runs.values()
    assert back.spent == spent


def test_missions_that_changed_are_known(tmp_path: Path) -> None:
    """Of three missions the first is as it was, the second is not, and of the third there are no runs."""
    missions = missions_in(tmp_path)
    setting, first = missions[0]
    path = written(tmp_path / "r.jsonl", run(digest=setting.digest(first)), run("home-visit"), run("other"))
    assert read_ledger(path).changed(missions) == ("home-visit",)
    assert read_ledger(path).changed(missions, whole=True) == ("home-find", "home-visit")
