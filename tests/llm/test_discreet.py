"""A key that an endpoint sends back goes no further."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.llm.chat import Message, Tool, ToolCall
from missiontree.llm.discreet import Discreet

KEY = "sk-0123456789"


def echo(messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
    return Message("assistant", f"I saw {KEY}!", (ToolCall("1", KEY, f'{{"a": "{KEY}"}}'),))


def test_keys_are_taken_out_of_text_names_and_arguments() -> None:
    said = Discreet(echo, [KEY])((), ())
    assert said.text == "I saw [a key was here]!"
    assert said.calls[0] == ToolCall("1", "[a key was here]", '{"a": "[a key was here]"}')


def test_texts_that_are_too_short_for_keys_stay() -> None:
    """An empty variable of the environment must not turn every gap between letters into a key."""
    assert Discreet(echo, ["", "saw"])((), ()).text == f"I saw {KEY}!"
