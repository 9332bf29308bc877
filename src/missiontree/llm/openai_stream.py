"""The body of an answer as the JSON objects it consists of: one if it came whole, many if it came piece by piece."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from typing import Any

from missiontree.llm.chat import ProviderError

EVENTS = "text/event-stream"
DONE = "[DONE]"
_MOST_LINES = 50
_STARTS_OF_EVENTS = (b"data:", b"event:", b"id:", b":")


def objects_of(content_type: str, body: Iterable[bytes]) -> Iterator[dict[str, Any]]:
    """
    The objects, as they come in.

    Parameters
    ----------
    content_type
        The header of that name. What it leaves open, the body's first letters decide.
    body
        The body, in pieces cut anywhere.

    Raises
    ------
    ProviderError
        ``failed``, if the body is something else; ``empty``, if there is nothing in it.
    """
    media = content_type.partition(";")[0].strip().casefold()
    pieces = iter(body)
    if media == EVENTS:
        yield from _events(pieces)
    elif media == "application/json" or media.endswith("+json"):
        yield _object(b"".join(pieces).decode("utf-8", "replace"))
    elif media in {"", "text/plain", "application/octet-stream", "application/x-ndjson"}:
        first = b""
        for piece in pieces:
            first += piece
            if len(first.lstrip()) >= max(map(len, _STARTS_OF_EVENTS)):
                break
        if first.lstrip().startswith(_STARTS_OF_EVENTS):
            yield from _events(_chained(first, pieces))
        else:
            yield _object((first + b"".join(pieces)).decode("utf-8", "replace"))
    else:
        raise no_json(f"The answer is {'a web page' if media == 'text/html' else 'of another type'}, not JSON.")


def no_json(what: str) -> ProviderError:
    """The error of an answer that is none."""
    hint = "Is a proxy or a login page in between, and is the base URL right? It commonly ends in /v1."
    return ProviderError(what, "failed", hint)


def _chained(first: bytes, rest: Iterator[bytes]) -> Iterator[bytes]:
    yield first
    yield from rest


def _object(text: str) -> dict[str, Any]:
    if not text.strip():
        raise ProviderError("The answer has no body.", "empty", "Try again.")
    try:
        value = json.loads(text.removeprefix("\ufeff"))
    except (ValueError, RecursionError):
        raise no_json("The answer is called JSON and is none.") from None
    if not isinstance(value, dict):
        raise no_json("The answer is JSON, but not an object.")
    return value


def _events(pieces: Iterator[bytes]) -> Iterator[dict[str, Any]]:
    """
    The data of server-sent events. Each line of data is taken as soon as it is a whole object, since some servers leave out the blank
    line that ends an event; what is not whole when the stream ends was cut off, and nothing is made of it.
    """
    event, data = "", list[str]()
    for line in _lines(pieces):
        name, _, value = line.partition(":")
        value = value.removeprefix(" ")
        if name == "event":
            event = value.strip()
        elif name == "data":
            if value.strip() == DONE:
                yield {DONE: True}
                return
            if not value.strip():
                continue
            data.append(value)
            whole = _whole("\n".join(data))
            if whole is not None:
                yield {"error": whole} if event == "error" and "error" not in whole else whole
                data = []
            elif len(data) > _MOST_LINES:
                break
        elif not line:
            event = ""
            if data:
                break
    else:
        return
    raise no_json("A piece of the stream is not a JSON object.")


def _whole(text: str) -> dict[str, Any] | None:
    try:
        value = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return value if isinstance(value, dict) else None


def _lines(pieces: Iterator[bytes]) -> Iterator[str]:
    """Lines, ended by LF, CR LF or CR; the last one may lack its end."""
    held: list[bytes] = []
    after_cr = False
    for piece in pieces:
        rest = piece[1:] if after_cr and piece.startswith(b"\n") else piece
        after_cr = piece.endswith(b"\r")
        parts = rest.replace(b"\r\n", b"\n").replace(b"\r", b"\n").split(b"\n")
        for part in parts[:-1]:
            yield _text([*held, part])
            held = []
        held.append(parts[-1])
    if last := _text(held):
        yield last


def _text(held: list[bytes]) -> str:
    return b"".join(held).decode("utf-8", "replace").removeprefix("\ufeff")
