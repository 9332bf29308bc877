"""``--estimator``, and ``estimator`` in a mission file."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.mission.estimate import Estimate
from missiontree.mission.estimator_source import EstimatorSource
from missiontree.routines.ground import ground
from tests.builders import brief_of, reunite_tree
from tests.cli.running import Shell


def estimator(folder: Path, name: str, quality: str) -> None:
    text = f"from missiontree.mission.estimate import Estimate\n\n\ndef estimate(*question, **about):\n    return Estimate({quality})\n"
    (folder / name).write_text(text, encoding="utf-8")


def utilities(shell: Shell, *arguments: str) -> list[float]:
    ran = shell("plan", *arguments, "--json")
    assert ran.code == 0, ran
    return [one["utility"] for one in json.loads(ran.out)["ranking"]["alternatives"]]


@pytest.fixture
def mission(tmp_path: Path) -> Path:
    """In a folder of its own, so that a path relative to the file differs from one relative to where one stands."""
    (tmp_path / "site").mkdir()
    path = tmp_path / "site/mission.yaml"
    path.write_text("mission: Find the cat\nestimator: mine.py\n", encoding="utf-8")
    estimator(tmp_path / "site", "mine.py", "0.5")
    return path


def test_the_mission_file_names_one_beside_it_and_the_command_line_goes_before_it(
    shell: Shell, mission: Path, tmp_path: Path
) -> None:
    """Two types search, in three actions each."""
    assert utilities(shell, str(mission)) == [1.5, 1.5]
    estimator(tmp_path, "other.py", "0.25")
    assert utilities(shell, str(mission), "--estimator", "other.py") == [0.75, 0.75]
    assert f"using estimator {mission.with_name('mine.py')}" in " ".join(shell("plan", str(mission)).err.split("\n"))


def test_comparing_ranks_by_it(shell: Shell, mission: Path) -> None:
    ran = shell("compare", str(mission), "--json")
    assert {tuple(run["utilities"]) for run in json.loads(ran.out)} == {(1.5, 1.5)}


def test_a_plan_by_it_is_checked_without_it_and_says_whose_word_that_is(shell: Shell, mission: Path) -> None:
    shell("plan", str(mission), "--out", "plan.json")
    mission.with_name("mine.py").unlink()
    ran = shell("check", "plan.json", "--json")
    assert ran.code == 0, ran
    assert [claim["rule"] for claim in json.loads(ran.out)["taken_on_trust"]] == ["estimates_on_trust"]


def test_a_plan_that_hides_its_estimator_is_refused(shell: Shell, mission: Path) -> None:
    shell("plan", str(mission), "--out", "plan.json")
    made = json.loads(Path("plan.json").read_text(encoding="utf-8"))
    del made["brief"]["estimator"], made["digests"]["estimator"]
    Path("plan.json").write_text(json.dumps(made), encoding="utf-8")
    ran = shell("check", "plan.json", "--json")
    assert ran.code == 6
    assert {"quality_differs", "estimates_differ"} <= {finding["rule"] for finding in json.loads(ran.out)["findings"]}


@pytest.mark.parametrize("quality", ["-1", "1 / 0", "float('nan')", "undefined"])
def test_an_estimator_that_fails_is_bad_input_without_a_traceback(shell: Shell, mission: Path, quality: str) -> None:
    estimator(mission.parent, "bad.py", quality)
    ran = shell("plan", str(mission), "--estimator", "site/bad.py")
    assert ran.code == 2
    assert "site/bad.py:5" in ran.err
    assert "action 'get_search_path' by robot type 'tele_robot'" in " ".join(ran.err.split())
    assert "Traceback" not in ran.err


def test_an_estimator_that_is_not_there_is_named(shell: Shell, mission: Path) -> None:
    mission.with_name("mine.py").unlink()
    ran = shell("plan", str(mission))
    assert ran.code == 2
    assert str(mission.with_name("mine.py")) in ran.err.replace("\n", "")


def test_a_brief_that_names_an_estimator_is_not_grounded_without_it() -> None:
    brief = brief_of(reunite_tree(), estimator=EstimatorSource(name="mine.py", digest="ab"))
    with pytest.raises(InputError, match=r"those of mine\.py .* and it is not there"):
        ground(reunite_tree(), brief)


def test_the_number_that_a_role_needs_stays_with_the_fleet(shell: Shell, tmp_path: Path) -> None:
    """An estimator cannot make a robot able: nobody but those two searches."""
    estimator(tmp_path, "mine.py", "1000")
    made = json.loads(shell("plan", "Find the cat", "--estimator", "mine.py", "--json").out)
    answers = made["grounding"]["estimates"]
    assert {said["robot_type"] for said in answers} == {"tele_robot", "transportation_robot"}
    assert {Estimate(**said["estimate"]) for said in answers} == {Estimate(1000)}
