"""
What has to be handed back with a message, word for word: thoughts, and signatures of thoughts beside the calls.

Some endpoints refuse a dialogue in which they do not find again what their model thought before it called.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from missiontree.llm.history import readable

THOUGHTS = "reasoning_content"
_FORM = "chat-completions"
_LONGEST = 200_000


def native_of(thoughts: str, beside: Sequence[Mapping[str, Any]]) -> str:
    """
    The text for ``Message.native``; empty if nothing has to be handed back.

    Parameters
    ----------
    thoughts
        What the model thought. Above 200,000 letters it is not handed back.
    beside
        Per call, in order, what stands beside it.
    """
    kept = thoughts if len(thoughts) <= _LONGEST else ""
    if not kept and not any(beside):
        return ""
    try:
        return readable(json.dumps({"form": _FORM, "thoughts": kept, "beside": list(beside)}, ensure_ascii=False))
    except RecursionError:  # signatures are not that deep
        return ""


def thoughts_of(native: str) -> tuple[dict[str, str], tuple[dict[str, Any], ...]]:
    """What goes into the message, and per call beside it; nothing if the text is empty or another provider's."""
    try:
        read = json.loads(native)
    except (ValueError, RecursionError):
        return {}, ()
    if not isinstance(read, dict) or read.get("form") != _FORM:
        return {}, ()
    return ({THOUGHTS: read["thoughts"]} if read["thoughts"] else {}), tuple(read["beside"])
