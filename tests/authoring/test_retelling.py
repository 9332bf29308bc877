"""What stays of a recorded dialogue, told by transcripts made by hand."""

from __future__ import annotations

import json
from typing import Any

import pytest

from missiontree.authoring.prompt import reminder
from missiontree.authoring.retelling import retold
from missiontree.llm.chat import Finish, Message, ToolCall
from missiontree.llm.recording import Answered, Recording
from missiontree.routines.library import built_in

PRINT, CHECK = ToolCall("a", "printTree", "{}"), ToolCall("b", "checkTree", "{}")
DONE = Answered("a", True, '{"ok": true}')
REFUSED = Answered("a", False, '{"ok": false, "refused": [{"rule": "no_tree", "message": "There is no tree yet."}]}')


def told(*entries: Message | Answered, slips: bool = False) -> list[dict[str, Any]]:
    opening = (Message("system", "Rules."), Message("user", "The mission: x"))
    numbered = tuple((number, entry) for number, entry in enumerate((*opening, *entries), start=2))
    recording = Recording(source="openai", model="m", endpoint="", mission="", entries=numbered, end={})
    made = retold(recording, built_in(), slips)
    assert made[:2] == ({"role": "system", "content": "Rules."}, {"role": "user", "content": "The mission: x"})
    return list(made[2:])


def said(text: str, *calls: ToolCall, finish: Finish = "stop") -> Message:
    return Message("assistant", text, calls, finish=finish)


def called(number: int, call: ToolCall) -> dict[str, Any]:
    function = {"name": call.name, "arguments": call.arguments}
    return {"id": f"t{number:04d}c001", "type": "function", "function": function}


def test_calls_behind_the_last_answer_were_not_made_and_are_no_slips() -> None:
    made = told(said("Both.", PRINT, CHECK), DONE, said("Right."))
    assert made[0] == {"role": "assistant", "content": "Both.", "tool_calls": [called(1, PRINT)]}
    assert made[2] == {"role": "assistant", "content": "Right."}, "nothing was refused, so these words stay"


def test_what_follows_the_last_answer_of_the_model_is_left_out() -> None:
    made = told(said("Look.", PRINT), DONE)
    assert [message["role"] for message in made] == ["assistant"]
    assert told(said("Right."), Message("user", "Review it."), said(""))[-1]["content"] == "Right."


def test_messages_are_numbered_as_they_were_said() -> None:
    made = told(said("", PRINT), REFUSED, said("", CHECK), Answered("b", True, "{}"), said("Right."))
    assert [call["id"] for message in made for call in message.get("tool_calls", ())] == ["t0002c001"]


@pytest.mark.parametrize(
    "text",
    [
        "no JSON",
        "[]",
        '{"refused": [{}]}',
        '{"refused": [{"rule": "no_tree"}, {"rule": "malformed_arguments"}]}',
        "[" * 100_000,
    ],
)
def test_a_refusal_that_may_be_of_a_malformed_call_is_never_kept(text: str) -> None:
    made = told(said("", PRINT), Answered("a", False, text), said("Sorry."), said("Right."), slips=True)
    assert [message["content"] for message in made] == ["Right."]


def test_a_kept_refusal_marks_its_message_alone() -> None:
    made = told(
        said("Look.", PRINT), REFUSED, said("Then so.", CHECK), Answered("b", True, "{}"), said("Right."), slips=True
    )
    assert [message.get("weight") for message in made] == [0, None, None, None, None]
    assert json.loads(made[1]["content"])["ok"] is False


def test_two_messages_to_the_model_in_a_row_become_one() -> None:
    made = told(said("Right."), Message("user", "One."), said(""), Message("user", "Two."), said("Right again."))
    assert [message["content"] for message in made] == ["Right.", "One.\n\nTwo.", "Right again."]


def test_the_reminder_is_known_by_its_first_line() -> None:
    made = told(said("All."), reminder(()), said("No, more.", PRINT), DONE, said("Right."))
    assert [message["content"] for message in made] == [None, '{"ok": true}', "Right."]
