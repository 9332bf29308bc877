"""The whole way: the real SDK, a real connection, and what becomes of the answer."""

from __future__ import annotations

import subprocess
import sys

import pytest

from missiontree.llm.chat import Message, ProviderError, Tool, ToolCall, Usage
from missiontree.llm.openai import OPENAI, OpenAIModel
from missiontree.llm.patience import Patience
from tests.llm.endpoint import KEY, Endpoint, nobody_listening
from tests.llm.endpoint_replies import Reply, Turn, delta, error, events

PING = Tool(
    "ping", "Pings.", {"type": "object", "properties": {"word": {"type": "string"}}, "additionalProperties": False}
)
TALK = [Message("system", "s"), Message("user", "u")]
ONCE = Patience(attempts=1)
SAID = Turn("Héllo, wörld.", (("ping", {"word": "ü"}), ("ping", {"word": None})))


@pytest.mark.parametrize("stream", [True, False])
def test_an_answer_is_the_same_streamed_and_whole(stream: bool) -> None:
    with Endpoint([SAID]) as endpoint:
        model = OpenAIModel("m", base_url=endpoint.url, api_key=KEY, stream=stream)
        said = model(TALK, [PING])
    assert endpoint.violations == []
    assert (said.text, said.finish, said.usage) == ("Héllo, wörld.", "stop", Usage(100, 10))
    assert [(call.name, call.arguments) for call in said.calls] == [("ping", '{"word": "\\u00fc"}'), ("ping", "{}")]
    assert endpoint.headers[0]["authorization"] == f"Bearer {KEY}"
    assert endpoint.requests[0].get("stream", False) is stream


def test_the_listener_hears_the_text_as_it_comes_in() -> None:
    heard: list[str] = []
    with Endpoint([SAID]) as endpoint:
        OpenAIModel("m", base_url=endpoint.url, listen=heard.append)(TALK, [])
        OpenAIModel("m", base_url=endpoint.url, listen=heard.append, stream=False)(TALK, [])
    assert heard == ["Héllo, ", "wörld.", "Héllo, wörld."]


def test_what_a_listener_raises_is_its_own_affair() -> None:
    """An OSError of a closed terminal is no fault of the provider."""

    def closed(piece: str) -> None:
        raise BrokenPipeError("the terminal is closed")

    with Endpoint([SAID]) as endpoint, pytest.raises(BrokenPipeError):
        OpenAIModel("m", base_url=endpoint.url, listen=closed, patience=ONCE)(TALK, [])


def test_an_answer_that_is_asked_for_again_holds_nothing_of_the_first_attempt() -> None:
    naps: list[float] = []
    broken = events([delta({"content": "I was about "})], "cut")
    with Endpoint([SAID], {1: [lambda turn, stream: broken]}) as endpoint:
        said = OpenAIModel("m", base_url=endpoint.url, patience=Patience(sleep=naps.append))(TALK, [PING])
    assert (said.text, len(said.calls), naps, len(endpoint.requests)) == ("Héllo, wörld.", 2, [1.0], 2)


def test_a_server_that_streams_unasked_is_understood_and_so_is_one_that_does_not_stream() -> None:
    streamed = events([delta({"content": "streamed"}), delta({}, "stop"), "[DONE]"])
    whole = Reply((b'{"choices": [{"message": {"content": "whole"}}]}',), headers={"content-type": "application/json"})
    for reply, stream, text in ((streamed, False, "streamed"), (whole, True, "whole")):
        with Endpoint([Turn()], objection=lambda body, reply=reply: reply) as endpoint:  # type: ignore[misc]
            assert OpenAIModel("m", base_url=endpoint.url, stream=stream)(TALK, []).text == text


def test_limits_are_sent_if_they_are_given() -> None:
    with Endpoint([SAID]) as endpoint:
        OpenAIModel("m", base_url=endpoint.url, max_output_tokens=50, temperature=0.5)(TALK, [])
    assert (endpoint.requests[0]["max_completion_tokens"], endpoint.requests[0]["temperature"]) == (50, 0.5)


def test_a_prompt_that_a_filter_stops_is_filtered_and_no_fault() -> None:
    with Endpoint([Turn()], objection=lambda body: error(400, "no", "content_filter")) as endpoint:
        assert OpenAIModel("m", base_url=endpoint.url)(TALK, []).finish == "filtered"


