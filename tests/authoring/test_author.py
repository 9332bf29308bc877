import json
from collections.abc import Sequence

import pytest

from missiontree.authoring.author import author_tree, authored_from_tree
from missiontree.authoring.budgets import Budgets
from missiontree.authoring.transcript import Origin
from missiontree.llm.chat import Message, ProviderError, Tool
from missiontree.llm.scripted import ScriptedModel, Turn
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason
from tests.authoring.conftest import REUNITE
from tests.builders import reunite_tree

INIT = ("HierarchicalTree_init", {"objective": REUNITE})
SEARCH = (
    "attachMultiSubTrees",
    {"parentString": REUNITE, "treeNames": ["SearchTree"], "treeArguments": [["Child"]], "LogicalConstraint": "AND"},
)
WRONG = ("removeSubtask", {"subtask": "nothing of that name"})


def rules(reasons: Sequence[Reason]) -> list[str]:
    return [reason.rule for reason in reasons]


def test_a_tree_that_passes_the_gate_is_complete(brief: MissionBrief) -> None:
    made = author_tree(brief, ScriptedModel([[INIT, SEARCH]]))
    assert (made.status, made.reasons, made.author, made.model) == ("complete", (), "scripted", "")
    assert made.tree is not None
    assert [node.id for node in made.tree.nodes] == ["reunite-mom-with-her-lost-child", "search-child"]
    assert rules(made.assumptions) == ["entity_introduced"]


def test_calls_of_one_turn_run_in_the_listed_order(brief: MissionBrief) -> None:
    """The other way round nothing can be attached, since there is no tree yet."""
    made = author_tree(brief, ScriptedModel([[SEARCH, INIT]]))
    assert rules(made.reasons) == ["open_leaf"]


def test_answers_and_tools_follow_the_state(brief: MissionBrief) -> None:
    """The model is shown each answer before its next turn, and the tools of that state."""
    seen: list[tuple[str, list[str]]] = []

    def play(messages: Sequence[Message], tools: Sequence[Tool]) -> Turn:
        seen.append((messages[-1].speaker, [tool.name for tool in tools]))
        turns: list[Turn] = [[INIT], [SEARCH], []]
        return turns[len(seen) - 1]

    assert author_tree(brief, ScriptedModel(play)).status == "complete"
    assert [speaker for speaker, _ in seen] == ["user", "tool", "tool"]
    assert "addMultiSubtasks" not in seen[0][1]
    assert "addMultiSubtasks" in seen[1][1]


def test_declining_ends_the_dialogue_at_once(brief: MissionBrief) -> None:
    decline = ("declareImpossible", {"missing": "recommend", "reason": "No routine recommends."})
    made = author_tree(brief, ScriptedModel([[decline, INIT], [INIT]]))
    assert (made.status, made.tree) == ("cannot_be_done", None)
    assert [reason.needed for reason in made.reasons] == ["recommend"]


@pytest.mark.parametrize("reminders", [0, 1, 2])
def test_who_stops_early_is_told_so_often_and_no_more(brief: MissionBrief, reminders: int) -> None:
    told: list[str] = []

    def play(messages: Sequence[Message], tools: Sequence[Tool]) -> Turn:
        told.extend(message.text for message in messages[-1:] if "not finished" in message.text)
        return [] if len(messages) > 2 else [INIT]

    made = author_tree(brief, ScriptedModel(play), Budgets(reminders=reminders))
    assert (made.status, rules(made.reasons)) == ("incomplete", ["open_leaf"])
    assert len(told) == reminders
    assert all("attachMultiSubTrees" in text for text in told)


def test_a_reminder_can_be_heeded(brief: MissionBrief) -> None:
    assert author_tree(brief, ScriptedModel([[INIT], [], [SEARCH]])).status == "complete"


def test_turns_run_out(brief: MissionBrief) -> None:
    made = author_tree(brief, ScriptedModel([[INIT], [SEARCH]]), Budgets(turns=2))
    assert (made.status, rules(made.reasons)) == ("exhausted", ["budget_exhausted"])
    assert "2 turns" in made.reasons[0].message
    assert made.tree is not None, "what was built is handed on"


def test_calls_run_out(brief: MissionBrief) -> None:
    made = author_tree(brief, ScriptedModel([[INIT, SEARCH]]), Budgets(calls=1))
    assert "1 calls" in made.reasons[0].message
    assert made.tree is not None
    assert len(made.tree.nodes) == 1


def test_refusals_one_after_the_other_run_out_and_the_last_is_told(brief: MissionBrief) -> None:
    made = author_tree(brief, ScriptedModel([[INIT, WRONG, WRONG, SEARCH, WRONG, WRONG, WRONG]]), Budgets(refusals=3))
    assert rules(made.reasons) == ["budget_exhausted", "repeated_call", "unknown_node"]
    answers = [json.loads(line) for line in made.transcript if '"kind":"answer"' in line]
    # An accepted call in between starts the count anew: two refused, one accepted, three refused.
    assert [answer["ok"] for answer in answers] == [True, False, False, True, False, False, False]


def test_a_provider_that_fails_is_an_outcome(brief: MissionBrief) -> None:
    def fail(messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        raise ProviderError("no answer within 60 s")

    made = author_tree(brief, fail, origin=Origin("somebody", "large-1"))
    assert (made.status, made.model) == ("provider_failed", "large-1")
    assert "60 s" in made.reasons[0].message


def test_a_tree_handed_in_passes_the_same_gate(brief: MissionBrief) -> None:
    assert authored_from_tree(reunite_tree(), brief).status == "complete"
    lone = MissionBrief(text=brief.text, fleet=brief.fleet, routines=brief.routines.__class__(routines=()))
    made = authored_from_tree(reunite_tree(), lone)
    assert (made.status, made.author) == ("incomplete", "given")
    assert rules(made.reasons) == ["unknown_routine", "unknown_routine"]


def test_arguments_reach_the_functions_as_the_model_wrote_them(brief: MissionBrief) -> None:
    malformed = '{"objective": Reunite}'
    made = author_tree(brief, ScriptedModel([[("HierarchicalTree_init", malformed)]]))
    said = [json.loads(line) for line in made.transcript]
    assert said[3]["calls"] == [{"id": "t0001c001", "name": "HierarchicalTree_init", "arguments": malformed}]
    assert said[4]["ok"] is False
    assert (made.status, rules(made.reasons)) == ("incomplete", ["no_tree"])
