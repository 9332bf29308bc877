import json
from pathlib import Path
from typing import Any

import pytest

from missiontree.authoring.tools import TOOLS, ToolBox, tools_table

SUBTASK = {"parentString": "Find", "isPrimitive": False, "taskName": "Look", "LogicalConstraint": "AND"}


def test_the_papers_six_functions_have_the_papers_arguments() -> None:
    by_name = {tool.name: [parameter.name for parameter in tool.parameters] for tool in TOOLS}
    assert by_name["HierarchicalTree_init"] == ["objective"]
    assert by_name["CreateAndAddSubtask"] == ["parentString", "isPrimitive", "taskName", "LogicalConstraint"]
    multi = ["parentString", "isPrimitiveList", "taskNameList", "LogicalConstraint", "constraintPairs"]
    assert by_name["addMultiSubtasks"] == multi
    trees = ["parentString", "treeNames", "treeArguments", "LogicalConstraint", "constraintPairs"]
    assert by_name["attachMultiSubTrees"] == trees
    assert by_name["printTree"] == by_name["plotTree"] == []


def test_the_reference_holds_the_table_of_functions() -> None:
    """To bring it up to date, put what ``tools_table()`` gives between the two marks."""
    page = Path(__file__).parents[2] / "docs" / "reference" / "tree-building.md"
    text = page.read_text(encoding="utf-8")
    assert text.split("<!-- functions -->\n")[1].split("<!-- /functions -->")[0].strip() == tools_table().strip()


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"isPrimitive": "false"}, "isPrimitive is a text where true or false"),
        ({"isPrimitive": 0}, "isPrimitive is a number where true or false"),
        ({"isPrimitive": None}, "isPrimitive is null where true or false"),
        ({"taskName": 7}, "taskName is a number where a text"),
        ({"taskName": ["Look"]}, "taskName is a list where a text"),
        ({"parentString": None}, "parentString is null where a text"),
        ({"LogicalConstraint": "OR"}, "no gate 'OR'"),
        ({"LogicalConstraint": ""}, "no gate ''"),
        ({"LogicalConstraint": True}, "LogicalConstraint is true or false where a text"),
        ({"taskname": "x"}, "no argument 'taskname'"),
        ({"taskName:": "x"}, "no argument 'taskName:'"),
        ({"draw": "x"}, "no argument 'draw'"),
    ],
)
def test_arguments_of_another_shape_are_refused(box: ToolBox, changes: dict[str, Any], said: str) -> None:
    before = box.builder.state
    answer = box.call("CreateAndAddSubtask", SUBTASK | changes)
    assert [reason.rule for reason in answer.reasons] == ["malformed_arguments"]
    assert said in answer.reasons[0].message
    assert answer.reasons[0].hint
    assert box.builder.state is before


@pytest.mark.parametrize("missing", list(SUBTASK))
def test_nothing_that_is_missing_is_made_up(box: ToolBox, missing: str) -> None:
    answer = box.call("CreateAndAddSubtask", {key: value for key, value in SUBTASK.items() if key != missing})
    assert answer.reasons[0].message == f"CreateAndAddSubtask lacks {missing}."


@pytest.mark.parametrize("flags", [["true"], [1], "false", [None], {"0": False}])
def test_lists_of_flags_hold_flags(box: ToolBox, flags: Any) -> None:
    call = {"parentString": "Find", "isPrimitiveList": flags, "taskNameList": ["A"], "LogicalConstraint": "AND"}
    assert box.call("addMultiSubtasks", call).reasons[0].rule == "malformed_arguments"


def test_a_misspelt_function_is_refused_with_the_nearest(box: ToolBox) -> None:
    answer = box.call("addMultiSubtask", "{}")
    assert answer.reasons[0].rule == "unknown_function"
    assert "'addMultiSubtasks'" in answer.reasons[0].hint


def test_a_repeated_call_on_an_unchanged_tree_is_refused(box: ToolBox) -> None:
    assert box.call("printTree").ok
    again = box.call("printTree", "{}")
    assert [reason.rule for reason in again.reasons] == ["repeated_call"]
    assert box.call("CreateAndAddSubtask", SUBTASK).ok
    assert box.call("printTree").ok, "the tree has changed"


def test_a_repeated_refused_call_tells_why_it_was_refused(box: ToolBox) -> None:
    """Key order and blanks do not make another call of it."""
    wrong = SUBTASK | {"parentString": "Fetch"}
    box.call("CreateAndAddSubtask", wrong)
    again = box.call("CreateAndAddSubtask", json.dumps(dict(reversed(wrong.items())), indent=3))
    assert [reason.rule for reason in again.reasons] == ["repeated_call", "unknown_parent"]


def test_answers_are_one_json_object_for_models(box: ToolBox) -> None:
    said = json.loads(box.call("CreateAndAddSubtask", SUBTASK | {"isPrimitive": True}).text)
    assert said["ok"] is True
    assert said["added"] == [{"id": "look", "label": "Look"}]
    assert said["open_leaves"] == ["look", "bring"]
    assert said["notices"][0]["rule"] == "not_primitive"
    no = json.loads(box.call("CreateAndAddSubtask", SUBTASK | {"parentString": "Fetch"}).text)
    assert no["ok"] is False
    assert set(no["refused"][0]) == {"rule", "message", "hint"}
