"""``missiontree show``: pictures, reports and views of a plan, and what cannot be shown."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.cli.running import Shell

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture
def site(shell: Shell) -> Shell:
    """A shell in a folder with the plan of the building site."""
    shell("plan", "--sample", "site", "--out", "plan.json", "--quiet")
    return shell


def title(svg: Path) -> str:
    """The title of a picture, which must be well formed."""
    return ElementTree.fromstring(svg.read_text(encoding="utf-8")).findtext(f"{SVG}title") or ""  # noqa: S314 - our own


def test_a_plan_that_points_nowhere_is_bad_input_and_can_still_be_checked(shell: Shell, tmp_path: Path) -> None:
    shell("plan", "--sample", "reunite", "--out", "plan.json", "--quiet")
    plan = json.loads((tmp_path / "plan.json").read_text(encoding="utf-8"))
    plan["schedules"][0]["actions"][0]["leaf"] = 9999
    (tmp_path / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    shown = shell("show", "plan.json")
    assert shown.code == 2, shown
    assert "plan.json: schedules[0].actions[0].leaf: node 9999" in shown.err
    assert shell("check", "plan.json").code == 6
    drawn = shell("show", "plan.json", "--report", "report.html")
    assert drawn.code == 2, drawn
    assert "node 9999" in drawn.err
    assert not (tmp_path / "report.html").exists()


def test_pictures_and_report_are_written_beside_the_answer(site: Shell, tmp_path: Path) -> None:
    files = ("tree.svg", "gantt.svg", "map.svg", "report.html")
    options = [part for file in files for part in (f"--{file.partition('.')[0]}", file)]
    shown = site("show", "plan.json", *options)
    assert shown.code == 0, shown
    assert shown.out == site("show", "plan.json").out
    assert [line for line in shown.err.splitlines() if line.startswith("written")] == [
        f"written to {file}" for file in files
    ]
    assert "Find the visitor" in title(tmp_path / "tree.svg")
    assert "alternative 1" in title(tmp_path / "gantt.svg")
    assert "alternative 1" in title(tmp_path / "map.svg")
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert report.startswith("<!doctype html>")
    assert "finds that the plan keeps every rule" in report  # the report is of a plan that was checked


def test_a_name_that_ends_in_png_is_a_png_file(site: Shell, tmp_path: Path) -> None:
    assert site("show", "plan.json", "--gantt", "gantt.PNG", "--tree", "tree.png").code == 0
    for file in ("gantt.PNG", "tree.png"):
        assert (tmp_path / file).read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"


def test_another_alternative_is_drawn_when_it_is_asked_for(site: Shell, tmp_path: Path) -> None:
    assert site("show", "plan.json", "--rank", "3", "--gantt", "gantt.svg", "--report", "report.html").code == 0
    assert "alternative 3" in title(tmp_path / "gantt.svg")
    assert 'id="way-3" value="3" checked' in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_the_unfolded_tree_goes_down_to_the_actions(site: Shell, tmp_path: Path) -> None:
    site("show", "plan.json", "--tree", "folded.svg")
    site("show", "plan.json", "--tree", "unfolded.svg", "--unfolded")
    assert "message_display" not in (tmp_path / "folded.svg").read_text(encoding="utf-8")
    assert "message_display" in (tmp_path / "unfolded.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--gantt", "gantt.pdf"], "gantt.pdf: --gantt: it ends in .pdf"),
        (["--tree", "tree"], "its name has no ending"),
        (["--report", "report.svg"], "a name that ends in .html or .htm"),
        (["--map", "no/map.svg"], "There is no folder no."),
        (["--tree", "a.svg", "--gantt", "a.svg"], "--tree and --gantt name the same file"),
        (["--view", "picture"], "accepted: plan, tree, schedule, map, team, order"),
    ],
)
def test_what_cannot_be_written_is_refused_before_the_plan_is_read(
    shell: Shell, tmp_path: Path, options: list[str], told: str
) -> None:
    """There is no plan file here, and nobody has looked for it."""
    refused = shell("show", "missing.json", *options)
    assert refused.code == 2
    assert told in refused.err
    assert "missing.json" not in refused.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("sample", "options", "told"),
    [
        ("restaurants", ["--gantt", "gantt.svg"], "--gantt: this plan has no schedule, so there is nothing to show"),
        ("restaurants", ["--rank", "1", "--tree", "t.svg"], "--rank 1\n  accepted: the plan has no alternatives"),
        ("restaurants", ["--unfolded", "--tree", "t.svg"], "--tree: this plan has no tree over the fleet"),
        ("restaurants", ["--view", "team"], "--view team: this plan has no alternatives"),
        ("restaurants", ["--view", "schedule"], "--view schedule: this plan has no schedule"),
        ("reunite", ["--map", "map.svg", "--tree", "t.svg"], "--map: this plan has nothing with a position"),
        ("reunite", ["--view", "map"], "--view map: this plan has nothing with a position"),
        ("reunite", ["--rank", "9"], "--rank 9\n  accepted: 1 to 4"),
        ("reunite", ["--rank", "0", "--report", "r.html"], "--rank 0\n  accepted: 1 to 4"),
    ],
)
def test_what_a_plan_does_not_have_is_said_and_nothing_is_written(
    shell: Shell, tmp_path: Path, sample: str, options: list[str], told: str
) -> None:
    shell("plan", "--sample", sample, "--out", "plan.json", "--quiet")
    refused = shell("show", "plan.json", *options)
    assert refused.code == 2, refused
    assert f"plan.json: {told}" in refused.err
    assert [file.name for file in tmp_path.iterdir()] == ["plan.json"]


def test_a_plan_that_was_declined_has_a_report_too(shell: Shell, tmp_path: Path) -> None:
    shell("plan", "--sample", "restaurants", "--out", "plan.json", "--quiet")
    assert shell("show", "plan.json", "--report", "report.htm").code == 1
    assert "Do this first" in (tmp_path / "report.htm").read_text(encoding="utf-8")


def test_the_parts_of_a_plan_have_forms_for_the_terminal(site: Shell) -> None:
    tree = site("show", "plan.json", "--view", "tree", "--rank", "2").out
    assert "Transport(visitor, gate)" in tree
    assert "Hauler" in tree
    assert "carry by Courier" in site("show", "plan.json", "--unfolded").out
    schedule = site("show", "plan.json", "--rank", "2").out
    assert schedule.startswith("Alternative 2: utility 10.2227, 347.5 s\n")
    assert site("show", "plan.json", "--rank", "2", "--view", "schedule").out == schedule
    assert "tower crane" in site("show", "plan.json", "--view", "map").out
    assert "alternative 3" in site("show", "plan.json", "--view", "team").out
    assert site("show", "plan.json", "--view", "order").out == site("show", "plan.json", "--order", "1").out
    assert site("show", "plan.json", "--view", "plan").out == site("show", "plan.json").out


def test_planning_writes_the_same_report_as_showing_the_plan(shell: Shell, tmp_path: Path) -> None:
    planned = shell("plan", "--sample", "clinic", "--out", "plan.json", "--report", "one.html")
    assert (planned.code, planned.err.splitlines()[-1]) == (0, "written to one.html")
    assert shell("show", "plan.json", "--report", "two.html").code == 0
    assert (tmp_path / "one.html").read_bytes() == (tmp_path / "two.html").read_bytes()


def test_a_declined_mission_has_a_report_too(shell: Shell, tmp_path: Path) -> None:
    assert shell("plan", "--sample", "restaurants", "--quiet", "--report", "no.html").code == 1
    assert "recommend" in (tmp_path / "no.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--report", "report.txt"], "report.txt: --report: it ends in .txt"),
        (["--report", "no/report.html"], "There is no folder no."),
        (["--report", "a.html", "--out", "a.html"], "--out and --report name the same file"),
    ],
)
def test_reports_that_cannot_be_written_are_refused_before_planning(
    shell: Shell, tmp_path: Path, options: list[str], told: str
) -> None:
    refused = shell("plan", "--sample", "reunite", *options)
    assert (refused.code, refused.out) == (2, "")
    assert told in refused.err
    assert list(tmp_path.iterdir()) == []
