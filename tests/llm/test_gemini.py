"""A model of Gemini's through Google's SDK, against the API's wire form on loopback."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import pytest

from missiontree.authoring.author import author_tree
from missiontree.authoring.schema import offered_tools
from missiontree.llm.chat import Finish, Message, ProviderError, Tool, ToolCall, Usage
from missiontree.llm.gemini import GeminiModel
from tests.authoring.conftest import begun
from tests.llm.authoring_script import BRING, INIT, NODES, SEARCH, TASKS, paper_brief
from tests.llm.gemini_endpoint import KEY, Said, answering, call, chunk, failure, response_of, text
from tests.llm.loopback import Reply

HELLO = [Message("system", "You build."), Message("user", "Build.")]
TOOL = Tool("build", "Builds.", {"type": "object", "properties": {"what": {"type": "string"}}, "required": ["what"]})
BARE = Tool("look", "Looks.", {"type": "object", "properties": {}, "required": [], "additionalProperties": False})

streaming = pytest.mark.parametrize("stream", [True, False], ids=["stream", "whole"])


@streaming
@pytest.mark.parametrize("strict", [True, False], ids=["signatures wanted", "signatures not looked at"])
def test_a_whole_dialogue_builds_the_tree(strict: bool, stream: bool) -> None:
    """Two calls in one turn, two in the next, words to finish, words after a review if there is one; and the API rejects none."""
    script = (
        Said([text("Two goals."), call(*INIT, signature=b"\xff\xfe sig 1"), call(*TASKS)]),
        Said([call(*SEARCH, signature=b"sig 2", call_id="fc-1"), call(*BRING, call_id="fc-2")]),
        Said([text("The tree is whole.", signature=b"sig 3")]),
        Said([text("Each part is covered.")]),
    )
    with answering(*script, stream=stream, strict=strict) as asked:
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
    roles = [content["role"] for content in asked.bodies[-1]["contents"]]
    assert roles == ["user", "model"] * (turns - 1) + ["user"]
    results = asked.bodies[1]["contents"][-1]["parts"]
    assert [part["functionResponse"]["response"]["ok"] for part in results] == [True, True]


@streaming
def test_what_is_sent_is_the_dialogue_the_tools_and_the_limits(stream: bool) -> None:
    with answering(Said([text("ok")]), stream=stream, max_output_tokens=77) as asked:
        asked.model(HELLO, [TOOL, BARE])
    body = asked.bodies[0]
    assert body.pop("systemInstruction")["parts"] == [{"text": "You build."}]
    declared = body.pop("tools")[0]["functionDeclarations"]
    assert declared[0]["parameters_json_schema"] == TOOL.parameters
    assert declared[1] == {"name": "look", "description": "Looks."}
    assert body == {
        "contents": [{"role": "user", "parts": [{"text": "Build."}]}],
        "toolConfig": {"functionCallingConfig": {"mode": "AUTO"}},
        "generationConfig": {"maxOutputTokens": 77},
    }


def test_schemas_go_over_the_wire_whole() -> None:
    """Enums, alternatives, null and bounds: what keeps a model from inventing a node or a robot."""
    tools = offered_tools(begun(paper_brief()).builder)
    with answering(Said([text("ok")])) as asked:
        asked.model(HELLO, tools)
    declared = {function["name"]: function for function in asked.bodies[0]["tools"][0]["functionDeclarations"]}
    assert set(declared) == {tool.name for tool in tools}
    for tool in tools:
        if tool.parameters["properties"]:
            assert declared[tool.name]["parameters_json_schema"] == tool.parameters
    sent = json.dumps(declared)
    assert all(word in sent for word in ('"enum"', '"anyOf"', '"null"', '"minItems"', '"additionalProperties"'))


def test_a_schema_keeps_its_nulls() -> None:
    odd = {"type": "object", "properties": {"x": {"enum": ["a", None], "default": None, "const": None}}}
    with answering(Said([text("ok")])) as asked:
        asked.model(HELLO, [Tool("odd", "Odd.", odd)])
    assert asked.bodies[0]["tools"][0]["functionDeclarations"][0]["parameters_json_schema"] == odd


@streaming
def test_text_is_told_as_it_comes_and_thoughts_are_not(stream: bool) -> None:
    heard: list[str] = []
    said = Said([text("secret thought", thought=True), text("Good day"), call("build", {}), text("!?")])
    with answering(said, stream=stream, listen=heard.append) as asked:
        message = asked.model(HELLO, [TOOL])
    assert message.text == "Good day!?"
    # The endpoint streams each text in two halves.
    assert heard == (["Good", " day", "!", "?"] if stream else ["Good day!?"])


@streaming
def test_calls_come_with_their_arguments_in_order_and_get_ids_if_they_have_none(stream: bool) -> None:
    arguments = {"what": "Haus für Jürgen", "n": [1, None, {"x": 2.5}], "z": None}
    with answering(Said([call("build", arguments), call("look", {}, call_id="fc-7")]), stream=stream) as asked:
        message = asked.model(HELLO, [TOOL])
    # Two messages went before, and it is the first call of the answer.
    assert [(made.id, made.name, json.loads(made.arguments)) for made in message.calls] == [
        ("call-2-1", "build", arguments),
        ("fc-7", "look", {}),
    ]
    assert message.finish == "stop"


@streaming
@pytest.mark.parametrize(
    ("reason", "finish"),
    [
        ("STOP", "stop"),
        ("MAX_TOKENS", "length"),
        ("CONTINUATION", "length"),
        ("SAFETY", "filtered"),
        ("RECITATION", "filtered"),
        ("BLOCKLIST", "filtered"),
        ("PROHIBITED_CONTENT", "filtered"),
        ("SPII", "filtered"),
        ("LANGUAGE", "filtered"),
        ("ESCALATION", "filtered"),
        ("OTHER", "filtered"),
    ],
)
def test_how_an_answer_ended_is_told(stream: bool, reason: str, finish: Finish) -> None:
    with answering(Said([text("Well.")], reason), stream=stream) as asked:
        message = asked.model(HELLO, [TOOL])
    assert (message.finish, message.text) == (finish, "Well.")


@pytest.mark.filterwarnings("ignore:BRAND_NEW is not a valid FinishReason")
def test_a_reason_to_come_is_none_to_go_on_with() -> None:
    with answering(Said([text("Well.")], "BRAND_NEW")) as asked:
        assert asked.model(HELLO, [TOOL]).finish == "filtered"


@streaming
def test_a_prompt_that_is_blocked_is_filtered(stream: bool) -> None:
    blocked = {"promptFeedback": {"blockReason": "SAFETY"}, "usageMetadata": {"promptTokenCount": 8}}
    reply = Reply.of_events([f"data: {json.dumps(blocked)}\n\n".encode()]) if stream else Reply.of_json(blocked)
    with answering(reply, stream=stream) as asked:
        message = asked.model(HELLO, [TOOL])
    assert (message.finish, message.text, message.usage) == ("filtered", "", Usage(8, 0))


@streaming
def test_silence_is_an_answer(stream: bool) -> None:
    """After answers to its calls the model may have nothing to add; asked again it would only be silent again."""
    silent = {"candidates": [{"content": {"role": "model"}, "finishReason": "STOP"}]}
    reply = Reply.of_events([f"data: {json.dumps(silent)}\n\n".encode()]) if stream else Reply.of_json(silent)
    with answering(reply, stream=stream) as asked:
        message = asked.model(HELLO, [TOOL])
    assert (message.text, message.calls, message.finish, message.usage) == ("", (), "stop", None)


@streaming
def test_tokens_of_the_cache_and_of_thoughts_count(stream: bool) -> None:
    """The prompt's 123 hold the 100 out of the cache; 9 said and 40 thought are 49 made."""
    usage = {
        "promptTokenCount": 123,
        "cachedContentTokenCount": 100,
        "candidatesTokenCount": 9,
        "thoughtsTokenCount": 40,
        "totalTokenCount": 172,
    }
    with answering(Said([text("ok")], usage=usage), stream=stream) as asked:
        assert asked.model(HELLO, [TOOL]).usage == Usage(123, 49, None)


