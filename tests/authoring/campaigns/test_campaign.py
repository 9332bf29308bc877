"""The common part of the campaigns: numbered runs, resumed where they were left, and a failure if anything was seen that must never be."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from benchmarks.campaign import CRASH, Campaign, Verdict, luck, made, run, table
from benchmarks.hallucinated_names import CAMPAIGN


def toss(seed: int, index: int) -> Verdict:
    """Heads or tails."""
    return Verdict(luck(seed, index).choice(("heads", "tails")), {"tosses": 2})


def fall(seed: int, index: int) -> Verdict:
    """The seventh coin stands on its edge, the eleventh is lost."""
    if index == 11:
        raise KeyError("coin")
    return Verdict("edge" if index == 7 else "flat", violations=(("edges", "it stands"),) if index == 7 else ())


TOSSES = Campaign("tosses", "Coins.", 250, toss, ("edges",), "coins")


def command(monkeypatch: pytest.MonkeyPatch, campaign: Campaign, *options: str | Path) -> None:
    monkeypatch.setattr("sys.argv", ["campaign", *map(str, options)])
    run(campaign)


def test_pieces_come_to_the_same_as_the_whole() -> None:
    whole, parts = made(TOSSES, 1, 0, 250), made(TOSSES, 1, 0, 30)
    parts.add(made(TOSSES, 1, 30, 250))
    assert (parts.done, parts.rows) == (whole.done, whole.rows)
    assert sum(row["tosses"] for row in whole.rows.values()) == 500  # two for each coin
    assert made(TOSSES, 2, 0, 250).rows != whole.rows


def test_an_interrupted_campaign_goes_on_where_it_was(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    state = tmp_path / "state.json"
    command(monkeypatch, TOSSES, "--count", "120", "--state", state)
    first = json.loads(state.read_text())
    command(monkeypatch, TOSSES, "--count", "250", "--state", state)
    assert (first["done"], json.loads(state.read_text())["done"]) == (120, 250)
    assert json.loads(state.read_text())["rows"] == made(TOSSES, 1, 0, 250).rows
    assert "| coins | 250 |" in capsys.readouterr().out


@pytest.mark.parametrize(("campaign", "seed"), [(TOSSES, 2), (replace(TOSSES, name="others"), 1)])
def test_a_state_of_something_else_is_refused(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, campaign: Campaign, seed: int
) -> None:
    state = tmp_path / "state.json"
    command(monkeypatch, TOSSES, "--count", "1", "--state", state)
    with pytest.raises(SystemExit, match="belongs to tosses, seed 1"):
        command(monkeypatch, campaign, "--count", "2", "--state", state, "--seed", str(seed))


def test_a_state_of_other_code_is_refused(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Figures of two states of the code would be figures of none."""
    state = tmp_path / "state.json"
    command(monkeypatch, TOSSES, "--count", "1", "--state", state)
    monkeypatch.setattr("benchmarks.campaign.source_digest", lambda _: "another")
    with pytest.raises(SystemExit, match="source another"):
        command(monkeypatch, TOSSES, "--count", "2", "--state", state)


def test_processes_side_by_side_come_to_the_same(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    state = tmp_path / "state.json"
    command(monkeypatch, CAMPAIGN, "--count", "250", "--jobs", "2", "--state", state)
    assert json.loads(state.read_text())["rows"] == made(CAMPAIGN, 1, 0, 250).rows


def test_what_must_never_be_fails_the_command(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    falls = Campaign("falls", "Coins that fall.", 20, fall, ("edges",))
    command(monkeypatch, falls, "--count", "7")
    assert "| edges | 0 |" in capsys.readouterr().out
    with pytest.raises(SystemExit) as end:
        command(monkeypatch, falls)
    told = capsys.readouterr().out
    assert end.value.code == 1
    assert "| edges | 1 |" in told
    assert "7: it stands" in told
    assert f"| {CRASH} | 1 |" in told
    assert "KeyError: 'coin'" in told


def test_the_table_names_the_machine_and_adds_up() -> None:
    state = made(TOSSES, 1, 0, 50)
    lines = table(TOSSES, state).splitlines()
    assert "Python" in lines[0]
    assert lines[-1] == "| all | 50 | 100 |"
