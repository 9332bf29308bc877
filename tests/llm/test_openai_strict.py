"""Schemas in strict form say the same, and arguments come back as if there had been none."""

from __future__ import annotations

import json
from typing import Any

import jsonschema
import pytest

from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.schema import offered_tools
from missiontree.authoring.tools import ToolBox
from missiontree.llm.openai_strict import restored, simple_form, strict_form
from missiontree.mission.brief import MissionBrief
from missiontree.routines.library import built_in
from tests.builders import paper_fleet
from tests.llm.endpoint_rules import _of_strict

TEXT = {"type": "string"}


def an_object(required: list[str], **properties: Any) -> dict[str, Any]:
    return {"type": "object", "properties": properties, "required": required, "additionalProperties": False}


def test_what_is_optional_may_be_null_and_must_be_there() -> None:
    schema = an_object(["a"], a=TEXT, b={"type": "integer", "description": "how many"})
    assert strict_form(schema) == an_object(
        ["a", "b"], a=TEXT, b={"anyOf": [{"type": "integer"}, {"type": "null"}], "description": "how many"}
    )


def test_what_may_be_null_already_stays_as_it_is() -> None:
    either = {"anyOf": [TEXT, {"type": "null"}]}
    assert strict_form(an_object([], a=either)) == an_object(["a"], a=either)


def test_objects_inside_lists_and_alternatives_are_made_strict_too() -> None:
    inner = an_object([], x=TEXT)
    made = strict_form(an_object(["a"], a={"type": "array", "items": {"anyOf": [TEXT, inner]}, "minItems": 1}))
    assert made is not None
    assert made["properties"]["a"]["items"]["anyOf"][1] == strict_form(inner)
    assert made["properties"]["a"]["minItems"] == 1


@pytest.mark.parametrize(
    "schema",
    [
        TEXT,
        an_object(["a"], a={"type": "array"}),
        an_object(["a"], a={}),
        an_object(["a"], a={"type": "object"}),
        an_object(["a"], a={"oneOf": [TEXT]}),
        an_object(["a"], a={"type": "string", "minLength": 3}),
        an_object(["a"], a={"type": "string", "enum": [str(number) for number in range(1001)]}),
        an_object(["a"], a={"type": "string", "enum": ["x" * 60 + str(number) for number in range(251)]}),
        an_object(["a"], a={"type": "string", "enum": ["x" * 1000 + str(number) for number in range(120)]}),
        {"type": "object", "properties": {"a": TEXT}, "required": ["a"]},
    ],
    ids=[
        *("no object", "list of anything", "anything", "open object", "another keyword", "length of a text"),
        *("too many values", "too long a long enum", "too many letters", "other properties allowed"),
    ],
)
def test_what_cannot_be_said_strictly_is_not(schema: dict[str, Any]) -> None:
    assert strict_form(schema) is None


def test_ten_levels_are_the_limit() -> None:
    def nested(levels: int) -> dict[str, Any]:
        return an_object(["a"], a=nested(levels - 1)) if levels > 1 else an_object([])

    assert strict_form(nested(10)) is not None
    assert strict_form(nested(11)) is None


def test_every_function_on_offer_has_a_strict_form_that_keeps_the_rules() -> None:
    """Before there is a tree and after; with the fleet of the paper."""
    box = ToolBox(TreeBuilder(MissionBrief(text="Find the cat", fleet=paper_fleet(), routines=built_in())))
    before = offered_tools(box.builder)
    assert box.call("HierarchicalTree_init", {"objective": "Find the cat"}).ok
    tools = (*before, *offered_tools(box.builder))
    assert len(tools) > len(before) > 0
    for tool in tools:
        form = strict_form(tool.parameters)
        assert form is not None, tool.name
        jsonschema.Draft202012Validator.check_schema(form)
        assert list(_of_strict(form, tool.name)) == []


def test_a_null_that_stands_for_left_out_is_left_out() -> None:
    schema = an_object(["a"], a={"type": "array", "items": {"anyOf": [TEXT, an_object([], x=TEXT, y=TEXT)]}}, b=TEXT)
    given = {"a": ["ü", {"x": None, "y": "1"}], "b": None}
    assert restored(json.dumps(given), schema) == '{"a": ["ü", {"y": "1"}]}'


def test_a_null_that_the_function_takes_stays() -> None:
    schema = an_object(["a"], a=TEXT, b={"anyOf": [TEXT, {"type": "null"}]})
    for given in ('{"a": null, "b":null}', '{"a": "1"}'):
        assert restored(given, schema) == given


@pytest.mark.parametrize(
    "given",
    [
        *("", "{", "[1]", "null", '{"b": null, "b": 1}', '{"b": null, "a": NaN}', '{"b": null, "a": 1e999}'),
        *('{"b": null' + "[" * 100_000, '{"b": null, "a": ' + "9" * 5000 + "}", '{"a":' * 5000 + "{}" + "}" * 5000),
    ],
)
def test_what_is_not_sound_json_stays_for_others_to_judge(given: str) -> None:
    assert restored(given, an_object(["a"], a=TEXT, b=TEXT)) == given


def test_the_simple_form_is_what_every_endpoint_understands() -> None:
    schema = an_object(
        ["a"],
        a={"type": "array", "items": {"anyOf": [{"type": "array", "items": TEXT, "minItems": 1}, TEXT]}, "minItems": 1},
        b={"anyOf": [{"type": "null"}, {"type": "string", "enum": ["x"]}], "description": "d"},
    )
    assert simple_form(schema) == {
        "type": "object",
        "properties": {
            "a": {"type": "array", "items": {"type": "array", "items": TEXT}},
            "b": {"type": "string", "enum": ["x"], "description": "d"},
        },
        "required": ["a"],
    }
