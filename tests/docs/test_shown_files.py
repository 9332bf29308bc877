"""The files that how-to pages show print what the pages say."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

HOW_TO = Path(__file__).parents[2] / "docs/how-to"
RECHARGE = "let-robots-recharge.md"
FRONT = "choose-between-best-staffed-and-fastest.md"
COMBINED = "combine-rules.md"
SMALL = ("limit-a-team.md", "set-times.md", "share-a-lift.md", "send-robots-home.md", FRONT, "hand-over.md", RECHARGE)
NAMES = (*SMALL, COMBINED)
PAGES = {name: (HOW_TO / name).read_text(encoding="utf-8") for name in NAMES}
FILES = {
    name: dict(re.findall(r"<!-- example: (\w+) -->\n```yaml\n(.*?)```", page, re.DOTALL))
    for name, page in PAGES.items()
}
SHOWN = [
    (name, *shown)
    for name, page in PAGES.items()
    for shown in re.findall(r"<!-- shows(?:: ([^\n]*) => ([^\n]*))? -->\n```text\n(.*?)```", page, re.DOTALL)
]


@pytest.mark.parametrize(("page", "was", "becomes", "shown"), SHOWN, ids=[f"{one[0]}-{one[1]}" for one in SHOWN])
def test_the_page_shows_what_is_printed(page: str, was: str, becomes: str, shown: str, tmp_path: Path) -> None:
    texts = dict(FILES[page])
    if was:
        (changed,) = (name for name, text in texts.items() if was in text)
        texts[changed] = texts[changed].replace(was, becomes)
    for name, text in texts.items():
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "missiontree", "plan", "mission.yaml", *(["--front"] if page == FRONT else [])]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, encoding="utf-8", check=False)
    assert shown in done.stdout


def test_the_pages_show_something() -> None:
    assert [len(FILES[name]) for name in NAMES] == [4, 3, 4, 3, 3, 4, 4, 4]
    assert [sum(one[0] == name for one in SHOWN) for name in NAMES] == [6, 3, 2, 3, 2, 1, 2, 1]


def test_what_more_room_would_bring_is_what_the_page_says(tmp_path: Path) -> None:
    for name, text in FILES[COMBINED].items():
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    (shown,) = re.findall(r"<!-- shown why -->\n```text\n(.*?)```", PAGES[COMBINED], re.DOTALL)
    for words in (["plan", "mission.yaml", "--out", "plan.json"], ["show", "plan.json", "--why-so-long"]):
        command = [sys.executable, "-m", "missiontree", *words]
        done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, encoding="utf-8", check=False)
    assert shown in done.stdout


def test_goals_hand_over_as_the_roles_of_one_routine_do(tmp_path: Path) -> None:
    """The page's routine parted into two of one role each, and the goals that the page shows for them: the same 86 s."""
    page, texts = PAGES["hand-over.md"], dict(FILES["hand-over.md"])
    (goals,) = re.findall(r"```yaml\n(goals:.*?)```", page, re.DOTALL)
    (relay,) = yaml.safe_load(texts["routines"])["routines"]
    (branch,) = relay["branches"]
    load, meeting, goal = relay["arguments"]
    parted = []
    for name, role, place in zip(("Bring", "Fly"), branch["roles"], (meeting, goal), strict=True):
        own = {"name": branch["name"], "roles": [role]}
        purpose = f"{name} {{load}} to {{{place['name']}}}."
        parted.append({"id": name, "purpose": purpose, "arguments": [load, place], "branches": [own]})
    texts["routines"] = json.dumps({"routines": parted})
    texts["mission"] = f"mission: Bring the medicine to the island\nroutines: [routines.yaml]\n{goals}"
    for name, text in texts.items():
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "missiontree", "plan", "mission.yaml"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, encoding="utf-8", check=False)
    assert "86.0 s, optimal" in done.stdout
    assert "Take Medicine, takes over from truck-1" in done.stdout
