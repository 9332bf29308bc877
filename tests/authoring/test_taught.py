"""Calls and tools in the form in which they are taught."""

from __future__ import annotations

import json

import pytest
from jsonschema import Draft202012Validator

from missiontree.authoring.taught import call_taught, tools_taught
from missiontree.authoring.tools import TOOLS
from missiontree.llm.chat import ToolCall
from missiontree.routines.library import built_in


def schema_of(name: str) -> Draft202012Validator:
    parameters = next(tool["function"]["parameters"] for tool in tools_taught() if tool["function"]["name"] == name)
    return Draft202012Validator(parameters)


def test_every_function_is_there_once_in_the_order_of_the_registry() -> None:
    made = tools_taught()
    assert [tool["function"]["name"] for tool in made] == [tool.name for tool in TOOLS]
    assert [tool["function"]["description"] for tool in made] == [tool.description for tool in TOOLS]


@pytest.mark.parametrize(
    ("arguments", "fits"),
    [
        ([["cat"]], True),
        ([["cat", "gate", ["tele_robot"]]], True),
        ([{"agent": "cat", "resources": ["tele_robot"]}], False),
        (["cat"], False),
        ([[]], False),
        ([], False),
        ([["cat", 7]], False),
    ],
)
def test_arguments_of_routines_are_names_or_lists_of_names(arguments: object, fits: bool) -> None:
    call = {"parentString": "x", "treeNames": ["SearchTree"], "treeArguments": arguments, "LogicalConstraint": "AND"}
    assert schema_of("attachMultiSubTrees").is_valid(call) == fits


@pytest.mark.parametrize(
    "call",
    [
        ("flyAway", "{}"),
        ("printTree", "{"),
        ("printTree", "[]"),
        ("printTree", '{"a": 1}'),
        ("setLink", '{"first": "a"}'),
        (
            "attachMultiSubTrees",
            '{"parentString": "a", "treeNames": ["SearchTree"], "treeArguments": [["b"], ["c"]], "LogicalConstraint": "AND"}',
        ),
        ("setLink", '{"first": "a", "second": "b", "kind": "Forever"}'),
    ],
)
def test_malformed_calls_are_not_taught(call: tuple[str, str]) -> None:
    assert call_taught(ToolCall("x", *call), built_in()) is None


def test_a_call_without_arguments_has_an_empty_object() -> None:
    assert call_taught(ToolCall("x", "printTree", ""), built_in()) == ToolCall("x", "printTree", "{}")


def test_arguments_stand_in_the_order_of_the_function_and_keep_their_letters() -> None:
    given = '{"kind": "place", "name": "Bäckerei"}'
    taught = call_taught(ToolCall("x", "introduceEntity", given), built_in())
    assert taught is not None
    assert taught.arguments == '{"name": "Bäckerei", "kind": "place"}'


def test_pairs_of_the_usual_kind_are_written_short() -> None:
    given = {
        "parentString": "x",
        "isPrimitiveList": [False, False, False],
        "taskNameList": ["a", "b", "c"],
        "LogicalConstraint": "and",
        "constraintPairs": [["a", 1, "precedence"], [1, 2, "SameRobot"]],
    }
    taught = call_taught(ToolCall("x", "addMultiSubtasks", json.dumps(given)), built_in())
    assert taught is not None
    written = json.loads(taught.arguments)
    assert written["constraintPairs"] == [["a", 1], [1, 2, "SameRobot"]]
    assert written["LogicalConstraint"] == "AND"
    assert schema_of("addMultiSubtasks").is_valid(written)


@pytest.mark.parametrize(
    ("name", "given", "written"),
    [
        ("TransportTree", {"location": "gate", "agent": "cat"}, ["cat", "gate"]),
        ("Transport", {"resources": ["drone"], "location": "gate", "agent": "cat"}, ["cat", "gate", ["drone"]]),
        ("TransportTree", {"location": "gate", "agent": "cat", "resources": None}, ["cat", "gate"]),
        ("TransportTree", ["cat", "gate", None], ["cat", "gate"]),
        ("TransprotTree", {"location": "gate", "agent": "cat"}, ["gate", "cat"]),
    ],
)
def test_arguments_by_name_are_written_in_the_order_of_the_routine(name: str, given: object, written: object) -> None:
    call = {"parentString": "x", "treeNames": ["SearchTree", name], "treeArguments": [["cat"], given]}
    taught = call_taught(
        ToolCall("x", "attachMultiSubTrees", json.dumps(call | {"LogicalConstraint": "AND"})), built_in()
    )
    assert taught is not None
    assert json.loads(taught.arguments)["treeArguments"] == [["cat"], written]
    assert schema_of("attachMultiSubTrees").is_valid(json.loads(taught.arguments))
