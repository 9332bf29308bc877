"""What an error answer says, whatever its form: an object, a text, a list of findings, or a page."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from itertools import islice

_STATUS_OF_TYPE = {
    "authentication_error": 401,
    "invalid_api_key": 401,
    "permission_error": 403,
    "not_found_error": 404,
    "model_not_found": 404,
    "request_too_large": 413,
    "rate_limit_error": 429,
    "rate_limit_exceeded": 429,
    "insufficient_quota": 429,
    "invalid_request_error": 400,
    "badrequesterror": 400,
    "timeout": 504,
}
_DEEPEST, _MOST_TEXTS, _MOST_LETTERS = 8, 50, 20_000
_NOT_ITS_OWN_WORDS = frozenset({"input", "ctx", "url"})


def error_in(body: str) -> object:
    """The error object of a body, or its text if that is a plain one; None if it is a page."""
    try:
        said = json.loads(body)
    except (ValueError, RecursionError):
        return None if body.lstrip().startswith("<") else body[:_MOST_LETTERS]
    if isinstance(said, list) and said:
        said = said[0]
    return said.get("error", said) if isinstance(said, Mapping) else said


def status_in(error: object) -> int:
    """The status that an error object names or stands for. An answer that broke down half-way is the endpoint's own trouble: 500."""
    if isinstance(error, Mapping):
        for name in ("code", "status", "status_code"):
            number = error.get(name)
            if isinstance(number, str) and number.isascii() and number.isdigit():
                number = int(number[:4])
            if isinstance(number, int) and 400 <= number < 600:
                return number
    return next((_STATUS_OF_TYPE[name] for name in names_of(error) if name in _STATUS_OF_TYPE), 500)


def names_of(error: object) -> list[str]:
    """The words by which an error object says what it is."""
    if not isinstance(error, Mapping):
        return []
    return [value.casefold() for key in ("code", "type", "status") if isinstance(value := error.get(key), str)]


def message_of(error: object) -> str:
    """The sentence of an error object; empty if it has none."""
    if isinstance(error, str):
        return error
    message = error.get("message") if isinstance(error, Mapping) else None
    return message if isinstance(message, str) else ""


def texts_of(value: object) -> str:
    """All texts of an error object but what it repeats of the request."""
    return " ".join(islice(_walk(value, 0), _MOST_TEXTS))[:_MOST_LETTERS]


def _walk(value: object, depth: int) -> Iterator[str]:
    if isinstance(value, str):
        yield value[:_MOST_LETTERS]
    elif depth < _DEEPEST and isinstance(value, Mapping):
        for key, entry in value.items():
            if key not in _NOT_ITS_OWN_WORDS:
                yield from _walk(entry, depth + 1)
    elif depth < _DEEPEST and isinstance(value, list):
        for entry in value:
            yield from _walk(entry, depth + 1)
