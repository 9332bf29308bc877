"""The files that ``bring-an-estimator.md`` shows print what it says."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from missiontree import plan
from tests.cli.running import Shell

PAGE = (Path(__file__).parents[2] / "docs/how-to/bring-an-estimator.md").read_text(encoding="utf-8")
FILES = {
    f"{name}.yaml": text for name, text in re.findall(r"<!-- example: (\w+) -->\n```yaml\n(.*?)```", PAGE, re.DOTALL)
}
FILES |= dict(re.findall(r"<!-- file: ([\w.]+) -->\n```\w+\n(.*?)```", PAGE, re.DOTALL))
SHOWN = re.findall(r"<!-- shows(?:: ([^\n]*) => ([^\n]*))? -->\n```text\n(.*?)```", PAGE, re.DOTALL)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name, text in FILES.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(("was", "becomes", "shown"), SHOWN, ids=range(len(SHOWN)))
def test_the_page_shows_what_is_printed(
    was: str,
    becomes: str,
    shown: str,
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    mission = folder / "mission.yaml"
    assert was in FILES["mission.yaml"]
    mission.write_text(FILES["mission.yaml"].replace(was, becomes) if was else FILES["mission.yaml"], encoding="utf-8")
    assert shown in Shell(monkeypatch, capsys)("plan", "mission.yaml").out


def test_the_plan_is_sound_where_the_estimator_is_not(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shell = Shell(monkeypatch, capsys)
    assert shell("plan", "mission.yaml", "--out", "plan.json").code == 0
    for name in FILES:
        (folder / name).unlink()
    ran = shell("check", "plan.json")
    assert ran.code == 0, ran
    (line,) = [line for line in " ".join(ran.out.split()).split("not confirmed: ")[1:] if "learned.py" in line]
    shown = re.search(r"not confirmed: (.*) \(SHA-256 …\)\.", PAGE)
    assert shown is not None
    assert line.startswith(shown[1])
    assert len(json.loads((folder / "plan.json").read_text(encoding="utf-8"))["grounding"]["estimates"]) == 6


def test_the_object_does_what_its_file_does(folder: Path) -> None:
    space: dict[str, object] = {"__file__": str(folder / "learned.py")}
    exec(compile(FILES["learned.py"], "learned.py", "exec"), space)  # noqa: S102 - it is our own page
    by_object = plan("Find the dog", fleet="fleet.yaml", estimator=space["estimator"])  # type: ignore[arg-type]  # the page has no types
    by_file = plan("Find the dog", fleet="fleet.yaml", estimator="learned.py")
    assert by_object.ranking == by_file.ranking
    assert by_object.brief.estimator is not None
    assert (by_object.brief.estimator.name, by_object.brief.estimator.digest) == ("Learned", "")


def test_the_page_shows_something() -> None:
    assert (sorted(FILES), len(SHOWN)) == (["fleet.yaml", "learned.py", "mission.yaml", "runs.csv"], 2)
