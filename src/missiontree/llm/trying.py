"""
What language models this machine can use: each provider is tried, not guessed at.

Trying a provider asks it for the list of its models, which costs nothing. Trying a model asks it to call a function, which costs a few
tokens.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from itertools import islice
from typing import Any, Literal

from missiontree.llm.chat import ChatModel, Message, ProviderError, Tool, Usage
from missiontree.llm.features import Features
from missiontree.llm.openai import OpenAIModel
from missiontree.llm.openai_probe import probe
from missiontree.llm.openai_words import Words, without_secrets
from missiontree.llm.opening import OLLAMA, PROVIDERS, Provider, Settings, open_model

State = Literal["ready", "lacking", "failed"]
TIMEOUT_S = 10.0
MOST_NAMES = 200
_PING = Tool(
    "ping",
    "Sends a word.",
    {"type": "object", "properties": {"word": {"type": "string", "enum": ["one"]}}, "required": ["word"]},
)
_QUESTION = (
    Message("system", "You test whether functions can be called. Do exactly what you are asked."),
    Message("user", 'Call ping with the word "one".', must_call=True),
)


@dataclass(frozen=True, slots=True)
class Tried:
    """
    What came of trying a provider.

    Parameters
    ----------
    name
        How its models are named: ``openai:NAME``.
    state
        ``ready``; ``lacking``: something has to be set or installed first; ``failed``: it was asked, and it did not answer well.
    says
        What it is, what is lacking, or what went wrong.
    models
        Names of its models, 200 at most; empty where it has none to tell.
    """

    name: str
    state: State
    says: str
    models: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class TriedModel:
    """
    What came of asking one model to call a function.

    Parameters
    ----------
    name
        The model, as it was named.
    calls
        Whether it called; without that it is of no use here.
    calls_together
        Whether it makes several calls in one answer; None if that was not tried.
    features
        What is made use of at its endpoint; None if it is not an OpenAI-compatible one.
    usage
        Tokens that asking took; None if they were not counted.
    fault
        Why it could not be asked; None if it could.
    """

    name: str
    calls: bool
    calls_together: bool | None = None
    features: Features | None = None
    usage: Usage | None = None
    fault: ProviderError | None = None


def try_providers(settings: Settings) -> Iterator[Tried]:
    """Try every provider, in the order of :data:`missiontree.llm.opening.PROVIDERS`; the offline author first, which is always there."""
    yield Tried("offline", "ready", "the built-in author: plain English, no model")
    yield Tried("recorded:FILE", "ready", "replays a dialogue that was recorded (plan --record FILE)")
    for provider in PROVIDERS.values():
        yield _tried(provider, settings)


def try_model(name: str, settings: Settings) -> TriedModel:
    """
    Ask one model to call a function.

    Parameters
    ----------
    name
        ``PROVIDER:MODEL``.
    settings
        What it is opened with.

    Raises
    ------
    InputError
        If the name names no model.
    """
    model = open_model(name, settings).model.model
    if isinstance(model, OpenAIModel):
        found = probe(model)
        return TriedModel(name, found.calls, found.calls_together, found.features, found.usage, found.fault)
    return _asked(name, model)


def _asked(name: str, model: ChatModel) -> TriedModel:
    try:
        said = model(_QUESTION, (_PING,))
    except ProviderError as fault:
        return TriedModel(name, calls=False, fault=fault)
    return TriedModel(name, calls=any(call.name == "ping" for call in said.calls), usage=said.usage)


def _tried(provider: Provider, settings: Settings) -> Tried:
    name = f"{provider.name}:{provider.example}"
    if provider.module and not _is_installed(provider.module):
        return Tried(name, "lacking", f"{provider.says}: pip install 'missiontree[{provider.name}]'")
    if provider.name == "local":
        return Tried(name, "ready", provider.says)
    key = next(filter(None, (settings.environment.get(variable) for variable in provider.keys)), "")
    url = _address(provider, settings)
    if provider.keys and not key and not url:
        return Tried(name, "lacking", f"{provider.says}: set {' or '.join(provider.keys)}")
    words = Words(tuple(filter(None, (key,))))
    try:
        models = tuple(islice(_LISTS[provider.name](url, key), MOST_NAMES))
    except Exception as error:  # whatever an SDK raises is what came of trying it
        said = words.clean(str(error), 200) or type(error).__name__
        if provider.name == "ollama" and type(error).__name__ == "APIConnectionError":
            return Tried(name, "lacking", f"{provider.says}: no server answers")
        at = f", at {without_secrets(url)}" if url else ""
        return Tried(name, "failed", f"{provider.says}{at}: {said}")
    return Tried(name, "ready", provider.says, models)


def _is_installed(module: str) -> bool:
    try:
        return find_spec(module) is not None
    except ModuleNotFoundError:  # a package above it is missing
        return False


def _address(provider: Provider, settings: Settings) -> str:
    if provider.name == "ollama":
        return settings.base_url or OLLAMA
    if provider.name == "openai":
        return settings.base_url or settings.environment.get("OPENAI_BASE_URL", "")
    return ""


def _openai_models(url: str, key: str) -> Iterator[str]:
    import openai

    client = openai.OpenAI(base_url=url or None, api_key=key or "no-key-needed", max_retries=0, timeout=TIMEOUT_S)
    return (model.id for model in client.models.list())


def _anthropic_models(url: str, key: str) -> Iterator[str]:
    import anthropic

    client = anthropic.Anthropic(api_key=key, max_retries=0, timeout=TIMEOUT_S)
    return (model.id for model in client.models.list())


def _gemini_models(url: str, key: str) -> Iterator[str]:
    from google import genai

    client = genai.Client(api_key=key, http_options={"timeout": int(1000 * TIMEOUT_S)})
    return ((model.name or "").removeprefix("models/") for model in client.models.list())


_LISTS: Mapping[str, Callable[[str, str], Iterator[Any]]] = {
    "openai": _openai_models,
    "ollama": _openai_models,
    "anthropic": _anthropic_models,
    "gemini": _gemini_models,
}
