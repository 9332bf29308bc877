"""The whole answer: the mission, what it was planned from, the trees, the alternatives, the schedules, and how they came about."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from missiontree.mission.alternative import Ranking
from missiontree.mission.brief import MissionBrief
from missiontree.mission.front import Chosen, Front
from missiontree.mission.grounded import Grounding
from missiontree.mission.partial import Partial
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Schedule
from missiontree.mission.shown import html_of
from missiontree.mission.spent import Spent
from missiontree.mission.tree import MissionTree
from missiontree.mission.value import Id, Value

Outcome = Literal["delivered", "partial", "cannot_be_done", "incomplete", "exhausted", "provider_failed"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Provenance(Value):
    """
    How a plan came about. The same input and seed give the same bytes; only what a language model took depends on the day.

    Parameters
    ----------
    author
        Who built the tree: ``offline``, ``scripted``, ``recorded``, a provider's model, or ``given`` for a tree that was handed in.
    model
        Name of the language model; empty if there was none.
    transcript
        The dialogue, one canonical JSON object per line.
    reading
        How an author that reads plain language understood the text, a line per clause.
    allocator, scheduler
        Names of the methods used.
    seed
        Seed of everything random.
    versions
        Package name to version, of what took part.
    spent
        What the dialogue with a language model took; None if there was none.
    """

    author: Id
    model: str = ""
    transcript: tuple[str, ...] = ()
    reading: tuple[str, ...] = ()
    allocator: str = ""
    scheduler: str = ""
    seed: int = 0
    versions: Mapping[str, str] = field(default_factory=dict)
    spent: Spent | None = None


@dataclass(frozen=True, kw_only=True)
class Plan(Value):
    """
    What planning a mission came to. Only plans that are ``delivered`` or ``partial`` have schedules; all but the first have reasons.

    Parameters
    ----------
    outcome
        ``delivered``; ``partial``: the mission cannot be done as a whole, and this is a plan for a part of it; ``cannot_be_done``:
        proven, the reasons say why; ``incomplete``: the mission was not fully understood or authored; ``exhausted``: a budget ran
        out first; ``provider_failed``: the language model could not be used.
    brief
        The mission and its inputs.
    tree
        The mission tree, as far as it was authored; of a partial plan, what is left of it.
    grounding
        The tree over fleet and scene.
    ranking
        The alternatives.
    schedules
        A schedule for each alternative, in rank order.
    chosen
        What the objective of the mission chooses; None if that is utility alone, by which the first alternative with a schedule stands
        first.
    front
        The utility-makespan front; None if it was not asked for.
    reasons
        Why the plan is not delivered; of a partial plan, why the whole mission cannot be done.
    notices, assumptions, findings
        What was done on the operator's behalf, taken for granted, and may be wrong; authoring, grounding and scheduling together.
    digests
        SHA-256 of the canonical JSON of each input, by its name.
    provenance
        How the plan came about.
    partial
        What a partial plan leaves out; None for every other outcome.
    """

    outcome: Outcome
    brief: MissionBrief
    tree: MissionTree | None = None
    grounding: Grounding | None = None
    ranking: Ranking | None = None
    schedules: tuple[Schedule, ...] = ()
    chosen: Chosen | None = None
    front: Front | None = None
    reasons: tuple[Reason, ...] = ()
    notices: tuple[Reason, ...] = ()
    assumptions: tuple[Reason, ...] = ()
    findings: tuple[Reason, ...] = ()
    digests: Mapping[str, str] = field(default_factory=dict)
    provenance: Provenance
    partial: Partial | None = None

    def _repr_html_(self) -> str | None:
        """The plan as notebooks show it."""
        return html_of(self)
