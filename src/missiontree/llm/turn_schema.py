"""
The JSON Schema of one turn: a thought, then calls of the tools on offer, each held to its own schema.

For engines that hold a model to a grammar. It allows less than the tools take, and never more. Everything is bounded, objects are
closed, and nothing refers to itself, so that even a model that says anything at random comes to an end, and what it then has said is a
turn.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from missiontree.llm.chat import Tool
from missiontree.mission.value import Count, Index, Value

Schema = dict[str, Any]
ONE_LINE = r"^[^\u0000-\u001f\u007f]*$"
"""Texts hold no control characters. Their escapes fall away with them, and so do halves of characters."""

_SILENT = frozenset({"description", "title"})


@dataclass(frozen=True, slots=True, kw_only=True)
class TurnBounds(Value):
    """
    The most that one turn may hold, where the schema of a tool sets no bound of its own.

    Parameters
    ----------
    thought
        Characters of the thought before the calls. Default 600.
    calls
        Calls. Default 8.
    items
        Entries of any list. Default 16.
    text
        Characters of any free text. Default 300.
    number
        Largest whole number, of either sign. Default 99.
    """

    thought: Index = 600
    calls: Count = 8
    items: Count = 16
    text: Count = 300
    number: Count = 99


USUAL = TurnBounds()
"""Enough for any turn that makes sense, and for the length limit of an answer rather than these to be the one that is met."""


def turn_schema(tools: Sequence[Tool], *, must_call: bool = False, bounds: TurnBounds = USUAL) -> Schema:
    """
    The schema of an object of ``thought``, a text, and ``calls``, a list of ``{"name": ..., "arguments": {...}}``.

    An empty list of calls is words alone.

    Parameters
    ----------
    tools
        What may be called.
    must_call
        Whether there must be a call. Default false.
    bounds
        What holds where the tools set no bound of their own.

    Raises
    ------
    ValueError
        If a call is demanded and nothing is on offer, or the schema of a tool says something that no grammar is made of here.
    """
    if must_call and not tools:
        raise ValueError("a call is demanded, and no tool is offered.")
    items = {"anyOf": [_call(tool, bounds) for tool in tools]}
    most = bounds.calls if tools else 0
    calls = {
        "type": "array",
        "items": items if tools else {"type": "null"},
        "minItems": int(must_call),
        "maxItems": most,
    }
    return _closed({"thought": _text({"maxLength": bounds.thought}, bounds), "calls": calls})


def _call(tool: Tool, bounds: TurnBounds) -> Schema:
    if tool.parameters.get("type") != "object":
        raise ValueError(f"the arguments of {tool.name} are no object.")
    try:
        arguments = _bounded(tool.parameters, bounds)
    except ValueError as fault:
        raise ValueError(f"the schema of {tool.name} cannot be made a grammar: {fault}") from fault
    return _closed({"name": {"const": tool.name}, "arguments": arguments})


def _closed(properties: Schema) -> Schema:
    return {"type": "object", "properties": properties, "required": list(properties), "additionalProperties": False}


def _bounded(schema: Mapping[str, Any], bounds: TurnBounds) -> Schema:
    """The schema with a bound on everything, and without what is only said to people."""
    said = {key: value for key, value in schema.items() if key not in _SILENT}
    for key, form in _WITHOUT_A_TYPE.items():
        if key in said:
            return form(said, bounds)
    kind = said.get("type")
    if not isinstance(kind, str) or kind not in _FORMS:
        raise ValueError(f"there is no form for {schema!r:.100}")
    return _FORMS[kind](said, bounds)


def _choice(said: Schema, bounds: TurnBounds) -> Schema:
    _only(said, "anyOf")
    return {"anyOf": [_bounded(branch, bounds) for branch in said["anyOf"]]}


def _value(said: Schema, bounds: TurnBounds) -> Schema:
    _only(said, "type", "enum", "const")
    return {key: value for key, value in said.items() if key != "type"}


def _text(said: Schema, bounds: TurnBounds) -> Schema:
    _only(said, "type", "minLength", "maxLength")
    low, high = _range(said, "minLength", "maxLength", bounds.text)
    return {"type": "string", "pattern": ONE_LINE, "minLength": low, "maxLength": high}


def _whole(said: Schema, bounds: TurnBounds) -> Schema:
    _only(said, "type", "minimum", "maximum")
    low, high = _range({"minimum": -bounds.number} | said, "minimum", "maximum", bounds.number)
    return {"type": "integer", "minimum": low, "maximum": high}


def _list(said: Schema, bounds: TurnBounds) -> Schema:
    _only(said, "type", "items", "minItems", "maxItems")
    if "items" not in said:
        raise ValueError("a list does not say of what")
    low, high = _range(said, "minItems", "maxItems", bounds.items)
    return {"type": "array", "items": _bounded(said["items"], bounds), "minItems": low, "maxItems": high}


def _object(said: Schema, bounds: TurnBounds) -> Schema:
    _only(said, "type", "properties", "required", "additionalProperties")
    known = said.get("properties", {})
    if missing := [name for name in said.get("required", ()) if name not in known]:
        raise ValueError(f"{missing[0]!r} is required and not described")
    properties = {name: _bounded(value, bounds) for name, value in known.items()}
    return _closed(properties) | {"required": list(said.get("required", ()))}


def _plain(said: Schema, bounds: TurnBounds) -> Schema:
    _only(said, "type")
    return said


def _range(said: Schema, lowest: str, highest: str, most: int) -> tuple[int, int]:
    """From where to where: the schema's own limits if it has any, and never past *most* without its word."""
    low = int(said.get(lowest, 0))
    return low, int(said.get(highest, max(low, most)))


def _only(said: Schema, *known: str) -> None:
    """A word that were passed over would be a rule that the model is not held to."""
    if unknown := sorted(set(said) - set(known)):
        raise ValueError(f"there is no form for {', '.join(unknown)}")


_Form = Callable[[Schema, TurnBounds], Schema]
_WITHOUT_A_TYPE: dict[str, _Form] = {"anyOf": _choice, "enum": _value, "const": _value}
_FORMS: dict[str, _Form] = {
    "string": _text,
    "integer": _whole,
    "array": _list,
    "object": _object,
    "boolean": _plain,
    "null": _plain,
}
