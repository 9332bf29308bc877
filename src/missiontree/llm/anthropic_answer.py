"""Anthropic's answer as a message, whether it comes whole or in events."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from missiontree.llm.anthropic_request import BETWEEN, NAME, THOUGHTS, Block
from missiontree.llm.chat import Finish, Message, ToolCall, Usage
from missiontree.llm.http_faults import BrokenOffError, MalformedError
from missiontree.llm.native import Piece, native_of
from missiontree.llm.rounds import named_apart

_FINISH: Mapping[str, Finish] = {
    "max_tokens": "length",
    "model_context_window_exceeded": "length",
    "refusal": "refused",
}
_GROWS = {
    "text_delta": "text",
    "thinking_delta": "thinking",
    "signature_delta": "signature",
    "input_json_delta": "json",
}
_COUNTS = ("input_tokens", "cache_creation_input_tokens", "cache_read_input_tokens", "output_tokens")


@dataclass
class Answer:
    """An answer while it comes in."""

    _blocks: dict[int, Block] = field(default_factory=dict)
    _usage: dict[str, int] = field(default_factory=dict)
    _stop: str = ""
    _explanation: str = ""
    _ended: bool = False

    def take_whole(self, plain: Any) -> str:
        """Take an answer that comes in one; gives its text."""
        message = _object(plain)
        if message.get("type") != "message" or not isinstance(message.get("content"), list):
            raise MalformedError("This is no message.")
        texts = [self._open(index, _object(block)) for index, block in enumerate(message["content"])]
        self._count(message.get("usage"))
        self._stopped(message)
        self._ended = True
        return BETWEEN.join(text for text in texts if text)

    def take(self, event: Any) -> str:
        """Take one event of a stream; gives the text that came with it. Events of unknown kinds are none of ours."""
        plain = _object(event)
        kind = plain.get("type")
        if kind == "message_start":
            self._count(_object(plain.get("message")).get("usage"))
        elif kind == "content_block_start":
            return self._open(_index(plain), _object(plain.get("content_block")))
        elif kind == "content_block_delta":
            return self._grow(_index(plain), _object(plain.get("delta")))
        elif kind == "message_delta":
            self._count(plain.get("usage"))
            self._stopped(_object(plain.get("delta")))
        elif kind == "message_stop":
            self._ended = True
        return ""

    def message(self, dialogue: Sequence[Message]) -> Message:
        """
        The answer, when it is whole.

        Raises
        ------
        BrokenOffError
            If it is not.
        """
        if not (self._ended and self._stop):
            raise BrokenOffError
        blocks = [self._blocks[index] for index in sorted(self._blocks)]
        asked = [block for block in blocks if block["type"] == "tool_use"]
        ids = named_apart([_text(block, "id") for block in asked], dialogue)
        finish = _FINISH.get(self._stop, "stop")
        text = BETWEEN.join(piece.text for piece in _pieces(blocks) if piece.kind == "text")
        return Message(
            "assistant",
            self._explanation if finish == "refused" and not text.strip() else text,
            tuple(
                ToolCall(name, _text(block, "name"), _arguments(block)) for name, block in zip(ids, asked, strict=True)
            ),
            finish=finish,
            usage=self._counted(),
            native=native_of(NAME, _pieces(blocks)) if any(block["type"] in THOUGHTS for block in blocks) else "",
        )

    def _open(self, index: int, block: Block) -> str:
        self._blocks[index] = {**block, "type": _text(block, "type")}
        return _text(block, "text") if block.get("type") == "text" else ""

    def _grow(self, index: int, delta: Block) -> str:
        kind = _text(delta, "type")
        if kind not in _GROWS:
            return ""
        if (block := self._blocks.get(index)) is None:
            raise MalformedError("A block goes on that never began.")
        name = _GROWS[kind]
        more = _text(delta, "partial_json" if name == "json" else name)
        block[name] = _text(block, name) + more
        return more if name == "text" else ""

    def _count(self, usage: Any) -> None:
        """Take counts; those of a later event are totals, and those it leaves out stay."""
        for name in _COUNTS:
            if isinstance(usage, dict) and isinstance(count := usage.get(name), int) and count >= 0:
                self._usage[name] = count

    def _counted(self) -> Usage | None:
        if not self._usage:
            return None
        return Usage(sum(self._usage.get(name, 0) for name in _COUNTS[:-1]), self._usage.get("output_tokens", 0))

    def _stopped(self, plain: Block) -> None:
        self._stop = _text(plain, "stop_reason") or self._stop
        if isinstance(details := plain.get("stop_details"), dict):
            self._explanation = _text(details, "explanation")


def _pieces(blocks: Iterable[Block]) -> list[Piece]:
    """Text, calls and thoughts; blocks of other kinds come of tools that are not on offer here."""
    pieces = []
    for block in blocks:
        if block["type"] == "text" and _text(block, "text"):
            pieces.append(Piece("text", _text(block, "text")))
        elif block["type"] == "tool_use":
            pieces.append(Piece("call", _text(block, "id")))
        elif block["type"] in THOUGHTS:
            pieces.append(Piece("thought", own=json.dumps(block)))
    return pieces


def _arguments(block: Block) -> str:
    """The arguments as the model wrote them, if they came as text; a stream may also bring them whole at the start."""
    if written := _text(block, "json"):
        return written
    return json.dumps(_object(block.get("input") or {}), ensure_ascii=False)


def _object(plain: Any) -> Block:
    if not isinstance(plain, dict):
        raise MalformedError("Something is no object where one is expected.")
    return plain


def _index(plain: Block) -> int:
    if not isinstance(index := plain.get("index"), int):
        raise MalformedError("A block has no index.")
    return index


def _text(plain: Block, name: str) -> str:
    """A text that may be missing; nothing else may stand in its place."""
    text = plain.get(name)
    if text is None:
        return ""
    if not isinstance(text, str):
        raise MalformedError(f"{name} is no text.")
    return text
