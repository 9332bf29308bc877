"""What every turn of a local model is, whoever made the model."""

from __future__ import annotations

import json
from collections.abc import Sequence

import jsonschema

from missiontree.llm.chat import Message, Tool
from missiontree.llm.turn_schema import TurnBounds, turn_schema

SHORT = TurnBounds(thought=8, calls=2, items=2, text=6, number=9)
ASKED = (Message("system", "Plan."), Message("user", "The mission: reunite mom with her child.", must_call=True))


def check(said: Message, tools: Sequence[Tool], must_call: bool) -> None:
    """The message is a turn: only names, ids and entities that were on offer, and of the length allowed."""
    assert (said.speaker, said.finish) == ("assistant", "stop")
    assert said.usage is not None
    assert min(said.usage.input_tokens, said.usage.output_tokens) > 0
    turn = {
        "thought": said.text,
        "calls": [{"name": call.name, "arguments": json.loads(call.arguments)} for call in said.calls],
    }
    jsonschema.Draft202012Validator(turn_schema(tools, must_call=must_call, bounds=SHORT)).validate(turn)
    offered = {tool.name: tool for tool in tools}
    for call in said.calls:
        jsonschema.Draft202012Validator(offered[call.name].parameters).validate(json.loads(call.arguments))
