"""The shapes that arguments of calls have: what is offered to models as JSON Schema, and how what comes back is read."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from missiontree.authoring.answer import refuse
from missiontree.authoring.links import WIRE_KINDS, read_kind, read_pairs
from missiontree.authoring.matching import quoted, same_name
from missiontree.authoring.wire import RULE, kind_of_json


@dataclass(frozen=True, slots=True)
class Shape:
    """
    One shape of an argument.

    Parameters
    ----------
    schema
        JSON Schema offered to models.
    read
        Turns what came, and the argument's name, into what the builder takes; refuses anything else.
    says
        The shape in a word, for people.
    """

    schema: Mapping[str, Any]
    read: Callable[[Any, str], Any]
    says: str


def _text(given: Any, name: str) -> str:
    if not isinstance(given, str):
        raise refuse(
            RULE, f"{name} is {kind_of_json(given)} where a text is expected.", hint="Put it in double quotes."
        )
    return given


def _flag(given: Any, name: str) -> bool:
    if not isinstance(given, bool):
        raise refuse(
            RULE, f"{name} is {kind_of_json(given)} where true or false is expected.", hint="Write it without quotes."
        )
    return given


def _seconds(given: Any, name: str) -> float | None:
    if given is None:
        return None
    if isinstance(given, bool) or not isinstance(given, int | float) or not 0 <= given < math.inf:
        raise refuse(
            RULE,
            f"{name} is {kind_of_json(given)} where a number of seconds is expected.",
            hint="Count seconds from the start of the mission; at least 0.",
        )
    return given


def _each(read: Callable[[Any, str], Any], what: str) -> Callable[[Any, str], list[Any]]:
    def read_list(given: Any, name: str) -> list[Any]:
        if not isinstance(given, list):
            raise refuse(
                RULE, f"{name} is {kind_of_json(given)} where a list of {what} is expected.", hint="Write [ ... ]."
            )
        return [read(entry, f"{name}[{number}]") for number, entry in enumerate(given)]

    return read_list


def _gate(given: Any, name: str) -> str:
    gate = same_name(_text(given, name))
    if gate not in {"and", "xor"}:
        raise refuse(
            RULE,
            f"{name}: there is no gate {quoted(given)}.",
            hint='Gates are "AND" (all of them) and "XOR" (one of them).',
        )
    return gate


_END = {"anyOf": [{"type": "string"}, {"type": "integer", "minimum": 0}]}
_PAIR = {"type": "array", "items": _END, "minItems": 2, "maxItems": 3}

TEXT = Shape({"type": "string"}, _text, "text")
FLAG = Shape({"type": "boolean"}, _flag, "true or false")
SECONDS = Shape({"type": "number", "minimum": 0}, _seconds, "number of seconds, at least 0")
TEXTS = Shape({"type": "array", "items": {"type": "string"}, "minItems": 1}, _each(_text, "texts"), "list of texts")
FLAGS = Shape(
    {"type": "array", "items": {"type": "boolean"}, "minItems": 1},
    _each(_flag, "true or false"),
    "list of true or false",
)
GATE = Shape({"type": "string", "enum": ["AND", "XOR"]}, _gate, '"AND" or "XOR"')
KIND = Shape({"type": "string", "enum": list(WIRE_KINDS)}, read_kind, "one of " + ", ".join(WIRE_KINDS))
PAIRS = Shape({"anyOf": [{"type": "array", "items": _PAIR}, {"type": "null"}]}, read_pairs, "list of pairs")
CALLS = Shape(
    {"type": "array", "items": {"anyOf": [{"type": "array"}, {"type": "object"}]}, "minItems": 1},
    _each(lambda given, name: given, "argument lists"),
    "list of lists or objects",
)
