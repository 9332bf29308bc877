"""
Make the sample transcripts, ``src/missiontree/samples/transcripts/*.jsonl``, from the dialogues written by hand in ``scripts/dialogues/``.

::

    python -m scripts.transcripts [--check]

Each dialogue is played through the loop that models are held in, with the same second opinion, and marked as scripted. Same dialogues and
same package, same bytes; ``--check`` writes nothing and says which files are not current.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from missiontree.authoring.author import author_tree
from missiontree.authoring.dialogue import Company
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.authoring.transcript import Origin
from missiontree.briefing import request_from
from missiontree.llm.chat import Message, Tool, ToolCall
from missiontree.mission.brief import MissionBrief
from missiontree.reporting.tree.view import tree_svg
from missiontree.samples.dialogues import DIALOGUES, mission_file, transcript_file

SCRIPTS = Path(__file__).with_name("dialogues")


@dataclass(frozen=True, slots=True)
class Script:
    """
    A model of messages written by hand.

    Parameters
    ----------
    turns
        What it says, message by message: ``says`` (words, thought first), ``calls`` (a list, each a function with its arguments; arguments
        that are a text go over the wire as they are, however malformed) and ``finish``. All may be left out.
    """

    turns: tuple[Mapping[str, Any], ...]

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Say the next message: as many were said as the dialogue holds. After the last one nothing is said."""
        said = sum(message.speaker == "assistant" for message in messages)
        turn = self.turns[said] if said < len(self.turns) else {}
        calls = [ToolCall("", name, _written(given)) for call in turn.get("calls", ()) for name, given in call.items()]
        return Message("assistant", turn.get("says", "").strip(), tuple(calls), finish=turn.get("finish", "stop"))


def script_of(name: str) -> Script:
    """The dialogue of that name."""
    return Script(tuple(yaml.safe_load((SCRIPTS / f"{name}.yaml").read_text(encoding="utf-8"))))


def brief_of(name: str) -> MissionBrief:
    """The mission that the dialogue of that name is about."""
    return request_from(mission_file(name)).brief


def played(name: str) -> Authored:
    """
    What a dialogue comes to.

    Raises
    ------
    ValueError
        If it ends before all that is written was said, or goes on after that.
    """
    brief, script = brief_of(name), script_of(name)
    company = Company(lambda: author_offline(brief), tree_svg)
    made = author_tree(brief, script, origin=Origin("scripted"), company=company)
    if made.spent is None or made.spent.turns != len(script.turns):
        raise ValueError(f"{name}: {len(script.turns)} turns are written, {made.spent and made.spent.turns} were said.")
    return made


def text_of(made: Authored) -> str:
    """The transcript as the text of its file."""
    return "".join(f"{line}\n" for line in made.transcript)


def stale() -> Iterator[tuple[Path, str]]:
    """Files that are not what their dialogues make, with what these do make."""
    for name in DIALOGUES:
        file, text = transcript_file(name), text_of(played(name))
        if not file.is_file() or file.read_text(encoding="utf-8") != text:
            yield file, text


def _written(given: str | Mapping[str, Any] | None) -> str:
    return given if isinstance(given, str) else json.dumps(given or {}, ensure_ascii=False)


def main() -> None:
    """Make the files, or say which are not current."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing; end with 1 if a file is not current")
    options = parser.parse_args()
    found = list(stale())
    for file, text in found:
        print(f"{file.name} {'is not current' if options.check else 'is written'}")
        if not options.check:
            file.write_text(text, encoding="utf-8")
    print(f"{len(DIALOGUES)} transcripts, {len(found)} of them changed")
    sys.exit(1 if found and options.check else 0)


if __name__ == "__main__":
    main()
