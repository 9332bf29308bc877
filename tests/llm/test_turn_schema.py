"""Whatever the schema of a turn allows is a turn; and it allows nothing that has no end, or names what is not there."""

from __future__ import annotations

import json
import random
from collections.abc import Mapping, Sequence
from typing import Any

import jsonschema
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.authoring.tools import BY_NAME, read_arguments
from missiontree.authoring.wire import parse_arguments
from missiontree.llm.chat import Tool
from missiontree.llm.local_turn import read_turn
from missiontree.llm.turn_schema import TurnBounds, turn_schema
from tests.llm.turns import OFFERED, STATES, drawn, longest

SMALL = TurnBounds(thought=5, calls=2, items=2, text=4, number=9)


def check(value: Any, schema: Mapping[str, Any]) -> None:
    """Raise unless the value is of the schema. Schemas made here are not checked themselves each time; that takes long."""
    jsonschema.Draft202012Validator(schema).validate(value)


@pytest.mark.parametrize("state", STATES)
@pytest.mark.parametrize("must_call", [False, True])
@settings(max_examples=40)
@given(seed=st.integers(0, 2**32))
def test_what_is_drawn_from_the_schema_is_a_turn_of_calls_in_the_shape_of_the_tools(
    state: str, must_call: bool, seed: int
) -> None:
    tools = OFFERED[state]
    schema = turn_schema(tools, must_call=must_call, bounds=SMALL)
    turn = drawn(schema, random.Random(seed))  # noqa: S311 - chance that is not chance
    check(turn, schema)
    thought, calls = read_turn(json.dumps(turn, ensure_ascii=False, separators=(",", ":")), turn=1)
    assert thought == turn["thought"]
    assert int(must_call) <= len(calls) <= SMALL.calls
    offered = {tool.name: tool for tool in tools}
    for call in calls:
        arguments = parse_arguments(call.arguments)
        check(arguments, offered[call.name].parameters)
        without_kinds = {name: value for name, value in arguments.items() if name != "constraintPairs"}
        read_arguments(BY_NAME[call.name], without_kinds)  # the kind of a pair is free text in the tool's own schema


@pytest.mark.parametrize("state", STATES)
def test_nothing_in_it_is_without_a_bound(state: str) -> None:
    assert longest(turn_schema(OFFERED[state])) < 1_000_000
    assert longest(turn_schema(OFFERED[state], bounds=SMALL)) < 2_000


def test_the_longest_turn_is_as_long_as_counted_by_hand() -> None:
    tool = Tool("go", "", {"type": "object", "properties": {"to": {"type": "string"}}, "required": ["to"]} | CLOSED)
    schema = turn_schema([tool], bounds=TurnBounds(thought=3, calls=2, items=1, text=1, number=1))
    thought = '{"thought":"' + '\\"' * 3 + '","calls":['
    call = '{"name":"go","arguments":{"to":"\\""}}'
    turn = f"{thought}{call},{call}]}}"
    jsonschema.validate(json.loads(turn), schema)
    # Per list and object one comma more is counted than there can be: in the turn, its list, and in each call two objects.
    assert longest(schema) == len(turn) + 1 + 1 + 2 * 2


CLOSED: dict[str, Any] = {"additionalProperties": False}


@pytest.mark.parametrize(
    ("arguments", "wrong"),
    [
        ({"parentString": "no-such-task"}, "a parent that is not there"),
        ({"treeNames": ["FlyTree"]}, "a routine that is not there"),
        ({"treeArguments": [["dragon"]]}, "an entity that is not there"),
        ({"LogicalConstraint": "OR"}, "a gate that is not there"),
        ({"treeArguments": [["child"]] * 17}, "more entries than a list may have"),
        ({"treeNames": []}, "an empty list"),
        ({"more": 1}, "an argument that is not there"),
    ],
)
def test_what_is_not_there_cannot_be_said(arguments: dict[str, Any], wrong: str) -> None:
    sound = {
        "parentString": "bring",
        "treeNames": ["SearchTree"],
        "treeArguments": [["child"]],
        "LogicalConstraint": "AND",
    }
    schema = turn_schema(OFFERED["scene"])
    jsonschema.validate(turn_of(("attachMultiSubTrees", sound)), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(turn_of(("attachMultiSubTrees", sound | arguments)), schema)


def turn_of(*calls: tuple[str, dict[str, Any]]) -> dict[str, Any]:
    return {"thought": "", "calls": [{"name": name, "arguments": arguments} for name, arguments in calls]}


def test_words_alone_are_a_turn_unless_a_call_is_demanded() -> None:
    words = turn_of()
    jsonschema.validate(words, turn_schema(OFFERED["root only"]))
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(words, turn_schema(OFFERED["root only"], must_call=True))


def test_without_tools_there_are_only_words() -> None:
    schema = turn_schema([])
    jsonschema.validate(turn_of(), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"thought": "", "calls": [None]}, schema)
    with pytest.raises(ValueError, match="no tool is offered"):
        turn_schema([], must_call=True)


