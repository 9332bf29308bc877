"""Endpoints that promise more than they keep: what they object to is left out, once, and remembered."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

from missiontree.llm.chat import Message, ProviderError, Tool
from missiontree.llm.feature_memory import FeatureMemory
from missiontree.llm.features import FEATURES, Features
from missiontree.llm.openai import OpenAIModel
from missiontree.llm.openai_native import native_of
from missiontree.llm.openai_probe import probe
from missiontree.llm.patience import Patience
from tests.llm.endpoint import KEY, Endpoint, nobody_listening
from tests.llm.endpoint_replies import Reply, Turn, error, json_body

SCHEMA = {"type": "object", "properties": {"word": {"type": "string"}}, "required": [], "additionalProperties": False}
PING, PONG = Tool("ping", "Pings.", SCHEMA), Tool("pong", "Pongs.", SCHEMA)
TALK = [Message("system", "s"), Message("user", "u", must_call=True)]
CALL = Turn("", (("ping", {"word": "one"}),))
Has = Callable[[Mapping[str, Any]], bool]


def _in_tools(text: str) -> Has:
    return lambda body: text in json.dumps(body.get("tools", []))


def _choice(kind: type) -> Has:
    return lambda body: isinstance(body.get("tool_choice"), kind)


OBJECTIONS: list[tuple[str, Has, str]] = [
    ("usage_in_stream", lambda body: "stream_options" in body, "Unknown parameter: stream_options"),
    ("parallel_calls", lambda body: "parallel_tool_calls" in body, "parallel_tool_calls is not supported"),
    ("thoughts", lambda body: "reasoning_content" in json.dumps(body["messages"]), "unexpected reasoning_content"),
    ("completion_tokens", lambda body: "max_completion_tokens" in body, "use max_tokens, not max_completion_tokens"),
    ("temperature", lambda body: "temperature" in body, "temperature is fixed for this model"),
    ("strict", _in_tools('"strict"'), "strict is not permitted"),
    ("named", _choice(dict), "tool_choice cannot be an object"),
    ("required", lambda body: body.get("tool_choice") not in (None, "auto"), "tool_choice: 'required' is unknown"),
    ("choice", lambda body: "tool_choice" in body, "tool_choice is unknown"),
    ("rich_schema", _in_tools("additionalProperties"), "cannot compile the grammar of additionalProperties"),
    ("stream", lambda body: "stream" in body, "streaming is not implemented"),
]


def objecting(has: Has, reply: Reply) -> Callable[[Mapping[str, Any]], Reply | None]:
    return lambda body: reply if has(body) else None


def thoughtful() -> list[Message]:
    """A dialogue with thoughts in it, and a demand at its end."""
    said = Message("assistant", "hm", native=native_of("hmm", []))
    return [Message("system", "s"), Message("user", "u"), said, Message("user", "go on", must_call=True)]


def open_at(endpoint: Endpoint, memory: FeatureMemory | None = None) -> OpenAIModel:
    return OpenAIModel(
        "m",
        base_url=endpoint.url,
        api_key=KEY,
        memory=memory,
        max_output_tokens=50,
        temperature=0.5,
        patience=Patience(attempts=1),
    )


def test_every_feature_is_objected_to_below() -> None:
    assert tuple(name for name, _, _ in OBJECTIONS) == FEATURES


@pytest.mark.parametrize(("feature", "has", "words"), OBJECTIONS, ids=[name for name, _, _ in OBJECTIONS])
@pytest.mark.parametrize("status", [400, 404, 422, 501])
def test_a_feature_that_is_objected_to_by_name_is_left_out_from_then_on(
    feature: str, has: Has, words: str, status: int
) -> None:
    """The first request meets the objection, and once more for every step that leads there; the second dialogue meets none."""
    steps = {"required": 2, "choice": 3, "rich_schema": 2}.get(feature, 1)
    with Endpoint([CALL], objection=objecting(has, error(status, words))) as endpoint:
        model = open_at(endpoint)
        for _ in range(2):
            assert model(thoughtful(), [PING]).calls[0].name == "ping"
    assert endpoint.violations == []
    assert feature in model.features.missing
    assert len(model.features.missing) == steps
    assert len(endpoint.requests) == steps + 2


@pytest.mark.parametrize(("feature", "has", "words"), OBJECTIONS, ids=[name for name, _, _ in OBJECTIONS])
def test_a_feature_that_is_objected_to_in_no_words_is_found_in_the_fixed_order(
    feature: str, has: Has, words: str
) -> None:
    """All that stand before it are given up on the way."""
    with Endpoint([CALL], objection=objecting(has, error(400, "Bad request"))) as endpoint:
        model = open_at(endpoint)
        assert model(thoughtful(), [PING]).calls[0].name == "ping"
    given_up = FEATURES.index(feature) + 1
    assert model.features.missing == FEATURES[:given_up]
    assert len(endpoint.requests) == given_up + 1


def test_an_endpoint_that_takes_nothing_is_asked_once_for_each_feature_and_nothing_is_remembered() -> None:
    """The fault is the first one: the others are about requests that nobody asked for."""
    said = iter(f"objection {number}" for number in range(100))
    with Endpoint([CALL], objection=lambda body: error(400, next(said))) as endpoint:
        model = open_at(endpoint)
        with pytest.raises(ProviderError, match=r"objection 0$") as raised:
            model(thoughtful(), [PING])
    assert raised.value.kind == "bad_request"
    assert len(endpoint.requests) == 1 + len(FEATURES)
    assert model.features == Features()


@pytest.mark.parametrize(
    ("status", "words"),
    [
        (400, "gemma does not support tools"),
        (400, "Invalid 'messages[1]': no"),
        (404, "The model does not exist"),
        (405, "Method not allowed"),
    ],
)
def test_what_is_about_something_else_is_not_asked_again(status: int, words: str) -> None:
    with Endpoint([CALL], objection=lambda body: error(status, words)) as endpoint, pytest.raises(ProviderError):
        open_at(endpoint)(TALK, [PING])
    assert len(endpoint.requests) == 1


def test_words_that_repeat_the_request_name_no_feature() -> None:
    """A server that sends back what it was sent, as pydantic's do, does not object to all that stands in it."""
    detail = [{"loc": ["body", "temperature"], "msg": "no", "input": {"user": "stream_options"}}]
    has: Has = lambda body: "temperature" in body  # noqa: E731
    with Endpoint([CALL], objection=objecting(has, json_body({"detail": detail}, 422))) as endpoint:
        model = open_at(endpoint)
        model(TALK, [PING])
    assert model.features.missing == ("temperature",)


