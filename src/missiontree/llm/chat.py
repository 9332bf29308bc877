"""The seam to language models: one method wide, plain values on both sides."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol

from missiontree.errors import MissiontreeError

Speaker = Literal["system", "user", "assistant", "tool"]
Finish = Literal["stop", "length", "filtered", "refused"]
FaultKind = Literal[
    "unreachable",
    "timed_out",
    "rate_limited",
    "overloaded",
    "unauthorised",
    "no_such_model",
    "bad_request",
    "context_overflow",
    "cut_off",
    "empty",
    "not_installed",
    "recording_ended",
    "failed",
]
Listener = Callable[[str], None]
"""Told each piece of a model's text as it comes in; what it is told is data, never trusted."""


def deaf(piece: str) -> None:
    """The listener that does not listen."""


@dataclass(frozen=True, slots=True)
class Usage:
    """
    What an answer took.

    Parameters
    ----------
    input_tokens, output_tokens
        As the provider counts them; at least 0.
    cost_usd
        Money, in US dollars, where the provider says it; None if it is not known.
    """

    input_tokens: int = 0
    output_tokens: int = 0
    cost_usd: float | None = None


@dataclass(frozen=True, slots=True)
class ToolCall:
    """
    A call that a model asks for.

    Parameters
    ----------
    id
        Name of the call, unique in the dialogue; answers refer to it.
    name
        Tool asked for, as the model spelt it.
    arguments
        Arguments exactly as the model wrote them: text that should be JSON and may not be.
    """

    id: str
    name: str
    arguments: str


@dataclass(frozen=True, slots=True)
class Message:
    """
    One entry of a dialogue.

    Parameters
    ----------
    speaker
        Who speaks.
    text
        What is said.
    calls
        Calls asked for, in order; from the assistant only.
    call_id
        Call that a tool's message answers.
    must_call
        From the user only: words alone are no answer to this. A model that can be made to call is.
    finish
        From the assistant only, how its message ended. ``stop``: of itself, with or without calls. ``length``: cut at the most it may say.
        ``filtered``: cut by a content filter. ``refused``: the model declines, and ``text`` says what it said.
    usage
        From the assistant only, what the message took; None if the provider does not say.
    native
        From the assistant only, text that only its provider understands (signatures of thoughts, say) and must be handed back with the
        message. No part of the dialogue, so no transcript holds it.
    """

    speaker: Speaker
    text: str = ""
    calls: tuple[ToolCall, ...] = ()
    call_id: str = ""
    must_call: bool = False
    finish: Finish = "stop"
    usage: Usage | None = None
    native: str = ""


@dataclass(frozen=True, slots=True)
class Tool:
    """
    A function offered to a model.

    Parameters
    ----------
    name
        Name on the wire.
    description
        What it does, for the model.
    parameters
        JSON Schema of its arguments.
    """

    name: str
    description: str
    parameters: Mapping[str, Any]


class ProviderError(MissiontreeError):
    """
    A model could not be used: not reached, refused, or out of words. Authoring makes the outcome ``provider_failed`` of it.

    Parameters
    ----------
    message
        What happened, in words; never holds a key.
    kind
        What sort of fault it is; authoring's reason has the rule ``provider_<kind>``.
    hint
        What to do about it.
    retry_after_s
        Seconds after which the provider says it may be asked again; None if it does not say.
    """

    def __init__(
        self, message: str, kind: FaultKind = "failed", hint: str = "", retry_after_s: float | None = None
    ) -> None:
        super().__init__(message)
        self.kind, self.hint, self.retry_after_s = kind, hint, retry_after_s


class ChatModel(Protocol):
    """A model that continues a dialogue."""

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """
        Answer the dialogue with one assistant message.

        Raises
        ------
        ProviderError
            If there is no answer to be had; anything else raised is a fault of the program.
        """
        ...
