"""JSON Schemas of the documents, explained by the docstrings of the values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, get_args

from missiontree.formats.annotation import arms, hints_of, is_value, noun
from missiontree.formats.docstring import described
from missiontree.formats.validation import adapter

DIALECT = "https://json-schema.org/draft/2020-12/schema"


def schema_of(cls: type[Any], kind: str) -> dict[str, Any]:
    """JSON Schema of a document; references are local, so that it can be copied anywhere."""
    schema = adapter(cls).json_schema()
    by_name = {value.__name__: value for value in values_in(cls)}
    for name, definition in schema.get("$defs", {}).items():
        _explain(definition, by_name[name])
    _explain(schema, cls)
    _close_mappings(schema)
    head = {
        "format": {
            "const": f"{kind}/1",
            "description": "Kind and version of the document; written first, may be left out.",
        },
        "$schema": {"type": "string", "description": "Address of a JSON Schema, for editors; not read."},
    }
    schema["properties"] = head | schema["properties"]
    return {"$schema": DIALECT, **schema, "title": f"missiontree {kind} file, version 1"}


def values_in(cls: type[Any]) -> Iterator[type[Any]]:
    """A value and every value that can stand within it, each once, in order of appearance."""
    waiting: list[Any] = [cls]
    seen: set[type[Any]] = set()
    while waiting:
        annotation = waiting.pop(0)
        if not is_value(annotation):
            waiting[:0] = [arg for arg in get_args(annotation) if arg is not Ellipsis and not isinstance(arg, str)]
        elif annotation not in seen:
            seen.add(annotation)
            yield annotation
            waiting += [arm for hint in hints_of(annotation).values() for arm in arms(hint)]


def _explain(definition: dict[str, Any], cls: type[Any]) -> None:
    about = described(cls)
    definition["title"] = noun(cls)
    definition["description"] = about.summary
    for name, field in definition.get("properties", {}).items():
        field.pop("title", None)
        if meaning := about.fields.get(name):
            field["description"] = meaning


def _close_mappings(schema: dict[str, Any]) -> None:
    """Refuse keys that do not match the pattern of a mapping's keys, which JSON Schema lets pass unless told."""
    waiting: list[Any] = [schema]
    while waiting:
        node = waiting.pop()
        if isinstance(node, dict):
            if "patternProperties" in node:
                node["additionalProperties"] = False
            waiting.extend(node.values())
        elif isinstance(node, list):
            waiting.extend(node)
