"""
What only a provider understands, and where in its message it stands: thoughts, their signatures, ids of its own.

Kept as text, a list of pieces in the order in which they came: a piece of text, a call, or a thought. Calls are kept by position, for
the dialogue may give them ids of its own. A message may have changed since, or come from elsewhere; then what is certain goes before.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.history import readable


@dataclass(frozen=True, slots=True)
class Piece:
    """
    A piece of an assistant's message.

    Parameters
    ----------
    kind
        What it is.
    text
        The text of a ``text``, the provider's own id of a ``call``, empty for a ``thought``.
    own
        What only the provider understands of it, as text.
    call
        The call, when the piece is laid beside a message.
    """

    kind: Literal["text", "call", "thought"]
    text: str = ""
    own: str = ""
    call: ToolCall | None = None


def native_of(provider: str, pieces: Sequence[Piece]) -> str:
    """The pieces as ``Message.native``."""
    return json.dumps({"of": provider, "pieces": [[piece.kind, piece.text, piece.own] for piece in pieces]})


def pieces_of(provider: str, message: Message, between: str) -> tuple[Piece, ...]:
    """
    An assistant's message in pieces, in the order in which its provider said them.

    Parameters
    ----------
    provider
        Who is to take it; what another one kept is left out.
    message
        The message.
    between
        What the message has between pieces of text.
    """
    kept = _read(provider, message.native)
    calls = iter(message.calls)
    if sum(piece.kind == "call" for piece in kept) != len(message.calls):
        kept = [piece for piece in kept if piece.kind != "call"] + [Piece("call") for _ in message.calls]
    if between.join(piece.text for piece in kept if piece.kind == "text") != message.text:
        kept = list(_with_text(kept, message.text))
    return tuple(Piece("call", piece.text, piece.own, next(calls)) if piece.kind == "call" else piece for piece in kept)


def _with_text(pieces: Sequence[Piece], text: str) -> Iterator[Piece]:
    """The pieces with that text in the place of all theirs: before the first call, after the thoughts that led to it."""
    without = [piece for piece in pieces if piece.kind != "text"]
    first = next((number for number, piece in enumerate(without) if piece.kind == "call"), len(without))
    yield from without[:first]
    if text.strip():
        yield Piece("text", text)
    yield from without[first:]


def _read(provider: str, native: str) -> list[Piece]:
    """The pieces that were kept; none if they are another provider's or damaged."""
    try:
        kept: Any = json.loads(native) if native else {}
        if kept.get("of") != provider:
            return []
        return [Piece(_kind(kind), readable(text), readable(own)) for kind, text, own in kept["pieces"]]
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return []


def _kind(given: Any) -> Literal["text", "call", "thought"]:
    if given not in ("text", "call", "thought"):
        raise ValueError(f"{given!r} is no kind of piece.")
    return given  # type: ignore[no-any-return]
