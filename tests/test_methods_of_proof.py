"""The checker knows the methods that the allocators and schedulers name, and documents them."""

from __future__ import annotations

import ast
from pathlib import Path

import missiontree
from missiontree.checking.methods import BOUND_PROOFS, CHOICE_PROOFS, IMPOSSIBILITY_PROOFS, RANKING_PROOFS, SEARCHES

ROOT = Path(missiontree.__file__).parent
DOCS = Path(__file__).parents[1] / "docs/reference/checks.md"
KNOWN = RANKING_PROOFS | BOUND_PROOFS | IMPOSSIBILITY_PROOFS | SEARCHES | CHOICE_PROOFS


def named_in(stage: str) -> set[str]:
    """Texts that a stage hands to a certificate as its method: keyword arguments, and constants so called."""
    found: set[str] = set()
    for file in (ROOT / stage).glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.keyword) and node.arg == "method" and isinstance(node.value, ast.Constant):
                found.add(str(node.value.value))
            if isinstance(node, ast.Return) and isinstance(node.value, ast.Tuple) and node.value.elts:
                first = node.value.elts[0]
                if isinstance(first, ast.Constant) and isinstance(first.value, str) and stage == "scheduling":
                    found.add(first.value)
    return found


def test_no_stage_names_a_method_that_the_checker_does_not_know() -> None:
    assert "serial_generation" in named_in("scheduling")
    assert "holding" in named_in("scheduling")
    assert named_in("scheduling") | named_in("allocation") <= KNOWN


def test_every_known_method_is_documented() -> None:
    page = DOCS.read_text(encoding="utf-8")
    assert [method for method in sorted(KNOWN) if f"`{method}`" not in page] == []
