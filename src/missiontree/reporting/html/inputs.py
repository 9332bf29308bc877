"""What the plan was made from, folded: each input as JSON, with its digest."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.formats.inputs import inputs_of
from missiontree.mission.plan import Plan
from missiontree.reporting.html.json_words import cut, json_words


@dataclass(frozen=True, slots=True)
class Input:
    """
    An input.

    Parameters
    ----------
    name
        What it is.
    text
        Its JSON, as far as the page holds it.
    more
        How many characters are left out.
    digest
        SHA-256 of its canonical JSON, as the plan states it; empty if the plan does not.
    """

    name: str
    text: str
    more: int
    digest: str


def inputs(plan: Plan) -> tuple[Input, ...]:
    """Every input of a plan."""
    found = []
    for name, value in inputs_of(plan.brief, plan.tree).items():
        text, more = cut(json_words(value))
        found.append(Input(name, text, more, plan.digests.get(name, "")))
    return tuple(found)
