"""``--front``, ``--front-plot``, ``--objective`` and ``--option`` at the command line."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from missiontree.formats.document import write_text
from tests.checking.plans import supplies
from tests.cli.running import Shell


@pytest.fixture
def clinic(tmp_path: Path) -> Path:
    """A folder with the supplies for a clinic: the mule does it well, the runner fast."""
    _, fleet, scene = supplies()
    (tmp_path / "fleet.json").write_text(write_text(fleet, "fleet"), encoding="utf-8")
    (tmp_path / "scene.json").write_text(write_text(scene, "scene"), encoding="utf-8")
    goals = "".join(f"  - {{do: 'ReachAndTransport({what}, clinic)'}}\n" for what in ("medicine", "blankets"))
    mission = f"mission: Supply the clinic\nfleet: fleet.json\nscene: scene.json\nk: 1\ngoals:\n{goals}"
    (tmp_path / "mission.yaml").write_text(mission, encoding="utf-8")
    return tmp_path


def test_the_front_is_printed_kept_drawn_and_checked(shell: Shell, clinic: Path) -> None:
    ran = shell("plan", "--front-plot", "front.svg", "--out", "plan.json", "--objective", "makespan")
    assert ran.code == 0
    assert "From the best staffed to the fastest: 3 plans, proven to be all" in ran.out
    assert "written to front.svg" in ran.err
    plan = json.loads((clinic / "plan.json").read_text(encoding="utf-8"))
    assert [one["alternative"]["utility"] for one in plan["front"]["options"]] == [8, 7.2, 6.4]
    assert plan["chosen"]["worth"] == plan["front"]["options"][-1]["schedule"]["makespan_s"]
    assert len(plan["ranking"]["alternatives"]) == 1
    assert shell("check", "plan.json").code == 0
    assert (clinic / "front.svg").read_text(encoding="utf-8").startswith("<svg")


def test_an_option_is_shown_as_if_it_were_the_alternative(shell: Shell, clinic: Path) -> None:
    shell("plan", "--front", "--objective", "makespan", "--out", "plan.json", "--quiet")
    assert "Schedule of alternative 1: 145.0 s" in shell("show", "plan.json", "--option", "2").out
    assert "Schedule of alternative 1: 132.6 s" in shell("show", "plan.json", "--option", "chosen").out
    assert shell("show", "plan.json", "--option", "3", "--gantt", "three.svg").code == 0
    assert "Option · utility 6.4" in (clinic / "three.svg").read_text(encoding="utf-8")
    again = shell("show", "plan.json", "--front-plot", "again.svg")
    assert (again.code, (clinic / "again.svg").exists()) == (0, True)


def test_an_option_that_there_is_not_is_refused_with_those_there_are(shell: Shell, clinic: Path) -> None:
    shell("plan", "--front", "--out", "plan.json", "--quiet")
    ran = shell("show", "plan.json", "--option", "4")
    assert ran.code == 2
    assert "1, 2, 3" in ran.err
    shell("plan", "--out", "bare.json", "--quiet")
    assert "neither a front nor a choice" in shell("show", "bare.json", "--option", "1").err
    assert "this plan has no front" in shell("show", "bare.json", "--front-plot", "f.svg").err


def test_another_objective_is_refused_with_those_there_are(shell: Shell, clinic: Path) -> None:
    ran = shell("plan", "--objective", "fastest")
    assert ran.code == 2
    assert "utility, makespan, utility-makespan, weighted-team, weighted-sum" in ran.err


def test_a_weighted_objective_without_a_weight_of_time_says_what_to_do(shell: Shell, clinic: Path) -> None:
    ran = shell("plan", "--objective", "weighted-team")
    assert ran.code == 2
    assert "the weight of a second (beta) is 0" in " ".join(ran.err.split())
    assert shell("plan", "--objective", "weighted-team", "--weights", "1,0.01").code == 0


def test_a_mission_file_names_its_objective_and_the_command_line_goes_before_it(shell: Shell, clinic: Path) -> None:
    file = clinic / "mission.yaml"
    file.write_text(file.read_text(encoding="utf-8") + "objective: makespan\n", encoding="utf-8")
    assert "Chosen by least makespan" in shell("plan").out
    assert "Chosen by" not in shell("plan", "--objective", "utility").out


def test_where_nothing_can_be_done_there_is_no_front_and_no_picture(shell: Shell, tmp_path: Path) -> None:
    ran = shell("plan", "--sample", "restaurants", "--front-plot", "front.svg")
    assert ran.code == 1
    assert not (tmp_path / "front.svg").exists()
    assert "no front to be drawn" in ran.err


def test_time_that_is_up_at_once_leaves_what_was_found(shell: Shell, clinic: Path) -> None:
    """However little is found: a plan that was delivered says what it knows, and passes the checker."""
    ran = shell("plan", "--front", "--objective", "makespan", "--time-limit", "0", "--out", "plan.json")
    plan = json.loads((clinic / "plan.json").read_text(encoding="utf-8"))
    assert ran.code == (0 if plan["outcome"] == "delivered" else 3)
    assert shell("check", "plan.json").code == 0
