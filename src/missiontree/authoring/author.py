"""author_tree: have a chat model build the tree of a mission, and say what it came to."""

from __future__ import annotations

from dataclasses import replace

from missiontree.authoring.budgets import Budgets
from missiontree.authoring.dialogue import Company, Dialogue
from missiontree.authoring.findings import findings
from missiontree.authoring.outcome import Authored
from missiontree.authoring.transcript import STAND_INS, Origin, Transcript
from missiontree.llm.chat import ChatModel
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree

WITHOUT_CLOCK = STAND_INS | {"recorded"}
"""Sources that wait for nobody: their seconds say nothing, and without them the same input gives the same bytes."""


def author_tree(
    brief: MissionBrief,
    model: ChatModel,
    budgets: Budgets = Budgets(),
    origin: Origin = Origin("scripted"),
    company: Company = Company(),
) -> Authored:
    """
    Have a mission tree built.

    Parameters
    ----------
    brief
        The mission.
    model
        Who makes the calls.
    budgets
        How long it may take.
    origin
        Who the model is, for the transcript's header.
    company
        Who is asked for a second opinion, who draws, who may stop it and who is told of progress.

    Returns
    -------
    Authored
        Whatever happened; see its status.
    """
    dialogue = Dialogue(brief, model, budgets, Transcript(brief, origin), company)
    status, reasons = dialogue.hold()
    said = tuple(dict.fromkeys((*dialogue.notices, *dialogue.remarks)))
    spent = dialogue.meter.spent()
    if origin.source in WITHOUT_CLOCK:
        spent = replace(spent, seconds=0.0)
    return Authored(
        status=status,
        tree=dialogue.box.builder.tree,
        reasons=reasons,
        notices=tuple(notice for notice in said if notice.severity != "assumption"),
        assumptions=tuple(notice for notice in said if notice.severity == "assumption"),
        transcript=dialogue.transcript.end(status, reasons, remarks=dialogue.remarks, spent=spent),
        author=origin.source,
        model=origin.model,
        spent=spent,
    )


def authored_from_tree(tree: MissionTree, brief: MissionBrief) -> Authored:
    """A tree that was handed in, as far as it passes the gate that every tree passes."""
    found = findings(tree, brief)
    faults = tuple(finding for finding in found if finding.severity == "error")
    return Authored(
        status="incomplete" if faults else "complete",
        tree=tree,
        reasons=faults,
        notices=tuple(finding for finding in found if finding.severity != "error"),
        author="given",
    )
