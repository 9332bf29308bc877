"""Every way in which an endpoint says no: of the right kind, in words a person can use, and never with a key in them."""

from __future__ import annotations

import gzip
from typing import Any

import pytest

from missiontree.llm import openai_http
from missiontree.llm.chat import FaultKind, Message, ProviderError, Tool
from missiontree.llm.openai import OpenAIModel
from missiontree.llm.patience import Patience
from tests.llm.endpoint import KEY, Endpoint
from tests.llm.endpoint_replies import Reply, Turn, delta, error, events, json_body

TALK = [Message("system", "s"), Message("user", "u")]
ONCE = Patience(attempts=1)
HTML = {"content-type": "text/html"}


def fault_of(reply: Reply, patience: Patience = ONCE, tools: tuple[Tool, ...] = ()) -> ProviderError:
    with Endpoint([Turn("hello")], objection=lambda body: reply) as endpoint:
        model = OpenAIModel("gpt-x", base_url=endpoint.url, api_key=KEY, patience=patience)
        with pytest.raises(ProviderError) as raised:
            model(TALK, tools)
    assert KEY not in f"{raised.value!r} {raised.value} {raised.value.hint}"
    assert len(str(raised.value)) < 700
    assert str(raised.value).isprintable()
    return raised.value


@pytest.mark.parametrize(
    ("reply", "kind", "words"),
    [
        (error(401, "Incorrect API key provided."), "unauthorised", "Incorrect API key"),
        (error(403, "Not in your country."), "unauthorised", "Not in your country"),
        (error(404, "The model gpt-x does not exist.", "model_not_found"), "no_such_model", "does not exist"),
        (Reply((b"404 page not found",), 404, {"content-type": "text/plain"}), "no_such_model", "404 page not found"),
        (error(408, "slow"), "timed_out", "slow"),
        (error(409, "busy"), "overloaded", "busy"),
        (error(429, "Slow down."), "rate_limited", "Slow down"),
        (error(429, "You exceeded your current quota.", "insufficient_quota"), "failed", "exceeded"),
        (error(402, "Insufficient Balance"), "failed", "Balance"),
        (error(500, "Oops."), "overloaded", "Oops"),
        (error(502, "Bad gateway."), "overloaded", "gateway"),
        (error(503, "Busy."), "overloaded", "Busy"),
        (error(504, "Late."), "overloaded", "Late"),
        (error(529, "Overloaded."), "overloaded", "Overloaded"),
        (error(501, "No."), "bad_request", "No"),
        (error(400, "Odd."), "bad_request", "Odd"),
        (error(418, "Tea."), "bad_request", "Tea"),
        (error(400, "x", "context_length_exceeded"), "context_overflow", "x"),
        (error(400, "This model's maximum context length is 4096 tokens."), "context_overflow", "4096"),
        (error(400, "the request exceeds the available context size"), "context_overflow", "context size"),
        (error(400, "prompt is too long: 9 tokens > 8 maximum"), "context_overflow", "too long"),
        (error(500, "context length exceeded"), "context_overflow", "exceeded"),
        (Reply((b"<html>Request Entity Too Large",), 413, HTML), "context_overflow", "413"),
        (Reply((b"<html>Bad Gateway",), 502, HTML), "overloaded", "502"),
        (json_body({"detail": "Not Found"}, 404), "no_such_model", "Not Found"),
        (json_body({"detail": [{"loc": ["body", "x"], "msg": "wrong"}]}, 400), "bad_request", "body x wrong"),
        (json_body([{"error": {"code": 429, "message": "Slow down."}}], 429), "rate_limited", "Slow down"),
        (json_body({"error": "just a text"}, 500), "overloaded", "just a text"),
        (json_body({"message": {"detail": "inside"}}, 500), "overloaded", "inside"),
        (Reply((b"[" * 100_000,), 500, {"content-type": "application/json"}), "overloaded", "500"),
        (Reply((), 500), "overloaded", "500"),
        (json_body({"error": {"message": "Died.", "code": 503}}), "overloaded", "Died"),
        (json_body({"error": {"message": "Late.", "type": "timeout"}}), "overloaded", "Late"),
        (json_body({"error": {"message": "Slow.", "code": "429"}}), "rate_limited", "Slow"),
        (json_body({"error": "text"}), "overloaded", "text"),
        (json_body({"object": "error", "message": "Bad.", "code": 404}), "no_such_model", "Bad"),
        (
            events([delta({"content": "a"}), {"error": {"message": "No key.", "type": "authentication_error"}}]),
            "unauthorised",
            "No key",
        ),
        (events([{"error": {"message": "Paid?", "code": "insufficient_quota"}}]), "failed", "Paid"),
    ],
    ids=str,
)
def test_an_error_is_of_its_kind_and_in_the_endpoints_words(reply: Reply, kind: FaultKind, words: str) -> None:
    fault = fault_of(reply)
    assert (fault.kind, words in str(fault)) == (kind, True), str(fault)
    assert str(fault).startswith("127.0.0.1:")
    assert fault.hint


