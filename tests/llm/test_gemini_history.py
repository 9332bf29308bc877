"""Whatever was said, the Gemini API takes the history; and what it wants back verbatim comes back verbatim."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given

from missiontree.llm.chat import Message, Tool, ToolCall
from tests.llm.gemini_endpoint import ANY_SIGNATURE, Answered, Part, Said, answering, call, signature_of, text
from tests.llm.histories import DIALOGUES, MISSION, SYSTEM, answered, called, dialogues

TOOL = Tool("a", "Does it.", {"type": "object", "properties": {}})


def sent(*dialogue: Message) -> list[dict[str, Any]]:
    """The contents as they went over the wire, and were not rejected."""
    with answering(Said([text("ok")])) as asked:
        assert asked.model(dialogue, [TOOL]).text == "ok"
    contents: list[dict[str, Any]] = asked.bodies[0]["contents"]
    return contents


def response(name: str, plain: Any) -> Part:
    return {"functionResponse": {"name": name, "response": plain}}


@pytest.fixture(scope="module")
def patient() -> Iterator[Answered]:
    """An endpoint that answers as often as it is asked."""
    with answering(*[Said([text("ok")])] * 1000) as asked:
        yield asked


@pytest.fixture(scope="module")
def strict() -> Iterator[Answered]:
    """The same, and it wants signatures."""
    with answering(*[Said([text("ok")])] * 1000, strict=True) as asked:
        yield asked


@pytest.mark.parametrize("name", DIALOGUES)
def test_no_history_is_rejected(name: str, patient: Answered) -> None:
    assert patient.model(DIALOGUES[name], [TOOL]).text == "ok"
    assert patient.endpoint.refusals == []


@pytest.mark.parametrize("name", DIALOGUES)
def test_no_history_is_rejected_for_long_by_a_model_that_wants_signatures(name: str, strict: Answered) -> None:
    assert strict.model(DIALOGUES[name], [TOOL]).text == "ok"
    assert len(strict.endpoint.refusals) <= 1, "it needs to be told once"


@given(dialogue=dialogues("gemini"))
def test_no_history_at_all_is_rejected(dialogue: list[Message], strict: Answered) -> None:
    assert strict.model(dialogue, [TOOL]).text == "ok"


def test_a_dialogue_from_elsewhere_is_sent_as_turns() -> None:
    """Names and order tie answers to calls; ids that Gemini did not give are none of its business."""
    first = called(("1", "a", '{"x": null}'), ("2", "b", "{broken"), text="Look.")
    contents = sent(SYSTEM, MISSION, first, answered("2", "no"), answered("1"), Message("user", "And?"))
    assert contents == [
        {"role": "user", "parts": [text("Build.")]},
        {"role": "model", "parts": [text("Look."), call("a", {"x": None}), call("b", {})]},
        {"role": "user", "parts": [response("a", {"ok": True}), response("b", {"output": "no"}), text("And?")]},
    ]


def test_what_the_user_says_in_a_row_is_one_turn() -> None:
    contents = sent(MISSION, Message("user", "And quickly."))
    assert contents == [{"role": "user", "parts": [text("Build.\n\nAnd quickly.")]}]


def test_a_call_that_was_not_made_is_answered_so() -> None:
    contents = sent(MISSION, called(("1", "a", "{}")))
    assert contents[-1]["parts"][0]["functionResponse"]["response"]["ok"] is False


SIGNED = [
    text("So.", signature=b"sig \xff\xfb\xef 0"),
    text("A thought.", signature=b"sig 1", thought=True),
    call("a", {"x": 1}, signature=b"sig 2", call_id="fc-1"),
    call("b", {}),
    text("", signature=b"sig 3"),
]


def alphabet(part: Part) -> Part:
    """The part with its signature as bytes, for base64 has two alphabets and the SDK sends the other one."""
    return part | ({"thoughtSignature": signature_of(part)} if "thoughtSignature" in part else {})


@pytest.mark.parametrize("stream", [True, False], ids=["stream", "whole"])
def test_signatures_go_back_with_the_parts_they_came_with(stream: bool) -> None:
    """Even in a part without text, and with Gemini's own ids, though the dialogue has others."""
    with answering(Said(SIGNED), Said([text("ok")]), stream=stream, strict=True) as asked:
        said = asked.model([MISSION], [TOOL])
        said = replace(said, calls=tuple(replace(made, id=f"t{number}") for number, made in enumerate(said.calls)))
        asked.model([MISSION, said, answered("t0"), answered("t1", "done")], [TOOL])
    assert asked.endpoint.refusals == []
    model, results = asked.bodies[1]["contents"][1:]
    # A stream brings each text in two chunks, and the signature with the second; parts are not merged over it.
    expected = [piece for part in SIGNED for piece in (halves(part) if stream else [part])]
    assert [alphabet(part) for part in model["parts"]] == [alphabet(part) for part in expected]
    assert [part["functionResponse"] for part in results["parts"]] == [
        {"name": "a", "id": "fc-1", "response": {"ok": True}},
        {"name": "b", "response": {"output": "done"}},
    ]


