"""The stand-in that says again what was said: the assistant's messages of a transcript, in order."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.llm.chat import Message, ProviderError, Tool
from missiontree.llm.recording import read_recording


class RecordedModel:
    """
    A chat model that replays a transcript, whatever it is told.

    Parameters
    ----------
    lines
        The transcript.

    Raises
    ------
    InputError
        If the transcript is damaged.
    """

    def __init__(self, lines: Sequence[str]) -> None:
        self.recording = read_recording(lines)
        self._left = [
            entry
            for _, entry in reversed(self.recording.entries)
            if isinstance(entry, Message) and entry.speaker == "assistant"
        ]

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Say the next message of the recording; ``ProviderError`` if there is none left."""
        if not self._left:
            raise ProviderError("The recording ends here, and the dialogue does not.", "recording_ended")
        return self._left.pop()
