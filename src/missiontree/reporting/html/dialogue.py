"""The dialogue that built the tree, told in short: what was called, and what was refused."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.errors import InputError
from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.recording import Answered, Recording, read_recording
from missiontree.reporting.escape import one_line

MOST_CALLS = 150
LONGEST = 300


@dataclass(frozen=True, slots=True)
class Called:
    """
    A call.

    Parameters
    ----------
    call
        Function and arguments, as they were written.
    ok
        Whether it was done.
    answer
        Why not; empty if it was.
    """

    call: str
    ok: bool
    answer: str


@dataclass(frozen=True, slots=True)
class Dialogue:
    """
    A dialogue in short.

    Parameters
    ----------
    turns, refused
        Messages of the author, and how many of its calls were refused.
    calls
        The calls in order.
    more
        How many are not listed.
    """

    turns: int
    refused: int
    calls: tuple[Called, ...]
    more: int


def dialogue(lines: Sequence[str]) -> Dialogue | None:
    """A transcript in short; None if there is none, it cannot be read, or nothing was said."""
    try:
        recording = read_recording(lines) if lines else None
    except InputError:
        return None
    if recording is None:
        return None
    calls = list(_calls(recording))
    turns = sum(isinstance(entry, Message) and entry.speaker == "assistant" for _, entry in recording.entries)
    if not turns and not calls:
        return None
    refused = sum(not called.ok for called in calls)
    return Dialogue(turns, refused, tuple(calls[:MOST_CALLS]), max(0, len(calls) - MOST_CALLS))


def _calls(recording: Recording) -> Iterator[Called]:
    """Calls with their answers; they are answered in the order in which they were asked."""
    asked: deque[ToolCall] = deque()
    for _, entry in recording.entries:
        if isinstance(entry, Answered):
            call = asked.popleft() if asked else ToolCall(entry.call, "?", "")
            yield Called(_short(f"{call.name} {call.arguments}"), entry.ok, "" if entry.ok else _short(entry.text))
        else:
            asked.extend(entry.calls)


def _short(text: str) -> str:
    line = one_line(text)
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1]}…"
