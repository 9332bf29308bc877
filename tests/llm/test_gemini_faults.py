"""Every fault of the Gemini API is one kind of ours, streamed or not, with words that hold no key."""

from __future__ import annotations

import json
from collections.abc import Sequence

import pytest

from missiontree.authoring.author import author_tree
from missiontree.llm.chat import FaultKind, Message, ProviderError, Tool
from missiontree.llm.gemini import GeminiModel
from missiontree.llm.patience import Patience
from tests.llm.authoring_script import INIT, SEARCH, paper_brief
from tests.llm.gemini_endpoint import KEY, Said, answering, call, chunk, chunks_of, failure, response_of, text
from tests.llm.loopback import Reply, closed_port

HELLO = [Message("user", "Build.")]
TOOL = Tool("build", "Builds.", {"type": "object", "properties": {}})
ONCE = Patience(attempts=1)
SAID = Said([text("Good day"), call("build", {"what": "house"}, signature=b"sig")])
BAD_KEY = {"@type": "type.googleapis.com/google.rpc.ErrorInfo", "reason": "API_KEY_INVALID"}
WAIT = {"@type": "type.googleapis.com/google.rpc.RetryInfo", "retryDelay": "7.5s"}

streaming = pytest.mark.parametrize("stream", [True, False], ids=["stream", "whole"])


def fault_of(reply: Reply | Said, stream: bool = True, patience: Patience = ONCE) -> ProviderError:
    with (
        answering(reply, stream=stream, patience=patience) as asked,
        pytest.raises(ProviderError) as fault,
    ):
        asked.model(HELLO, [TOOL])
    assert len(asked.bodies) == 1, "the SDK must not ask again by itself"
    return fault.value


FAULTS: Sequence[tuple[Reply, FaultKind]] = [
    (failure(401, "UNAUTHENTICATED", "no credentials"), "unauthorised"),
    (failure(403, "PERMISSION_DENIED", "not for you"), "unauthorised"),
    (failure(400, "INVALID_ARGUMENT", "API key not valid. Please pass a valid API key."), "unauthorised"),
    (failure(400, "INVALID_ARGUMENT", "Renew it.", BAD_KEY), "unauthorised"),
    (failure(404, "NOT_FOUND", "models/gemini-loopback is not found"), "no_such_model"),
    (failure(429, "RESOURCE_EXHAUSTED", "quota"), "rate_limited"),
    (failure(429, "RESOURCE_EXHAUSTED", "The token count exceeds the maximum per minute."), "rate_limited"),
    (failure(500, "INTERNAL", "An internal error has occurred."), "overloaded"),
    (failure(503, "UNAVAILABLE", "The model is overloaded."), "overloaded"),
    (failure(504, "DEADLINE_EXCEEDED", "too slow"), "timed_out"),
    (
        failure(
            400,
            "INVALID_ARGUMENT",
            "The input token count (1091639) exceeds the maximum number of tokens allowed (1048576).",
        ),
        "context_overflow",
    ),
    (failure(400, "INVALID_ARGUMENT", "contents: something is wrong"), "bad_request"),
    (failure(400, "FAILED_PRECONDITION", "User location is not supported for the API use."), "bad_request"),
    (Reply.of_json([{"error": {"code": 400, "message": "x", "status": "INVALID_ARGUMENT"}}], 400), "bad_request"),
    (Reply.of_json({"error": {"status": ["odd"], "message": {}, "details": [7]}}, 400), "bad_request"),
    (Reply.of_json({"error": "odd"}, 403), "unauthorised"),
    (Reply.of_json("odd", 404), "no_such_model"),
    (Reply(503, {"content-type": "text/html"}, b"<html>Service Unavailable</html>"), "overloaded"),
    (Reply(529, {}, b""), "overloaded"),
    (Reply(302, {"location": "/elsewhere"}, b""), "failed"),
    (Reply(200, {"content-type": "text/html"}, b"<html>Welcome</html>"), "failed"),
    (Reply(200, {"content-type": "application/json"}, b"[" * 100_000), "failed"),
    (Reply(200, {"content-type": "application/json"}, b"7"), "failed"),
    (Reply.of_json({"candidates": 3}), "failed"),
    (Reply.of_json({"candidates": [{"content": {"parts": [{"text": 7}]}, "finishReason": "STOP"}]}), "failed"),
    (Reply.of_json({}), "empty"),
    (Reply.of_json({"candidates": []}), "empty"),
    (Reply(mute=True), "cut_off"),
    (Reply(200, {"content-type": "application/json"}, b'{"candidates": []}', cut=True), "cut_off"),
]