@pytest.mark.parametrize(
    ("headers", "seconds"),
    [
        ({}, None),
        ({"retry_after": "7"}, 7),
        ({"retry_after": "0.5"}, 0.5),
        ({"retry_after": "-3"}, None),
        ({"retry_after": "soon"}, None),
        ({"retry_after": "nan"}, None),
        ({"retry_after": "Wed, 21 Oct 2015 07:28:30 GMT"}, None),
        ({"retry_after": "7", "retry_after_ms": "1500"}, 1.5),
        ({"retry_after": "Wed, 21 Oct 2015 07:28:30 GMT", "date": "Wed, 21 Oct 2015 07:28:00 GMT"}, 30),
        ({"retry_after": "Wed, 21 Oct 2015 07:28:00 GMT", "date": "Wed, 21 Oct 2015 07:28:30 GMT"}, 0),
    ],
)
@pytest.mark.parametrize("status", [429, 503])
def test_when_to_ask_again_is_taken_from_the_headers(
    status: int, headers: dict[str, str], seconds: float | None
) -> None:
    assert fault_of(error(status, "no", None, **headers)).retry_after_s == seconds


@pytest.mark.parametrize(
    ("reply", "part"),
    [
        (error(401, "no"), "OPENAI_API_KEY"),
        (error(404, "no"), "'gpt-x'"),
        (error(429, "no", "insufficient_quota"), "bill"),
        (error(400, "x", "context_length_exceeded"), "longer context"),
        (Reply((b"<html>",), 200, HTML), "/v1"),
        (json_body({"hello": "world"}), "/v1"),
    ],
)
def test_the_hint_says_what_to_do(reply: Reply, part: str) -> None:
    assert part in fault_of(reply).hint


@pytest.mark.parametrize("status", [301, 302, 307, 308])
def test_a_redirect_is_told_and_not_followed(status: int) -> None:
    """The other server would get the key; it is not even asked."""
    with Endpoint([Turn("hello")]) as other:
        location = other.url.replace("http://", f"http://user:{KEY}@") + f"/chat/completions?key={KEY}"
        fault = fault_of(Reply((b"",), status, {"location": location}))
    assert other.requests == []
    assert fault.kind == "failed"
    assert other.url in str(fault)
    assert "base URL" in fault.hint


@pytest.mark.parametrize(
    "message",
    [
        f"The key {KEY} is wrong",
        f"x{KEY}{KEY}y",
        f"{'.' * 290}{KEY}",
        "Authorization: Bearer abcdefghijklmnop was not taken",
        "the key sk-0123456789abcdefABCDEF is unknown",
    ],
)
def test_a_key_that_is_sent_back_is_not_shown(message: str) -> None:
    """Not even the part of it that stands before the text is shortened."""
    shown = str(fault_of(error(401, message)))
    for part in (KEY[:12], "abcdefghijklmnop", "sk-0123"):
        assert part not in shown


