"""Calls put together from deltas, whatever an endpoint numbers and repeats."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from missiontree.llm.chat import ToolCall

_BESIDE = "extra_content"
"""Where endpoints put signatures of thoughts, which have to come back with the call."""


_LONGEST_ID = 64


@dataclass(slots=True)
class CallPart:
    """One call as far as it has come in."""

    id: str = ""
    name: str = ""
    arguments: str = ""
    index: int | None = None
    beside: dict[str, Any] = field(default_factory=dict)

    @property
    def whole(self) -> bool:
        """Whether the arguments are a whole JSON object, which nothing can follow."""
        try:
            return isinstance(json.loads(self.arguments), dict)
        except (ValueError, RecursionError):
            return False


class CallParts:
    """The calls of one answer, in the order in which they began."""

    def __init__(self) -> None:
        self.parts: list[CallPart] = []

    def add(self, delta: Mapping[str, Any], *, whole: bool) -> None:
        """
        Take in a delta.

        Parameters
        ----------
        delta
            An entry of ``tool_calls``.
        whole
            Whether entries are whole calls, not deltas.
        """
        function = delta.get("function")
        function = function if isinstance(function, Mapping) else {}
        given = _Delta(_text(delta.get("id")), _text(function.get("name")), _arguments(function.get("arguments")))
        index = delta.get("index") if isinstance(delta.get("index"), int) else None
        part = None if whole else self._meant(given, index)
        if part is None:
            part = CallPart(index=index)
            self.parts.append(part)
        part.id = part.id or given.id
        if delta.get(_BESIDE) is not None:
            part.beside[_BESIDE] = delta[_BESIDE]
        part.name = given.name if given.name.startswith(part.name) else part.name + given.name
        if not (given.arguments == part.arguments and part.whole):
            part.arguments += given.arguments

    def calls(self) -> tuple[ToolCall, ...]:
        """
        The calls, each with an id of its own.

        One that came without, or with one that is none or another's, is given nine letters and digits, a form that every endpoint takes.
        """
        used: set[str] = set()
        made = []
        for number, part in enumerate(self.parts, start=1):
            name = part.id if _is_id(part.id) and part.id not in used else f"call{number:05d}"
            used.add(name)
            made.append(ToolCall(name, part.name, part.arguments))
        return tuple(made)

    def _meant(self, given: _Delta, index: int | None) -> CallPart | None:
        """The call that a delta goes on with; None if it begins another."""
        if not self.parts:
            return None
        if index is not None:
            part = next((part for part in reversed(self.parts) if part.index == index), None)
        else:
            part = next((part for part in self.parts if given.id and part.id == given.id), self.parts[-1])
        if part is None or not given.name or given.id == part.id != "":
            return part  # a delta without a name never begins a call: some endpoints make up an id for each
        if given.id and part.id:
            return None
        # No id tells calls apart. A name that comes again is a repetition, unless what it names is whole and more comes.
        repeated = given.name == part.name and not (part.whole and given.arguments.strip())
        growing = not part.arguments and index is not None and given.name != part.name
        return part if repeated or growing else None


@dataclass(frozen=True, slots=True)
class _Delta:
    id: str
    name: str
    arguments: str


def _text(value: Any) -> str:
    return value if isinstance(value, str) else ""


def _is_id(text: str) -> bool:
    return 0 < len(text) <= _LONGEST_ID and text.isascii() and text.isprintable()


def _arguments(value: Any) -> str:
    """Arguments are JSON as text; some endpoints send the JSON itself."""
    if value is None or isinstance(value, str):
        return value or ""
    try:
        return json.dumps(value, ensure_ascii=False)
    except RecursionError:  # what could be read just so may be too deep to be written
        return "nested too deep"
