"""Every fault of Anthropic's API is one kind of ours, streamed or not, with words that hold no key."""

from __future__ import annotations

import json
from collections.abc import Sequence

import pytest

from missiontree.authoring.author import author_tree
from missiontree.llm.anthropic import AnthropicModel
from missiontree.llm.chat import FaultKind, Message, ProviderError, Tool
from missiontree.llm.patience import Patience
from tests.llm.anthropic_endpoint import KEY, Said, answering, event, events_of, failure, text, thinking, use
from tests.llm.authoring_script import INIT, SEARCH, paper_brief
from tests.llm.loopback import Reply, closed_port

HELLO = [Message("user", "Build.")]
TOOL = Tool("build", "Builds.", {"type": "object", "properties": {}})
ONCE = Patience(attempts=1)
HTML = Reply(200, {"content-type": "text/html"}, b"<html>Welcome</html>")
SAID = Said([thinking("Hm.", "sig"), text("Good day"), use("build", {"what": "house"})])

streaming = pytest.mark.parametrize("stream", [True, False], ids=["stream", "whole"])


def fault_of(reply: Reply, stream: bool = True, patience: Patience = ONCE) -> ProviderError:
    with (
        answering(reply, stream=stream, patience=patience) as asked,
        pytest.raises(ProviderError) as fault,
    ):
        asked.model(HELLO, [TOOL])
    assert len(asked.bodies) == 1, "the SDK must not ask again by itself"
    return fault.value


FAULTS: Sequence[tuple[Reply, FaultKind]] = [
    (failure(401, "authentication_error", "invalid x-api-key"), "unauthorised"),
    (failure(402, "billing_error", "credit is used up"), "unauthorised"),
    (failure(403, "permission_error", "not for you"), "unauthorised"),
    (failure(404, "not_found_error", "model: claude-loopback"), "no_such_model"),
    (failure(408, "timeout_error", "too slow"), "timed_out"),
    (failure(413, "request_too_large", "Request exceeds the maximum size"), "context_overflow"),
    (failure(429, "rate_limit_error", "too many"), "rate_limited"),
    (failure(429, "rate_limit_error", "too many tokens in a minute"), "rate_limited"),
    (failure(500, "api_error", "Internal server error"), "overloaded"),
    (failure(504, "timeout_error", "too slow"), "timed_out"),
    (failure(529, "overloaded_error", "Overloaded"), "overloaded"),
    (failure(400, "invalid_request_error", "prompt is too long: 210000 tokens > 200000 maximum"), "context_overflow"),
    (
        failure(400, "invalid_request_error", "input length and `max_tokens` exceed context limit: 199000 + 16000"),
        "context_overflow",
    ),
    (failure(400, "invalid_request_error", "messages.1: something is wrong"), "bad_request"),
    (failure(422, "invalid_request_error", "unprocessable"), "bad_request"),
    (Reply(503, {"content-type": "text/html"}, b"<html>Service Unavailable</html>"), "overloaded"),
    (Reply(401, {}, b""), "unauthorised"),
    (Reply.of_json({"error": {"type": ["odd"], "message": {}}}, 400), "bad_request"),
    (Reply(501, {}, b"no"), "failed"),
    (HTML, "failed"),
    (Reply(200, {"content-type": "application/json"}, b"{"), "failed"),
    (Reply(200, {"content-type": "application/json"}, b""), "failed"),
    (Reply(200, {"content-type": "application/json"}, b"[" * 100_000), "failed"),
    (Reply.of_json([1, 2]), "failed"),
    (Reply.of_json({"type": "message", "content": "text"}), "failed"),
    (Reply.of_json({"type": "message", "content": [{"type": "text", "text": 7}], "stop_reason": "end_turn"}), "failed"),
    (Reply.of_json({"type": "message", "content": [7], "stop_reason": "end_turn"}), "failed"),
    (Reply(mute=True), "cut_off"),
    (Reply(200, {"content-type": "application/json"}, b'{"type": "message"}', cut=True), "cut_off"),
]


@streaming
@pytest.mark.parametrize(("reply", "kind"), FAULTS, ids=[f"{reply.status} {kind}" for reply, kind in FAULTS])
def test_each_fault_has_its_kind(reply: Reply, kind: FaultKind, stream: bool) -> None:
    if reply.cut and stream:
        reply = Reply.of_events([b"event: message_start\n"], cut=True)
    fault = fault_of(reply, stream)
    assert fault.kind == kind
    assert fault.hint or kind == "bad_request"


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("overloaded_error", "overloaded"),
        ("api_error", "overloaded"),
        ("rate_limit_error", "rate_limited"),
        ("timeout_error", "timed_out"),
        ("invalid_request_error", "bad_request"),
        ("authentication_error", "unauthorised"),
        ("something_new", "failed"),
    ],
)
def test_an_error_in_the_middle_of_a_stream_has_its_kind(name: str, kind: FaultKind) -> None:
    """Its status was 200 long before."""
    error = event({"type": "error", "error": {"type": name, "message": "Sorry"}})
    begun = events_of(SAID, SAID.content)[:5]
    fault = fault_of(Reply.of_events([*begun, error]))
    assert fault.kind == kind
    assert str(fault).endswith(": Sorry")
    assert "status" not in str(fault)