def test_a_server_of_ones_own_needs_no_key(monkeypatch: pytest.MonkeyPatch) -> None:
    with Endpoint([SAID]) as endpoint:
        OpenAIModel("m", base_url=endpoint.url)(TALK, [])
        monkeypatch.setenv("OPENAI_API_KEY", f"  {KEY}\n")
        OpenAIModel("m", base_url=endpoint.url)(TALK, [])
        monkeypatch.setenv("OPENAI_BASE_URL", endpoint.url)
        OpenAIModel("m")(TALK, [])
    keys = [headers["authorization"] for headers in endpoint.headers]
    assert keys == ["Bearer no-key-needed", f"Bearer {KEY}", f"Bearer {KEY}"]


def test_openai_itself_needs_one() -> None:
    model = OpenAIModel("m")
    assert (model.endpoint, model.host) == (OPENAI, "api.openai.com")
    with pytest.raises(ProviderError, match=r"no key for api\.openai\.com") as raised:
        model(TALK, [])
    assert raised.value.kind == "unauthorised"
    assert "OPENAI_API_KEY" in raised.value.hint


@pytest.mark.parametrize("key", ["sk-mïssing-letters", "sk-a b", "sk-a\nb"])
def test_a_key_that_can_be_none_is_not_sent_and_not_shown(key: str) -> None:
    with Endpoint([SAID]) as endpoint, pytest.raises(ProviderError, match="holds blanks or letters") as raised:
        OpenAIModel("m", base_url=endpoint.url, api_key=key)(TALK, [])
    assert key not in f"{raised.value} {raised.value.hint}"
    assert endpoint.requests == []


@pytest.mark.parametrize(
    "url", ["localhost:8000", "ftp://host/v1", "http://", "http://[::1/v1", "http://host:port/v1", "//host/v1", "v1"]
)
def test_an_address_that_is_none_is_a_fault_of_the_call(url: str) -> None:
    with pytest.raises(ProviderError, match="no address") as raised:
        OpenAIModel("m", base_url=url)(TALK, [])
    assert raised.value.kind == "failed"


def test_a_server_that_is_not_there_is_named_with_what_to_do() -> None:
    with nobody_listening() as url, pytest.raises(ProviderError) as raised:
        OpenAIModel("m", base_url=url, patience=ONCE)(TALK, [])
    assert raised.value.kind == "unreachable"
    assert url in str(raised.value)
    assert url in raised.value.hint


def test_what_runs_on_this_machine_is_asked_without_a_proxy(monkeypatch: pytest.MonkeyPatch) -> None:
    with nobody_listening() as proxy, Endpoint([SAID]) as endpoint:
        for name in ("HTTP_PROXY", "http_proxy", "ALL_PROXY", "all_proxy"):
            monkeypatch.setenv(name, proxy)
        assert OpenAIModel("m", base_url=endpoint.url, patience=ONCE)(TALK, []).text == "Héllo, wörld."


def test_what_does_not_goes_through_the_proxy_of_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nobody listens at the proxy, so the fault shows that it was asked; the host's name can be found nowhere."""
    with nobody_listening() as proxy:
        for name in ("NO_PROXY", "no_proxy", "ALL_PROXY", "all_proxy"):
            monkeypatch.delenv(name, raising=False)
        monkeypatch.setenv("http_proxy", proxy.removesuffix("/v1"))
        with pytest.raises(ProviderError, match="refused") as raised:
            OpenAIModel("m", base_url="http://models.invalid/v1", patience=ONCE)(TALK, [])
    assert raised.value.kind == "unreachable"


def test_the_address_is_shown_without_what_is_secret_in_it() -> None:
    model = OpenAIModel("m", base_url="https://anna:geheim123@host.example:8443/openai/v1/?api-key=abcdef12#top")
    assert model.endpoint == "https://host.example:8443/openai/v1"
    assert model.host == "host.example:8443"


def test_two_calls_of_one_id_come_out_as_two() -> None:
    calls = [{"index": at, "id": "same", "function": {"name": "ping", "arguments": "{}"}} for at in (0, 1)]
    reply = events([delta({"tool_calls": calls}), delta({}, "tool_calls"), "[DONE]"])
    with Endpoint([Turn()], objection=lambda body: reply) as endpoint:
        said = OpenAIModel("m", base_url=endpoint.url)(TALK, [PING])
    assert said.calls == (ToolCall("same", "ping", "{}"), ToolCall("call00002", "ping", "{}"))


def test_importing_it_and_making_a_model_loads_no_sdk() -> None:
    code = (
        "import sys; from missiontree.llm.openai import OpenAIModel; import missiontree.llm.openai_probe;"
        "OpenAIModel('m', api_key='sk-1'); print({'openai', 'httpx2', 'pydantic'} & set(sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"