def test_tokens_that_only_an_earlier_chunk_told_count() -> None:
    first, last = response_of([text("o")], None, {"promptTokenCount": 7}), response_of([text("k")], "STOP", None)
    with answering(Reply.of_events([chunk(first), chunk(last)])) as asked:
        assert asked.model(HELLO, [TOOL]).usage == Usage(7, 0)


def test_fields_to_come_are_passed_over() -> None:
    said = response_of([{"text": "ok", "mood": {"good": True}}], "STOP", None) | {"weather": "blue"}
    with answering(Reply.of_json(said), stream=False) as asked:
        assert asked.model(HELLO, [TOOL]).text == "ok"


@pytest.mark.parametrize(
    ("messages", "mode"),
    [
        ([Message("user", "Go.", must_call=True)], "ANY"),
        ([Message("user", "Go.")], "AUTO"),
        ([Message("user", "Go.", must_call=True), Message("assistant", "Yes."), Message("user", "Well?")], "AUTO"),
        (
            [
                Message("user", "Go.", must_call=True),
                Message("assistant", calls=(ToolCall("1", "build", "{}"),)),
                Message("tool", "done", call_id="1"),
            ],
            "AUTO",
        ),
    ],
)
def test_only_the_last_word_of_the_user_can_ask_for_a_call(messages: list[Message], mode: str) -> None:
    with answering(Said([text("ok")])) as asked:
        asked.model(messages, [TOOL])
    assert asked.bodies[0]["toolConfig"]["functionCallingConfig"]["mode"] == mode


