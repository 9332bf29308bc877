"""The documentation speaks of things that exist: its examples load, its links lead somewhere."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from missiontree.formats.document import read_text
from missiontree.formats.routine_file import RoutineFile
from missiontree.mission.routine import RoutineLibrary
from missiontree.routines.library import built_in

ROOT = Path(__file__).parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
EXAMPLE = re.compile(r"<!-- example: (\w+) -->\n```yaml\n(.*?)\n```", re.DOTALL)
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
EXAMPLES = [
    pytest.param(kind, text, id=f"{page.relative_to(ROOT)}-{number}")
    for page in PAGES
    for number, (kind, text) in enumerate(EXAMPLE.findall(page.read_text(encoding="utf-8")))
]


@pytest.mark.parametrize(("kind", "text"), EXAMPLES)
def test_every_example_loads(kind: str, text: str) -> None:
    value = read_text(text, kind)
    if isinstance(value, RoutineFile):
        RoutineLibrary(routines=(*built_in().routines, *value.routines))


def test_there_are_examples() -> None:
    assert len(EXAMPLES) >= 3


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_link_leads_somewhere(page: Path) -> None:
    for target in LINK.findall(page.read_text(encoding="utf-8")):
        if "://" not in target:
            assert (page.parent / target).exists(), f"{page.name} links to {target}"
