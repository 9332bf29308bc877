"""The seam to language models: one method wide, plain values on both sides."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol

from missiontree.errors import MissiontreeError

Speaker = Literal["system", "user", "assistant", "tool"]


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
    """

    speaker: Speaker
    text: str = ""
    calls: tuple[ToolCall, ...] = ()
    call_id: str = ""


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
    """A model could not be used: not reached, refused, or out of words. Authoring makes the outcome ``provider_failed`` of it."""


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
