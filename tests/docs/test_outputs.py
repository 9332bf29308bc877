"""What the documentation shows is what the commands print."""

from __future__ import annotations

from pathlib import Path

import pytest

from missiontree import plan
from missiontree.reporting.tree.view import tree_svg
from missiontree.samples.catalogue import sample_file
from tests.docs.outputs import ROOT, pages, refreshed


@pytest.mark.parametrize("page", pages(), ids=lambda page: page.stem)
def test_the_outputs_are_real(page: Path) -> None:
    """``python -m tests.docs.outputs`` renews them."""
    text = page.read_text(encoding="utf-8")
    assert refreshed(text) == text


def test_there_are_outputs() -> None:
    assert len(pages()) >= 2


def test_the_picture_is_real() -> None:
    """``missiontree plan --sample reunite --out p.json; missiontree show p.json --tree docs/pictures/reunite.svg`` renews it."""
    tree = plan(sample_file("reunite")).tree
    assert tree is not None
    assert tree_svg(tree) == (ROOT / "docs/pictures/reunite.svg").read_text(encoding="utf-8")