def test_a_tools_own_bounds_go_before_the_usual_ones() -> None:
    pair = {"type": "array", "items": {"type": "integer", "minimum": 3, "maximum": 500}, "minItems": 1, "maxItems": 40}
    name = {"type": "string", "minLength": 2, "maxLength": 5_000}
    many = {"type": "array", "items": {"type": "boolean"}, "minItems": 30}
    schema = turn_schema([tool_of(pair=pair, name=name, many=many)])
    made = schema["properties"]["calls"]["items"]["anyOf"][0]["properties"]["arguments"]["properties"]
    assert made["pair"]["items"] == {"type": "integer", "minimum": 3, "maximum": 500}
    assert (made["pair"]["minItems"], made["pair"]["maxItems"]) == (1, 40)
    assert (made["name"]["minLength"], made["name"]["maxLength"]) == (2, 5_000)
    # 30 entries are needed where 16 are the usual most: as many as are needed, and no more.
    assert (made["many"]["minItems"], made["many"]["maxItems"]) == (30, 30)


def tool_of(**properties: Mapping[str, Any]) -> Tool:
    return Tool("go", "Go.", {"type": "object", "properties": properties, "required": list(properties)} | CLOSED)


def test_whole_numbers_have_two_ends() -> None:
    schema = turn_schema([tool_of(of={"type": "integer"})], bounds=SMALL)
    jsonschema.validate(turn_of(("go", {"of": -9})), schema)
    for beyond in (-10, 10):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(turn_of(("go", {"of": beyond})), schema)


def test_texts_are_of_one_line() -> None:
    schema = turn_schema([tool_of(of={"type": "string"})])
    for text in ("a\nb", "\x00", "\x7f"):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(turn_of(("go", {"of": text})), schema)
    jsonschema.validate(turn_of(("go", {"of": 'ä "quoted" \\ text'})), schema)


@pytest.mark.parametrize(
    ("schema", "says"),
    [
        ({"type": "array"}, "of what"),
        ({"type": "number"}, "no form for"),
        ({"type": ["string", "null"]}, "no form for"),
        ({}, "no form for"),
        ({"$ref": "#"}, "no form for"),
        ({"type": "string", "format": "date"}, "format"),
        ({"type": "string", "pattern": "a"}, "pattern"),
        ({"type": "integer", "multipleOf": 2}, "multipleOf"),
        ({"type": "array", "items": {"type": "null"}, "uniqueItems": True}, "uniqueItems"),
        ({"type": "boolean", "minimum": 1}, "minimum"),
        ({"anyOf": [{"type": "null"}], "type": "string"}, "type"),
        ({"enum": ["a"], "minLength": 1}, "minLength"),
        ({"type": "object", "properties": {}, "required": ["x"]} | CLOSED, "'x' is required"),
        ({"anyOf": [{"type": "null"}, {"type": "array"}]}, "of what"),
        ({"type": "array", "items": {"type": "object", "patternProperties": {}}}, "patternProperties"),
    ],
)
def test_what_no_grammar_is_made_of_is_refused_and_never_passed_over(schema: dict[str, Any], says: str) -> None:
    with pytest.raises(ValueError, match=says) as raised:
        turn_schema([tool_of(of=schema)])
    assert "the schema of go" in str(raised.value)


@pytest.mark.parametrize("more", [{}, {"additionalProperties": True}, {"additionalProperties": {"type": "string"}}])
def test_objects_that_are_open_are_closed(more: dict[str, Any]) -> None:
    """What is described is said, and nothing else; that is something the tool takes."""
    known = {"type": "object", "properties": {"a": {"type": "null"}}}
    schema = turn_schema([tool_of(of=known | more)])
    check(turn_of(("go", {"of": {"a": None}})), schema)
    with pytest.raises(jsonschema.ValidationError):
        check(turn_of(("go", {"of": {"b": "more"}})), schema)


def test_arguments_are_an_object() -> None:
    with pytest.raises(ValueError, match="arguments of go are no object"):
        turn_schema([Tool("go", "", {"type": "array", "items": {"type": "null"}})])


def test_words_for_people_are_no_part_of_it() -> None:
    text = json.dumps([turn_schema(tools) for tools in OFFERED.values()])
    assert "description" not in text


def test_properties_stand_in_the_order_of_the_tool() -> None:
    calls = turn_schema(OFFERED["root only"])["properties"]["calls"]["items"]["anyOf"]
    for tool, call in zip(OFFERED["root only"], calls, strict=True):
        assert list(call["properties"]) == ["name", "arguments"]
        arguments = call["properties"]["arguments"]
        assert list(arguments["properties"]) == list(tool.parameters["properties"])
        assert arguments["required"] == list(tool.parameters["required"])


def names_of(tools: Sequence[Tool]) -> list[str]:
    return [tool.name for tool in tools]


@pytest.mark.parametrize("state", STATES)
def test_it_is_a_json_schema(state: str) -> None:
    jsonschema.Draft202012Validator.check_schema(turn_schema(OFFERED[state]))


@pytest.mark.parametrize("state", STATES)
def test_each_tool_on_offer_can_be_called(state: str) -> None:
    schema = turn_schema(OFFERED[state])
    names = [call["properties"]["name"]["const"] for call in schema["properties"]["calls"]["items"]["anyOf"]]
    assert names == names_of(OFFERED[state])
