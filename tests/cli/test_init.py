"""``missiontree init``: a sample becomes a folder of one's own, in which it can be planned."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from missiontree.samples.catalogue import SAMPLES, sample_files
from tests.cli.running import Shell


@pytest.mark.parametrize("name", SAMPLES)
def test_every_sample_is_written_as_it_is(shell: Shell, tmp_path: Path, name: str) -> None:
    ran = shell("init", name, "--sample", name)
    assert ran.code == 0
    assert ran.out.splitlines()[-1] == f"next: cd {name} && missiontree plan"
    written = {file.relative_to(tmp_path / name).as_posix() for file in (tmp_path / name).rglob("*") if file.is_file()}
    assert written == set(sample_files(name))
    for file, source in sample_files(name).items():
        assert (tmp_path / name / file).read_bytes() == source.read_bytes()


@pytest.mark.parametrize("name", ["reunite", "orchard", "harbour"])
def test_the_folder_plans_as_the_sample_does(shell: Shell, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    sample = shell("plan", "--sample", name, "--json")
    shell("init", "mine", "--sample", name)
    monkeypatch.chdir("mine")
    assert json.loads(shell("plan", "--json").out) == json.loads(sample.out)


def test_an_unknown_sample_is_refused_and_nothing_is_written(shell: Shell, tmp_path: Path) -> None:
    ran = shell("init", "mine", "--sample", "picnic")
    assert ran.code == 2
    assert "there is no sample 'picnic'" in ran.err
    assert "wind_farm" in ran.err
    assert list(tmp_path.iterdir()) == []


def test_a_sample_does_not_overwrite_another(shell: Shell, tmp_path: Path) -> None:
    shell("init", "mine", "--sample", "home")
    ran = shell("init", "mine", "--sample", "orchard")
    assert ran.code == 2
    assert "Nothing was written" in ran.err
    assert not (tmp_path / "mine" / "routines").exists()


def test_the_help_lists_every_sample(shell: Shell) -> None:
    words = shell("init", "--help").out.replace(",", " ").replace(".", " ").split()
    assert set(SAMPLES) <= set(words)
