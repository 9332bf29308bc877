"""The list of rules, and the page that explains them."""

from __future__ import annotations

import re
from pathlib import Path

from missiontree.checking import RULES

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "checks.md"


def test_the_page_lists_every_rule_with_its_meaning() -> None:
    """Code and meaning of each rule, in a row of a table."""
    rows = dict(re.findall(r"^\| `(\w+)` \| (.*?) \| .+ \|$", PAGE.read_text(encoding="utf-8"), re.MULTILINE))
    assert rows == {rule.__name__: (rule.__doc__ or "").strip() for rule in RULES}


def test_no_rule_has_two_meanings() -> None:
    codes = [rule.__name__ for rule in RULES]
    assert len(codes) == len(set(codes))
