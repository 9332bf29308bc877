"""What the page says of bare trees is what comes out, and so is what the package's docstring says."""

from __future__ import annotations

import doctest
import re
from pathlib import Path

import pytest

from missiontree.allocation import arrays

PAGE = Path(__file__).parents[2] / "docs/how-to/rank-a-bare-tree.md"


def test_the_example_prints_what_the_page_shows(capsys: pytest.CaptureFixture[str]) -> None:
    page = PAGE.read_text(encoding="utf-8")
    program, shown = re.findall(r"```(?:python|text)\n(.*?)```", page, re.DOTALL)
    exec(compile(program, str(PAGE), "exec"), {})  # noqa: S102 - the page is our own
    assert capsys.readouterr().out == shown


def test_the_example_of_the_package_is_right() -> None:
    assert doctest.testmod(arrays) == (0, 3)