def halves(part: Part) -> list[Part]:
    words = part.get("text", "")
    if len(words) < 2:
        return [part]
    middle = len(words) // 2
    head = {name: value for name, value in part.items() if name != "thoughtSignature"}
    return [head | {"text": words[:middle]}, part | {"text": words[middle:]}]


def test_signatures_of_calls_stay_when_the_text_has_changed() -> None:
    with answering(Said([text("Later."), call("a", {}, signature=b"sig")]), Said([text("ok")]), strict=True) as asked:
        said = asked.model([MISSION], [TOOL])
        asked.model([MISSION, Message("assistant", "Before."), said, answered(said.calls[0].id)], [TOOL])
    parts = asked.bodies[1]["contents"][1]["parts"]
    assert parts == [text("Before.\n\nLater."), call("a", {}, signature=b"sig")]


def test_calls_of_another_source_get_the_signature_that_is_documented_for_them_once_it_is_wanted() -> None:
    """Asked without, rejected, asked with; and from then on with. Models that want none are never sent one."""
    foreign = [MISSION, called(("1", "a", "{}"), ("2", "a", "{}")), answered("1"), answered("2")]
    with answering(Said([text("x")]), Said([text("y")]), strict=True) as asked:
        assert [asked.model(foreign, [TOOL]).text, asked.model(foreign, [TOOL]).text] == ["x", "y"]
    assert len(asked.bodies) == 3
    signed = [[signature_of(part) for part in body["contents"][1]["parts"]] for body in asked.bodies]
    assert signed == [[b"", b""], [ANY_SIGNATURE, b""], [ANY_SIGNATURE, b""]]


def test_a_model_that_only_says_so_at_the_end_gets_it_too() -> None:
    foreign = [MISSION, called(("1", "a", "{}")), answered("1")]
    with answering(Said([], "MISSING_THOUGHT_SIGNATURE"), Said([text("x")])) as asked:
        assert asked.model(foreign, [TOOL]).text == "x"
    assert signature_of(asked.bodies[1]["contents"][1]["parts"][0]) == ANY_SIGNATURE


def test_an_answer_without_signatures_keeps_nothing() -> None:
    with answering(Said([text("So."), call("a", {})])) as asked:
        assert asked.model([MISSION], [TOOL]).native == ""


def test_what_another_provider_kept_is_left_out() -> None:
    native = '{"of": "anthropic", "pieces": [["thought", "", "{}"], ["call", "toolu_1", ""]]}'
    assert sent(MISSION, called(("1", "a", "{}"), native=native), answered("1"))[1]["parts"] == [call("a", {})]


def test_a_function_that_cannot_be_named_is_named_otherwise_in_call_and_answer() -> None:
    contents = sent(MISSION, called(("1", "7up", "{}")), answered("1"))
    assert contents[1]["parts"] == [call("not_a_function", {})]
    assert contents[2]["parts"] == [response("not_a_function", {"ok": True})]


def test_an_id_that_the_dialogue_has_already_is_not_given_again() -> None:
    with answering(Said([call("a", {}, call_id="fc"), call("a", {}, call_id="fd")])) as asked:
        ids = [made.id for made in asked.model([MISSION, called(("fc", "a", "{}")), answered("fc")], [TOOL]).calls]
    assert ids[1] == "fd"
    assert len({"fc", *ids}) == 3


def test_arguments_that_no_one_can_read_are_sent_as_none() -> None:
    damaged = Message("assistant", calls=(ToolCall("1", "a", '{"x": '),))
    assert sent(MISSION, damaged, answered("1"))[1]["parts"] == [call("a", {})]
