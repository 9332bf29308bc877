"""Who is put to a suite."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from threading import Lock

from missiontree.formats.source import load_text
from missiontree.llm.chat import ChatModel, Message, ProviderError, Tool
from missiontree.llm.openai_words import without_secrets
from missiontree.llm.opening import Settings, no_such_model, open_model

_AT = "@http"
_WITH_ADDRESS = ("openai:", "ollama:")


@dataclass(frozen=True, slots=True)
class Contestant:
    """
    A model that is put to a suite.

    Parameters
    ----------
    name
        What it is called in results.
    model
        Name of a model as ``missiontree plan --model`` takes it, or a function without arguments that makes a chat model; it is called
        for each run, and what it makes is asked in one thread at a time.
    base_url
        Address that a model by name is asked at; empty for the usual one.
    """

    name: str
    model: str | Callable[[], ChatModel]
    base_url: str = ""

    def ready(self) -> str | ChatModel:
        """
        The model for one run.

        Raises
        ------
        ProviderError
            If there is none to be had.
        """
        return self.model if isinstance(self.model, str) else self.model()


def named(text: str, base_url: str = "") -> Contestant:
    """
    The contestant that a person names.

    Parameters
    ----------
    text
        ``offline``, ``recorded:FILE``, ``openai:NAME`` and so on; an address of its own may follow: ``openai:NAME@http://host:8000/v1``.
    base_url
        Address for the models that can be asked at any and have none of their own.

    Raises
    ------
    InputError
        If there is no such model, or its file or address is none. Nothing is asked of a model yet.
    """
    model, at, own = text.partition(_AT)
    url = f"http{own}" if at else base_url if text.startswith(_WITH_ADDRESS) else ""
    name = f"{model}@{without_secrets(url)}" if url else model
    kind, _, rest = model.partition(":")
    if kind == "local" and rest.strip() and not url:
        opened = _OneAtATime(open_model(model, Settings()).model)
        return Contestant(name, lambda: opened)
    if kind == "recorded" and not url:
        load_text(Path(rest))
    elif model != "offline" or url:
        _check_opens(model, url)
    return Contestant(name, model, url)


def _check_opens(model: str, url: str) -> None:
    if model == "offline" or model.startswith("recorded:"):
        raise no_such_model(f"{model}@{url}")
    try:
        open_model(model, Settings(base_url=url))
    except ProviderError:
        return  # a key or a package is missing; the runs will say so, and another model may still be put to the suite


class _OneAtATime:
    """A model in this process: loaded once for all its runs, and asked by one of them at a time."""

    def __init__(self, model: ChatModel) -> None:
        self._model, self._lock = model, Lock()

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        with self._lock:
            return self._model(messages, tools)
