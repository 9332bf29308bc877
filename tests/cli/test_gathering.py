"""What a command takes up from the folder one stands in, and what it leaves alone."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.running import Shell

FLEET = "types: [{id: nobody_else, count: 1, place: gate, capabilities: {search: 1}}]\n"
SCENE = "places: [{id: gate, position: {x_m: 0, y_m: 0}}]\n"


@pytest.fixture
def site(tmp_path: Path) -> Path:
    """A folder with a fleet and a scene of the usual names; the fleet starts at a place of the scene."""
    folder = tmp_path / "site"
    folder.mkdir()
    (folder / "fleet.yaml").write_text(FLEET, encoding="utf-8")
    (folder / "scene.yaml").write_text(SCENE, encoding="utf-8")
    return folder


def test_a_sentence_is_planned_for_the_fleet_of_the_folder(
    shell: Shell, site: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(site)
    ran = shell("plan", "Find the cat")
    assert ran.code == 0, ran
    assert "nobody_else-1" in ran.out
    assert "using fleet fleet.yaml\nusing scene scene.yaml\n" in ran.err


def test_what_is_named_goes_before_what_lies_about(shell: Shell, site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (site / "other.yaml").write_text(FLEET.replace("nobody_else", "somebody"), encoding="utf-8")
    monkeypatch.chdir(site)
    assert "somebody-1" in shell("plan", "Find the cat", "--fleet", "other.yaml").out


def test_a_mission_file_that_names_no_fleet_takes_the_one_beside_it(shell: Shell, site: Path) -> None:
    (site / "mission.yaml").write_text("mission: Find the cat", encoding="utf-8")
    assert "nobody_else-1" in shell("plan", "site/mission.yaml").out
    assert "nobody_else-1" in shell("plan", "site").out


def test_a_mission_file_takes_what_it_names_and_not_what_lies_where_one_stands(
    shell: Shell, site: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (site / "other.yaml").write_text(FLEET.replace("nobody_else", "somebody"), encoding="utf-8")
    (site / "patrol.yaml").write_text("mission: Find the cat\nfleet: other.yaml\n", encoding="utf-8")
    monkeypatch.chdir(site)
    ran = shell("plan", "patrol.yaml")
    assert "somebody-1" in ran.out, ran
    (site / "patrol.yaml").write_text("mission: Find the cat\nfleet: gone.yaml\n", encoding="utf-8")
    ran = shell("plan", "patrol.yaml")
    assert ran.code == 2
    assert "gone.yaml: there is no such file" in ran.err


def test_a_folder_that_may_not_be_read_is_bad_input(site: Path) -> None:
    """Root may read every folder, so the command runs without the rights that let it."""
    as_anybody = ["setpriv", "--bounding-set=-dac_override,-dac_read_search"] if os.geteuid() == 0 else []
    site.chmod(0)
    try:
        ran = subprocess.run(
            [*as_anybody, sys.executable, "-m", "missiontree", "plan", site.name],
            cwd=site.parent,
            capture_output=True,
            text=True,
            check=False,
        )
    finally:
        site.chmod(0o700)
    assert ran.returncode == 2, ran
    assert "this folder may not be read" in ran.stderr


def test_without_any_the_papers_team_is_taken(shell: Shell) -> None:
    ran = shell("plan", "Find the cat")
    assert ran.err == "using fleet the paper's team\n"


def test_python_files_that_lie_about_are_not_run(shell: Shell, site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (site / "routines.py").write_text("raise RuntimeError('it was run')", encoding="utf-8")
    monkeypatch.chdir(site)
    assert shell("plan", "Find the cat").code == 0
    ran = shell("plan", "Find the cat", "--routines", "routines.py")  # named, it is
    assert ran.code == 2
    assert "it was run" in ran.err


@pytest.mark.parametrize("folder", ["site", "."])
def test_a_folder_without_a_mission_is_said_to_be_one(shell: Shell, site: Path, folder: str) -> None:
    assert site.is_dir()
    ran = shell("plan", folder)
    assert ran.code == 2, ran
    assert "without a mission.yaml" in ran.err


def test_files_that_do_not_fit_together_are_both_named(shell: Shell, site: Path) -> None:
    (site / "scene.yaml").write_text("label: nothing here", encoding="utf-8")
    (site / "mission.yaml").write_text("mission: Find the cat", encoding="utf-8")
    ran = shell("plan", "site")
    assert ran.code == 2
    assert "'nobody_else' starts at place 'gate'" in ran.err
    assert "site/fleet.yaml, site/scene.yaml: these do not fit together" in ran.err


def test_a_misspelt_place_has_its_line(shell: Shell, site: Path) -> None:
    fleet = (site / "fleet.yaml").read_text(encoding="utf-8")
    (site / "fleet.yaml").write_text(fleet.replace("gate", "gaet", 1), encoding="utf-8")
    (site / "scene.yaml").write_text("places: [{id: gate, position: {x_m: 0, y_m: 0}}]", encoding="utf-8")
    (site / "mission.yaml").write_text("mission: Find the cat", encoding="utf-8")
    ran = shell("plan", "site")
    line = next(number for number, text in enumerate(fleet.splitlines(), start=1) if "gate" in text)
    assert ran.code == 2
    assert f"site/fleet.yaml:{line}: " in ran.err
    assert "Did you mean 'gate'?" in ran.err


@pytest.mark.parametrize("name", ["fleet.yaml", "scene.yaml"])
def test_a_folder_with_the_name_of_a_file_is_not_passed_over(shell: Shell, tmp_path: Path, name: str) -> None:
    (tmp_path / "here" / name).mkdir(parents=True)
    (tmp_path / "here" / "mission.yaml").write_text("mission: Find the cat", encoding="utf-8")
    ran = shell("plan", "here")
    assert ran.code == 2, ran
    assert f"here/{name}: this is a folder, not a file" in ran.err


@pytest.mark.parametrize("option", ["--out", "--record"])
def test_a_file_that_cannot_be_written_is_refused_before_planning(shell: Shell, option: str) -> None:
    ran = shell("plan", "Find the cat", option, ".")
    assert (ran.code, ran.out) == (2, "")
    assert "cannot be written" in ran.err


@pytest.mark.parametrize(
    ("quality", "weights"),
    [("1.0e+300", "1"), ("1", "1e300"), ("1", "1e308,1e308,1e308")],
    ids=["fleet", "alpha", "all"],
)
def test_numbers_beyond_measure_are_bad_input(shell: Shell, site: Path, quality: str, weights: str) -> None:
    """Not an internal error: no utility could be told from another."""
    (site / "fleet.yaml").write_text(FLEET.replace("search: 1", f"search: {quality}"), encoding="utf-8")
    (site / "mission.yaml").write_text("mission: Find the cat", encoding="utf-8")
    ran = shell("plan", "site", "--weights", weights)
    assert ran.code == 2, ran
    assert "is too large" in ran.err
