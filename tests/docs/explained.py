"""
Keep the explanations in the documentation real.

usage: python -m tests.docs.explained

A block that follows ``<!-- explained: NAME -->`` holds what ``missiontree explain examples/failures/NAME/mission.yaml`` prints.
"""

from __future__ import annotations

import re
from pathlib import Path

from missiontree.explaining.explain import explain
from missiontree.reporting.explanation_view import explanation_text

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "how-to" / "explain-a-failure.md"
FAILURES = ROOT / "examples" / "failures"
BLOCK = re.compile(r"(<!-- explained: (?P<name>\w+) -->\n```text\n)(?P<text>.*?)(```)", re.DOTALL)


def explained(name: str) -> str:
    """The explanation of one of the missions that cannot be done."""
    return explanation_text(explain(FAILURES / name / "mission.yaml"))


def refreshed(page: str) -> str:
    """The page with every explanation as it is now."""
    return BLOCK.sub(lambda match: f"{match[1]}{explained(match['name'])}{match[4]}", page)


if __name__ == "__main__":
    PAGE.write_text(refreshed(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
