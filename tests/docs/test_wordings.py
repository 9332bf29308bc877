"""Every wording that ``word-a-mission.md`` shows is read as the page says."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from missiontree.briefing import request_from
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.verdict import judge
from missiontree.formats.document import read_text
from missiontree.mission.scene import Scene
from missiontree.planner import author

PAGE = (Path(__file__).parents[2] / "docs/how-to/word-a-mission.md").read_text(encoding="utf-8")
TABLE = re.compile(r"<!-- (wordings|declined)( in the scene)? -->\n\|[^\n]*\n\|[-|]*\n((?:\|[^\n]*\n)+)")
ROWS = [
    (kind, bool(scene), *(cell.strip().strip("`") for cell in row.strip("|").split("|")))
    for kind, scene, rows in TABLE.findall(PAGE)
    for row in rows.splitlines()
]
READ = [pytest.param(*row[1:], id=row[2]) for row in ROWS if row[0] == "wordings"]
DECLINED = [pytest.param(*row[1:], id=row[2]) for row in ROWS if row[0] == "declined"]


def scene() -> Scene:
    """The scene of the page."""
    (text,) = re.findall(r"<!-- example: scene -->\n```yaml\n(.*?)\n```", PAGE, re.DOTALL)
    value = read_text(text, "scene")
    assert isinstance(value, Scene)
    return value


def expected(words: str, tree: str) -> SuiteMission:
    """A row as a mission of a suite: calls and relations are separated by semicolons, options by *xor*."""
    parts = [part.strip() for part in tree.split(";")]
    order = tuple(part for part in parts if part[0].isdigit())
    calls = [part.split(" xor ") for part in parts if not part[0].isdigit()]
    plan = tuple(options[0] if len(options) == 1 else {"xor": options} for options in calls)
    return SuiteMission(id="row", say=words, plan=plan, order=order)


@pytest.mark.parametrize(("in_scene", "words", "tree"), READ)
def test_a_wording_gives_the_tree(in_scene: bool, words: str, tree: str) -> None:
    request = request_from(words, scene=scene() if in_scene else None)
    assert judge(expected(words, tree), author(request), request.brief).differences == ()


@pytest.mark.parametrize(("in_scene", "words", "outcome", "said"), DECLINED)
def test_a_wording_is_declined(in_scene: bool, words: str, outcome: str, said: str) -> None:
    authored = author(request_from(words, scene=scene() if in_scene else None))
    assert authored.status == outcome
    assert any(said in f"{reason.message} {reason.hint}" for reason in authored.reasons)


def test_there_are_wordings() -> None:
    assert len(READ) > 50
    assert len(DECLINED) > 15
