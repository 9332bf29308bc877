"""The how-to about instances shows what is really printed, but for the seconds it took."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).parents[2] / "docs" / "how-to" / "schedule-an-instance.md"
TOOK = re.compile(r": \d+\.\d\d s$", re.MULTILINE)


def test_the_files_of_the_page_give_the_outputs_of_the_page(tmp_path: Path) -> None:
    page = PAGE.read_text(encoding="utf-8")
    blocks = re.findall(r"```(\w+)\n(.*?)```", page, re.DOTALL)
    (tmp_path / "shop.txt").write_text(blocks[0][1], encoding="utf-8")
    (tmp_path / "mission.json").write_text(next(text for kind, text in blocks if kind == "json"), encoding="utf-8")
    shown = re.findall(r"<!-- shown: ([^\n]*) -->\n```text\n(.*?)```", page, re.DOTALL)
    assert len(shown) == 4
    (tmp_path / "schedule.json").write_text(printed("schedule shop.txt --json", tmp_path), encoding="utf-8")
    for arguments, text in shown:
        assert TOOK.sub("", text) in TOOK.sub("", printed(arguments, tmp_path))


def printed(arguments: str, folder: Path) -> str:
    command = [sys.executable, "-m", "missiontree", *arguments.split()]
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True, encoding="utf-8", check=False)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout
