"""The routines that the documentation writes in Python load, and plan as it says."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from missiontree import plan
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.position import Position
from missiontree.mission.routine import Routine
from missiontree.mission.scene import Scene
from missiontree.routines.python import collect

PAGE = (Path(__file__).parents[2] / "docs/how-to/write-a-routine.md").read_text(encoding="utf-8")
FILES = dict(re.findall(r"<!-- example: (\w+\.py) -->\n```python\n(.*?)```", PAGE, re.DOTALL))
OTHERS = [text for text in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL) if text not in FILES.values()]


@pytest.fixture
def lifting(tmp_path: Path) -> Path:
    path = tmp_path / "lifting.py"
    path.write_text(FILES["lifting.py"], encoding="utf-8")
    return path


def test_the_function_is_the_routine_that_the_page_speaks_of(lifting: Path) -> None:
    (made,) = collect(lifting)
    assert isinstance(made, Routine)
    assert made.id == "LiftTogether"
    assert made.purpose == "Bring {load} to {location} with two, three or four robots."
    assert [(argument.name, argument.kinds) for argument in made.arguments] == [
        ("load", ("object",)),
        ("location", ("place", "person")),
    ]
    assert made.branches[0].roles[0].actions[2].brings == ("load",)


def test_three_robots_lift_what_two_cannot(lifting: Path) -> None:
    """A piano of 240 kg: 120 kg for each of two, 80 kg for each of three, 60 kg for each of four; a porter carries 90 kg."""
    fleet = Fleet((RobotType(id="porter", count=3, capabilities={"carry": 1.0}, limits={"payload_kg": 90}),))
    hall = Entity(id="hall", kind="place", position=Position(0, 0))
    piano = Entity(id="piano", kind="object", mass_kg=240, position=Position(5, 0))
    scene = Scene(places=(hall,), entities=(piano,))
    made = plan("Haul the piano to the hall", fleet=fleet, scene=scene, routines=[lifting])
    assert made.outcome == "delivered"
    # Four robots are not there, two are too weak: three porters, alike, are the only way.
    assert len({assignment.robot for assignment in made.schedules[0].assignments}) == 3
    assert made.ranking is not None
    assert len(made.ranking.alternatives) == 1


def test_the_other_snippets_run(lifting: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert OTHERS
    monkeypatch.chdir(lifting.parent)
    for text in OTHERS:
        exec(compile(text, "write-a-routine.md", "exec"), {})  # noqa: S102 - it is our own page