def test_without_tools_there_is_no_choice() -> None:
    with answering(Said([text("ok")])) as asked:
        asked.model([Message("user", "Go.", must_call=True)], [])
    assert not {"tools", "toolConfig"} & set(asked.bodies[0])


@streaming
def test_a_model_that_cannot_be_made_to_call_is_asked_without_and_that_is_remembered(stream: bool) -> None:
    words = "The specified schema produces a constraint that has too many states for serving."
    forced = [Message("user", "Go.", must_call=True)]
    script = (failure(400, "INVALID_ARGUMENT", words), Said([text("a")]), Said([text("b")]))
    with answering(*script, stream=stream) as asked:
        assert [asked.model(forced, [TOOL]).text, asked.model(forced, [TOOL]).text] == ["a", "b"]
    modes = [body["toolConfig"]["functionCallingConfig"]["mode"] for body in asked.bodies]
    assert modes == ["ANY", "AUTO", "AUTO"]


def test_the_sdk_neither_calls_nor_goes_on_by_itself(caplog: pytest.LogCaptureFixture) -> None:
    """An answer cut at its limit comes with a token to go on with; that is for the dialogue to decide."""
    plain = response_of([text("Well")], "CONTINUATION", None)
    plain["candidates"][0]["continuationToken"] = "bW9yZQ=="
    with caplog.at_level("INFO"), answering(Reply.of_json(plain), stream=False) as asked:
        assert asked.model(HELLO, []).finish == "length"
    assert len(asked.bodies) == 1
    assert "AFC" not in caplog.text


def test_importing_the_module_does_not_load_the_sdk() -> None:
    program = "import sys, missiontree.llm.gemini; sys.exit('google.genai' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


def test_without_the_sdk_the_hint_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "google.genai", None)
    with pytest.raises(ProviderError) as fault:
        GeminiModel("gemini-loopback", api_key=KEY)
    assert (fault.value.kind, fault.value.hint) == ("not_installed", "pip install 'missiontree[gemini]'")


def test_without_a_key_the_hint_names_the_variables() -> None:
    with pytest.raises(ProviderError) as fault:
        GeminiModel("gemini-loopback")
    assert fault.value.kind == "unauthorised"
    assert "GEMINI_API_KEY or GOOGLE_API_KEY" in fault.value.hint


@pytest.mark.parametrize("variable", ["GEMINI_API_KEY", "GOOGLE_API_KEY"])
def test_the_key_comes_from_the_environment_and_shows_nowhere(variable: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(variable, f" {KEY}\n")
    with answering(Said([text("ok")]), api_key=None) as asked:
        message = asked.model(HELLO, [TOOL])
    assert KEY not in repr(asked.model) + repr(vars(asked.model)) + repr(message)


def test_the_environment_does_not_turn_it_to_another_service(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GOOGLE_GENAI_USE_VERTEXAI", "true")
    monkeypatch.setenv("GOOGLE_CLOUD_PROJECT", "elsewhere")
    with answering(Said([text("ok")])) as asked:
        assert asked.model(HELLO, [TOOL]).text == "ok"


def test_a_listener_may_raise_what_it_will() -> None:
    """Its exception is none of the provider's, so it is not asked again."""

    def stop(piece: str) -> Any:
        raise KeyError(piece)

    with answering(Said([text("Good day")]), listen=stop) as asked, pytest.raises(KeyError):
        asked.model(HELLO, [TOOL])
    assert len(asked.bodies) == 1
