"""The answer to a question about a plan, for the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.text import Text

from missiontree.mission.why_not import Verdict, WhyNot
from missiontree.reporting.text import reason_line, render, words

MOST_REASONS = 12
HEADLINES: dict[Verdict, tuple[str, str]] = {
    "same": ("It is so", "bold green"),
    "refused": ("Not allowed", "bold red"),
    "impossible": ("Cannot be", "bold red"),
    "worse": ("Possible, but worth less", "bold yellow"),
    "later": ("Possible, but it ends later", "bold yellow"),
    "as_good": ("Possible, and as good", "bold green"),
    "sooner": ("Possible, and it ends sooner", "bold green"),
    "better": ("Possible, and worth more", "bold green"),
    "part_only": ("Only a part of the mission can be done", "bold red"),
    "undecided": ("Not decided", "bold yellow"),
}


def why_not_text(answer: WhyNot, width: int = 100) -> str:
    """The answer as plain text, without colour."""
    return render(why_not_view(answer), width)


def why_not_view(answer: WhyNot) -> Group:
    """Question, verdict, the words of the answer, and what forbids what was asked for."""
    return Group(*_lines(answer))


def _lines(answer: WhyNot) -> Iterator[RenderableType]:
    headline, style = HEADLINES[answer.verdict]
    known = "" if answer.claim == "proven" else " (as far as it was looked for)"
    yield words(answer.question, "bold")
    yield Text.assemble((headline, style), Text(known, style="dim"))
    first, *others = answer.words
    yield Padding(words(first), (0, 0, 0, 2))
    for sentence in others:
        yield Padding(Text.assemble(("· ", "dim"), words(sentence)), (0, 0, 0, 4))
    for reason in answer.reasons[:MOST_REASONS]:
        yield Padding(reason_line(reason), (0, 0, 0, 4))
    if len(answer.reasons) > MOST_REASONS:
        more = f"… and {len(answer.reasons) - MOST_REASONS} more; --json lists them all"
        yield Padding(Text(more, style="dim"), (0, 0, 0, 4))
