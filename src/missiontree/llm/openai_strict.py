"""
Schemas in the form that strict function calling demands, and arguments back in the form that the function takes.

Strict calling knows a part of JSON Schema only, and every property must be required; one that is optional becomes one that may be null.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any, NoReturn

Schema = Mapping[str, Any]
_NULL: dict[str, Any] = {"type": "null"}
_PLAIN = frozenset(
    {
        *("type", "enum", "const", "description", "title", "pattern", "format", "minItems", "maxItems"),
        *("minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum", "multipleOf"),
    }
)
_SIMPLE = frozenset({"type", "enum", "description"})
_MOST_PROPERTIES = 5_000
_MOST_ENUM_VALUES = 1_000
_MOST_LETTERS = 120_000
_LONG_ENUM, _MOST_LETTERS_OF_LONG_ENUM = 250, 15_000
_DEEPEST = 10


class _NotStrictError(Exception):
    """The schema says something that strict calling cannot be told."""


def strict_form(schema: Schema) -> dict[str, Any] | None:
    """
    The schema of a function's arguments in strict form.

    Parameters
    ----------
    schema
        JSON Schema of an object.

    Returns
    -------
    dict[str, Any] | None
        None if it cannot be said in that form, or is larger than the form allows (5,000 properties, 1,000 values of enums, 120,000
        letters of names and values, 10 levels).
    """
    if schema.get("type") != "object":
        return None
    size = _Size()
    try:
        return _strict(schema, size, 1)
    except _NotStrictError:
        return None


class _Size:
    """What the limits of strict calling count."""

    def __init__(self) -> None:
        self.properties = self.values = self.letters = 0

    def count(self, properties: Mapping[str, Any], values: list[Any]) -> None:
        """Add the properties and the values of one schema."""
        letters = sum(len(value) for value in values if isinstance(value, str))
        self.properties += len(properties)
        self.values += len(values)
        self.letters += letters + sum(map(len, properties))
        _must(self.properties <= _MOST_PROPERTIES and self.values <= _MOST_ENUM_VALUES)
        _must(self.letters <= _MOST_LETTERS)
        _must(len(values) <= _LONG_ENUM or letters <= _MOST_LETTERS_OF_LONG_ENUM)


def _strict(schema: Schema, size: _Size, depth: int) -> dict[str, Any]:
    _must(depth <= _DEEPEST and isinstance(schema, Mapping))
    made = {key: value for key, value in schema.items() if key in _PLAIN}
    rest = set(schema) - _PLAIN - {"properties", "required", "additionalProperties", "items", "anyOf"}
    _must(not rest and ("type" in schema or "anyOf" in schema or "enum" in schema or "const" in schema))
    size.count({}, list(schema.get("enum", ())))
    if "anyOf" in schema:
        made["anyOf"] = [_strict(branch, size, depth) for branch in schema["anyOf"]]
    if schema.get("type") == "array":
        _must("items" in schema)
        made["items"] = _strict(schema["items"], size, depth + 1)
    if schema.get("type") == "object":
        _must(schema.get("additionalProperties") is False)  # strict calling has no properties but the named ones
        properties = schema.get("properties", {})
        size.count(properties, [])
        made["properties"] = {
            name: _strict(known if name in schema.get("required", ()) else _or_null(known), size, depth + 1)
            for name, known in properties.items()
        }
        made |= {"required": list(properties), "additionalProperties": False}
    return made


def _must(true: bool) -> None:
    if not true:
        raise _NotStrictError


def _or_null(schema: Schema) -> Schema:
    if _takes_null(schema):
        return schema
    said = {"description": schema["description"]} if "description" in schema else {}
    bare = {key: value for key, value in schema.items() if key != "description"}
    branches = bare["anyOf"] if set(bare) == {"anyOf"} else [bare]
    return {"anyOf": [*branches, _NULL], **said}


def _takes_null(schema: Schema) -> bool:
    kinds = schema.get("type")
    return (
        kinds == "null"
        or (isinstance(kinds, list) and "null" in kinds)
        or any(map(_takes_null, schema.get("anyOf", ())))
    )


def simple_form(schema: Schema) -> dict[str, Any]:
    """The schema reduced to what every endpoint understands: types, enums, properties and items; of alternatives, the first."""
    first: Schema = next((branch for branch in schema.get("anyOf", ()) if not _takes_null(branch)), {})
    whole = {**first, **{key: value for key, value in schema.items() if key != "anyOf"}}
    made = {key: value for key, value in whole.items() if key in _SIMPLE}
    if "items" in whole:
        made["items"] = simple_form(whole["items"])
    if whole.get("type") == "object":
        made["properties"] = {name: simple_form(known) for name, known in whole.get("properties", {}).items()}
        made["required"] = list(whole.get("required", ()))
    return made


def restored(arguments: str, schema: Schema) -> str:
    """
    Arguments that were given in strict form, in the form of the schema: a null that stands for "left out" is left out.

    Parameters
    ----------
    arguments
        What the model wrote. Text that is not sound JSON stays as it is; it is for others to judge.
    schema
        The schema before :func:`strict_form`.
    """
    try:
        given = json.loads(arguments, object_pairs_hook=_once, parse_constant=_refused, parse_float=_finite)
        kept = _without_nulls(given, schema)
        return arguments if kept == given else json.dumps(kept, ensure_ascii=False)
    except (ValueError, RecursionError):
        return arguments


def _without_nulls(given: Any, schema: Schema) -> Any:
    for branch in schema.get("anyOf", ()):
        given = _without_nulls(given, branch)
    if isinstance(given, list) and "items" in schema:
        return [_without_nulls(entry, schema["items"]) for entry in given]
    if isinstance(given, dict) and "properties" in schema:
        known = schema["properties"]
        optional = {name for name in known if name not in schema.get("required", ()) and not _takes_null(known[name])}
        return {
            name: _without_nulls(value, known.get(name, {}))
            for name, value in given.items()
            if value is not None or name not in optional
        }
    return given


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    if len(items := dict(pairs)) < len(pairs):
        raise ValueError("a key stands twice")
    return items


def _refused(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is not JSON")


def _finite(text: str) -> float:
    if not math.isfinite(number := float(text)):
        raise ValueError(f"{text[:40]} is too large a number")
    return number
