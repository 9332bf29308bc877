"""A model of Anthropic's through its SDK, against the API's wire form on loopback."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import pytest

from missiontree.authoring.author import author_tree
from missiontree.llm.anthropic import AnthropicModel
from missiontree.llm.chat import Finish, Message, ProviderError, Tool, ToolCall, Usage
from tests.llm.anthropic_endpoint import KEY, Said, answering, failure, text, thinking, use
from tests.llm.authoring_script import BRING, INIT, NODES, SEARCH, TASKS, paper_brief

HELLO = [Message("system", "You build."), Message("user", "Build.")]
TOOL = Tool("build", "Builds.", {"type": "object", "properties": {"what": {"type": "string"}}, "required": ["what"]})

streaming = pytest.mark.parametrize("stream", [True, False], ids=["stream", "whole"])


@streaming
def test_a_whole_dialogue_builds_the_tree(stream: bool) -> None:
    """Two calls in one turn, two in the next, words to finish, words after a review if there is one; and the API rejects none."""
    script = (
        Said([thinking("Search first.", "sig-1"), text("Two goals."), use(*INIT), use(*TASKS)]),
        Said([use(*SEARCH), use(*BRING)]),
        Said([text("The tree is whole.")]),
        Said([text("Each part is covered.")]),
    )
    with answering(*script, stream=stream) as asked:
        made = author_tree(paper_brief(), asked.model)
    assert (made.status, made.reasons, asked.endpoint.refusals) == ("complete", (), [])
    assert made.tree is not None
    assert [node.id for node in made.tree.nodes] == NODES
    assert made.spent is not None
    turns = len(asked.bodies)
    assert turns >= 3
    # Each answer took 10 tokens in and 5 out.
    assert (made.spent.turns, made.spent.calls) == (turns, 4)
    assert (made.spent.input_tokens, made.spent.output_tokens) == (10 * turns, 5 * turns)
    roles = [message["role"] for message in asked.bodies[-1]["messages"]]
    assert roles == ["user", "assistant"] * (turns - 1) + ["user"]
    results = asked.bodies[1]["messages"][-1]["content"]
    assert [block["type"] for block in results] == ["tool_result", "tool_result"]
    assert all(json.loads(block["content"])["ok"] for block in results)


@streaming
def test_what_is_sent_is_the_dialogue_the_tools_and_the_limits(stream: bool) -> None:
    with answering(Said([text("ok")]), stream=stream, max_output_tokens=77) as asked:
        asked.model(HELLO, [TOOL])
    body = asked.bodies[0]
    assert body.pop("stream", False) is stream
    assert body == {
        "model": "claude-loopback",
        "max_tokens": 77,
        "system": "You build.",
        "messages": [{"role": "user", "content": [text("Build.")]}],
        "tools": [{"name": "build", "description": "Builds.", "input_schema": dict(TOOL.parameters)}],
        "tool_choice": {"type": "auto"},
    }


@streaming
def test_text_is_told_as_it_comes_and_thoughts_are_not(stream: bool) -> None:
    heard: list[str] = []
    said = Said([thinking("secret thought", "s"), text("Good day"), use("build", {}), text("and more")])
    with answering(said, stream=stream, listen=heard.append) as asked:
        message = asked.model(HELLO, [TOOL])
    assert message.text == "Good day\n\nand more"
    # The endpoint streams each text in two halves.
    assert heard == (["Good", " day", "and ", "more"] if stream else ["Good day\n\nand more"])


@streaming
def test_calls_come_with_their_arguments_in_order(stream: bool) -> None:
    arguments = {"what": "Haus für Jürgen", "n": [1, None, {"x": 2.5}]}
    with answering(Said([use("build", arguments, "toolu_A"), use("look", {}, "toolu_B")]), stream=stream) as asked:
        message = asked.model(HELLO, [TOOL])
    assert [(call.id, call.name, json.loads(call.arguments)) for call in message.calls] == [
        ("toolu_A", "build", arguments),
        ("toolu_B", "look", {}),
    ]
    assert message.finish == "stop"


def test_streamed_arguments_stay_as_the_model_wrote_them() -> None:
    """The SDK would complete what was cut; whether it is sound is for the functions to say, and they must see it as it is."""
    with answering(Said([use("build", '{"what": "a ho')], stop_reason="max_tokens")) as asked:
        message = asked.model(HELLO, [TOOL])
    assert (message.calls[0].arguments, message.finish) == ('{"what": "a ho', "length")


@streaming
@pytest.mark.parametrize(
    ("reason", "finish"),
    [
        ("end_turn", "stop"),
        ("stop_sequence", "stop"),
        ("pause_turn", "stop"),
        ("something_new", "stop"),
        ("max_tokens", "length"),
        ("model_context_window_exceeded", "length"),
        ("refusal", "refused"),
    ],
)
def test_how_an_answer_ended_is_told(stream: bool, reason: str, finish: Finish) -> None:
    with answering(Said([text("Well.")], stop_reason=reason), stream=stream) as asked:
        message = asked.model(HELLO, [TOOL])
    assert (message.finish, message.text) == (finish, "Well.")


@streaming
def test_a_refusal_without_words_gives_its_explanation(stream: bool) -> None:
    details = {"type": "refusal", "category": "cyber", "explanation": "This could do harm."}
    with answering(Said([], stop_reason="refusal", stop_details=details), stream=stream) as asked:
        message = asked.model(HELLO, [TOOL])
    assert (message.finish, message.text) == ("refused", "This could do harm.")


@streaming
def test_silence_is_an_answer(stream: bool) -> None:
    """After answers to its calls the model may have nothing to add; asked again it would only be silent again."""
    with answering(Said([]), stream=stream) as asked:
        message = asked.model(HELLO, [TOOL])
    assert (message.text, message.calls, message.finish) == ("", (), "stop")


@streaming
def test_tokens_of_the_cache_count_as_sent(stream: bool) -> None:
    """3 new, 20 written to the cache, 100 read out of it: 123 sent."""
    usage = {
        "input_tokens": 3,
        "cache_creation_input_tokens": 20,
        "cache_read_input_tokens": 100,
        "output_tokens": 9,
    }
    with answering(Said([text("ok")], usage=usage), stream=stream) as asked:
        assert asked.model(HELLO, [TOOL]).usage == Usage(123, 9, None)


@pytest.mark.parametrize(
    ("messages", "choice"),
    [
        ([Message("user", "Go.", must_call=True)], {"type": "any"}),
        ([Message("user", "Go.")], {"type": "auto"}),
        (
            [Message("user", "Go.", must_call=True), Message("assistant", "Yes."), Message("user", "Well?")],
            {"type": "auto"},
        ),
        (
            [
                Message("user", "Go.", must_call=True),
                Message("assistant", calls=(ToolCall("1", "build", "{}"),)),
                Message("tool", "done", call_id="1"),
            ],
            {"type": "auto"},
        ),
    ],
)
def test_only_the_last_word_of_the_user_can_ask_for_a_call(messages: list[Message], choice: dict[str, str]) -> None:
    with answering(Said([text("ok")])) as asked:
        asked.model(messages, [TOOL])
    assert asked.bodies[0]["tool_choice"] == choice


def test_without_tools_there_is_no_choice() -> None:
    with answering(Said([text("ok")])) as asked:
        asked.model([Message("user", "Go.", must_call=True)], [])
    assert not {"tools", "tool_choice"} & set(asked.bodies[0])


@streaming
def test_a_model_that_cannot_be_made_to_call_is_asked_without_and_that_is_remembered(stream: bool) -> None:
    words = "Thinking may not be enabled when tool_choice forces tool use."
    forced = [Message("user", "Go.", must_call=True)]
    with answering(
        failure(400, "invalid_request_error", words), Said([text("a")]), Said([text("b")]), stream=stream
    ) as asked:
        assert [asked.model(forced, [TOOL]).text, asked.model(forced, [TOOL]).text] == ["a", "b"]
    assert [body["tool_choice"]["type"] for body in asked.bodies] == ["any", "auto", "auto"]


def test_other_faults_are_not_asked_away() -> None:
    reply = failure(403, "permission_error", "tool_choice is not for you")
    with answering(reply, Said([text("a")])) as asked, pytest.raises(ProviderError, match="tool_choice"):
        asked.model([Message("user", "Go.", must_call=True)], [TOOL])
    assert len(asked.bodies) == 1


@streaming
def test_texts_without_a_letter_part_nothing(stream: bool) -> None:
    with answering(Said([text(""), text("One."), text(""), text("Two.")]), stream=stream) as asked:
        assert asked.model(HELLO, [TOOL]).text == "One.\n\nTwo."


def test_importing_the_module_does_not_load_the_sdk() -> None:
    program = "import sys, missiontree.llm.anthropic; sys.exit('anthropic' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


def test_without_the_sdk_the_hint_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "anthropic", None)
    with pytest.raises(ProviderError) as fault:
        AnthropicModel("claude-loopback", api_key=KEY)
    assert (fault.value.kind, fault.value.hint) == ("not_installed", "pip install 'missiontree[anthropic]'")


def test_without_a_key_the_hint_names_the_variable() -> None:
    with pytest.raises(ProviderError) as fault:
        AnthropicModel("claude-loopback")
    assert fault.value.kind == "unauthorised"
    assert "ANTHROPIC_API_KEY" in fault.value.hint


def test_the_key_comes_from_the_environment_and_shows_nowhere(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ANTHROPIC_API_KEY", f" {KEY}\n")
    with answering(Said([text("ok")]), api_key=None) as asked:
        message = asked.model(HELLO, [TOOL])
    assert KEY not in repr(asked.model) + repr(vars(asked.model)) + repr(message)


def test_a_listener_may_raise_what_it_will() -> None:
    """Its exception is none of the provider's, so it is not asked again."""

    def stop(piece: str) -> Any:
        raise KeyError(piece)

    with answering(Said([text("Good day")]), listen=stop) as asked, pytest.raises(KeyError):
        asked.model(HELLO, [TOOL])
    assert len(asked.bodies) == 1
