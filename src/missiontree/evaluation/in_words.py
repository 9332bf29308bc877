"""Verdicts, shares, times and money as people read them, the same on every page and screen."""

from __future__ import annotations

from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.summary import Summary
from missiontree.evaluation.verdict import VerdictKind

VERDICT_NAMES: dict[VerdictKind, str] = {
    "right": "right",
    "wrong": "wrong plan",
    "declined_though_possible": "wrong refusal",
    "wrong_decline": "wrong decline",
    "no_answer": "no answer",
}
"""Verdicts in the order in which they are shown."""
MEANINGS: dict[VerdictKind, str] = {
    "right": "The plan is right, or the mission was rightly declined.",
    "wrong": "There is a plan, and it is not a right one, or there should be none. Nobody is told, so this is worst.",
    "declined_though_possible": "No plan, though there is a right one.",
    "wrong_decline": "Rightly no plan, but for another reason than the right one.",
    "no_answer": "A budget ran out, or the model could not be used.",
}
NOT_KNOWN = "not known"
NONE = "–"


def size_in_words(evaluation: Evaluation) -> str:
    """``40 missions, 3 runs each, 2 models``."""
    parts = [count(len(evaluation.missions), "mission"), f"{count(evaluation.asked, 'run')} each"]
    return ", ".join([*parts, count(len(evaluation.models), "model")])


def count(number: int, noun: str) -> str:
    """``1 run``, ``2 runs``."""
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"


def share(value: float) -> str:
    """A share from 0 to 1 with three digits, never rounded up to 1 or down to 0."""
    if 0 < value < 1:
        return f"{min(max(value, 0.001), 0.999):.3f}"
    return f"{value:.3f}"


def per_run(total: float, runs: int, digits: int = 1) -> str:
    """A mean; a dash if there are no runs."""
    return f"{total / runs:,.{digits}f}" if runs else NONE


def took(summary: Summary) -> dict[str, str]:
    """What a run takes on average, and all of them in money, by column."""
    spent, asked = summary.spent, summary.asked
    about = "about " if spent.estimated else ""
    return {
        "turns": per_run(spent.turns, asked),
        "calls": per_run(spent.calls, asked),
        "refused": per_run(spent.refused, asked),
        "tokens in": about + per_run(spent.input_tokens, asked, 0) if asked else NONE,
        "tokens out": about + per_run(spent.output_tokens, asked, 0) if asked else NONE,
        "seconds": per_run(summary.seconds, summary.runs, 2),
        "money in all": money(summary),
    }


def money(summary: Summary) -> str:
    """What all runs cost together, as far as the provider says; a dash if no language model was asked."""
    if not summary.asked:
        return NONE
    cost = summary.spent.cost_usd
    if cost is None:
        return NOT_KNOWN
    return f"${cost:,.2f}" if cost >= 1 or cost == 0 else f"${cost:.4f}"


def twins_in_words(summary: Summary) -> str:
    """How many pairs of twins were told apart; empty if none was tried."""
    return f"{summary.told_apart} of {summary.twins}" if summary.twins else ""
