"""A dialogue as a request to the Gemini API."""

from __future__ import annotations

import base64
import binascii
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from missiontree.llm.chat import Message, Tool, ToolCall
from missiontree.llm.history import NOT_A_NAME
from missiontree.llm.native import Piece, pieces_of
from missiontree.llm.rounds import Round, plain_arguments, rounds_of

NAME = "gemini"
UNSIGNED = b"skip_thought_signature_validator"
"""The signature that Google documents for calls which the model did not make itself, such as those of another provider."""
_FUNCTION = re.compile(r"[A-Za-z_][A-Za-z0-9_-]{0,63}")

Content = dict[str, Any]
"""A content, in the SDK's form of plain values."""


def contents_of(messages: Sequence[Message], signed: bool) -> tuple[str, list[Content]]:
    """
    The system's text, and what was said.

    Parameters
    ----------
    messages
        The dialogue, from any source.
    signed
        Whether each turn's first call must bear a signature, be it :data:`UNSIGNED`.
    """
    rounds = rounds_of(messages)
    contents: list[Content] = []
    for entry in rounds.said:
        if entry.message.speaker == "user":
            _append(contents, "user", [{"text": entry.message.text}])
            continue
        pieces = pieces_of(NAME, entry.message, "")
        _append(contents, "model", list(_parts(pieces, signed)))
        if entry.answers:
            _append(contents, "user", list(_responses(pieces, entry)))
    return rounds.system, contents


def config_of(system: str, tools: Iterable[Tool], forced: bool, max_output_tokens: int | None) -> dict[str, Any]:
    """
    What is asked for: the functions on offer, and whether one must be called. The SDK is kept from calling or going on by itself.

    Parameters
    ----------
    system
        The system's text.
    tools
        What is on offer.
    forced
        Whether the model must call one of them.
    max_output_tokens
        Most tokens of the answer; the model's own limit if None.
    """
    config: dict[str, Any] = {
        "automatic_function_calling": {"disable": True},
        "automatic_continuation": False,
    }
    if system:
        config["system_instruction"] = system
    if max_output_tokens is not None:
        config["max_output_tokens"] = max_output_tokens
    if declared := [_declaration(tool) for tool in tools]:
        config["tools"] = [{"function_declarations": declared}]
        config["tool_config"] = {"function_calling_config": {"mode": "ANY" if forced else "AUTO"}}
    return config


def _declaration(tool: Tool) -> dict[str, Any]:
    """The function as it is declared; one without parameters needs no schema."""
    declared: dict[str, Any] = {"name": tool.name, "description": tool.description}
    if tool.parameters.get("properties"):
        declared["parameters_json_schema"] = dict(tool.parameters)
    return declared


def _append(contents: list[Content], role: str, parts: list[Content]) -> None:
    if contents and contents[-1]["role"] == role:
        contents[-1]["parts"] += parts
    else:
        contents.append({"role": role, "parts": parts})


def _parts(pieces: Iterable[Piece], signed: bool) -> Iterator[Content]:
    bare = signed  # whether the turn's first call is still to come
    for piece in pieces:
        signature = _signature(piece.own)
        if piece.call is not None:
            signature = signature or (UNSIGNED if bare else None)
            part: Content = {"function_call": _named(piece) | {"args": plain_arguments(piece.call)}}
            bare = False
        elif piece.text.strip() or signature:
            part = {"text": piece.text} | ({"thought": True} if piece.kind == "thought" else {})
        else:
            continue
        yield part | ({"thought_signature": signature} if signature else {})


def _responses(pieces: Iterable[Piece], entry: Round) -> Iterator[Content]:
    called = [piece for piece in pieces if piece.call is not None]
    for piece, text in zip(called, entry.answers, strict=True):
        yield {"function_response": _named(piece) | {"response": _response(text)}}


def _named(piece: Piece) -> Content:
    """The function, and the id if Gemini gave the call one; it knows no others."""
    name = piece.call.name if piece.call is not None else ""
    named = {"name": name if _FUNCTION.fullmatch(name) else NOT_A_NAME}
    return named | ({"id": piece.text} if piece.text else {})


def _response(text: str) -> dict[str, Any]:
    """An answer as the object that the API wants; our answers are objects already."""
    return plain_arguments(ToolCall("", "", text)) or {"output": text}


def _signature(own: str) -> bytes | None:
    try:
        return base64.b64decode(own, validate=True) or None
    except (binascii.Error, ValueError):
        return None
