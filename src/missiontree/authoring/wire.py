"""Arguments as they come over the wire: text that should be one JSON object, and may be anything."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any, NoReturn

from missiontree.authoring.answer import refuse
from missiontree.authoring.matching import quoted

RULE = "malformed_arguments"
MAX_CHARACTERS = 1_000_000
MAX_NESTING = 32
_ACCEPTED = "Send one JSON object: keys and texts in double quotes, each key once, no NaN."


def parse_arguments(arguments: str | Mapping[str, Any]) -> dict[str, Any]:
    """
    The arguments of a call. Nothing is repaired: what is not one plain JSON object is refused.

    Parameters
    ----------
    arguments
        The text a model sent (empty means no arguments), or a mapping from a caller in Python.

    Raises
    ------
    RefusalError
        With the rule ``malformed_arguments`` and the place of the fault.
    """
    text = arguments if isinstance(arguments, str) else _written(arguments)
    if len(text) > MAX_CHARACTERS:
        raise refuse(
            RULE,
            f"The arguments have {len(text)} characters; at most {MAX_CHARACTERS} are read.",
            hint="Use several calls.",
        )
    _check_nesting(text)
    try:
        parsed = json.loads(text or "{}", object_pairs_hook=_once, parse_constant=_no_constant, parse_float=_finite)
    except json.JSONDecodeError as error:
        near = text[max(0, error.pos - 20) : error.pos + 20]
        message = f"The arguments are not JSON: {error.msg} at character {error.pos + 1}, near {near!r}."
        raise refuse(RULE, message, hint=_ACCEPTED) from None
    except (ValueError, RecursionError) as error:
        raise refuse(RULE, f"The arguments are not JSON: {error}.", hint=_ACCEPTED) from None
    if not isinstance(parsed, dict):
        raise refuse(RULE, f"The arguments are {kind_of_json(parsed)}, not an object.", hint=_ACCEPTED)
    _check_letters(parsed)
    return parsed


def kind_of_json(value: object) -> str:
    """What a JSON value is, in words."""
    names = {
        bool: "true or false",
        str: "a text",
        int: "a number",
        float: "a number",
        list: "a list",
        dict: "an object",
    }
    return "null" if value is None else names.get(type(value), type(value).__name__)


def _written(arguments: Mapping[str, Any]) -> str:
    try:
        return json.dumps(dict(arguments), allow_nan=False)
    except (TypeError, ValueError, RecursionError) as error:
        raise refuse(RULE, f"The arguments cannot be written as JSON: {error}.", hint=_ACCEPTED) from None


def _check_nesting(text: str) -> None:
    """Refuse deep nesting before a parser descends into it."""
    depth, quoted, escaped = 0, False, False
    for letter in text:
        if escaped:
            escaped = False
        elif quoted:
            escaped, quoted = letter == "\\", letter != '"'
        elif letter == '"':
            quoted = True
        elif letter in "[{":
            depth += 1
            if depth > MAX_NESTING:
                raise refuse(RULE, f"The arguments are nested more than {MAX_NESTING} levels deep.", hint=_ACCEPTED)
        elif letter in "]}":
            depth -= 1


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    items = dict(pairs)
    if len(items) < len(pairs):
        seen: set[str] = set()
        twice = next(key for key, _ in pairs if key in seen or seen.add(key))  # type: ignore[func-returns-value]
        raise ValueError(f"key {quoted(twice)} stands twice")
    return items


def _no_constant(name: str) -> NoReturn:
    raise ValueError(f"{name} is not a number of JSON")


def _finite(text: str) -> float:
    number = float(text)
    if not math.isfinite(number):
        raise ValueError(f"{text[:40]} is too large a number")
    return number


def _check_letters(parsed: dict[str, Any]) -> None:
    stack: list[Any] = [parsed]
    while stack:
        value = stack.pop()
        if isinstance(value, dict):
            stack.extend(value)
            stack.extend(value.values())
        elif isinstance(value, list):
            stack.extend(value)
        elif isinstance(value, str) and any("\ud800" <= letter <= "\udfff" for letter in value):
            raise refuse(
                RULE,
                f"The text {quoted(value)} holds half a character (a lone surrogate).",
                hint="Send whole characters.",
            )
