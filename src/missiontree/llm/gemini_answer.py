"""Gemini's answer as a message, whether it comes whole or in chunks."""

from __future__ import annotations

import base64
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from missiontree.llm.chat import Finish, Message, ToolCall, Usage
from missiontree.llm.gemini_request import NAME
from missiontree.llm.http_faults import BrokenOffError
from missiontree.llm.native import Piece, native_of
from missiontree.llm.rounds import named_apart

_FINISH: Mapping[str, Finish] = {
    "STOP": "stop",
    "FINISH_REASON_UNSPECIFIED": "stop",
    "MAX_TOKENS": "length",
    "CONTINUATION": "length",
}
_WITHOUT_ANSWER = frozenset(
    {"MALFORMED_FUNCTION_CALL", "UNEXPECTED_TOOL_CALL", "TOO_MANY_TOOL_CALLS", "MALFORMED_RESPONSE"}
)
"""Ends of answers that the model spoilt; asked again, it may do better."""
UNSIGNED_REASON = "MISSING_THOUGHT_SIGNATURE"


class EmptyError(Exception):
    """There is no answer in the answer."""


class UnsignedError(Exception):
    """A call in the dialogue lacks the signature that the model wants."""


@dataclass
class Answer:
    """An answer while it comes in. Of several candidates the first counts."""

    _pieces: list[Piece] = field(default_factory=list)
    _calls: list[Any] = field(default_factory=list)
    _usage: Any = None
    _reason: str = ""
    _blocked: bool = False
    _began: bool = False

    def take(self, response: Any) -> str:
        """Take an answer or a chunk of one, as the SDK reads it; gives its text."""
        self._usage = response.usage_metadata or self._usage
        self._blocked |= bool(response.prompt_feedback and response.prompt_feedback.block_reason)
        if not response.candidates:
            return ""
        self._began = True
        candidate = response.candidates[0]
        if candidate.finish_reason:
            self._reason = str(candidate.finish_reason.value)
        parts = candidate.content.parts if candidate.content else None
        return "".join(self._part(part) for part in parts or ())

    def message(self, dialogue: Sequence[Message]) -> Message:
        """
        The answer, when it is whole.

        Raises
        ------
        BrokenOffError
            If it is not.
        EmptyError
            If there is none: no candidate, or a call that nobody can read.
        UnsignedError
            If a signature is missing in the dialogue.
        """
        if self._blocked and not self._began:
            return Message("assistant", finish="filtered", usage=self._counted())
        if not self._began or self._reason in _WITHOUT_ANSWER:
            raise EmptyError(self._reason)
        if not self._reason:
            raise BrokenOffError
        if self._reason == UNSIGNED_REASON:
            raise UnsignedError
        ids = named_apart([call.id or "" for call in self._calls], dialogue)
        return Message(
            "assistant",
            "".join(piece.text for piece in self._pieces if piece.kind == "text"),
            tuple(
                ToolCall(name, call.name or "", _arguments(call)) for name, call in zip(ids, self._calls, strict=True)
            ),
            finish=_FINISH.get(self._reason, "filtered"),
            usage=self._counted(),
            native=self._native(),
        )

    def _part(self, part: Any) -> str:
        own = base64.b64encode(part.thought_signature).decode() if part.thought_signature else ""
        if part.function_call is not None:
            self._calls.append(part.function_call)
            self._pieces.append(Piece("call", part.function_call.id or "", own))
            return ""
        if part.text is None:
            return ""
        kind: Literal["text", "thought"] = "thought" if part.thought else "text"
        last = self._pieces[-1] if self._pieces else None
        # Chunks of one text make one part again, but a signature belongs to the part that it came with.
        if last and last.kind == kind and not last.own and not own:
            self._pieces[-1] = Piece(kind, last.text + part.text)
        else:
            self._pieces.append(Piece(kind, part.text, own))
        return part.text if kind == "text" else ""

    def _counted(self) -> Usage | None:
        usage = self._usage
        if usage is None:
            return None
        # Tokens out of a cache are counted as tokens of the prompt already.
        sent = (usage.prompt_token_count, usage.tool_use_prompt_token_count)
        made = (usage.candidates_token_count, usage.thoughts_token_count)
        return Usage(sum(max(0, count or 0) for count in sent), sum(max(0, count or 0) for count in made))

    def _native(self) -> str:
        kept = any(
            piece.own or piece.kind == "thought" or (piece.kind == "call" and piece.text) for piece in self._pieces
        )
        return native_of(NAME, self._pieces) if kept else ""


def _arguments(call: Any) -> str:
    return json.dumps(call.args or {}, ensure_ascii=False)
