"""Models of Google's Gemini, by Google's own SDK (extra ``gemini``)."""

from __future__ import annotations

import math
import re
from collections.abc import Generator, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from typing import Any

from missiontree.llm.chat import Listener, Message, ProviderError, Tool, deaf
from missiontree.llm.gemini_answer import Answer
from missiontree.llm.gemini_faults import UNSIGNED_WORDS, explained
from missiontree.llm.gemini_request import config_of, contents_of
from missiontree.llm.http_faults import each_guarded, guarded
from missiontree.llm.patience import Patience, asked_patiently
from missiontree.llm.rounds import must_call
from missiontree.llm.sdk import LONGEST_S, Sdk
from missiontree.llm.wording import Wording

GEMINI = Sdk("Gemini", "google.genai", "gemini", ("GEMINI_API_KEY", "GOOGLE_API_KEY"))
_MODEL = re.compile(r"[A-Za-z0-9_.:/@-]+")
_SHORTEST_S = 10.0
"""Shortest deadline that the API takes, in seconds."""
_NOT_FORCED = ("function_calling", "function calling", "tool_config", "too many states")
"""What a rejected request says if the model cannot be made to call."""


@dataclass(frozen=True, slots=True)
class _Ways:
    """How a model is asked; found out by being rejected, and then kept to."""

    forced: bool = True
    signed: bool = False


class GeminiModel:
    """
    A chat model of Google's Gemini.

    The signatures of its thoughts are kept in ``Message.native`` and handed back with the message.

    Parameters
    ----------
    model
        The model, as Google names it.
    api_key
        The key; taken from ``GEMINI_API_KEY`` or ``GOOGLE_API_KEY`` if None.
    base_url
        Where the API is; Google's own, or ``GOOGLE_GEMINI_BASE_URL``, if None.
    listen
        Told each piece of text as it comes. An answer that broke off and is asked for again is told again.
    stream
        Whether answers come in pieces. Without, a time-out counts until the whole answer is there. Default true.
    patience
        How long to wait and how often to ask.
    max_output_tokens
        Most tokens of one answer, thoughts included; at least 1. The model's own limit if None.

    Raises
    ------
    ProviderError
        ``unauthorised`` without a key, ``not_installed`` without the SDK.
    """

    def __init__(
        self,
        model: str,
        *,
        api_key: str | None = None,
        base_url: str | None = None,
        listen: Listener = deaf,
        stream: bool = True,
        patience: Patience = Patience(),
        max_output_tokens: int | None = None,
    ) -> None:
        sdk, key = GEMINI.load(), GEMINI.key(api_key)
        self._wording = Wording(GEMINI.provider, model, GEMINI.where, key)
        if not _MODEL.fullmatch(model) or ".." in model:
            raise self._wording.fault("no_such_model")
        options = _options(patience, GEMINI.address(base_url))
        self._client = guarded(lambda: sdk.Client(api_key=key, vertexai=False, http_options=options), self._fault)
        self._model, self._max_output_tokens = model, max_output_tokens
        self._listen, self._stream, self._patience = listen, stream, patience
        self._ways = _Ways()

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Answer the dialogue; ``ProviderError`` if there is no answer to be had."""
        return asked_patiently(lambda: self._ask(messages, tools), self._patience)

    def _ask(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Ask, and where the way of asking is rejected, once more in another; each way is given up once and for all."""
        while True:
            ways = self._ways
            try:
                return self._answer(messages, tools, ways)
            except ProviderError as fault:
                other = _other(ways, fault, must_call(messages) and bool(tools))
                if other == ways:
                    raise
                self._ways = other

    def _answer(self, messages: Sequence[Message], tools: Sequence[Tool], ways: _Ways) -> Message:
        system, contents = contents_of(messages, ways.signed)
        config = config_of(system, tools, ways.forced and must_call(messages), self._max_output_tokens)
        answer = Answer()
        with closing(self._told(answer, contents, config)) as told:
            for text in each_guarded(told, self._fault):
                self._listen(text)
        return guarded(lambda: answer.message(messages), self._fault)

    def _told(self, answer: Answer, contents: Any, config: Any) -> Generator[str]:
        """Ask, and let the answer come in; gives its text."""
        ask = self._client.models.generate_content_stream if self._stream else self._client.models.generate_content
        given = ask(model=self._model, contents=contents, config=config)
        for response in given if self._stream else (given,):
            if text := answer.take(response):
                yield text

    def _fault(self, error: Exception) -> ProviderError:
        return explained(error, self._wording)


def _options(patience: Patience, base_url: str | None) -> dict[str, Any]:
    """The SDK's settings for HTTP: no attempts of its own, and how long to wait."""
    silence = min(patience.timeout_s, LONGEST_S)
    total = min(max(_SHORTEST_S, silence, patience.total_s), LONGEST_S)
    options: dict[str, Any] = {
        "timeout": math.ceil(1000 * silence),
        "retry_options": {"attempts": 1},
        # Left alone, the SDK has the server give up after the time-out, which here bounds a silence and not an answer that goes on.
        "headers": {"X-Server-Timeout": str(math.ceil(total))},
    }
    return options if base_url is None else options | {"base_url": base_url}


def _other(ways: _Ways, fault: ProviderError, forced: bool) -> _Ways:
    """The way to ask after that fault; the same if no other would help."""
    words = str(fault).lower()
    if fault.kind == "bad_request" and UNSIGNED_WORDS in words:
        return replace(ways, signed=True)
    if fault.kind == "bad_request" and forced and any(name in words for name in _NOT_FORCED):
        return replace(ways, forced=False)
    return ways