@streaming
@pytest.mark.parametrize(("reply", "kind"), FAULTS, ids=[f"{reply.status} {kind}" for reply, kind in FAULTS])
def test_each_fault_has_its_kind(reply: Reply, kind: FaultKind, stream: bool) -> None:
    if reply.cut and stream:
        reply = Reply.of_events([b'data: {"candidates"'], cut=True)
    fault = fault_of(reply, stream)
    assert fault.kind == kind
    assert fault.hint or kind == "bad_request"


@streaming
@pytest.mark.parametrize(
    "reason", ["MALFORMED_FUNCTION_CALL", "UNEXPECTED_TOOL_CALL", "TOO_MANY_TOOL_CALLS", "MALFORMED_RESPONSE"]
)
def test_a_call_that_the_model_spoilt_is_an_empty_answer(reason: str, stream: bool) -> None:
    fault = fault_of(Said([], reason), stream)
    assert fault.kind == "empty"
    assert reason in str(fault)


@pytest.mark.parametrize(
    ("code", "status", "kind"),
    [
        (503, "UNAVAILABLE", "overloaded"),
        (500, "INTERNAL", "overloaded"),
        (429, "RESOURCE_EXHAUSTED", "rate_limited"),
        (504, "DEADLINE_EXCEEDED", "timed_out"),
        (400, "INVALID_ARGUMENT", "bad_request"),
    ],
)
def test_an_error_in_the_middle_of_a_stream_has_its_kind(code: int, status: str, kind: FaultKind) -> None:
    """Its status was 200 long before."""
    error = chunk({"error": {"code": code, "message": "Sorry", "status": status}})
    assert fault_of(Reply.of_events([*chunks_of(SAID)[:2], error])).kind == kind


