"""Models by name: what is accepted, what is refused in words, and that nothing is opened unasked."""

from __future__ import annotations

import subprocess
import sys

import pytest

from missiontree.errors import InputError
from missiontree.llm.opening import PROVIDERS, Settings, keys_found, open_model

KEYS = {
    "OPENAI_API_KEY": "sk-openai-0",
    "ANTHROPIC_API_KEY": "sk-anthropic-0",
    "GEMINI_API_KEY": "sk-gemini-0",
}


@pytest.mark.parametrize("name", ["", "gpt-x", "openai", "openai:", "openai: ", "cohere:x", "OPENAI:x"])
def test_what_names_no_model_is_refused_with_those_there_are(name: str) -> None:
    with pytest.raises(InputError) as error:
        open_model(name, Settings(environment={}))
    assert "recorded:FILE, openai:NAME" in error.value.accepted


@pytest.mark.parametrize(("provider", "endpoint"), [("openai", ""), ("anthropic", ""), ("gemini", "")])
def test_providers_are_opened_by_name(provider: str, endpoint: str) -> None:
    opened = open_model(f"{provider}:some/model:7b", Settings(environment=KEYS))
    assert (opened.source, opened.name, opened.endpoint) == (provider, "some/model:7b", endpoint)


def test_ollama_needs_no_key_and_says_where_it_is() -> None:
    opened = open_model("ollama:qwen3", Settings(environment={}))
    assert (opened.source, opened.name, opened.endpoint) == ("ollama", "qwen3", "http://localhost:11434/v1")


def test_an_endpoint_of_ones_own_is_named_without_its_secrets() -> None:
    settings = Settings(base_url="https://me:secret@host.example:8000/v1?key=secret", environment={})
    assert open_model("openai:x", settings).endpoint == "https://host.example:8000/v1"


@pytest.mark.parametrize("name", ["anthropic:x", "gemini:x", "local:x.gguf"])
def test_an_address_is_refused_where_it_would_be_ignored(name: str) -> None:
    with pytest.raises(InputError, match="--base-url is given"):
        open_model(name, Settings(base_url="http://localhost:1/v1", environment=KEYS))


@pytest.mark.parametrize("url", ["localhost:8000", "file:///etc/passwd", "no address"])
def test_an_address_that_is_none_is_refused(url: str) -> None:
    with pytest.raises(InputError, match="is no address"):
        open_model("openai:x", Settings(base_url=url, environment=KEYS))


def test_keys_are_found_with_whom_they_are_for() -> None:
    found = [(key, provider.name) for key, provider in keys_found({"GOOGLE_API_KEY": "k", "OPENAI_API_KEY": ""})]
    assert found == [("GOOGLE_API_KEY", "gemini")]


def test_every_provider_says_what_it_is() -> None:
    for name, provider in PROVIDERS.items():
        assert (name, bool(provider.says), bool(provider.example)) == (provider.name, True, True)


def test_no_sdk_is_loaded_before_a_model_is_opened() -> None:
    loaded = "import sys, missiontree.llm.opening; print([m for m in ('openai', 'anthropic', 'google', 'mistralrs') if m in sys.modules])"
    ran = subprocess.run([sys.executable, "-c", loaded], capture_output=True, text=True, check=True)
    assert ran.stdout == "[]\n"
