"""
Hostile names at the doors: typed on the command line, read from files, said by models in an evaluation.

What is printed a terminal shows and does not obey; what is written holds up before the parsers of :mod:`tests.reporting.strict`.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest
import yaml

from missiontree.cli.main import command_line
from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.page import page
from missiontree.evaluation.plain import plain_evaluation
from missiontree.evaluation.table_view import evaluation_view
from missiontree.formats.document import write_text
from missiontree.formats.json_text import json_text
from missiontree.formats.source import forbidden
from missiontree.reporting.text import render
from tests.evaluation.contestants import missions_in, run
from tests.reporting.hostile import MARKED, hostile_names
from tests.reporting.hostile_plans import dealt, harmless, poisoned
from tests.reporting.strict import check_png, check_terminal, parse_page, parse_svg

NAMES = hostile_names(500)


class Shell:
    """Types commands, and minds that whatever they print is only shown."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
        self._monkeypatch, self._capsys = monkeypatch, capsys

    def __call__(self, *arguments: str) -> tuple[int, str]:
        self._monkeypatch.setattr(sys, "argv", ["missiontree", *arguments])
        code = command_line()
        printed = self._capsys.readouterr()
        check_terminal(printed.out)
        check_terminal(printed.err)
        return code, printed.out


@pytest.fixture
def shell(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Shell:
    monkeypatch.chdir(tmp_path)
    return Shell(monkeypatch, capsys)


@pytest.mark.parametrize("first", range(20))
def test_what_is_typed_is_understood_declined_or_refused_and_said_back_harmlessly(shell: Shell, first: int) -> None:
    for name in NAMES[first::20]:
        assert shell("plan", name, "--explain-reading")[0] in {0, 1, 2, 5}, ascii(name)
        assert shell("show", name)[0] == 2, ascii(name)
        assert shell("plan", "Find the keys", "--fleet", f"{name}.json")[0] == 2
        assert shell("init", "x", "--sample", name)[0] == 2
    assert list(Path().iterdir()) == []  # no name became a path that was written to


HANDS = [NAMES[start : start + 50] for start in range(0, len(NAMES), 50)]


@pytest.mark.parametrize("hand", HANDS, ids=[f"{number * 50}+50" for number in range(len(HANDS))])
def test_files_with_such_names_are_planned_shown_drawn_and_learned_from(shell: Shell, hand: Sequence[str]) -> None:
    before = harmless("home")
    assert before.tree is not None
    assert before.brief.scene is not None
    rename = dealt([name for name in hand if not forbidden(name)])
    for kind, value in (("fleet", before.brief.fleet), ("scene", before.brief.scene), ("tree", before.tree)):
        Path(f"{kind}.json").write_text(write_text(poisoned(value, rename), kind), encoding="utf-8")
    files = {"fleet": "fleet.json", "scene": "scene.json", "tree": "tree.json"}
    mission = {"format": "mission/1", "mission": rename("mission", ""), **files}
    Path("mission.json").write_text(json.dumps(mission), encoding="utf-8")
    assert shell("plan", "mission.json", "--out", "plan.json")[0] == 0
    code, printed = shell("plan", "mission.json", "--json")
    assert (code, printed) == (0, Path("plan.json").read_text(encoding="utf-8"))
    for view in ("plan", "tree", "schedule", "map", "team", "order"):
        assert shell("show", "plan.json", "--view", view)[0] == 0
    assert shell("check", "plan.json")[0] == 0
    assert shell("compare", "mission.json", "--json")[0] == 0
    drawn = ("--tree", "tree.svg", "--gantt", "gantt.svg", "--map", "map.svg", "--report", "report.html")
    assert shell("show", "plan.json", *drawn)[0] == 0
    for file in ("tree.svg", "gantt.svg", "map.svg"):
        parse_svg(Path(file).read_text(encoding="utf-8")).check_values(MARKED)
    parse_page(Path("report.html").read_text(encoding="utf-8")).check_values(MARKED)
    assert shell("show", "plan.json", "--gantt", "gantt.png")[0] == 0
    check_png(Path("gantt.png").read_bytes())
    code, learned = shell("learn", "plan.json", "--quiet")
    assert code in {0, 2}
    if code == 0:
        assert set(yaml.safe_load(learned)) <= {"format", "methods"}


@pytest.mark.parametrize("first", range(10))
def test_what_models_say_in_an_evaluation_is_shown_and_no_more(tmp_path: Path, first: int) -> None:
    missions = missions_in(tmp_path)
    usual = parse_page(page(Evaluation(suite="s", missions=missions, models=("m",), asked=1, runs=(run(right=False),))))
    for name in NAMES[first::10]:
        said = replace(poisoned(run(right=False), dealt([name])), digest="x")
        named = [(setting, replace(mission, say=name, note=name)) for setting, mission in missions]
        model = said.model
        made = Evaluation(
            suite=name, missions=tuple(named), models=(model,), asked=1, runs=(said,), stopped={model: name}
        )
        parsed = parse_page(page(made))
        parsed.check_values(MARKED)
        assert parsed.styles == usual.styles
        assert parsed.scripts == parsed.data == []
        check_terminal(render(evaluation_view(made)))
        check_terminal(json_text(plain_evaluation(made)))
