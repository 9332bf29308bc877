"""An explanation for the terminal: why it cannot be done, and what would make it possible."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.text import Text

from missiontree.mission.alternative import Ranking
from missiontree.mission.explanation import Cause, Explanation, Repair
from missiontree.mission.plan import Plan
from missiontree.reporting.text import HEADLINES, best_scheduled, render, words

MOST_REFUSALS = 12
MOST_STEPS = 8
CLAIMS = {"smallest_proven": "nothing less would do, proven", "smallest_found": "the least that was found"}


def explanation_text(explanation: Explanation, width: int = 100) -> str:
    """The explanation as plain text, without colour."""
    return render(explanation_view(explanation), width)


def explanation_view(explanation: Explanation) -> Group:
    """Causes, repairs and remarks, in this order."""
    return Group(*_sections(explanation))


def hint_view(told: Explanation) -> Group:
    """What would make it possible, in a few lines below a plan that says why it cannot be done: the best repair, and where to see more."""
    lines: list[RenderableType] = []
    if told.repairs:
        lines += [*_titled("What would make it possible"), *_repair(told.repairs[0])]
    if told.nearest is not None:
        nearest = f"{told.nearest.words} `--partial` plans it."
        lines += [*_titled("What can be done all the same"), Padding(words(nearest), (0, 0, 0, 2))]
    if not lines:
        return Group()
    more = "`missiontree explain` with the same mission tells more: causes, other repairs, their plans."
    return Group(*lines, Text(""), Padding(words(more, "dim"), (0, 0, 0, 2)))


def _sections(told: Explanation) -> Iterator[RenderableType]:
    headline, style = HEADLINES[told.outcome]
    can = told.outcome == "delivered"
    yield Text.assemble(
        ("Can be done" if can else headline, style), ": ", words(told.mission.strip() or "(no words)", "bold")
    )
    if can and told.plan is not None and told.plan.ranking is not None:
        yield from _best(told.plan, told.plan.ranking)
    if told.causes:
        yield from _titled("Why it cannot be done")
        for cause in told.causes:
            yield from _cause(cause, bool(told.repairs))
    if told.repairs:
        yield from _titled("What would make it possible, cheapest first")
        for repair in told.repairs:
            yield from _repair(repair)
        if told.cheapest == "proven":
            yield Padding(
                Text("No single change that costs less than number 1 is enough; proven.", style="dim"), (0, 0, 0, 2)
            )
    if told.nearest is not None:
        yield from _titled("What can be done all the same")
        known = "" if told.nearest.proven else " (as far as it was looked for)"
        yield Padding(words(f"{told.nearest.words}{known}"), (0, 0, 0, 2))
        yield Padding(words("`missiontree plan … --partial` plans it.", "dim"), (0, 0, 0, 2))
    for notice in told.notices:
        yield Padding(Text.assemble(("+", "cyan"), " ", words(notice.message)), (0, 0, 0, 2))


def _best(plan: Plan, ranking: Ranking) -> Iterator[RenderableType]:
    """That nothing has to change, and how to ask further."""
    best = best_scheduled(plan)
    if best is not None:
        utility = ranking.alternatives[best.rank - 1].utility
        known = (
            f"Nothing has to change: alternative {best.rank} has utility {utility:g} and takes {best.makespan_s:.1f} s."
        )
        yield Padding(words(known), (0, 0, 0, 2))
        yield Padding(
            words("`missiontree plan …` shows it, `--why-not` asks why it is not otherwise.", "dim"), (0, 0, 0, 2)
        )


def _titled(title: str) -> Iterator[RenderableType]:
    yield Text("")
    yield Text(title, style="bold")


def _cause(cause: Cause, mended: bool) -> Iterator[RenderableType]:
    yield Padding(Text.assemble(("✗", "red"), " ", words(cause.words)), (0, 0, 0, 2))
    details = [reason.message for reason in cause.reasons if reason.message != cause.words]
    more = len(details) - MOST_REFUSALS
    for message in [*details[:MOST_REFUSALS], *([f"… and {more} more; --json lists them all"] if more > 0 else [])]:
        yield Padding(words(message, "dim"), (0, 0, 0, 6))
    if cause.chain:
        yield Padding(words("At the earliest:", "dim"), (0, 0, 0, 6))
    for step in shortened(cause.chain):
        yield Padding(words(step, "dim"), (0, 0, 0, 8))
    if cause.hint and not mended:
        yield Padding(words(cause.hint), (0, 0, 0, 6))


def shortened(steps: Sequence[str]) -> list[str]:
    """Steps of a chain; of a long one the first and the last."""
    if len(steps) <= MOST_STEPS:
        return list(steps)
    half = MOST_STEPS // 2
    return [*steps[:half], f"… {len(steps) - 2 * half} more …", *steps[-half:]]


def _repair(repair: Repair) -> Iterator[RenderableType]:
    yield Padding(Text.assemble((f"{repair.number}.", "bold green"), " ", words(repair.words)), (0, 0, 0, 2))
    result = f"cost {repair.cost:.4g}; {CLAIMS[repair.claim]}; utility {repair.utility:g}, {repair.makespan_s:.1f} s"
    yield Padding(words(result, "dim"), (0, 0, 0, 5))
