"""
A dialogue as plain chat, for engines that know no tools: who speaks, and text.

The tools are described in the first message. What the assistant called stands as the JSON it answered with, and the answers to it as
JSON lines from the user. Roles alternate, since the templates of many models insist on it.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby
from typing import Any

from missiontree.llm.chat import Message, Tool, ToolCall
from missiontree.llm.history import arguments_of, sendable

_FORM = """\
Answer with one JSON object and nothing else:
{"thought": "...", "calls": [{"name": "...", "arguments": {...}}]}
Think in thought, in few words. In calls, ask for functions, to be run in that order; an empty list says that you are done."""
_ANSWERS = "What your calls were answered, in order:"


def plain_chat(
    messages: Iterable[Message], tools: Sequence[Tool], *, system_apart: bool = True
) -> list[dict[str, str]]:
    """
    The dialogue in plain roles, ``system``, ``user`` and ``assistant``.

    Parameters
    ----------
    messages
        The dialogue.
    tools
        What may be called in the next turn.
    system_apart
        Whether what the system says is a message of its own; if not, the user's first begins with it. Default true.
    """
    said = sendable(messages)
    told = "\n\n".join([message.text for message in said if message.speaker == "system"] + [told_of(tools)])
    names = {call.id: call.name for message in said for call in message.calls}
    spoken = [("system", told)] if system_apart else [("user", told)]
    for speaker, run in groupby((one for one in said if one.speaker != "system"), key=lambda one: one.speaker):
        if speaker == "assistant":
            spoken += [("assistant", turn_text(message)) for message in run]
        elif speaker == "tool":
            lines = [_answer(message, names) for message in run]
            spoken.append(("user", "\n".join([_ANSWERS, *lines])))
        else:
            spoken += [("user", message.text) for message in run]
    return [
        {"role": role, "content": "\n\n".join(text for _, text in run)}
        for role, run in groupby(spoken, key=lambda one: one[0])
    ]


def turn_text(message: Message) -> str:
    """An assistant's message in the form that it is asked to answer in."""
    return _json({"thought": message.text, "calls": [_call(call) for call in message.calls]})


def told_of(tools: Sequence[Tool]) -> str:
    """
    What the model is told of its form and its tools.

    Values that only this turn allows are not told, since the grammar holds to them, and a first message that stays as it is need not be
    read again at each turn.
    """
    lines = [_FORM, "The functions:" if tools else "There are no functions now."]
    for tool in tools:
        known: Mapping[str, Mapping[str, Any]] = tool.parameters.get("properties", {})
        needed = tool.parameters.get("required", ())
        names = ", ".join(name if name in needed else f"{name}?" for name in known)
        lines.append(f"- {tool.name}({names}): {tool.description}")
        lines += [f"    {name}: {schema['description']}" for name, schema in known.items() if schema.get("description")]
    return "\n".join(lines)


def _call(call: ToolCall) -> dict[str, object]:
    return {"name": call.name, "arguments": arguments_of(call)}


def _answer(message: Message, names: Mapping[str, str]) -> str:
    """An answer as one line of JSON. Text that is none is quoted, so that it cannot pass for words of the user."""
    try:
        answer = json.loads(message.text)
        json.dumps(answer, allow_nan=False)  # what can be read may be no JSON, or too deep to be written
    except (ValueError, RecursionError):
        answer = message.text
    return _json({"answer_to": names.get(message.call_id, ""), "answer": answer})


def _json(plain: Mapping[str, object]) -> str:
    return json.dumps(plain, ensure_ascii=False, separators=(",", ":"))
