"""
Chat models by name: ``openai:gpt-x``, ``ollama:qwen3``, ``local:model.gguf`` and so on.

Nothing here is asked unless it was named: a key that lies about in the environment opens nothing.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import urlsplit

from missiontree.errors import InputError
from missiontree.llm.chat import ChatModel, Listener, deaf
from missiontree.llm.discreet import Discreet
from missiontree.llm.feature_memory import FeatureMemory
from missiontree.llm.patience import Patience

OLLAMA = "http://localhost:11434/v1"


@dataclass(frozen=True, slots=True)
class Settings:
    """
    What a model is opened with.

    Parameters
    ----------
    base_url
        Address of an OpenAI-compatible endpoint, for ``openai:`` and ``ollama:``; empty for the usual one. Never taken from a mission
        file, since the key of the environment goes to where it points.
    listen
        Told each piece of text as it comes in.
    patience
        How long answers are waited for.
    environment
        Where keys are found.
    memory
        File in which is kept what endpoints were found to lack; None keeps it in this process.
    """

    base_url: str = ""
    listen: Listener = deaf
    patience: Patience = Patience()
    environment: Mapping[str, str] = field(default_factory=lambda: os.environ)
    memory: Path | None = None


@dataclass(frozen=True, slots=True)
class Opened:
    """
    A model that can be asked.

    Parameters
    ----------
    model
        The model.
    source
        Whose it is: ``openai``, ``anthropic``, ``gemini``, ``ollama`` or ``local``.
    name
        Its name there.
    endpoint
        Address of the endpoint, without anything secret; empty for the provider's own.
    """

    model: Discreet
    source: str
    name: str
    endpoint: str = ""


@dataclass(frozen=True, slots=True)
class Provider:
    """
    Who models can be had from.

    Parameters
    ----------
    name
        What stands before the colon.
    example
        What stands behind it.
    says
        What it is, for people.
    keys
        Variables of the environment, one of which must hold a key; none if no key is needed.
    open
        Opens a model by its name there; gives it and the address of its endpoint, which is empty for the provider's own.
    module
        Module of an extra that it needs; empty if it needs none.
    """

    name: str
    example: str
    says: str
    keys: tuple[str, ...]
    open: Callable[[str, Settings], tuple[ChatModel, str]]
    module: str = ""


def open_model(name: str, settings: Settings) -> Opened:
    """
    Open the model of that name.

    Parameters
    ----------
    name
        ``PROVIDER:MODEL``.
    settings
        What it is opened with.

    Raises
    ------
    InputError
        If there is no such provider, no model is named, or ``base_url`` is given for a provider that has none.
    """
    provider_name, _, model = name.partition(":")
    provider = PROVIDERS.get(provider_name)
    if provider is None or not model.strip():
        raise no_such_model(name)
    if settings.base_url and provider_name not in {"openai", "ollama"}:
        raise InputError(f"--base-url is given for {name!r}", accepted="openai:NAME or ollama:NAME with --base-url")
    if settings.base_url and urlsplit(settings.base_url).scheme not in {"http", "https"}:
        raise InputError(f"--base-url {settings.base_url!r:.100} is no address", accepted="http://... or https://...")
    opened, endpoint = provider.open(model, settings)
    keys = [settings.environment.get(variable, "") for variable in provider.keys]
    called = Path(model).name if provider_name == "local" else model
    return Opened(Discreet(opened, keys), provider_name, called, endpoint)


def no_such_model(name: str) -> InputError:
    """The error for a name that names no model."""
    known = ", ".join(f"{provider.name}:{provider.example}" for provider in PROVIDERS.values())
    return InputError(
        f"there is no model {name!r:.100}",
        accepted=f"offline, recorded:FILE, {known}",
        hint="It was named by --model, by the environment's MISSIONTREE_MODEL, or by the mission file. "
        "`missiontree models` tells what can be used here.",
    )


def keys_found(environment: Mapping[str, str]) -> tuple[tuple[str, Provider], ...]:
    """Variables that hold a key, with the provider each is for."""
    return tuple((key, provider) for provider in PROVIDERS.values() for key in provider.keys if environment.get(key))


def _openai(model: str, settings: Settings) -> tuple[ChatModel, str]:
    from missiontree.llm.openai import OpenAIModel

    url = settings.base_url or settings.environment.get("OPENAI_BASE_URL", "")
    opened = OpenAIModel(
        model,
        base_url=url or None,
        api_key=settings.environment.get("OPENAI_API_KEY"),
        listen=settings.listen,
        patience=settings.patience,
        memory=FeatureMemory(settings.memory),
    )
    return opened, opened.endpoint if url else ""


def _ollama(model: str, settings: Settings) -> tuple[ChatModel, str]:
    from missiontree.llm.openai import OpenAIModel

    opened = OpenAIModel(
        model,
        base_url=settings.base_url or OLLAMA,
        api_key="ollama",
        listen=settings.listen,
        patience=settings.patience,
        memory=FeatureMemory(settings.memory),
    )
    return opened, opened.endpoint


def _anthropic(model: str, settings: Settings) -> tuple[ChatModel, str]:
    from missiontree.llm.anthropic import AnthropicModel

    key = settings.environment.get("ANTHROPIC_API_KEY")
    return AnthropicModel(model, api_key=key, listen=settings.listen, patience=settings.patience), ""


def _gemini(model: str, settings: Settings) -> tuple[ChatModel, str]:
    from missiontree.llm.gemini import GeminiModel

    key = settings.environment.get("GEMINI_API_KEY") or settings.environment.get("GOOGLE_API_KEY")
    return GeminiModel(model, api_key=key, listen=settings.listen, patience=settings.patience), ""


def _local(path: str, settings: Settings) -> tuple[ChatModel, str]:
    from missiontree.llm.local import LocalModel

    return LocalModel(Path(path), listen=settings.listen), ""


PROVIDERS: dict[str, Provider] = {
    provider.name: provider
    for provider in (
        Provider(
            "openai",
            "NAME",
            "OpenAI, or with --base-url any endpoint of the same form (vLLM, llama-server, LM Studio)",
            ("OPENAI_API_KEY",),
            _openai,
        ),
        Provider("anthropic", "NAME", "Anthropic", ("ANTHROPIC_API_KEY",), _anthropic, "anthropic"),
        Provider("gemini", "NAME", "Google Gemini", ("GEMINI_API_KEY", "GOOGLE_API_KEY"), _gemini, "google.genai"),
        Provider("ollama", "NAME", f"an Ollama server, at {OLLAMA} or --base-url", (), _ollama),
        Provider("local", "FILE.gguf", "a model in this process, from a GGUF file", (), _local, "mistralrs"),
    )
}
