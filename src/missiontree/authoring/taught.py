"""Calls and tools in the form in which they are taught: every argument under its own name, and as the schema has it."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from missiontree.authoring.answer import RefusalError
from missiontree.authoring.links import Pair, name_of_kind
from missiontree.authoring.schema import schema_of
from missiontree.authoring.shapes import GATE, KIND, PAIRS
from missiontree.authoring.tools import BY_NAME, TOOLS, Parameter, read_arguments
from missiontree.authoring.wire import parse_arguments
from missiontree.llm.chat import ToolCall
from missiontree.mission.routine import Routine, RoutineLibrary

_NAMES = {"type": "array", "items": {"type": "string"}, "minItems": 1}
_IN_ORDER = {"type": "array", "items": {"anyOf": [{"type": "string"}, _NAMES]}, "minItems": 1}
_OF_ANY_MISSION = {"treeArguments": {"type": "array", "items": _IN_ORDER, "minItems": 1}}


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


def call_taught(call: ToolCall, library: RoutineLibrary) -> ToolCall | None:
    """
    A call as it should be written.

    Other spellings that are accepted, such as ``contraintsPairs``, ``"and"``, ``{}`` for no pairs or arguments of a routine by name, become
    those that the schema has.

    Parameters
    ----------
    call
        The call as the model wrote it.
    library
        The routines on offer.

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
        if known.name in read:
            spelling = next(name for name in (known.name, *known.also) if name in parsed)
            written[known.name] = _written(known, parsed[spelling], read[known.name])
    if "treeArguments" in written:
        if len(read["treeNames"]) != len(written["treeArguments"]):
            return None
        named = zip(read["treeNames"], written["treeArguments"], strict=True)
        written["treeArguments"] = [_in_order(given, library.find(name)) for name, given in named]
    return replace(call, arguments=json.dumps(written, ensure_ascii=False))


def _written(known: Parameter, said: Any, read: Any) -> Any:
    """An argument as its schema has it, from how it was said and how it was read."""
    if known.shape is GATE:
        return str(read).upper()
    if known.shape is KIND:
        return name_of_kind(read)
    if known.shape is PAIRS:
        return [_pair(pair) for pair in read]
    return said


def _pair(pair: Pair) -> Sequence[str | int]:
    first, second, kind = pair
    return [first, second] if kind == "precedence" else [first, second, name_of_kind(kind)]


def _in_order(given: Any, routine: Routine | None) -> Any:
    """The arguments of a routine in its order, the robot types allowed last; a null stands for types that are left out."""
    if isinstance(given, dict):
        names = [argument.name for argument in routine.arguments] if routine is not None else list(given)
        given = [given[name] for name in (*names, "resources") if name in given]
    return [value for value in given if value is not None] if isinstance(given, list) else given
