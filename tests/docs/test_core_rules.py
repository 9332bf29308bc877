"""The table of the second checker's rules in the reference is the table in the code."""

from __future__ import annotations

import re
from pathlib import Path

from missiontree.rechecking import CORE_RULES

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "checks.md"


def test_the_reference_lists_the_core_rules_in_the_words_of_the_code() -> None:
    rows = re.findall(r"^\| `(core_\w+)` \| (.*)\. \|$", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    assert rows == [(rule, asks[:1].upper() + asks[1:]) for rule, asks in CORE_RULES.items()]
