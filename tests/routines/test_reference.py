"""The reference lists every rule that grounding speaks of, and no other."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_every_rule_of_grounding_is_in_the_reference() -> None:
    page = (ROOT / "docs" / "reference" / "grounding.md").read_text(encoding="utf-8")
    rows = [line.split("|")[1] for line in page.splitlines() if line.startswith("| `")]
    listed = {rule for row in rows for rule in re.findall(r"`(\w+)`", row)}
    sources = [path.read_text(encoding="utf-8") for path in (ROOT / "src" / "missiontree" / "routines").glob("*.py")]
    said = {
        rule
        for source in sources
        for row in re.findall(r"rule=(.*),$", source, re.MULTILINE)
        for rule in re.findall(r'"(\w+)"', row)
    }
    assert said | {"unreachable"} == listed  # unreachable is the travel model's own
