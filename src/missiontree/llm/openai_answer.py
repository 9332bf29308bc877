"""
An answer put together from the objects it came in, one or many.

Endpoints differ in how they cut an answer: calls with an index, without one, or all with the index 0; a call in many deltas or in one;
id and name once or in every delta, or a new id in each; nulls and empty texts anywhere.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from missiontree.llm.chat import FaultKind, Finish, Listener, Message, ProviderError, Usage
from missiontree.llm.openai_calls import CallParts
from missiontree.llm.openai_native import THOUGHTS, native_of
from missiontree.llm.openai_stream import DONE

_FINISH: dict[str, Finish] = {
    "length": "length",
    "max_tokens": "length",
    "model_length": "length",
    "content_filter": "filtered",
    "safety": "filtered",
    "refusal": "refused",
}
_BROKEN_OFF = frozenset({"error", "abort", "cancelled", "insufficient_system_resource"})
_THOUGHTS = (THOUGHTS, "reasoning")


class Answer:
    """
    An answer while it is coming in.

    Parameters
    ----------
    listen
        Told each piece of text and of thought.
    """

    def __init__(self, listen: Listener) -> None:
        self._listen = listen
        self._text: list[str] = []
        self._refusal: list[str] = []
        self._thoughts: list[str] = []
        self._calls = CallParts()
        self._finish: str | None = None
        self._usage: Usage | None = None
        self._part_seen = self._choices_seen = self._choice_seen = self._whole = self._done = False

    def add(self, part: Mapping[str, Any]) -> None:
        """
        Take in one object.

        Raises
        ------
        ProviderError
            ``failed``, if it is not of the form of chat completions.
        """
        if DONE in part:
            self._done = True
            return
        self._part_seen = True
        if isinstance(part.get("usage"), Mapping):
            self._usage = _usage(part["usage"])
        if "choices" not in part:
            return
        self._choices_seen = True
        choices = _a(list, part["choices"] or [], "choices")
        for choice in choices:
            if _a(dict, choice, "choices[0]").get("index") in (None, 0):
                self._choice_seen = True
                self._take(choice)
                break

    def message(self) -> Message:
        """
        The whole answer.

        Raises
        ------
        ProviderError
            ``empty``, ``cut_off`` or ``failed``, if there is none.
        """
        self._check_there_is_one()
        finish = _FINISH.get((self._finish or "").casefold(), "stop")
        refusal = "".join(self._refusal)
        if refusal.strip():
            finish = "refused"
        text = refusal if finish == "refused" and refusal else "".join(self._text)
        calls = self._calls.calls()
        native = native_of("".join(self._thoughts), [part.beside for part in self._calls.parts])
        return Message("assistant", text, calls, finish=finish, usage=self._usage, native=native)

    def _check_there_is_one(self) -> None:
        if self._choice_seen:
            if (self._finish is None and not self._whole) or (self._finish or "").casefold() in _BROKEN_OFF:
                raise _no_answer("The answer was cut off: it ended without saying that it is finished.", "cut_off")
        elif self._choices_seen or (self._done and not self._part_seen):
            raise _no_answer("The answer is empty: it has no choices.", "empty")
        elif self._part_seen:
            raise _wrong_shape("it has no choices")
        else:
            raise _no_answer("The answer was cut off before it began.", "cut_off")

    def _take(self, choice: Mapping[str, Any]) -> None:
        said = choice.get("delta")
        if said is None:
            said = choice.get("message")
            self._whole = self._whole or said is not None
        reason = choice.get("finish_reason")
        if isinstance(reason, str) and reason:
            self._finish = reason
        if said is None:
            return
        said = _a(dict, said, "the message")
        if thought := next((said[name] for name in _THOUGHTS if said.get(name) and isinstance(said[name], str)), ""):
            self._listen(thought)
        if isinstance(thought := said.get(THOUGHTS), str):
            self._thoughts.append(thought)
        if text := _text(said.get("content")):
            self._text.append(text)
            self._listen(text)
        if isinstance(refusal := said.get("refusal"), str):
            self._refusal.append(refusal)
        for number, call in enumerate(_a(list, said.get("tool_calls") or [], "tool_calls")):
            self._calls.add(_a(dict, call, f"tool_calls[{number}]"), whole=self._whole)


def _text(content: Any) -> str:
    """Content is a text, null, or a list of parts of which some are texts."""
    if content is None or isinstance(content, str):
        return content or ""
    parts = [_a(dict, part, "a part of the content") for part in _a(list, content, "content")]
    return "".join(part["text"] for part in parts if isinstance(part.get("text"), str))


def _usage(given: Mapping[str, Any]) -> Usage | None:
    sent, received = given.get("prompt_tokens"), given.get("completion_tokens")
    if isinstance(sent, int) and isinstance(received, int) and min(sent, received) >= 0:
        return Usage(sent, received, _money(given.get("cost")))
    return None


def _money(cost: Any) -> float | None:
    """An amount that can be one; JSON has numbers of any size, and Python's reader takes NaN for one."""
    if not isinstance(cost, int | float):
        return None
    try:
        return float(cost) if 0 <= cost < math.inf else None
    except OverflowError:
        return None


def _a(kind: type[Any], value: Any, what: str) -> Any:
    if not isinstance(value, kind):
        raise _wrong_shape(f"{what} is not {'a list' if kind is list else 'an object'}")
    return value


def _no_answer(what: str, kind: FaultKind) -> ProviderError:
    return ProviderError(what, kind, "Try again; if it stays like that, use another model or server.")


def _wrong_shape(what: str) -> ProviderError:
    hint = "Is it an endpoint of the OpenAI form (Chat Completions)? The base URL commonly ends in /v1."
    return ProviderError(f"The answer is JSON, but not of the form of chat completions: {what}.", "failed", hint)