@pytest.mark.parametrize("cut", [True, False], ids=["connection lost", "closed in order"])
def test_a_stream_that_ends_too_soon_is_cut_off_wherever_it_ends(cut: bool) -> None:
    """At every event but the last, and in the middle of each; only then is the answer whole."""
    events = events_of(SAID, SAID.content)
    ends = [events[:count] for count in range(1, len(events))]
    ends += [[*events[:count], events[count][: len(events[count]) // 2]] for count in range(len(events))]
    replies = [Reply.of_events(end, cut) for end in ends]
    with answering(*replies, Reply.of_events(events), patience=ONCE) as asked:
        for _ in replies:
            with pytest.raises(ProviderError) as fault:
                asked.model(HELLO, [TOOL])
            assert fault.value.kind == "cut_off"
        assert asked.model(HELLO, [TOOL]).text == "Good day"


def test_a_whole_answer_that_has_no_end_is_cut_off() -> None:
    plain = {"type": "message", "content": [text("Well")], "stop_reason": None}
    assert fault_of(Reply.of_json(plain), stream=False).kind == "cut_off"


@pytest.mark.parametrize(
    "events",
    [
        [b"event: message_start\ndata: {nonsense\n\n"],
        [b"event: message_start\ndata: 7\n\n"],
        [event({"type": "content_block_delta", "index": 3, "delta": {"type": "text_delta", "text": "x"}})],
        [event({"type": "content_block_start", "index": "a", "content_block": text("x")})],
        [event({"type": "content_block_start", "index": 0, "content_block": None})],
        [b"event: message_start\ndata: " + b"[" * 100_000 + b"\n\n"],
        [b"event: message_start\ndata: \xff\xfe\n\n"],
    ],
)
def test_events_that_are_none_are_no_answer(events: list[bytes]) -> None:
    assert fault_of(Reply.of_events(events)).kind == "failed"


def test_events_of_kinds_to_come_are_passed_over() -> None:
    events = events_of(SAID, SAID.content)
    events.insert(1, event({"type": "weather", "sky": "blue"}))
    events.insert(
        4, event({"type": "content_block_delta", "index": 0, "delta": {"type": "mood_delta", "mood": "good"}})
    )
    with answering(Reply.of_events(events)) as asked:
        assert asked.model(HELLO, [TOOL]).text == "Good day"


@streaming
def test_a_provider_that_says_nothing_is_given_up(stream: bool) -> None:
    assert fault_of(Reply(held=True), stream, Patience(attempts=1, timeout_s=0.05)).kind == "timed_out"


def test_patience_without_end_can_be_had() -> None:
    with answering(SAID, patience=Patience(timeout_s=float("inf"), total_s=float("inf"))) as asked:
        assert asked.model(HELLO, [TOOL]).text == "Good day"


@streaming
def test_a_provider_that_is_not_there_is_unreachable(stream: bool) -> None:
    model = AnthropicModel("m", api_key=KEY, base_url=f"http://127.0.0.1:{closed_port()}", stream=stream, patience=ONCE)
    with pytest.raises(ProviderError) as fault:
        model(HELLO, [TOOL])
    assert fault.value.kind == "unreachable"


@streaming
@pytest.mark.parametrize(
    ("headers", "seconds"),
    [
        ({"retry_after": "7"}, 7.0),
        ({"retry_after": "0.5"}, 0.5),
        ({"retry_after_ms": "1500", "retry_after": "9"}, 1.5),
        ({"retry_after": "soon"}, None),
        ({"retry_after": "nan"}, None),
        ({"retry_after": "-1"}, None),
        ({}, None),
    ],
)
def test_when_to_ask_again_is_told(headers: dict[str, str], seconds: float | None, stream: bool) -> None:
    assert fault_of(failure(429, "rate_limit_error", "slow down", **headers), stream).retry_after_s == seconds


@streaming
def test_a_fault_that_passes_is_waited_out(stream: bool) -> None:
    slept: list[float] = []
    patience = Patience(sleep=slept.append, clock=lambda: 0.0)
    with answering(
        failure(429, "rate_limit_error", "slow down", retry_after="7"),
        Reply.of_events(events_of(SAID, SAID.content)[:4]) if stream else Reply(mute=True),
        failure(529, "overloaded_error", "Overloaded"),
        SAID,
        stream=stream,
        patience=patience,
    ) as asked:
        assert asked.model(HELLO, [TOOL]).text == "Good day"
    # 7 as asked for; of our own 1, 2, 4 the first went by with it.
    assert slept == [7, 2, 4]
    assert [body == asked.bodies[0] for body in asked.bodies] == [True] * 4


@streaming
def test_the_key_is_in_no_word_even_if_it_is_sent_back(stream: bool) -> None:
    words = f"invalid key {KEY}\x1b[31m\n and again {KEY}" + "x" * 10_000
    fault = fault_of(failure(401, "authentication_error", words), stream)
    shown = str(fault) + fault.hint
    assert KEY not in shown
    assert "invalid key [key] [31m and again [key]" in shown
    assert len(shown) < 600
    # Nor in what it carries along: a traceback shows causes and contexts.
    cause: BaseException | None = fault
    while cause is not None:
        assert isinstance(cause, ProviderError)
        cause = cause.__cause__ or cause.__context__


@streaming
@pytest.mark.parametrize("turn", [1, 2, 3])
def test_a_fault_at_any_turn_is_the_outcome_with_the_tree_so_far(turn: int, stream: bool) -> None:
    """After the first turn the tree has its root, after the second a leaf; what was built is kept."""
    script: list[Said | Reply] = [Said([use(*INIT)]), Said([use(*SEARCH)]), Said([text("Done.")])]
    script[turn - 1] = failure(401, "authentication_error", json.dumps("no"))
    with answering(*script, patience=ONCE, stream=stream) as asked:
        made = author_tree(paper_brief(), asked.model)
    assert (made.status, [reason.rule for reason in made.reasons]) == ("provider_failed", ["provider_unauthorised"])
    assert (made.tree is not None) == (turn > 1)