@pytest.mark.parametrize("cut", [True, False], ids=["connection lost", "closed in order"])
def test_a_stream_that_ends_too_soon_is_cut_off_wherever_it_ends(cut: bool) -> None:
    """After every chunk but the last, and in the middle of each; only then is the answer whole."""
    chunks = chunks_of(SAID)
    ends = [chunks[:count] for count in range(1, len(chunks))]
    ends += [[*chunks[:count], chunks[count][: len(chunks[count]) // 2]] for count in range(len(chunks))]
    replies = [Reply.of_events(end, cut) for end in ends]
    with answering(*replies, Reply.of_events(chunks), patience=ONCE) as asked:
        for _ in replies:
            with pytest.raises(ProviderError) as fault:
                asked.model(HELLO, [TOOL])
            assert fault.value.kind == "cut_off"
        assert asked.model(HELLO, [TOOL]).text == "Good day"


def test_a_stream_that_could_be_resumed_is_not_resumed_by_the_sdk() -> None:
    """How often to ask is for patience to say."""
    plain = response_of([text("Well")], None, None)
    plain["candidates"][0]["continuationToken"] = "bW9yZQ=="
    assert fault_of(Reply.of_events([chunk(plain)], cut=True)).kind == "cut_off"


def test_other_faults_are_not_asked_away() -> None:
    assert fault_of(failure(403, "PERMISSION_DENIED", "thought_signature, tool_config")).kind == "unauthorised"


def test_a_whole_answer_that_has_no_end_is_cut_off() -> None:
    assert fault_of(Reply.of_json(response_of([text("Well")], None, None)), stream=False).kind == "cut_off"


@pytest.mark.parametrize(
    "events",
    [
        [b"data: nonsense\n\n"],
        [b"data: 7\n\n"],
        [b"data: " + b"[" * 100_000 + b"\n\n"],
        [b'data: {"error": {"message": "without a code"}}\n\n'],
        [chunk({"candidates": [7]})],
        [chunk({"candidates": [{"content": {"parts": [{"thoughtSignature": "?", "text": "x"}]}}]})],
    ],
)
def test_events_that_are_none_are_no_answer(events: list[bytes]) -> None:
    assert fault_of(Reply.of_events(events)).kind == "failed"


@streaming
def test_a_provider_that_says_nothing_is_given_up(stream: bool) -> None:
    assert fault_of(Reply(held=True), stream, Patience(attempts=1, timeout_s=0.05)).kind == "timed_out"


@pytest.mark.parametrize(
    ("timeout_s", "total_s", "sent"), [(20, 90, "90"), (20, 5, "20"), (1, 5, "10"), (0.5, 10.2, "11")]
)
def test_the_server_may_take_longer_than_a_silence(timeout_s: float, total_s: float, sent: str) -> None:
    """As long as all attempts together, and never less than the 10 s that the API insists on."""
    with answering(Said([text("ok")]), patience=Patience(timeout_s=timeout_s, total_s=total_s)) as asked:
        asked.model(HELLO, [TOOL])
    assert asked.server.requests[0].headers["x-server-timeout"] == sent


def test_patience_without_end_can_be_had() -> None:
    with answering(Said([text("ok")]), patience=Patience(timeout_s=float("inf"), total_s=float("inf"))) as asked:
        assert asked.model(HELLO, [TOOL]).text == "ok"


@streaming
def test_a_provider_that_is_not_there_is_unreachable(stream: bool) -> None:
    model = GeminiModel("m", api_key=KEY, base_url=f"http://127.0.0.1:{closed_port()}", stream=stream, patience=ONCE)
    with pytest.raises(ProviderError) as fault:
        model(HELLO, [TOOL])
    assert fault.value.kind == "unreachable"


@pytest.mark.parametrize("name", ["", "a b", "../../x", "m?key=1", "m&x"])
def test_what_can_be_no_model_is_none(name: str) -> None:
    """The name goes into the address."""
    with pytest.raises(ProviderError) as fault:
        GeminiModel(name, api_key=KEY)
    assert fault.value.kind == "no_such_model"


@streaming
@pytest.mark.parametrize(
    ("reply", "seconds"),
    [
        (failure(429, "RESOURCE_EXHAUSTED", "quota", WAIT), 7.5),
        (failure(429, "RESOURCE_EXHAUSTED", "quota", WAIT, retry_after="9"), 7.5),
        (failure(503, "UNAVAILABLE", "busy", retry_after="9"), 9.0),
        (failure(429, "RESOURCE_EXHAUSTED", "quota", {"retryDelay": "soon"}), None),
        (failure(429, "RESOURCE_EXHAUSTED", "quota"), None),
    ],
)
def test_when_to_ask_again_is_told(reply: Reply, seconds: float | None, stream: bool) -> None:
    assert fault_of(reply, stream).retry_after_s == seconds


@streaming
def test_a_fault_that_passes_is_waited_out(stream: bool) -> None:
    slept: list[float] = []
    patience = Patience(sleep=slept.append, clock=lambda: 0.0)
    with answering(
        failure(429, "RESOURCE_EXHAUSTED", "quota", WAIT),
        Reply.of_events(chunks_of(SAID)[:2]) if stream else Reply(mute=True),
        Said([], "MALFORMED_FUNCTION_CALL"),
        SAID,
        stream=stream,
        patience=patience,
    ) as asked:
        assert asked.model(HELLO, [TOOL]).text == "Good day"
    # 7.5 as asked for; of our own 1, 2, 4 the first went by with it.
    assert slept == [7.5, 2, 4]
    assert [body == asked.bodies[0] for body in asked.bodies] == [True] * 4


@streaming
def test_the_key_is_in_no_word_even_if_it_is_sent_back(stream: bool) -> None:
    words = f"invalid key {KEY}\x1b[31m\n and again {KEY}" + "x" * 10_000
    fault = fault_of(failure(403, "PERMISSION_DENIED", words), stream)
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
    script: list[Said | Reply] = [Said([call(*INIT)]), Said([call(*SEARCH)]), Said([text("Done.")])]
    script[turn - 1] = failure(403, "PERMISSION_DENIED", json.dumps("no"))
    with answering(*script, patience=ONCE, stream=stream) as asked:
        made = author_tree(paper_brief(), asked.model)
    assert (made.status, [reason.rule for reason in made.reasons]) == ("provider_failed", ["provider_unauthorised"])
    assert (made.tree is not None) == (turn > 1)
