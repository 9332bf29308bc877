"""Calls and tools in the form in which they are taught: every argument under its own name, and as the schema has it."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from missiontree.authoring.answer import RefusalError
from missiontree.authoring.links import Pair, name_of_kind
from missiontree.authoring.schema import schema_of
from missiontree.authoring.shapes import CALLS, GATE, KIND, PAIRS
from missiontree.authoring.tools import BY_NAME, TOOLS, Parameter, read_arguments
from missiontree.authoring.wire import parse_arguments
from missiontree.llm.chat import ToolCall

_NAMES = {"type": "array", "items": {"type": "string"}, "minItems": 1}
_ARGUMENT = {"anyOf": [{"type": "string"}, _NAMES]}
_ONE_CALL = {
    "anyOf": [
        {"type": "array", "items": _ARGUMENT, "minItems": 1},
        {"type": "object", "additionalProperties": _ARGUMENT},
    ]
}
_OF_ANY_MISSION = {"treeArguments": {"type": "array", "items": _ONE_CALL, "minItems": 1}}


def tools_taught() -> list[dict[str, Any]]:
    """
    All tree-building functions as chat endpoints take them.

    Their schemas are those of any mission. What a turn offers is narrower: it lists the nodes, routines and entities there are. A line
    of training data has one list of tools, and the list of a later turn would give away what the model is yet to make.
    """
    return [
        {
            "type": "function",
            "function": {
                "name": tool.name,
                "description": tool.description,
                "parameters": schema_of(tool, _OF_ANY_MISSION),
            },
        }
        for tool in TOOLS
    ]


def call_taught(call: ToolCall) -> ToolCall | None:
    """
    A call as it should be written.

    Other spellings that are accepted, such as ``contraintsPairs``, ``"and"`` or ``{}`` for no pairs, become the schema's own.

    Returns
    -------
    ToolCall | None
        None if the call is malformed: there is no such function, or its arguments are no JSON object that fits.
    """
    tool = BY_NAME.get(call.name)
    if tool is None:
        return None
    try:
        parsed = parse_arguments(call.arguments)
        read = read_arguments(tool, parsed)
    except RefusalError:
        return None
    written = {}
    for known in tool.parameters:
        spelling = next((name for name in (known.name, *known.also) if name in parsed), None)
        if spelling is not None:
            written[known.name] = _written(known, parsed[spelling], read[known.name])
    return replace(call, arguments=json.dumps(written, ensure_ascii=False))


def _written(known: Parameter, said: Any, read: Any) -> Any:
    """An argument as its schema has it, from how it was said and how it was read."""
    if known.shape is GATE:
        return str(read).upper()
    if known.shape is KIND:
        return name_of_kind(read)
    if known.shape is PAIRS:
        return [_pair(pair) for pair in read]
    if known.shape is CALLS:
        return [_without_nulls(entry) for entry in said]
    return said


def _pair(pair: Pair) -> Sequence[str | int]:
    first, second, kind = pair
    return [first, second] if kind == "precedence" else [first, second, name_of_kind(kind)]


def _without_nulls(arguments: Any) -> Any:
    """The arguments of a routine; a null stands for resources that are left out."""
    if isinstance(arguments, dict):
        return {name: value for name, value in arguments.items() if value is not None}
    return [value for value in arguments if value is not None] if isinstance(arguments, list) else arguments
