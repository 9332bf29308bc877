"""Transcripts as training data: what is taught is what was checked, in the form that strict trainers take."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.authoring.author import author_tree
from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.dialogue import Company
from missiontree.authoring.finetuning import Choice, Example, Unfit, example_from, mission_said
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.authoring.prompt import opening
from missiontree.authoring.tools import TOOLS, ToolBox
from missiontree.authoring.transcript import Origin
from missiontree.errors import InputError
from missiontree.formats.document import read_file
from missiontree.llm.chat import Message, ProviderError, Tool, ToolCall
from missiontree.llm.discreet import HIDDEN, Discreet
from missiontree.llm.recording import read_recording
from missiontree.mission.brief import MissionBrief
from missiontree.mission.fleet import Fleet
from missiontree.routines.library import built_in
from missiontree.samples.catalogue import FOLDER
from tests.authoring.conftest import REUNITE
from tests.authoring.trainer import accept, calls_of

SLIPS = Choice(slips=True)
INIT = ("HierarchicalTree_init", {"objective": REUNITE})
SEARCH = (
    "attachMultiSubTrees",
    {"parentString": REUNITE, "treeNames": ["SearchTree"], "treeArguments": [["Child"]], "LogicalConstraint": "AND"},
)
BRING = (
    "attachMultiSubTrees",
    {
        "parentString": REUNITE,
        "treeNames": ["ReachAndTransportTree"],
        "treeArguments": [["Child", "Mom"]],
        "LogicalConstraint": "AND",
        "constraintPairs": [["SearchTree(Child)", 0]],
    },
)
MISSPELT = (SEARCH[0], {**SEARCH[1], "treeNames": ["SerachTree"]})
UNQUOTED = ("addMultiSubtasks", '{"parentString": Locate the Lost Child}')
NO_FUNCTION = ("flyToTheMoon", "{}")
Call = tuple[str, str | Mapping[str, object]]


def said(text: str, *calls: Call, finish: Any = "stop") -> Message:
    made = [ToolCall("x", name, given if isinstance(given, str) else json.dumps(dict(given))) for name, given in calls]
    return Message("assistant", text, tuple(made), finish=finish)


class Speaker:
    """A model of fixed messages; behind the last it says that it is done."""

    def __init__(self, *messages: Message | ProviderError) -> None:
        self._left = list(messages)

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        message = self._left.pop(0) if self._left else Message("assistant", "Done.")
        if isinstance(message, ProviderError):
            raise message
        return message


def held(brief: MissionBrief, *messages: Message | ProviderError, origin: Origin = Origin("openai", "m")) -> Authored:
    return author_tree(brief, Speaker(*messages), origin=origin)


def taught(made: Authored, brief: MissionBrief, choice: Choice | None = None) -> dict[str, Any]:
    """The example as a strict trainer reads it."""
    example = example_from(made.transcript, brief, choice)
    assert isinstance(example, Example), example
    return accept(example.line)


def why_not(made: Authored, brief: MissionBrief, choice: Choice | None = None) -> str:
    example = example_from(made.transcript, brief, choice, lambda: author_offline(brief))
    assert isinstance(example, Unfit)
    return example.why


def words(example: dict[str, Any]) -> list[str | None]:
    return [message["content"] for message in example["messages"] if message["role"] == "assistant"]


def made_again(example: dict[str, Any], brief: MissionBrief) -> ToolBox:
    """The calls of an example, and of nothing else, each of which must be accepted."""
    box = ToolBox(TreeBuilder(brief))
    for name, arguments in calls_of(example):
        answer = box.call(name, arguments)
        assert answer.ok, answer.text
    return box


def test_a_dialogue_without_slips_is_taught_as_it_was(brief: MissionBrief) -> None:
    made = held(brief, said("Begin.", INIT), said("Build.", SEARCH, BRING), said("Right."))
    example = taught(made, brief)
    assert [message["role"] for message in example["messages"]] == [
        *("system", "user"),
        *("assistant", "tool"),
        *("assistant", "tool", "tool"),
        "assistant",
    ]
    assert words(example) == ["Begin.", "Build.", "Right."]
    assert [message["content"] for message in example["messages"][:2]] == [m.text for m in opening(TreeBuilder(brief))]
    assert [(name, json.loads(arguments)) for name, arguments in calls_of(example)] == [INIT, SEARCH, BRING]
    assert not [message for message in example["messages"] if "weight" in message]
    assert made_again(example, brief).builder.tree == made.tree


def test_all_functions_are_offered_with_schemas_of_any_mission(brief: MissionBrief) -> None:
    example = taught(held(brief, said("", INIT), said("", SEARCH)), brief)
    assert [tool["function"]["name"] for tool in example["tools"]] == [tool.name for tool in TOOLS]
    assert "Child" not in json.dumps(example["tools"])
    assert "reunite" not in json.dumps(example["tools"])


def test_refused_calls_are_left_out_and_so_are_the_words_that_follow(brief: MissionBrief) -> None:
    made = held(
        brief, said("Begin.", INIT), said("Build.", SEARCH, MISSPELT), said("A slip of mine.", BRING), said("Right.")
    )
    example = taught(made, brief)
    assert words(example) == ["Begin.", "Build.", None, "Right."]
    assert [name for name, _ in calls_of(example)] == [INIT[0], SEARCH[0], BRING[0]]
    assert "SerachTree" not in json.dumps(example)
    assert made_again(example, brief).builder.tree == made.tree


def test_a_turn_of_refused_calls_alone_is_left_out(brief: MissionBrief) -> None:
    made = held(brief, said("Begin.", INIT), said("Build.", MISSPELT, UNQUOTED), said("So:", SEARCH), said("Right."))
    example = taught(made, brief)
    assert words(example) == ["Begin.", None, "Right."]
    assert [message["role"] for message in example["messages"]] == [
        *("system", "user"),
        *("assistant", "tool"),
        *("assistant", "tool"),
        "assistant",
    ]


def test_slips_can_be_kept_and_are_marked_as_not_to_be_learnt(brief: MissionBrief) -> None:
    made = held(brief, said("Begin.", INIT), said("Build.", MISSPELT), said("A slip.", SEARCH), said("Right."))
    example = taught(made, brief, SLIPS)
    assert words(example) == ["Begin.", "Build.", "A slip.", "Right."]
    weights = [message.get("weight") for message in example["messages"] if message["role"] == "assistant"]
    assert weights == [None, 0, None, None]
    answers = [json.loads(message["content"])["ok"] for message in example["messages"] if message["role"] == "tool"]
    assert answers == [True, False, True]


@pytest.mark.parametrize("choice", [Choice(), SLIPS])
@pytest.mark.parametrize("bad", [UNQUOTED, NO_FUNCTION, (SEARCH[0], {**SEARCH[1], "treeArguments": ["Child"]})])
def test_malformed_calls_are_never_taught(brief: MissionBrief, choice: Choice, bad: Call) -> None:
    made = held(brief, said("Begin.", INIT), said("Oops.", bad), said("Sorry.", SEARCH), said("Right."))
    example = taught(made, brief, choice)
    assert words(example) == ["Begin.", None, "Right."]
    assert [name for name, _ in calls_of(example)] == [INIT[0], SEARCH[0]]


def test_an_answer_that_was_cut_is_left_out_with_what_was_said_to_it(brief: MissionBrief) -> None:
    made = held(brief, said("Well, let me", INIT, finish="length"), said("Begin.", INIT), said("Build.", SEARCH))
    example = taught(made, brief)
    assert words(example) == [None, "Build.", "Done."]
    assert "cut off" not in example["messages"][2]["role"]
    kept = taught(made, brief, SLIPS)
    assert words(kept) == ["Well, let me", "Begin.", "Build.", "Done."]
    assert (kept["messages"][2]["weight"], "tool_calls" in kept["messages"][2]) == (0, False)
    assert kept["messages"][3]["content"].startswith("Your answer was cut off")


def test_stopping_before_the_tree_is_finished_is_not_taught(brief: MissionBrief) -> None:
    made = held(brief, said("Begin.", INIT), said("That is all."), said("Not yet, then.", SEARCH), said("Right."))
    assert words(taught(made, brief)) == ["Begin.", None, "Right."]
    kept = taught(made, brief, SLIPS)
    assert words(kept) == ["Begin.", "That is all.", "Not yet, then.", "Right."]
    assert [message["content"] for message in kept["messages"] if message.get("weight") == 0] == ["That is all."]


def test_a_silent_model_leaves_turns_that_a_trainer_takes(brief: MissionBrief) -> None:
    made = held(brief, said(""), said("", INIT), said("", SEARCH), said(""))
    for choice in (Choice(), SLIPS):
        example = taught(made, brief, choice)
        assert words(example) == [None, None]


def test_other_spellings_that_are_accepted_are_taught_as_the_schema_has_them(brief: MissionBrief) -> None:
    odd = {
        "treeArguments": [{"agent": "Child", "resources": None}],
        "treeNames": ["SearchTree"],
        "parentString": REUNITE,
        "LogicalConstraint": "and",
        "contraintsPairs": {},
    }
    until = {
        "parentString": REUNITE,
        "treeNames": ["FollowTree"],
        "treeArguments": [["Mom", None]],
        "LogicalConstraint": "And",
        "constraintsPairs": [[0, "SearchTree(Child)", "until"]],
    }
    kind = {"first": "search-child", "second": "follow-mom", "kind": "different_robot"}
    made = held(
        brief,
        said("", INIT),
        said("", ("attachMultiSubTrees", odd), ("attachMultiSubTrees", until), ("setLink", kind)),
    )
    assert made.spent is not None
    assert made.spent.refused == 0
    example = taught(made, brief)
    assert [json.loads(arguments) for _, arguments in calls_of(example)[1:]] == [
        {
            "parentString": REUNITE,
            "treeNames": ["SearchTree"],
            "treeArguments": [["Child"]],
            "LogicalConstraint": "AND",
            "constraintPairs": [],
        },
        {
            "parentString": REUNITE,
            "treeNames": ["FollowTree"],
            "treeArguments": [["Mom"]],
            "LogicalConstraint": "AND",
            "constraintPairs": [[0, "SearchTree(Child)", "Until"]],
        },
        {"first": "search-child", "second": "follow-mom", "kind": "DifferentRobot"},
    ]
    assert made_again(example, brief).builder.tree == made.tree


def test_dialogues_that_did_not_end_well_are_left_out_with_the_reason(brief: MissionBrief) -> None:
    early = held(brief, said("", INIT), said("a"), said("b"), said("c"))
    assert why_not(early, brief).startswith("it ended as incomplete: 'Reunite mom with her lost child'")
    failed = held(brief, said("", INIT), said("", SEARCH), ProviderError("no answer within 60 s", "timed_out"))
    assert why_not(failed, brief) == "it ended as provider failed: no answer within 60 s"
    stuck = held(brief, said("", INIT), *[said("", MISSPELT)] * 30)
    assert why_not(stuck, brief).startswith("it ended as exhausted: The dialogue used up its 8 repeated calls")


def test_a_declaration_is_taught_only_if_it_is_asked_for_and_holds(fleet: Fleet, brief: MissionBrief) -> None:
    cooking = MissionBrief(text="Cook a soup", fleet=fleet, routines=built_in())
    declare = said("Nobody cooks.", ("declareImpossible", {"missing": "cook", "reason": "No routine cooks."}))
    made = held(cooking, declare)
    assert why_not(made, cooking).startswith("its mission was declared impossible; such dialogues are taken only if")
    example = taught(made, cooking, Choice(impossible=True))
    assert [message["role"] for message in example["messages"]] == ["system", "user", "assistant"]

    wrong = held(brief, said("", ("declareImpossible", {"missing": "telepathy", "reason": "It is needed."})))
    assert wrong.status == "cannot_be_done", "nobody else was asked while the dialogue was held"
    told = why_not(wrong, brief, Choice(impossible=True))
    assert told.startswith(
        "its mission was declared impossible, and something speaks against that: An author without a"
    )


def test_a_tree_with_a_doubt_is_left_out(fleet: Fleet) -> None:
    brief = MissionBrief(text="Let the mobile scooter find the keys", fleet=fleet, routines=built_in())
    search = {"parentString": brief.text, "treeNames": ["ReachTree"], "treeArguments": [["Keys"]]}
    model = Speaker(
        said("", ("HierarchicalTree_init", {"objective": brief.text})),
        said("", ("attachMultiSubTrees", {**search, "LogicalConstraint": "AND"})),
    )
    made = author_tree(brief, model, company=Company(lambda: author_offline(brief)))
    assert (made.status, "perhaps_impossible" in [notice.rule for notice in made.notices]) == ("complete", True)
    assert why_not(made, brief).startswith("there is a doubt about its tree: An author without a model finds")


def test_calls_without_words_to_a_model_are_left_out(brief: MissionBrief) -> None:
    made = author_offline(brief)
    assert made.status == "complete"
    assert why_not(made, brief).startswith("it holds calls only, and no words to a model")


def test_a_transcript_of_another_mission_is_left_out(brief: MissionBrief, scenic: MissionBrief) -> None:
    made = held(brief, said("", INIT), said("", SEARCH))
    assert why_not(made, scenic) == "it was recorded with another mission, fleet, scene or set of routines"


@pytest.mark.parametrize(
    ("line", "text", "accepted"),
    [
        (1, "no JSON", "the line is not JSON"),
        (5, '"ok":false', "call 't0001c001' of HierarchicalTree_init is accepted now and was refused"),
    ],
)
def test_a_damaged_transcript_is_refused_with_its_line(
    brief: MissionBrief, line: int, text: str, accepted: str
) -> None:
    lines = list(held(brief, said("", INIT), said("", SEARCH)).transcript)
    lines[line - 1] = lines[line - 1].replace('"ok":true', text) if line > 1 else text
    with pytest.raises(InputError, match=accepted) as refused:
        example_from(lines, brief)
    assert refused.value.line == line


def test_a_tree_that_does_not_pass_the_gate_is_left_out_whatever_the_end_line_says(brief: MissionBrief) -> None:
    lines = list(held(brief, said("", INIT), said("a"), said("b"), said("c")).transcript)
    end = json.loads(lines[-1]) | {"status": "complete", "reasons": []}
    example = example_from([*lines[:-1], json.dumps(end)], brief)
    assert example == Unfit(
        "its tree does not pass the gate: 'Reunite mom with her lost child' (reunite-mom-with-her-lost-child) ends in no routine."
    )


def test_ids_stay_unique_whatever_the_transcript_called_them(brief: MissionBrief) -> None:
    lines = list(held(brief, said("", INIT), said("", SEARCH), said("", BRING)).transcript)
    same = [line.replace("t0001c001", "a").replace("t0002c001", "a").replace("t0003c001", "a") for line in lines]
    example = example_from(same, brief)
    assert isinstance(example, Example)
    assert len(calls_of(accept(example.line))) == 3


def test_the_example_says_where_it_comes_from_and_the_line_does_not(brief: MissionBrief) -> None:
    origin = Origin("openai", "gpt-secret-9", "https://endpoint.example/v1")
    made = held(brief, said("", INIT), said("", MISSPELT), said("", SEARCH), origin=origin)
    example = example_from(made.transcript, brief)
    assert isinstance(example, Example)
    assert (example.source, example.model, example.status, example.refused) == ("openai", "gpt-secret-9", "complete", 1)
    assert "gpt-secret-9" not in example.line
    assert "endpoint.example" not in example.line


def test_a_key_that_a_model_says_is_not_in_the_data(brief: MissionBrief) -> None:
    key = "sk-0123456789abcdef"
    named = (SEARCH[0], {**SEARCH[1], "parentString": REUNITE})
    speaker = Speaker(said(f"My key is {key}.", INIT), said(key, named), said(f"{key} {key}"))
    made = author_tree(brief, Discreet(speaker, [key]), origin=Origin("openai", "m"))
    for choice in (Choice(), SLIPS):
        example = taught(made, brief, choice)
        assert key not in json.dumps(example)
        assert words(example) == [f"My key is {HIDDEN}.", HIDDEN, f"{HIDDEN} {HIDDEN}"]


def test_letters_of_every_kind_stay_on_their_line(brief: MissionBrief) -> None:
    odd = "Zwölf\u2028Läufer\u2029\x85 \U0001f916 \ud800"
    example = taught(held(brief, said(odd, INIT), said("Build.", SEARCH)), brief)
    assert words(example)[0] == odd.replace("\ud800", "?")


def test_the_words_of_the_mission_are_found_in_a_transcript(brief: MissionBrief) -> None:
    assert mission_said(read_recording(held(brief, said("", INIT)).transcript)) == REUNITE
    assert mission_said(read_recording(author_offline(brief).transcript)) is None


TURNS = st.lists(
    st.sampled_from(
        [
            said("Think.", SEARCH),
            said("", BRING, MISSPELT),
            said("Oops.", UNQUOTED, SEARCH, NO_FUNCTION),
            said("Cut", SEARCH, finish="length"),
            said("That is all."),
            said(""),
            said("Look.", ("printTree", ""), ("checkTree", "{}")),
            said("Take back.", ("removeSubtask", {"subtask": "search-child"})),
            said("Again.", INIT, BRING),
            said("Nobody.", ("declareImpossible", {"missing": "search", "reason": "x"})),
        ]
    ),
    max_size=8,
)


def _reunite() -> MissionBrief:
    fleet = read_file(FOLDER / "fleet.yaml", "fleet")
    assert isinstance(fleet, Fleet)
    return MissionBrief(text=REUNITE, fleet=fleet, routines=built_in())


BRIEF = _reunite()


@settings(max_examples=80, deadline=None)
@given(turns=TURNS)
def test_whatever_was_said_what_is_taught_is_valid_and_builds_the_same_tree(turns: list[Message]) -> None:
    made = held(BRIEF, said("Begin.", INIT), *turns, said("Build.", SEARCH), said("Right."))
    example = example_from(made.transcript, BRIEF)
    if made.status != "complete":
        assert isinstance(example, Unfit)
        return
    assert isinstance(example, Example)
    clean = accept(example.line)
    assert made_again(clean, BRIEF).builder.tree == made.tree
    assert not [message for message in clean["messages"] if "weight" in message]
    with_slips = taught(made, BRIEF, SLIPS)
    all_calls, all_words = iter(calls_of(with_slips)), iter(words(with_slips))
    assert all(call in all_calls for call in calls_of(clean)), "slips stand between the calls, and change none"
    assert all(text in all_words for text in words(clean) if text is not None)
