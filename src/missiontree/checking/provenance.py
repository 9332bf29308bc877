"""Does the plan say truly who built its tree? None is presented as a model's that is not."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault
from missiontree.formats.digest import digest
from missiontree.llm.recording import Recording

GIVEN = "given"
NO_MODELS = frozenset({GIVEN, "offline", "scripted"})
"""Authors that are no language model."""

OTHER_INPUTS = "other_inputs"
"""Rule of the notice that a transcript was recorded with other inputs."""


def transcript_missing(case: Case) -> Iterator[Fault]:
    """A plan whose tree was built in a dialogue does not hold the dialogue; or one whose tree was handed in holds one."""
    provenance = case.plan.provenance
    if (provenance.author == GIVEN) == bool(provenance.transcript):
        yield Fault(
            f"the author is {provenance.author}, and the plan holds {'a' if provenance.transcript else 'no'} transcript.",
            found=f"{len(provenance.transcript)} lines",
            needed="no line" if provenance.author == GIVEN else "the dialogue",
        )


def transcript_damaged(case: Case) -> Iterator[Fault]:
    """The transcript cannot be read: a line is damaged, or its header or its end is missing."""
    if isinstance(case.recording, str):
        yield Fault(f"the transcript cannot be read: {case.recording}")


def author_contradicted(case: Case) -> Iterator[Fault]:
    """The author or the model is not the one that the transcript's header names; or something that is no model bears a model's name."""
    provenance, recording = case.plan.provenance, case.recording
    if provenance.author in NO_MODELS and provenance.model:
        yield _contradiction(provenance.model, "no model", f"{provenance.author} is no language model")
    if not isinstance(recording, Recording):
        return
    if provenance.author not in {recording.source, "recorded"}:
        yield _contradiction(provenance.author, recording.source, "the transcript's header names another author")
    if provenance.model != recording.model:
        yield _contradiction(provenance.model, recording.model, "the transcript's header names another model")
    if recording.source in NO_MODELS and recording.model:
        yield _contradiction(
            recording.model, "no model", f"the transcript's header names {recording.source}, which is none"
        )


def transcript_of_another_mission(case: Case) -> Iterator[Fault]:
    """The transcript was recorded with other inputs than the plan's, and the plan does not say that it was played again."""
    if isinstance(case.recording, Recording) and not case.same_inputs:
        replayed = case.plan.provenance.author == "recorded"
        if not replayed or all(said.rule != OTHER_INPUTS for said in (*case.plan.notices, *case.plan.findings)):
            yield Fault(
                "the transcript is of another mission or other inputs, and the plan does not say so.",
                found=case.recording.mission,
                needed=digest(case.plan.brief),
            )


def _contradiction(found: str, needed: str, why: str) -> Fault:
    return Fault(f"the plan names {found or 'nobody'} as its author: {why}.", found=found, needed=needed)
