"""A model whose words hold no secret: an endpoint that sends a key back, in its text or its calls, does not get it into a transcript."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.llm.chat import ChatModel, Message, Tool

HIDDEN = "[a key was here]"
_SHORTEST = 8


class Discreet:
    """
    A chat model that says what another says, keys taken out.

    Parameters
    ----------
    model
        The other.
    secrets
        What must not be said. Texts of fewer than 8 letters are no keys.
    """

    def __init__(self, model: ChatModel, secrets: Sequence[str]) -> None:
        self.model = model
        self._secrets = tuple(secret for secret in secrets if len(secret) >= _SHORTEST)

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Ask the other; see :class:`ChatModel`."""
        said = self.model(messages, tools)
        if not self._secrets:
            return said
        calls = tuple(replace(c, name=self._hidden(c.name), arguments=self._hidden(c.arguments)) for c in said.calls)
        return replace(said, text=self._hidden(said.text), calls=calls)

    def _hidden(self, text: str) -> str:
        for secret in self._secrets:
            text = text.replace(secret, HIDDEN)
        return text
