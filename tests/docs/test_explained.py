"""The page on failures shows what is printed, for every mission in the folder of failures."""

from __future__ import annotations

import pytest

from missiontree.mission.costs import DEFAULTS
from tests.docs.explained import BLOCK, FAILURES, PAGE, explained

SHOWN = {match["name"]: match["text"] for match in BLOCK.finditer(PAGE.read_text(encoding="utf-8"))}


@pytest.mark.parametrize("name", sorted(folder.name for folder in FAILURES.iterdir() if folder.is_dir()))
def test_every_failure_is_shown_as_it_is_explained(name: str) -> None:
    """If this fails: python -m tests.docs.explained."""
    assert SHOWN[name] == explained(name)


def test_the_table_of_costs_is_that_of_the_code() -> None:
    page = PAGE.read_text(encoding="utf-8")
    for kind, (fixed, per_share) in DEFAULTS.items():
        more = f" + {per_share:g} per share" if per_share else ""
        assert f"| `{kind}` | {fixed:g}{more} |" in page