@pytest.mark.parametrize(
    ("words", "feature"),
    [
        ("Cannot use tools with stream", "stream"),
        ("failed to parse grammar", "strict"),
        ("tool_choice: type must be string, but is object", "named"),
    ],
)
def test_a_server_that_dies_of_a_feature_and_says_so_is_asked_without_it(words: str, feature: str) -> None:
    has = next(has for name, has, _ in OBJECTIONS if name == feature)
    with Endpoint([CALL], objection=objecting(has, error(500, words))) as endpoint:
        model = open_at(endpoint)
        assert model(TALK, [PING]).calls
    assert model.features.missing == (feature,)


def test_a_server_that_dies_of_something_else_is_asked_the_same_again() -> None:
    """The words name the schema, and the bare request dies, too: what is left is a server out of order, which may pass."""
    naps: list[float] = []
    patience = Patience(attempts=3, sleep=naps.append)
    with Endpoint([CALL], objection=lambda body: error(500, "the json schema store is down")) as endpoint:
        model = OpenAIModel("m", base_url=endpoint.url, patience=patience)
        with pytest.raises(ProviderError) as raised:
            model(TALK, [PING])
    assert (raised.value.kind, naps, model.features) == ("overloaded", [1.0, 2.0], Features())
    assert len(endpoint.requests) == 3 + 2  # without strict, then with simple schemas; no more than that


def test_an_objection_inside_a_stream_is_one_too() -> None:
    has: Has = lambda body: "parallel_tool_calls" in body  # noqa: E731
    inside = json_body({"error": {"message": "parallel_tool_calls?", "type": "invalid_request_error"}})
    with Endpoint([CALL], objection=objecting(has, inside)) as endpoint:
        model = open_at(endpoint)
        assert model(TALK, [PING]).calls
    assert model.features.missing == ("parallel_calls",)


