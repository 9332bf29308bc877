"""The files that ``limit-a-team.md`` shows print what it says."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

PAGE = (Path(__file__).parents[2] / "docs/how-to/limit-a-team.md").read_text(encoding="utf-8")
FILES = re.findall(r"<!-- example: (\w+) -->\n```yaml\n(.*?)```", PAGE, re.DOTALL)
SHOWN = re.findall(r"<!-- shows(?:: ([^\n]*) => ([^\n]*))? -->\n```text\n(.*?)```", PAGE, re.DOTALL)


@pytest.mark.parametrize(("was", "becomes", "shown"), SHOWN, ids=range(len(SHOWN)))
def test_the_page_shows_what_is_printed(was: str, becomes: str, shown: str, tmp_path: Path) -> None:
    texts = dict(FILES)
    if was:
        (changed,) = (name for name, text in texts.items() if was in text)
        texts[changed] = texts[changed].replace(was, becomes)
    for name, text in texts.items():
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "missiontree", "plan", "mission.yaml"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, encoding="utf-8", check=False)
    assert shown in done.stdout


def test_the_page_shows_something() -> None:
    assert (len(FILES), len(SHOWN)) == (4, 3)
