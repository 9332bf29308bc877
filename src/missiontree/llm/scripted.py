"""The stand-in that obeys a script: turns written by hand, or a function."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from missiontree.llm.chat import Message, Tool, ToolCall

Turn = Sequence[tuple[str, str | Mapping[str, Any]]]
Player = Callable[[Sequence[Message], Sequence[Tool]], Turn]


class ScriptedModel:
    """
    A chat model without a model.

    Parameters
    ----------
    script
        Turns, each a list of (tool, arguments); after the last one nothing more is called. Or a function that is shown the dialogue
        and the tools and answers with such a turn. Arguments that are texts go over the wire as they are, however malformed.
    """

    def __init__(self, script: Sequence[Turn] | Player) -> None:
        self._script = script
        self._turn = 0

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Say the next turn."""
        calls = self._next(messages, tools)
        self._turn += 1
        return Message(
            "assistant", calls=tuple(self._call(number, *call) for number, call in enumerate(calls, start=1))
        )

    def _next(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Turn:
        if callable(self._script):
            return self._script(messages, tools)
        return self._script[self._turn] if self._turn < len(self._script) else ()

    def _call(self, number: int, name: str, arguments: str | Mapping[str, Any]) -> ToolCall:
        text = arguments if isinstance(arguments, str) else json.dumps(dict(arguments), ensure_ascii=False)
        return ToolCall(f"call-{self._turn}-{number}", name, text)
