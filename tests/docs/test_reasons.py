"""Every rule that a reason may carry is explained in the reference."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import missiontree

SOURCE = Path(missiontree.__file__).parent
REFERENCE = Path(__file__).parents[2] / "docs/reference"
TREES = [ast.parse(file.read_text(encoding="utf-8")) for file in sorted(SOURCE.rglob("*.py"))]


def functions_of_rules() -> dict[str, int]:
    """Functions that take a rule, with its place among the arguments that are given."""
    found: dict[str, int] = {}
    for node in (node for tree in TREES for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)):
        names = [argument.arg for argument in node.args.args if argument.arg != "self"]
        if "rule" in names:
            found[node.name] = names.index("rule")
    return found


def named_by(call: ast.Call, functions: dict[str, int]) -> Iterator[ast.expr]:
    yield from (keyword.value for keyword in call.keywords if keyword.arg == "rule")
    name = call.func.id if isinstance(call.func, ast.Name) else getattr(call.func, "attr", "")
    place = functions.get(name, -1)
    if 0 <= place < len(call.args):
        yield call.args[place]


def rules() -> set[str]:
    """Texts given as ``rule=`` anywhere, or to a function that takes a rule; of a choice, every text."""
    functions = functions_of_rules()
    calls = (node for tree in TREES for node in ast.walk(tree) if isinstance(node, ast.Call))
    given = (value for call in calls for value in named_by(call, functions))
    return {text for value in given for text in texts_of(value)}


def texts_of(value: ast.expr) -> Iterator[str]:
    if isinstance(value, ast.IfExp):
        yield from (*texts_of(value.body), *texts_of(value.orelse))
    elif isinstance(value, ast.Constant) and isinstance(value.value, str):
        yield value.value


def test_functions_that_take_a_rule_are_found() -> None:
    assert {"refuse", "trouble"} <= functions_of_rules().keys()
    assert {"unclear", "verb_unknown", "words_left_over", "order_unclear", "exception_unused"} <= rules()


def test_every_rule_is_explained() -> None:
    pages = "".join(page.read_text(encoding="utf-8") for page in REFERENCE.glob("*.md"))
    assert len(rules()) > 80
    assert [rule for rule in sorted(rules()) if f"`{rule}`" not in pages] == []
