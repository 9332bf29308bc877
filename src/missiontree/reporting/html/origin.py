"""How a plan came about, in pairs of name and value."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.objective import IN_WORDS
from missiontree.mission.plan import Plan
from missiontree.reporting.html.quantity import number
from missiontree.reporting.spent_view import author_in_words

_AUTHORS = {
    "offline": "the offline author, which reads plain language by rules",
    "scripted": "turns written by hand",
    "recorded": "a recorded dialogue, replayed",
    "given": "handed in",
}


def origin(plan: Plan) -> tuple[tuple[str, str], ...]:
    """Author, what it took, methods, seed, weights, versions, digests."""
    return tuple((name, value) for name, value in _pairs(plan) if value)


def _pairs(plan: Plan) -> Iterator[tuple[str, str]]:
    provenance = plan.provenance
    yield "tree by", _AUTHORS.get(provenance.author, provenance.author)
    yield "language model", provenance.model
    if provenance.spent is not None:
        yield "it took", author_in_words("", "", provenance.spent).removeprefix(": ")
    yield "alternatives by", provenance.allocator.replace("_", " ")
    yield "schedules by", provenance.scheduler.replace("_", " ")
    weights = plan.brief.weights
    terms = [
        f"{number(weight)} × {what}"
        for weight, what in ((weights.alpha, "quality"), (-weights.beta, "seconds"), (-weights.gamma, "cost"))
        if weight
    ]
    yield "utility", " + ".join(terms).replace("+ -", "− ") or "0"
    if plan.brief.accumulate != "sum":
        yield "of an alternative", f"{plan.brief.aim.worth} of its actions"
    if plan.brief.diverse:
        yield "teams", "no two alternatives have the same"
    if plan.brief.objective != "utility":
        yield "chosen by", IN_WORDS[plan.brief.objective]
    if not plan.brief.check_kinds:
        yield "kinds of arguments", "not enforced"
    yield "seed", str(provenance.seed)
    yield "made by", ", ".join(f"{package} {version}" for package, version in provenance.versions.items())
