"""Every rule that a reason may carry is explained in the reference."""

from __future__ import annotations

import ast
from pathlib import Path

import missiontree

SOURCE = Path(missiontree.__file__).parent
REFERENCE = Path(__file__).parents[2] / "docs/reference"


def rules() -> set[str]:
    """Texts given as ``rule=`` anywhere, and first arguments of ``refuse``."""
    found: set[str] = set()
    for file in SOURCE.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call):
                continue
            named = [keyword.value for keyword in node.keywords if keyword.arg == "rule"]
            if isinstance(node.func, ast.Name) and node.func.id == "refuse":
                named += node.args[:1]
            found |= {str(value.value) for value in named if isinstance(value, ast.Constant)}
    return found


def test_every_rule_is_explained() -> None:
    pages = "".join(page.read_text(encoding="utf-8") for page in REFERENCE.glob("*.md"))
    assert len(rules()) > 60
    assert [rule for rule in sorted(rules()) if f"`{rule}`" not in pages] == []
