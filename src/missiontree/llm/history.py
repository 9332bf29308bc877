"""
A dialogue in the form that providers take back.

What a model said is kept as it said it, in the transcript; some of it no endpoint accepts as history, or takes the dialogue down
with a fault of its own: arguments that are no JSON object, names that are no names, lone surrogates, two messages of the user in a
row (chat templates of many open models insist on turns), an assistant's message of nothing, and the user right after a tool.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from dataclasses import replace

from missiontree.llm.chat import Message, ToolCall

NAME = re.compile(r"[A-Za-z0-9_-]{1,64}")
NOT_A_NAME = "not_a_function"
NO_WORDS = "(no words)"


def sendable(messages: Iterable[Message]) -> tuple[Message, ...]:
    """The messages with whatever an endpoint would reject put into a form that it takes; a model's own mistakes stay answered."""
    sent: list[Message] = []
    for message in messages:
        empty = message.speaker == "assistant" and not message.calls and not message.text.strip()
        if empty and not (sent and sent[-1].speaker == "tool"):
            continue
        text = NO_WORDS if empty else readable(message.text)  # some endpoints take no user after a tool
        clean = replace(message, text=text, calls=tuple(_call(call) for call in message.calls))
        if sent and sent[-1].speaker == clean.speaker and clean.speaker in {"user", "assistant"} and not sent[-1].calls:
            before = sent.pop()
            clean = replace(clean, text="\n\n".join(filter(None, (before.text, clean.text))))
        sent.append(clean)
    return tuple(sent)


def arguments_of(call: ToolCall) -> dict[str, object]:
    """The arguments of a call as an object; of none if they are not one."""
    try:
        given = json.loads(call.arguments or "{}", parse_constant=_refused)
        json.dumps(given)  # what can be read just so may be too deep to be written
    except (ValueError, RecursionError):
        return {}
    return given if isinstance(given, dict) else {}


def readable(text: str) -> str:
    """The text without what UTF-8 cannot write."""
    return text.encode("utf-8", "replace").decode("utf-8")


def _call(call: ToolCall) -> ToolCall:
    """The call with a name and arguments that can be sent; arguments that could not are left out, as the answer to it says."""
    arguments = json.dumps(arguments_of(call), ensure_ascii=False)
    name = call.name if NAME.fullmatch(call.name) else NOT_A_NAME
    return replace(call, name=name, arguments=readable(arguments))


def _refused(constant: str) -> float:
    raise ValueError(f"{constant} is not JSON.")