def test_what_is_secret_in_the_address_is_not_shown_either() -> None:
    """User and password stand in it, and the value of a query; the server sends all of them back, in both spellings."""
    reply = error(500, "anna came with geheim%2F123, that is geheim/123, and with abcdef12")
    with Endpoint([Turn()], objection=lambda body: reply) as endpoint:
        url = endpoint.url.replace("http://", "http://anna:geheim%2F123@") + "?api-key=abcdef12"
        model = OpenAIModel("m", base_url=url, patience=ONCE)
        with pytest.raises(ProviderError) as raised:
            model(TALK, ())
    shown = f"{raised.value} {raised.value.hint}"
    assert shown.count("[a key was here]") == 4
    for secret in ("anna", "geheim", "abcdef12"):
        assert secret not in shown
    assert endpoint.headers[0]["authorization"].startswith("Basic ")
    assert endpoint.headers[0][":path"] == "/v1/chat/completions?api-key=abcdef12"


def test_control_characters_do_no_harm_and_words_are_bounded() -> None:
    """Terminal sequences, letters that turn the writing round, and a text of a million letters."""
    nasty = "\x1b[31mred\x07\r\n\u202eabc\u2066\ud800 " + "a" * 1_000_000
    shown = str(fault_of(error(400, nasty)))
    assert "\x1b" not in shown
    assert "\u202e" not in shown
    assert len(shown) < 400


@pytest.mark.parametrize("status", [200, 500])
def test_an_answer_that_is_too_large_is_given_up(status: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Sent as 10 kB, unpacked 10 MB, allowed 1 MB: the unpacked size counts, of errors too."""
    monkeypatch.setattr(openai_http, "LARGEST", 2**20)
    packed = gzip.compress(b'{"a": "' + b"a" * 10_000_000 + b'"}')
    headers = {"content-type": "application/json", "content-encoding": "gzip"}
    fault = fault_of(Reply((packed,), status, headers))
    assert (fault.kind, "larger than 1 MiB" in str(fault)) == ("failed", True)


def test_an_answer_that_is_packed_is_unpacked() -> None:
    body = gzip.compress(b'{"choices": [{"message": {"content": "hello"}}]}')
    reply = Reply((body,), headers={"content-type": "application/json", "content-encoding": "gzip"})
    with Endpoint([Turn()], objection=lambda body: reply) as endpoint:
        assert OpenAIModel("m", base_url=endpoint.url)(TALK, ()).text == "hello"


def test_a_packed_answer_that_cannot_be_unpacked_is_none() -> None:
    reply = Reply((b"no gzip",), headers={"content-type": "application/json", "content-encoding": "gzip"})
    assert fault_of(reply).kind == "failed"


def test_an_answer_that_never_ends_is_given_up_after_the_time_of_all_attempts() -> None:
    """The clock says 1 at the request and goes on by 100 with every piece: at the fourth it is past 1 + 300."""
    seconds = iter([0.0, *(1.0 + 100 * number for number in range(100))])
    patience = Patience(attempts=1, total_s=300, clock=lambda: next(seconds))
    fault = fault_of(events([delta({"content": "."})] * 50, "hold"), patience)
    assert (fault.kind, "300 s" in str(fault)) == ("timed_out", True)


def test_silence_is_timed_out() -> None:
    fault = fault_of(Reply(ending="hold"), Patience(attempts=1, timeout_s=0.05))
    assert (fault.kind, "0.05 s" in str(fault)) == ("timed_out", True)


def test_a_fault_does_not_drag_the_request_with_its_key_along() -> None:
    """What a report of the fault prints of its causes is nothing but our own faults."""
    fault: BaseException | None = fault_of(error(401, "no"), Patience(attempts=2))
    seen: list[Any] = []
    while fault is not None:
        seen.append(fault)
        fault = fault.__cause__ or (None if fault.__suppress_context__ else fault.__context__)
    assert {isinstance(each, ProviderError) for each in seen} == {True}
