"""Providers are tried over real HTTP on loopback; what is lacking, what fails and what is ready are told apart."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Thread
from typing import Any

import pytest

from missiontree.llm.opening import Settings
from missiontree.llm.patience import Patience
from missiontree.llm.trying import Tried, try_model, try_providers
from tests.llm.endpoint import KEY, Endpoint, nobody_listening
from tests.llm.endpoint_replies import Turn

LISTS = {
    "/v1/models": {"object": "list", "data": [{"id": "large", "object": "model", "created": 1, "owned_by": "us"}]},
}


@contextmanager
def listing(status: int = 200, body: Any = None) -> Iterator[str]:
    """A server that lists models, or answers as it is told."""

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            plain = body if body is not None else LISTS[self.path.partition("?")[0]]
            data = json.dumps(plain).encode()
            self.send_response(status)
            self.send_header("content-type", "application/json")
            self.send_header("content-length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        def log_message(self, format: str, *args: Any) -> None:
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        thread = Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_address[1]}/v1"
        finally:
            server.shutdown()
            thread.join()


def tried(environment: Mapping[str, str], base_url: str = "") -> dict[str, Tried]:
    with nobody_listening() as nowhere:
        settings = Settings(environment=environment, base_url=base_url or nowhere)
        return {one.name.partition(":")[0]: one for one in try_providers(settings)}


def test_the_offline_author_is_always_there() -> None:
    assert (tried({})["offline"].state, tried({})["recorded"].state) == ("ready", "ready")


def test_without_keys_nothing_is_asked_and_what_to_set_is_said() -> None:
    found = tried({})
    assert (found["anthropic"].state, found["gemini"].state) == ("lacking", "lacking")
    assert "set ANTHROPIC_API_KEY" in found["anthropic"].says
    assert "set GEMINI_API_KEY or GOOGLE_API_KEY" in found["gemini"].says


def test_an_endpoint_that_answers_is_ready_with_its_models() -> None:
    with listing() as url:
        found = tried({"OPENAI_API_KEY": KEY}, url)["openai"]
    assert (found.state, found.models) == ("ready", ("large",))


def test_an_endpoint_that_does_not_answer_has_failed() -> None:
    found = tried({"OPENAI_API_KEY": KEY})["openai"]
    assert found.state == "failed"
    assert "at http://127.0.0.1:" in found.says


def test_an_ollama_server_that_is_not_there_is_lacking() -> None:
    assert tried({})["ollama"].state == "lacking"


def test_a_key_that_is_echoed_is_not_told() -> None:
    with listing(401, {"error": {"message": f"Incorrect API key provided: {KEY}."}}) as url:
        found = tried({"OPENAI_API_KEY": KEY}, url)["openai"]
    assert found.state == "failed"
    assert "Incorrect API key provided" in found.says
    assert KEY not in found.says


def settings(url: str) -> Settings:
    return Settings(base_url=url, environment={"OPENAI_API_KEY": KEY}, patience=Patience(attempts=1))


def test_a_model_that_calls_is_told_with_what_its_endpoint_supports() -> None:
    """Asked for one call by name, for one of two, and for two together."""
    ping, pong = ("ping", {"word": "one"}), ("pong", {"word": "two"})
    with Endpoint([Turn(calls=(ping,)), Turn(calls=(ping,)), Turn(calls=(ping, pong))]) as endpoint:
        found = try_model("openai:large", settings(endpoint.url))
    assert (found.calls, found.calls_together, found.fault) == (True, True, None)
    assert found.features is not None
    assert found.features.missing == ()
    assert endpoint.violations == []


def test_a_model_that_only_talks_is_of_no_use() -> None:
    with Endpoint([Turn("pong!")]) as endpoint:
        found = try_model("openai:small", settings(endpoint.url))
    assert (found.calls, found.fault) == (False, None)


def test_a_model_that_cannot_be_asked_has_a_fault() -> None:
    with nobody_listening() as nowhere:
        found = try_model("openai:none", settings(nowhere))
    assert found.fault is not None
    assert found.fault.kind == "unreachable"


@pytest.mark.parametrize("name", ["offline", "nobody:x"])
def test_what_is_no_language_model_cannot_be_asked(name: str) -> None:
    from missiontree.errors import InputError

    with pytest.raises(InputError, match="there is no model"):
        try_model(name, settings("http://127.0.0.1:9/v1"))
