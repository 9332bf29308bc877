"""What is taken of recorded dialogues as training data, what is not, and why."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from missiontree.cli.recordings import Source, dialogue_of, request_of
from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.authoring.finetuning import Choice, Example, Unfit


@dataclass
class Export:
    """
    What was taken and what was not.

    Parameters
    ----------
    choice
        What is taken of a dialogue.
    sources
        Sources of dialogues that are taken; empty for all.
    """

    choice: Choice
    sources: frozenset[str]
    taken: dict[str, tuple[str, Example]] = field(default_factory=dict)  # by line, since none is to stand there twice
    left_out: list[tuple[str, str]] = field(default_factory=list)

    def take(self, file: Path, looked_at: Sequence[Source]) -> None:
        """Take the dialogue of a file, or say why not."""
        from missiontree.authoring.finetuning import Unfit

        try:
            made = self._made(file, looked_at)
        except InputError as error:
            place = f"{error.file}:{error.line}" if error.line else error.file
            self.left_out.append((place or str(file), error.message))
            return
        if isinstance(made, Unfit):
            self.left_out.append((str(file), made.why))
        elif made.line in self.taken:
            self.left_out.append((str(file), f"{self.taken[made.line][0]} holds the same dialogue"))
        else:
            self.taken[made.line] = (str(file), made)

    def _made(self, file: Path, looked_at: Sequence[Source]) -> Example | Unfit:
        from missiontree.authoring.finetuning import Unfit, example_from, why_not
        from missiontree.authoring.methods.method import load_methods
        from missiontree.authoring.offline import author_offline
        from missiontree.llm.recording import read_recording

        lines, given = dialogue_of(file)
        if not lines:
            return Unfit("the plan has no dialogue; its tree was handed in")
        try:
            recording = read_recording(lines)
            if self.sources and recording.source not in self.sources:
                return Unfit(f"it comes from {recording.source}")
            if why := why_not(recording, self.choice):
                return Unfit(why)
            request = given or request_of(recording, file, looked_at)
            if request is None:
                return Unfit("its mission is not known; name its mission file, or the files given to plan")
            opinion = partial(author_offline, request.brief, load_methods(request.methods))
            return example_from(lines, request.brief, self.choice, opinion)
        except InputError as error:
            raise error if error.file != "transcript" else replace(error, file=str(file)) from error

    def summary(self, where: str) -> str:
        """What was taken, in a line."""
        from missiontree.authoring.budgets import BYTES_PER_TOKEN

        by = Counter(f"{made.source}:{made.model}" if made.model else made.source for _, made in self.taken.values())
        held = ", ".join(f"{number} {name}" for name, number in sorted(by.items()))
        tokens = max(1, round(sum(map(len, self.taken)) / BYTES_PER_TOKEN / 1_000)) * 1_000
        seen = len(self.taken) + len(self.left_out)
        return f"{where}: {len(self.taken)} of {seen} dialogues ({held}), about {tokens:,} tokens"

    def index(self) -> dict[str, Any]:
        """What each line was made of, and what was left out, as plain data."""
        lines = [
            {"line": number, "file": file, "source": made.source, "model": made.model, "status": made.status}
            | {"refused": made.refused}
            for number, (file, made) in enumerate(self.taken.values(), start=1)
        ]
        return {"lines": lines, "left_out": [{"file": file, "why": why} for file, why in self.left_out]}
