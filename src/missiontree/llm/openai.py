"""Models behind any endpoint that speaks OpenAI's Chat Completions: OpenAI itself, vLLM, llama-server, Ollama, LM Studio and others."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from missiontree.llm.chat import Listener, Message, ProviderError, Tool, deaf
from missiontree.llm.discreet import Discreet
from missiontree.llm.feature_memory import FeatureMemory
from missiontree.llm.features import Features, to_blame
from missiontree.llm.openai_answer import Answer
from missiontree.llm.openai_faults import FilteredError, Place, RejectedError
from missiontree.llm.openai_request import Request, Wish, request_of
from missiontree.llm.openai_stream import objects_of
from missiontree.llm.openai_words import Words, is_address, secrets_in, without_secrets
from missiontree.llm.patience import Patience, asked_patiently

if TYPE_CHECKING:
    from missiontree.llm.openai_http import Wire

OPENAI = "https://api.openai.com/v1"
NO_KEY = "no-key-needed"
_SUSPICIOUS = frozenset({400, 422, 501})
"""Statuses of endpoints that do not know a feature, even if they do not say which."""


class OpenAIModel:
    """
    A chat model behind an OpenAI-compatible endpoint.

    Parameters
    ----------
    model
        Its name there.
    base_url
        Address of the endpoint; by default ``OPENAI_BASE_URL``, else OpenAI's own.
    api_key
        By default ``OPENAI_API_KEY``. An endpoint with a ``base_url`` of its own may need none.
    listen
        Told each piece of text and of thought as it comes in. If an answer is cut off and asked for again, it begins again.
    stream
        Whether answers come piece by piece. Default true.
    patience
        How long, and how often, an answer is waited for.
    memory
        What is known of endpoints; by default nothing, and what is learnt is kept as long as the model.
    max_output_tokens
        Most tokens of one answer; by default the endpoint's own limit.
    temperature
        Spread of the answers; by default the endpoint's own.

    Notes
    -----
    Nothing is loaded and nothing is sent before the first call, and whatever goes wrong is a ``ProviderError`` of that call.
    """

    def __init__(
        self,
        model: str,
        *,
        base_url: str | None = None,
        api_key: str | None = None,
        listen: Listener = deaf,
        stream: bool = True,
        patience: Patience = Patience(),
        memory: FeatureMemory | None = None,
        max_output_tokens: int | None = None,
        temperature: float | None = None,
    ) -> None:
        given = base_url or os.environ.get("OPENAI_BASE_URL", "")
        self._url = given or OPENAI
        self._key = (api_key or os.environ.get("OPENAI_API_KEY", "")).strip() or (NO_KEY if given else "")
        self._listen, self._patience = listen, patience
        self._wish = Wish(model, stream, max_output_tokens, temperature)
        self.memory = memory if memory is not None else FeatureMemory()

    @property
    def model(self) -> str:
        """Name of the model at its endpoint."""
        return self._wish.model

    @cached_property
    def endpoint(self) -> str:
        """Address of the endpoint, without anything secret."""
        return without_secrets(self._url)

    @property
    def host(self) -> str:
        """Host of the endpoint, with its port if one is named."""
        return urlsplit(self.endpoint).netloc

    @property
    def features(self) -> Features:
        """What is made use of, as far as is known."""
        return self.memory.known(self.endpoint, self.model)

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Answer the dialogue; see :class:`ChatModel`."""
        self._check()
        asking = _Asking(self, messages, tools, self.features)
        quiet = Discreet(lambda *_: asked_patiently(asking.ask, self._patience), self._secrets)
        return quiet(messages, tools)

    def request(self, messages: Sequence[Message], tools: Sequence[Tool], features: Features) -> Request:
        """The request for the next message, with those features and no others."""
        return request_of(messages, tools, self._wish, features)

    def send(self, request: Request) -> Message:
        """
        Ask once.

        Raises
        ------
        RejectedError
            If the endpoint objects to the request.
        ProviderError
            If there is no answer to be had.
        """
        answer = Answer(self._listen)
        try:
            with self._wire.post(request.body) as reply:
                for part in objects_of(reply.content_type, reply.body):
                    if error := _error_in(part):
                        raise self._place.fault_of_error(error)
                    answer.add(part)
        except FilteredError:
            return Message("assistant", finish="filtered")
        said = answer.message()
        return replace(said, calls=tuple(map(request.restored, said.calls)))

    @property
    def _secrets(self) -> tuple[str, ...]:
        return (*secrets_in(self._url), *([self._key] if self._key != NO_KEY else []))

    @cached_property
    def _place(self) -> Place:
        return Place(self.endpoint, self.host, self.model, Words(self._secrets))

    @cached_property
    def _wire(self) -> Wire:
        from missiontree.llm.openai_http import Wire

        return Wire(self._url, self._key, self._place, self._patience)

    def _check(self) -> None:
        if not is_address(self._url):
            message = f"{without_secrets(self._url)!r:.100} is no address of an endpoint."
            raise ProviderError(message, "failed", "A base URL has the form http://HOST:PORT/v1.")
        if not self._key:
            hint = "Set OPENAI_API_KEY, or name the endpoint of another server by its base URL."
            raise ProviderError(f"There is no key for {self.host}.", "unauthorised", hint)
        if not (self._key.isascii() and self._key.isprintable()) or " " in self._key:
            message = f"The key for {self.host} holds blanks or letters that no key has."
            raise ProviderError(message, "unauthorised", "Copy OPENAI_API_KEY anew.")


@dataclass(slots=True)
class _Asking:
    """One message being asked for: what an endpoint objects to is left out, each feature at most once, and remembered if that helped."""

    model: OpenAIModel
    messages: Sequence[Message]
    tools: Sequence[Tool]
    features: Features
    objection: RejectedError | None = None
    """The first one: it is about the request that was meant."""

    def ask(self) -> Message:
        """The message; ``ProviderError`` as long as there is none."""
        model = self.model
        while True:
            request = model.request(self.messages, self.tools, self.features)
            try:
                said = model.send(request)
                break
            except RejectedError as fault:
                self.objection = self.objection or fault
                blamed = to_blame(fault.words, request.used, if_unsaid=fault.status in _SUSPICIOUS)
                if blamed is None:
                    raise self.objection from None
                self.features = self.features.without([blamed])
        found = self.features.without(_not_kept(request, said))
        if found != model.features:
            model.memory.learn(model.endpoint, model.model, found)
        return said


def _not_kept(request: Request, said: Message) -> tuple[str, ...]:
    """The demand that the endpoint accepted and did not keep, if there was one."""
    demanded = request.demanded
    if demanded is None or said.finish != "stop":
        return ()
    if demanded:
        return () if any(call.name == demanded for call in said.calls) else ("named",)
    return () if said.calls else ("required",)


def _error_in(part: dict[str, object]) -> object:
    """The error object of an answer, of either form that is seen."""
    return part if part.get("object") == "error" else part.get("error")
