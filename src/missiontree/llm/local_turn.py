"""What a model under the grammar of a turn wrote, read strictly: of that very form, or not at all."""

from __future__ import annotations

import json
import re
from typing import TypeVar

from missiontree.llm.chat import ToolCall

T = TypeVar("T")

_START = '{"thought":'
_WHOLE = re.compile(r'"(?:[^"\\]|\\(?:[^u]|u[0-9A-Fa-f]{4}))*')
_DECODER = json.JSONDecoder()


def read_turn(text: str, turn: int) -> tuple[str, tuple[ToolCall, ...]]:
    """
    The thought and the calls of a turn.

    Parameters
    ----------
    text
        What the model wrote.
    turn
        Which message of the model this is, from 1; ids of calls hold it, so that they are unique in the dialogue.

    Raises
    ------
    ValueError
        If the text is not of the form, to the letter. Nothing is repaired.
    """
    reader = _Reader(text)
    reader.expect(_START)
    thought = reader.read(str)[0]
    reader.expect(',"calls":[')
    calls: list[ToolCall] = []
    while not reader.at("]"):
        reader.expect(',{"name":' if calls else '{"name":')
        name = reader.read(str)[0]
        reader.expect(',"arguments":')
        arguments = reader.read(dict)[1]
        reader.expect("}")
        calls.append(ToolCall(f"call-{turn}-{len(calls) + 1}", name, arguments))
    reader.expect("]}")
    reader.end()
    return thought, tuple(calls)


def thought_in(text: str) -> str:
    """
    The thought of a turn, as far as it is written.

    Parameters
    ----------
    text
        The beginning of a turn. One that does not begin like a turn has no thought.
    """
    found = _WHOLE.match(text, len(_START)) if text.startswith(_START) else None
    if found is None:
        return ""
    thought = json.loads(found[0] + '"', strict=False)
    return str(thought).encode("utf-8", "replace").decode("utf-8")


class _Reader:
    """A text, and how far it is read."""

    def __init__(self, text: str) -> None:
        self._text, self._at = text, 0

    def at(self, what: str) -> bool:
        return self._text.startswith(what, self._at)

    def expect(self, what: str) -> None:
        if not self.at(what):
            raise ValueError(f"{what!r} is expected at character {self._at + 1}, near {self._near()!r}")
        self._at += len(what)

    def read(self, kind: type[T]) -> tuple[T, str]:
        """The JSON value that stands here, and how it is written."""
        start = self._at
        try:
            value, self._at = _DECODER.raw_decode(self._text, start)
        except RecursionError:
            raise ValueError(f"the value at character {start + 1} is nested too deep") from None
        if not isinstance(value, kind):
            raise ValueError(f"{'a text' if kind is str else 'an object'} is expected at character {start + 1}")
        return value, self._text[start : self._at]

    def end(self) -> None:
        if self._at != len(self._text):
            raise ValueError(f"nothing more is expected at character {self._at + 1}, near {self._near()!r}")

    def _near(self) -> str:
        return self._text[max(0, self._at - 20) : self._at + 20]
