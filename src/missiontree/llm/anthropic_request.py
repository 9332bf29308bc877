"""A dialogue as a request to Anthropic's Messages API."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence
from typing import Any

from missiontree.llm.chat import Message, Tool
from missiontree.llm.native import Piece, pieces_of
from missiontree.llm.rounds import Round, plain_arguments, rounds_of

Block = dict[str, Any]
"""A content block as it stands on the wire."""

NAME = "anthropic"
BETWEEN = "\n\n"
"""What a message has between its text blocks."""
THOUGHTS = frozenset({"thinking", "redacted_thinking"})
_ID = re.compile(r"[A-Za-z0-9_-]+")


def request_of(messages: Sequence[Message], tools: Iterable[Tool], forced: bool) -> dict[str, Any]:
    """
    What depends on the dialogue: ``system``, ``messages``, ``tools`` and ``tool_choice``.

    No cache is asked for: the tools stand first in what is cached and change with the tree, so most of it would be paid for in vain.

    Parameters
    ----------
    messages
        The dialogue, from any source.
    tools
        What is on offer.
    forced
        Whether the model must call one of them.
    """
    rounds = rounds_of(messages)
    declared = [
        {"name": tool.name, "description": tool.description, "input_schema": dict(tool.parameters)} for tool in tools
    ]
    request: dict[str, Any] = {"messages": _turns(rounds.said)}
    if rounds.system:
        request["system"] = rounds.system
    if declared:
        request |= {"tools": declared, "tool_choice": {"type": "any" if forced else "auto"}}
    return request


def _turns(said: Iterable[Round]) -> list[Block]:
    """Turns of user and assistant, one after the other; answers go first in the user's."""
    turns: list[Block] = []
    ids: set[str] = set()
    for entry in said:
        if entry.message.speaker == "user":
            _append(turns, "user", [{"type": "text", "text": entry.message.text}])
            continue
        blocks = [block for piece in pieces_of(NAME, entry.message, BETWEEN) for block in _block(piece, ids) if block]
        _append(turns, "assistant", blocks)
        asked = [block["id"] for block in blocks if block["type"] == "tool_use"]
        answers = zip(asked, entry.answers, strict=True)
        if asked:
            _append(
                turns, "user", [{"type": "tool_result", "tool_use_id": name, "content": text} for name, text in answers]
            )
    return turns


def _append(turns: list[Block], role: str, blocks: list[Block]) -> None:
    if turns and turns[-1]["role"] == role:
        turns[-1]["content"] += blocks
    else:
        turns.append({"role": role, "content": blocks})


def _block(piece: Piece, ids: set[str]) -> list[Block]:
    """A piece as a content block; as none if it is blank or no longer what it was."""
    if piece.call is not None:
        name = _unused(piece.text or piece.call.id, ids)
        return [{"type": "tool_use", "id": name, "name": piece.call.name, "input": plain_arguments(piece.call)}]
    if piece.kind == "text":
        return [{"type": "text", "text": piece.text}] if piece.text.strip() else []
    try:
        thought = json.loads(piece.own)
    except (ValueError, RecursionError):
        return []
    return [thought] if isinstance(thought, dict) and thought.get("type") in THOUGHTS else []


def _unused(wanted: str, ids: set[str]) -> str:
    """The id if it can be sent and no call before has it, or one in its place."""
    name = wanted if _ID.fullmatch(wanted) else f"call_{len(ids) + 1}"
    while name in ids:
        name += "_"
    ids.add(name)
    return name
