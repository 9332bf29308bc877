"""
JSON text to plain data, safely and fast: plans of 100,000 nodes are read through here.

Lines are found only when a message needs one, by a second look at the text.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from missiontree.errors import InputError
from missiontree.formats.parsed import Parsed
from missiontree.formats.place import Path, quoted, where
from missiontree.formats.source import character_name, forbidden
from missiontree.formats.yaml_reader import MAX_DEPTH

_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[\[\]{},]|[^\s\[\]{}:,"]+', re.DOTALL)
_SUSPECT = re.compile(r"\\(?:[bf]|u(?:00[01789]|[dD][89a-fA-F]|[fF]{3}[eEfF]))").search

_NESTING = frozenset((dict, list))


class NotJsonError(Exception):
    """The text is not JSON at all; it may still be YAML."""

    def __init__(self, refusal: InputError) -> None:
        super().__init__(refusal)
        self.refusal = refusal


class _Duplicate(Exception):
    """A key stands twice somewhere."""


class _NotFinite(Exception):
    """NaN or infinity."""


def parse_json(text: str, source: str) -> Parsed:
    """
    Read one JSON document.

    Raises
    ------
    NotJsonError
        If the text is not JSON.
    InputError
        If it is, and uses what is not accepted: duplicate keys, NaN, control characters, more than 64 levels.
    """
    try:
        data = json.loads(text, object_pairs_hook=_once_each, parse_constant=_refuse_constant)
    except _Duplicate:
        raise _duplicate_refusal(text, source) from None
    except _NotFinite as error:
        line = _line(text, re.search(rf"(?<![\w\"]){error}", text))
        raise InputError(f"{error} is not a number", file=source, line=line, accepted="a finite number") from None
    except RecursionError:
        raise _too_deep(source) from None
    except json.JSONDecodeError as error:
        raise NotJsonError(_syntax_refusal(error, text, source)) from None
    except ValueError:
        message = "a number has too many digits"
        raise InputError(message, file=source, accepted="numbers of at most 400 digits") from None
    if isinstance(data, dict | list) and _depth_exceeds(data, MAX_DEPTH):
        raise _too_deep(source)
    parsed = Parsed(data, source, _Lines(text))
    if "\\" in text and _SUSPECT(text):
        _refuse_forbidden(parsed)
    return parsed


@dataclass(frozen=True)
class _Lines:
    """Finds the line of a path, by reading the text again."""

    text: str

    def __call__(self, path: Path) -> int:
        best, line = 0, 1
        for here, offset in places(self.text):
            if len(here) > best and here == path[: len(here)]:
                best, line = len(here), self.text.count("\n", 0, offset) + 1
                if best == len(path):
                    break
        return line


def places(text: str) -> Iterator[tuple[Path, int]]:
    """Path and offset of every key and every list entry of valid JSON, in order."""
    stack: list[_Open] = []
    for token in _TOKEN.finditer(text):
        mark, top = token[0], stack[-1] if stack else None
        if mark in {"]", "}"}:
            stack.pop()
        elif mark == ",":
            assert top is not None
            top.step = top.step + 1 if isinstance(top.step, int) else None
        elif top is not None and top.step is None:
            top.step = str(json.loads(mark))
            yield (*top.path, top.step), token.start()
        else:
            path = () if top is None or top.step is None else (*top.path, top.step)
            if top is not None and isinstance(top.step, int):
                yield path, token.start()
            if mark in {"[", "{"}:
                stack.append(_Open(path, 0 if mark == "[" else None))


@dataclass(slots=True)
class _Open:
    """An open list with the index it is at, or an open mapping with its key, None while one is awaited."""

    path: Path
    step: str | int | None


def _once_each(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    mapping = dict(pairs)
    if len(mapping) != len(pairs):
        raise _Duplicate
    return mapping


def _refuse_constant(name: str) -> Any:
    raise _NotFinite(name)


def _duplicate_refusal(text: str, source: str) -> InputError:
    seen: dict[Path, int] = {}
    for path, offset in places(text):
        line = text.count("\n", 0, offset) + 1
        if path in seen:
            message = f"the key {quoted(str(path[-1]))} stands twice, in lines {seen[path]} and {line}"
            return InputError(message, file=source, line=line, where=where(path[:-1]), accepted="each key once")
        seen[path] = line
    return InputError("a key stands twice", file=source, accepted="each key once")


def _syntax_refusal(error: json.JSONDecodeError, text: str, source: str) -> InputError:
    lines = text.split("\n")
    there = lines[error.lineno - 1].strip() if error.lineno <= len(lines) else ""
    message = f"the text is not JSON here (column {error.colno})" + (f", in {quoted(there)}" if there else "")
    hint = "Check commas, quotes and brackets of this line and the one before."
    return InputError(message, file=source, line=error.lineno, accepted="JSON", hint=hint)


def _too_deep(source: str) -> InputError:
    return InputError("the file is nested too deep", file=source, accepted=f"at most {MAX_DEPTH} levels")


def _depth_exceeds(data: Any, limit: int) -> bool:
    level = [data]
    for _ in range(limit):
        level = [child for node in level for child in _nested(node.values() if isinstance(node, dict) else node)]
        if not level:
            return False
    return True


def _nested(values: Collection[Any]) -> Iterable[Any]:
    """Those that hold values themselves; a long list of numbers is passed over by its types."""
    return () if _NESTING.isdisjoint(map(type, values)) else (value for value in values if type(value) in _NESTING)


def _refuse_forbidden(parsed: Parsed) -> None:
    stack: list[tuple[Path, Any]] = [((), parsed.data)]
    while stack:
        path, node = stack.pop()
        if isinstance(node, dict):
            stack.extend(((*path, key), child) for key, child in node.items())
            stack.extend((path, key) for key in node)
        elif isinstance(node, list):
            stack.extend(((*path, index), child) for index, child in enumerate(node))
        elif isinstance(node, str) and (wrong := forbidden(node)):
            message = f"the text holds {character_name(wrong[0])}"
            raise parsed.refusal(message, path, "text without control characters")


def _line(text: str, match: re.Match[str] | None) -> int:
    return text.count("\n", 0, match.start()) + 1 if match else 0
