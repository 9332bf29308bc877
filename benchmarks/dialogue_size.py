"""
How long the paper's dialogues are: turns, calls, and the whole context of the last turn.

::

    python -m benchmarks.dialogue_size

The sample transcripts are held again through the loop. The context of a turn is what an OpenAI-compatible endpoint is sent for it: the
messages so far and the tools on offer, as the client writes them (JSON without blanks, UTF-8). A token is taken to be three bytes,
rounded up; real tokenizers need about four for such text. More than 4 turns or 6,000 tokens is a fault, and the command ends with 1.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field

from benchmarks.machine import machine_line
from missiontree.authoring.author import author_tree
from missiontree.authoring.budgets import BYTES_PER_TOKEN
from missiontree.authoring.dialogue import Company
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.authoring.transcript import Origin
from missiontree.briefing import request_from
from missiontree.formats.source import load_text
from missiontree.llm.chat import Message, Tool
from missiontree.llm.features import Features
from missiontree.llm.openai_request import Wish, request_of
from missiontree.llm.recorded import RecordedModel
from missiontree.samples.dialogues import mission_file, transcript_file

MISSIONS = ("reunite", "rescue", "luggage", "monster", "restaurants")
MOST_TURNS = 4
MOST_TOKENS = 6_000


@dataclass(frozen=True)
class Size:
    """
    How long a dialogue is.

    Parameters
    ----------
    mission
        Name of the sample.
    turns, calls
        Messages of the model, its review of the tree included, and the calls in them.
    context
        Bytes of the last turn's whole context.
    system, said, told, tools
        Bytes of its parts: the system text, what the model said, what it was told beside that, the tools on offer.
    """

    mission: str
    turns: int
    calls: int
    context: int
    system: int
    said: int
    told: int
    tools: int

    @property
    def tokens(self) -> int:
        """Tokens of the last turn's whole context, by the measure above."""
        return -(-self.context // BYTES_PER_TOKEN)

    @property
    def too_long(self) -> bool:
        """Whether it is longer than it may be."""
        return self.turns > MOST_TURNS or self.tokens > MOST_TOKENS


@dataclass
class Witness:
    """A model that keeps what another was sent last."""

    model: RecordedModel
    sent: tuple[Sequence[Message], Sequence[Tool]] = field(default=((), ()))

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Ask the other."""
        self.sent = (tuple(messages), tuple(tools))
        return self.model(messages, tools)


def held_again(name: str) -> tuple[Authored, Witness]:
    """A sample transcript through the loop once more, and what was sent for its last turn."""
    brief = request_from(mission_file(name)).brief
    witness = Witness(RecordedModel(load_text(transcript_file(name)).splitlines()))
    company = Company(lambda: author_offline(brief))
    return author_tree(brief, witness, origin=Origin("scripted"), company=company), witness


def size_of(name: str) -> Size:
    """How long the dialogue of a sample is."""
    made, witness = held_again(name)
    assert made.spent is not None
    assert made.status == witness.model.recording.end["status"], f"{name} does not end as it was recorded"
    body = request_of(*witness.sent, Wish(model=""), Features()).body
    by_role = dict.fromkeys(("system", "assistant", "user", "tool"), 0)
    for message in body["messages"]:
        by_role[message["role"]] += bytes_of(message)
    return Size(
        mission=name,
        turns=made.spent.turns,
        calls=made.spent.calls,
        context=bytes_of({"messages": body["messages"], "tools": body["tools"]}),
        system=by_role["system"],
        said=by_role["assistant"],
        told=by_role["user"] + by_role["tool"],
        tools=bytes_of(body["tools"]),
    )


def bytes_of(value: object) -> int:
    """Size of a value as the client sends it."""
    return len(json.dumps(value, ensure_ascii=False, separators=(",", ":")).encode())


def table(sizes: Sequence[Size]) -> str:
    """A row per mission."""
    head = "| mission | turns | calls | context, bytes | tokens | system | said | told | tools |"
    rows = [
        f"| {size.mission} | {size.turns} | {size.calls} | {size.context:,} | {size.tokens:,} "
        f"| {size.system:,} | {size.said:,} | {size.told:,} | {size.tools:,} |"
        for size in sizes
    ]
    return "\n".join([head, f"|---|{'---|' * 8}", *rows])


def main() -> None:
    """Measure and print."""
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    sizes = [size_of(name) for name in MISSIONS]
    print(machine_line(), end="\n\n")
    print(table(sizes))
    print(f"\nallowed: {MOST_TURNS} turns, {MOST_TOKENS:,} tokens of {BYTES_PER_TOKEN} bytes for the last turn")
    sys.exit(1 if any(size.too_long for size in sizes) else 0)


if __name__ == "__main__":
    main()
