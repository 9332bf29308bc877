"""
The paper's dialogue for its first mission, rebuilt with the slips that its print has; the wording around them is ours.

An unquoted task name, a key with a colon in it, a key spelt two ways, an object where pairs are expected, and a parent "Reunite
the Child with Mom" where "Reunite the child and mom" was made. A scripted model sends each call as it stands. Refused, it sends the
call again with only what the refusal named put right, and nothing else.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, field

import pytest

from missiontree.authoring.author import author_tree
from missiontree.authoring.outcome import Authored
from missiontree.authoring.transcript import replay
from missiontree.llm.chat import Message, Tool
from missiontree.llm.scripted import ScriptedModel, Turn
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import Link

PRINTED = [
    ("HierarchicalTree_init", '{"objective": "Reunite mom with her lost child"}'),
    (
        "CreateAndAddSubtask",
        '{"parentString": "Reunite mom with her lost child", "isPrimitive": false, "taskName": Locate the Lost Child, '
        '"LogicalConstraint": "AND"}',
    ),
    (
        "addMultiSubtasks",
        '{"parentString": "Reunite mom with her lost child", "isPrimitiveList": [false], "taskNameList": ["Reunite the child and mom"], '
        '"LogicalConstraint:": "AND", "contraintsPairs": {"Locate the Lost Child": "Reunite the child and mom"}}',
    ),
    (
        "attachMultiSubTrees",
        '{"parentString": "Locate the Lost Child", "treeNames": ["SearchTree"], "treeArguments": [["Child"]], '
        '"LogicalConstraint": "AND", "constraintsPairs": {}}',
    ),
    (
        "attachMultiSubTrees",
        '{"parentString": "Reunite the Child with Mom", "treeNames": ["ReachAndTransportTree"], "treeArguments": [["Child", "Mom"]], '
        '"LogicalConstraint": "AND", "constraintPairs": {}}',
    ),
    ("printTree", ""),
]

# What a refusal says, and what of the call is changed for it.
REPAIRS = [
    (
        "Expecting value at character 87, near",
        '"taskName": Locate the Lost Child,',
        '"taskName": "Locate the Lost Child",',
    ),
    (
        "no argument 'LogicalConstraint:'. Did you mean 'LogicalConstraint'?",
        '"LogicalConstraint:"',
        '"LogicalConstraint"',
    ),
    (
        "contraintsPairs is an object where a list of pairs is expected",
        '{"Locate the Lost Child": "Reunite the child and mom"}',
        '[["Locate the Lost Child", "Reunite the child and mom"]]',
    ),
]


@dataclass
class PrintedModel:
    """Sends what is printed, call by call, and mends what it is told is wrong."""

    waiting: list[tuple[str, str]] = field(default_factory=lambda: list(PRINTED))
    sent: tuple[str, str] = ("", "")
    mended: list[str] = field(default_factory=list)

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Turn:
        said = json.loads(messages[-1].text) if messages[-1].speaker == "tool" else {}
        if "refused" in said:
            self.sent = self.sent[0], self.mend(said["refused"])
        elif self.waiting:
            self.sent = self.waiting.pop(0)
        else:
            return []
        return [self.sent]

    def mend(self, refusals: list[dict[str, str]]) -> str:
        told = " ".join(f"{refusal['message']} {refusal['hint']}" for refusal in refusals)
        (repair,) = [repair for repair in REPAIRS if repair[0] in told]
        assert self.sent[1].count(repair[1]) == 1
        self.mended.append(repair[0])
        return self.sent[1].replace(repair[1], repair[2])


@pytest.fixture
def played(brief: MissionBrief) -> tuple[Authored, PrintedModel]:
    model = PrintedModel()
    return author_tree(brief, ScriptedModel(model)), model


def test_it_ends_in_the_tree_of_the_paper(played: tuple[Authored, PrintedModel]) -> None:
    """AND[Locate the Lost Child: Search(Child); Reunite: ReachAndTransport(Child, Mom)], the first before the second."""
    made, _ = played
    assert (made.status, made.reasons) == ("complete", ())
    assert made.tree is not None
    shape = [(node.label, node.gate, node.routine, tuple(node.arguments.values())) for node in made.tree.nodes]
    assert shape == [
        ("Reunite mom with her lost child", "and", None, ()),
        ("Locate the Lost Child", "and", None, ()),
        ("Search(Child)", None, "Search", ("child",)),
        ("Reunite the child and mom", "and", None, ()),
        ("ReachAndTransport(Child, Mom)", None, "ReachAndTransport", ("child", "mom")),
    ]
    assert made.tree.links == (Link("locate-the-lost-child", "reunite-the-child-and-mom"),)
    assert {entity.label: entity.kind for entity in made.tree.entities} == {"Child": "person", "Mom": "person"}


def test_every_slip_is_told_and_nothing_is_lost_in_silence(played: tuple[Authored, PrintedModel]) -> None:
    """Three slips are refused, each mended by what its refusal said; the parent that was named otherwise is taken with a notice."""
    made, model = played
    assert model.mended == [told for told, _, _ in REPAIRS]
    assert [notice.rule for notice in made.notices] == ["parent_matched"]
    assert "Reunite the Child with Mom" in made.notices[0].message
    answers = [json.loads(line) for line in made.transcript if '"kind":"answer"' in line]
    # Six calls are printed; the second was sent twice and the third three times.
    assert [answer["ok"] for answer in answers] == [True, False, True, False, False, True, True, True, True]
    refused = [json.loads(answer["text"])["refused"][0]["rule"] for answer in answers if not answer["ok"]]
    assert refused == ["malformed_arguments"] * 3


def test_the_transcript_keeps_each_call_as_printed(played: tuple[Authored, PrintedModel]) -> None:
    made, _ = played
    entries = [json.loads(line) for line in made.transcript]
    sent = [(call["name"], call["arguments"]) for entry in entries for call in entry.get("calls", ())]
    assert [call for call in sent if call in PRINTED] == PRINTED


def test_it_replays(played: tuple[Authored, PrintedModel], brief: MissionBrief) -> None:
    made, _ = played
    assert replay(made.transcript, brief).tree == made.tree
