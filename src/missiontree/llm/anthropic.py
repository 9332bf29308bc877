"""Models of Anthropic, by its own SDK (extra ``anthropic``)."""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
from contextlib import closing
from typing import Any

from missiontree.llm.anthropic_answer import Answer
from missiontree.llm.anthropic_faults import explained
from missiontree.llm.anthropic_request import request_of
from missiontree.llm.chat import Listener, Message, ProviderError, Tool, deaf
from missiontree.llm.http_faults import MalformedError, each_guarded, guarded
from missiontree.llm.patience import Patience, asked_patiently
from missiontree.llm.rounds import must_call
from missiontree.llm.sdk import LONGEST_S, Sdk
from missiontree.llm.wording import Wording

ANTHROPIC = Sdk("Anthropic", "anthropic", "anthropic", ("ANTHROPIC_API_KEY",))


class AnthropicModel:
    """
    A chat model of Anthropic's.

    Its thoughts, if it has any, are kept in ``Message.native`` and handed back with the message.

    Parameters
    ----------
    model
        The model, as Anthropic names it.
    api_key
        The key; taken from ``ANTHROPIC_API_KEY`` if None.
    base_url
        Where the API is; Anthropic's own, or ``ANTHROPIC_BASE_URL``, if None.
    listen
        Told each piece of text as it comes. An answer that broke off and is asked for again is told again.
    stream
        Whether answers come in pieces. Without, a time-out counts until the whole answer is there. Default true.
    patience
        How long to wait and how often to ask.
    max_output_tokens
        Most tokens of one answer, thoughts included; at least 1. Default 16,000.

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
        max_output_tokens: int = 16_000,
    ) -> None:
        sdk, key = ANTHROPIC.load(), ANTHROPIC.key(api_key)
        self._wording = Wording(ANTHROPIC.provider, model, ANTHROPIC.where, key)
        options = {
            "base_url": ANTHROPIC.address(base_url),
            "timeout": min(patience.timeout_s, LONGEST_S),
            "max_retries": 0,
        }
        self._client = guarded(lambda: sdk.Anthropic(api_key=key, **options), self._fault)
        self._settings = {"model": model, "max_tokens": max_output_tokens}
        self._listen, self._stream, self._patience = listen, stream, patience
        self._can_be_made_to_call = True

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Answer the dialogue; ``ProviderError`` if there is no answer to be had."""
        return asked_patiently(lambda: self._ask(messages, tools), self._patience)

    def _ask(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        forced = must_call(messages) and self._can_be_made_to_call
        try:
            return self._answer(messages, request_of(messages, tools, forced))
        except ProviderError as fault:
            # Models that think of themselves reject to be forced. They are asked without, now and from now on.
            if not (forced and fault.kind == "bad_request" and "tool_choice" in str(fault)):
                raise
            self._can_be_made_to_call = False
        return self._answer(messages, request_of(messages, tools, forced=False))

    def _answer(self, messages: Sequence[Message], request: Mapping[str, Any]) -> Message:
        answer = Answer()
        with closing(self._told(answer, request)) as told:
            for text in each_guarded(told, self._fault):
                self._listen(text)
        return guarded(lambda: answer.message(messages), self._fault)

    def _told(self, answer: Answer, request: Mapping[str, Any]) -> Generator[str]:
        """Ask, and let the answer come in; gives its text."""
        if not self._stream:
            yield answer.take_whole(_plain(self._client.messages.create(**self._settings, **request)))
            return
        with self._client.messages.create(**self._settings, **request, stream=True) as stream:
            if "text/event-stream" not in stream.response.headers.get("content-type", ""):
                raise MalformedError("It is no stream of events.")
            for event in stream:
                if text := answer.take(_plain(event)):
                    yield text

    def _fault(self, error: Exception) -> ProviderError:
        return explained(error, self._wording)


def _plain(model: Any) -> Any:
    """What the SDK read, as plain values: it does not check what it reads, so we do."""
    return model.to_dict(warnings=False) if hasattr(model, "to_dict") else model
