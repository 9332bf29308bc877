"""Answers put together from what endpoints really send: every way to cut, number and repeat the parts of a call."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.llm.chat import Message, ProviderError, ToolCall, Usage, deaf
from missiontree.llm.openai_answer import Answer
from missiontree.llm.openai_native import thoughts_of
from missiontree.llm.openai_stream import DONE


def of(*parts: dict[str, Any]) -> Message:
    answer = Answer(deaf)
    for part in parts:
        answer.add(part)
    return answer.message()


def delta(finish: str | None = None, **said: Any) -> dict[str, Any]:
    return {"choices": [{"index": 0, "delta": said, "finish_reason": finish}]}


def call(**given: Any) -> dict[str, Any]:
    """A delta of a call: id and index beside, name and arguments inside the function."""
    function = {key: given.pop(key) for key in ("name", "arguments") if key in given}
    return delta(tool_calls=[{**given, "function": function}])


END = delta("tool_calls")


def calls_of(*parts: dict[str, Any]) -> list[tuple[str, str, str]]:
    return [(made.id, made.name, made.arguments) for made in of(*parts, END).calls]


def test_text_comes_in_pieces_and_the_listener_hears_each() -> None:
    heard: list[str] = []
    answer = Answer(heard.append)
    for part in (
        delta(role="assistant", content=""),
        delta(content="Hel"),
        delta(content=None),
        delta(content="lo"),
        delta("stop"),
    ):
        answer.add(part)
    assert answer.message() == Message("assistant", "Hello")
    assert heard == ["Hel", "lo"]


def test_thoughts_are_heard_and_are_no_part_of_the_text() -> None:
    heard: list[str] = []
    answer = Answer(heard.append)
    for part in (delta(reasoning_content="hm"), delta(reasoning_content="m, "), delta(content="Yes."), delta("stop")):
        answer.add(part)
    said = answer.message()
    assert (said.text, "".join(heard)) == ("Yes.", "hmm, Yes.")
    assert thoughts_of(said.native) == ({"reasoning_content": "hmm, "}, ())


def test_content_may_be_a_list_of_parts() -> None:
    parts = [{"type": "thinking", "thinking": []}, {"type": "text", "text": "Yes."}]
    assert of({"choices": [{"message": {"content": parts}, "finish_reason": "stop"}]}).text == "Yes."


@pytest.mark.parametrize(
    ("parts", "expected"),
    [
        pytest.param(
            [
                call(index=0, id="a", name="ping", arguments=""),
                call(index=0, arguments='{"x"'),
                call(index=1, id="b", name="pong", arguments=""),
                call(index=0, arguments=": 1}"),
                call(index=1, arguments="{}"),
            ],
            [("a", "ping", '{"x": 1}'), ("b", "pong", "{}")],
            id="as OpenAI does it, interleaved",
        ),
        pytest.param(
            [call(id="a", name="ping", arguments="{}"), call(id="b", name="ping", arguments="{}")],
            [("a", "ping", "{}"), ("b", "ping", "{}")],
            id="whole calls without an index",
        ),
        pytest.param(
            [call(name="ping", arguments='{"x": 1}'), call(name="ping", arguments='{"x": 2}')],
            [("call00001", "ping", '{"x": 1}'), ("call00002", "ping", '{"x": 2}')],
            id="whole calls with neither index nor id",
        ),
        pytest.param(
            [call(index=0, id="a", name="ping", arguments="{}"), call(index=0, id="b", name="pong", arguments="{}")],
            [("a", "ping", "{}"), ("b", "pong", "{}")],
            id="every index is 0",
        ),
        pytest.param(
            [call(index=0, name="ping", arguments='{"x": 1}'), call(index=0, name="ping", arguments='{"x": 2}')],
            [("call00001", "ping", '{"x": 1}'), ("call00002", "ping", '{"x": 2}')],
            id="every index is 0 and there is no id",
        ),
        pytest.param(
            [
                call(index=0, id="a", name="ping", arguments='{"x"'),
                call(index=0, id="a", name="ping", arguments=": 1"),
                call(index=0, id="a", name="ping", arguments="}"),
            ],
            [("a", "ping", '{"x": 1}')],
            id="id and name in every delta",
        ),
        pytest.param(
            [call(name="ping", arguments='{"x"'), call(name="ping", arguments=": 1}")],
            [("call00001", "ping", '{"x": 1}')],
            id="the name alone in every delta",
        ),
        pytest.param(
            [
                call(index=0, id="a", name="ping", arguments='{"x"'),
                call(index=0, id="b", name=None, arguments=": 1"),
                call(index=0, id="c", name="", arguments="}"),
            ],
            [("a", "ping", '{"x": 1}')],
            id="a new id in every delta",
        ),
        pytest.param(
            [call(id="a", name="ping", arguments=""), call(id="b", arguments='{"x": '), call(arguments="1}")],
            [("a", "ping", '{"x": 1}')],
            id="a new id in every delta and no index",
        ),
        pytest.param(
            [call(index=0, id="a", name="pi"), call(index=0, name="ng"), call(index=0, arguments="{}")],
            [("a", "ping", "{}")],
            id="the name in pieces",
        ),
        pytest.param(
            [
                call(index=0, id="a", name="ping", arguments='{"x": 1}'),
                call(index=0, id="a", name="ping", arguments='{"x": 1}'),
            ],
            [("a", "ping", '{"x": 1}')],
            id="the whole call once more at the end",
        ),
        pytest.param(
            [call(index=0, id="a", name="ping", arguments={"x": "ü"})],
            [("a", "ping", '{"x": "ü"}')],
            id="arguments that are JSON and no text",
        ),
        pytest.param(
            [call(index=0, id="a", name="ping", arguments=None), call(index=1, id="a", name="pong", arguments=None)],
            [("a", "ping", ""), ("call00002", "pong", "")],
            id="one id for two calls, and no arguments",
        ),
        pytest.param(
            [call(index=0, id="a", name="ping", arguments='{"x": 1'), call(index=0, arguments='"y"')],
            [("a", "ping", '{"x": 1"y"')],
            id="nothing is repaired",
        ),
        pytest.param([call(arguments="{}")], [("call00001", "", "{}")], id="no name"),
        pytest.param([delta(tool_calls=[{"id": "a", "function": None}])], [("a", "", "")], id="no function"),
        pytest.param(
            [call(index=5, id="a", name="ping", arguments="{}"), call(index=2, id="b", name="pong", arguments="{}")],
            [("a", "ping", "{}"), ("b", "pong", "{}")],
            id="the order is that of their beginnings",
        ),
    ],
)
def test_calls_are_put_together(parts: list[dict[str, Any]], expected: list[tuple[str, str, str]]) -> None:
    assert calls_of(*parts) == expected


def test_calls_of_a_whole_message_are_never_merged() -> None:
    entries = [{"function": {"name": "ping", "arguments": ""}}, {"function": {"name": "ping", "arguments": ""}}]
    said = of({"choices": [{"message": {"content": None, "tool_calls": entries}, "finish_reason": "stop"}]})
    assert said.calls == (ToolCall("call00001", "ping", ""), ToolCall("call00002", "ping", ""))


def test_what_stands_beside_a_call_is_kept_for_the_way_back() -> None:
    signature = {"google": {"thought_signature": "xyz"}}
    said = of(
        call(index=0, id="a", name="ping", arguments="{}"),
        call(index=1, id="b", name="ping", arguments="{}", extra_content=signature),
        END,
    )
    assert thoughts_of(said.native) == ({}, ({}, {"extra_content": signature}))


@pytest.mark.parametrize("native", ["", "{", "[]", '{"form": "another"}'])
def test_what_another_provider_keeps_is_not_handed_back(native: str) -> None:
    assert thoughts_of(native) == ({}, ())


@pytest.mark.parametrize(
    ("reason", "finish"),
    [
        ("stop", "stop"),
        ("tool_calls", "stop"),
        ("function_call", "stop"),
        ("eos", "stop"),
        ("length", "length"),
        ("model_length", "length"),
        ("max_tokens", "length"),
        ("content_filter", "filtered"),
        ("SAFETY", "filtered"),
    ],
)
def test_how_it_ended(reason: str, finish: str) -> None:
    assert of(delta(content="a"), delta(reason)).finish == finish


def test_a_refusal_is_said_in_its_own_words() -> None:
    said = of(delta(refusal="I "), delta(refusal="cannot."), delta("stop"))
    assert (said.finish, said.text, said.calls) == ("refused", "I cannot.", ())


def test_an_empty_refusal_is_none() -> None:
    assert of({"choices": [{"message": {"content": "Yes.", "refusal": ""}, "finish_reason": "stop"}]}).finish == "stop"


def test_a_whole_message_needs_no_word_that_it_is_finished() -> None:
    assert of({"choices": [{"message": {"content": "Yes."}}]}) == Message("assistant", "Yes.")


@pytest.mark.parametrize(
    ("usage", "expected"),
    [
        ({"prompt_tokens": 3, "completion_tokens": 4}, Usage(3, 4)),
        ({"prompt_tokens": 3, "completion_tokens": 4, "cost": 0.25}, Usage(3, 4, 0.25)),
        ({"prompt_tokens": 3, "completion_tokens": 4, "cost": -1}, Usage(3, 4)),
        ({"prompt_tokens": 3, "completion_tokens": 4, "cost": float("nan")}, Usage(3, 4)),
        ({"prompt_tokens": 3, "completion_tokens": 4, "cost": 10**400}, Usage(3, 4)),
        ({"prompt_tokens": 3, "completion_tokens": 4, "cost": "0.25"}, Usage(3, 4)),
        ({"prompt_tokens": -3, "completion_tokens": 4}, None),
        ({"prompt_tokens": "3"}, None),
        (None, None),
    ],
)
def test_tokens_and_money_are_counted_if_the_endpoint_does(usage: Any, expected: Usage | None) -> None:
    assert of(delta("stop", content="a"), {"choices": [], "usage": usage}).usage == expected


@pytest.mark.parametrize(
    ("parts", "kind"),
    [
        ([], "cut_off"),
        ([delta(content="a")], "cut_off"),
        ([delta(content="a"), {DONE: True}], "cut_off"),
        ([delta(content="a"), delta("error")], "cut_off"),
        ([{"choices": []}, {DONE: True}], "empty"),
        ([{"choices": None}], "empty"),
        ([{DONE: True}], "empty"),
        ([{"hello": "world"}], "failed"),
        ([{}], "failed"),
        ([{"choices": {"a": 1}}], "failed"),
        ([{"choices": ["a"]}], "failed"),
        ([{"choices": [{"message": "a"}]}], "failed"),
        ([{"choices": [{"message": {"content": 7}}]}], "failed"),
        ([{"choices": [{"message": {"tool_calls": {"a": 1}}}]}], "failed"),
        ([{"choices": [{"message": {"tool_calls": ["a"]}}]}], "failed"),
    ],
)
def test_what_is_no_answer_is_a_fault_of_its_kind(parts: list[dict[str, Any]], kind: str) -> None:
    with pytest.raises(ProviderError) as raised:
        of(*parts)
    assert raised.value.kind == kind


def test_an_index_that_is_no_number_is_nobodys() -> None:
    with pytest.raises(ProviderError, match="no choices"):
        of({"choices": [{"index": [0], "message": {"content": "a"}}]})


def test_of_several_choices_the_first_counts() -> None:
    choices = [{"index": 1, "message": {"content": "no"}}, {"index": 0, "message": {"content": "yes"}}]
    assert of({"choices": choices}).text == "yes"


@pytest.mark.parametrize("name", ["", "x" * 65, "ä", "a\n", "\ud800"])
def test_an_id_that_is_none_is_replaced(name: str) -> None:
    assert calls_of(call(index=0, id=name, name="ping", arguments="{}")) == [("call00001", "ping", "{}")]


def test_what_is_nested_too_deep_to_be_written_is_no_arguments() -> None:
    deep: Any = {}
    for _ in range(100_000):
        deep = {"a": deep}
    said = of(call(index=0, id="a", name="ping", arguments=deep, extra_content=deep), END)
    assert (said.calls[0].arguments, said.native) == ("nested too deep", "")
    while deep:
        deep = deep["a"]  # taken apart by hand, since Python would do it by recursion


def test_halves_of_characters_are_not_handed_back() -> None:
    """They cannot be written as UTF-8, and the whole request would fail of them."""
    said = of(delta(reasoning_content="a\ud800b"), delta("stop"))
    assert thoughts_of(said.native) == ({"reasoning_content": "a?b"}, ())


WORDS = st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=5), st.just({}), st.just([]))
KEYS = (
    *("choices", "usage", "index", "delta", "message", "finish_reason", "content", "refusal", "tool_calls"),
    *("function", "name", "arguments", "id", "reasoning_content", "extra_content", "prompt_tokens", "text"),
)
ANYTHING = st.recursive(
    WORDS, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(KEYS), inner, max_size=5)
)
PARTS = st.dictionaries(st.sampled_from(KEYS), ANYTHING, max_size=4) | st.builds(
    lambda said, finish: {"choices": [{"delta": said, "finish_reason": finish}]},
    st.dictionaries(st.sampled_from(KEYS), ANYTHING, max_size=5),
    WORDS,
)


@given(st.lists(PARTS, max_size=4))
def test_whatever_an_endpoint_sends_is_a_message_or_a_fault(parts: list[dict[str, Any]]) -> None:
    with suppress(ProviderError):
        said = of(*parts, delta("stop"))
        assert said.speaker == "assistant"
        assert len({made.id for made in said.calls}) == len(said.calls)
        thoughts_of(said.native)