@pytest.mark.parametrize(
    ("tools", "turn", "missing"),
    [
        ([PING, PONG], Turn("words"), ("required",)),
        ([PING], Turn("words"), ("named",)),
        ([PING], Turn("", (("pong", {}),)), ("named",)),
        ([PING], Turn("", (("pong", {}), ("ping", {}))), ()),
        ([PING, PONG], Turn("", (("neither", {}),)), ()),
        ([PING, PONG], Turn("wor", finish="length"), ()),
        ([PING, PONG], Turn("", finish="content_filter"), ()),
    ],
)
def test_a_demand_that_is_accepted_and_not_kept_is_not_made_again(
    tools: list[Tool], turn: Turn, missing: tuple[str, ...]
) -> None:
    """It is no fault: the dialogue goes on with what was said."""
    with Endpoint([turn]) as endpoint:
        model = open_at(endpoint)
        said = model(TALK, tools)
    assert said.text == turn.text
    assert model.features.missing == missing


def test_what_was_found_out_is_known_to_the_next_model(tmp_path: Path) -> None:
    path = tmp_path / "endpoints.json"
    has, words = OBJECTIONS[1][1:]
    with Endpoint([CALL], objection=objecting(has, error(400, words))) as endpoint:
        open_at(endpoint, FeatureMemory(path))(TALK, [PING])
        open_at(endpoint, FeatureMemory(path))(TALK, [PING])
    assert len(endpoint.requests) == 3
    assert KEY not in path.read_text(encoding="utf-8")


def test_a_fault_on_the_way_forgets_nothing_and_is_asked_again() -> None:
    """400, left out, 503, slept, answered: three requests. The 503 does not begin the search anew."""
    has, words = OBJECTIONS[1][1:]
    naps: list[float] = []
    busy = iter([error(503, "Busy.")])

    def objection(body: Mapping[str, Any]) -> Reply | None:
        return error(400, words) if has(body) else next(busy, None)

    with Endpoint([CALL], objection=objection) as endpoint:
        model = OpenAIModel("m", base_url=endpoint.url, patience=Patience(sleep=naps.append))
        assert model(TALK, [PING]).calls
    assert (naps, len(endpoint.requests), model.features.missing) == ([1.0], 3, ("parallel_calls",))


TWO = Turn("", (("ping", {"word": "one"}), ("pong", {"word": "two"})))


def test_a_probe_tells_what_a_model_does() -> None:
    with Endpoint([CALL, CALL, TWO]) as endpoint:
        found = probe(open_at(endpoint))
    assert endpoint.violations == []
    assert (found.calls, found.calls_together, found.fault) == (True, True, None)
    assert found.features == Features()
    assert found.usage is not None
    assert (found.usage.input_tokens, found.usage.output_tokens, found.usage.cost_usd) == (300, 30, None)
    assert (found.endpoint, found.model) == (endpoint.url, "m")
    sent = [request["tool_choice"] for request in endpoint.requests]
    assert sent == [{"type": "function", "function": {"name": "ping"}}, "required", "auto"]


def test_a_probe_finds_what_is_not_kept_and_forgets_what_was_believed() -> None:
    with Endpoint([Turn("words"), Turn("words"), CALL]) as endpoint:
        model = open_at(endpoint)
        model.memory.learn(model.endpoint, model.model, Features(strict=False))
        found = probe(model)
    assert found.features.missing == ("named", "required")
    assert (found.calls, found.calls_together) == (True, False)


def test_a_probe_of_a_model_that_only_talks_says_so() -> None:
    with Endpoint([Turn("words")]) as endpoint:
        found = probe(open_at(endpoint))
    assert (found.calls, found.calls_together, found.fault) == (False, False, None)


def test_a_probe_that_cannot_be_made_says_why_and_forgets_nothing() -> None:
    with nobody_listening() as url:
        model = OpenAIModel("m", base_url=url, patience=Patience(attempts=1))
        model.memory.learn(model.endpoint, model.model, Features(strict=False))
        found = probe(model)
    assert found.fault is not None
    assert (found.fault.kind, found.calls, found.usage) == ("unreachable", False, None)
    assert found.features == model.features == Features(strict=False)
