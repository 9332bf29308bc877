"""Dialogues as they may come from anywhere: another provider, a damaged transcript, a model gone wild."""

from __future__ import annotations

from hypothesis import strategies as st

from missiontree.llm.chat import Message, ToolCall

SYSTEM = Message("system", "You build.")
MISSION = Message("user", "Build.")


def called(*calls: tuple[str, str, str], text: str = "", native: str = "") -> Message:
    """The assistant calls."""
    return Message("assistant", text, tuple(ToolCall(*call) for call in calls), native=native)


def answered(call_id: str, text: str = '{"ok": true}') -> Message:
    return Message("tool", text, call_id=call_id)


DIALOGUES: dict[str, list[Message]] = {
    "nothing": [],
    "no user": [SYSTEM],
    "blank user": [SYSTEM, Message("user", " \n")],
    "users in a row": [MISSION, Message("user", "And quickly."), Message("user", "Now.")],
    "assistant first": [Message("assistant", "I begin."), MISSION],
    "assistant last": [MISSION, Message("assistant", "Done.")],
    "assistants in a row": [
        MISSION,
        Message("assistant", "One."),
        called(("1", "a", "{}")),
        Message("assistant", "Two."),
    ],
    "empty assistant": [MISSION, Message("assistant", " "), Message("user", "Well?")],
    "call without answer": [
        MISSION,
        called(("1", "a", "{}"), ("2", "a", "{}")),
        answered("2"),
        Message("user", "Go on."),
    ],
    "call without answer at the end": [MISSION, called(("1", "a", "{}"))],
    "answer without call": [MISSION, answered("9"), Message("user", "Well?")],
    "answer twice": [MISSION, called(("1", "a", "{}")), answered("1"), answered("1")],
    "answers in another order": [MISSION, called(("1", "a", "{}"), ("2", "b", "{}")), answered("2"), answered("1")],
    "blank answer": [MISSION, called(("1", "a", "{}")), answered("1", "")],
    "answer that is no object": [MISSION, called(("1", "a", "{}")), answered("1", "done")],
    "answer with a number that is none": [MISSION, called(("1", "a", "{}")), answered("1", '{"x": NaN}')],
    "unreadable arguments": [MISSION, called(("1", "a", '{"x": [1, 2')), answered("1")],
    "arguments that are a list": [MISSION, called(("1", "a", "[1]")), answered("1")],
    "arguments beyond all depth": [MISSION, called(("1", "a", '{"x":' * 100_000)), answered("1")],
    "arguments too deep": [MISSION, called(("1", "a", '{"x":' * 60 + "1" + "}" * 60)), answered("1")],
    "arguments with numbers too large": [
        MISSION,
        called(("1", "a", '{"x": 1e999}'), ("2", "a", '{"x": ' + "9" * 400 + "}")),
        answered("1"),
    ],
    "arguments with nulls": [MISSION, called(("1", "a", '{"x": null, "y": [null, {"z": null}]}')), answered("1")],
    "names that are none": [MISSION, called(("1", "a b", "{}"), ("2", "", "{}"), ("3", "7up", "{}")), answered("3")],
    "ids that are none": [MISSION, called(("", "a", "{}"), ("x y", "a", "{}"), ("ü", "a", "{}")), answered("x y")],
    "the same id in every turn": [
        MISSION,
        called(("1", "a", "{}")),
        answered("1"),
        called(("1", "a", "{}"), ("1", "b", "{}")),
        answered("1"),
        answered("1"),
    ],
    "lone surrogates": [
        Message("user", "\ud800"),
        called(("1", "a", '{"x": "\\ud800"}'), text="\udfff"),
        answered("1"),
    ],
    "native that is damaged": [MISSION, called(("1", "a", "{}"), text="hm", native='{"of": "gem'), answered("1")],
    "native of nobody": [MISSION, called(("1", "a", "{}"), native='{"of": "x", "pieces": []}'), answered("1")],
    "native of another form": [MISSION, called(("1", "a", "{}"), native="[[]]"), answered("1")],
}

_WORDS = st.text(max_size=6)
_ARGUMENTS = st.one_of(_WORDS, st.sampled_from(["{}", '{"x": 1}', '{"x": null}', '{"x": [', "[]"]))
_CALLS = st.lists(st.builds(ToolCall, st.sampled_from(["", "1", "2", "x y"]), _WORDS, _ARGUMENTS), max_size=3)


def _natives(provider: str) -> st.SearchStrategy[str]:
    piece = '["{}", "{}", "{}"]'
    pieces = st.lists(
        st.builds(
            piece.format, st.sampled_from(["text", "call", "thought"]), st.sampled_from(["", "toolu_1"]), st.just("")
        ),
        max_size=3,
    )
    return st.one_of(_WORDS, pieces.map(lambda many: f'{{"of": "{provider}", "pieces": [{", ".join(many)}]}}'))


def dialogues(provider: str) -> st.SearchStrategy[list[Message]]:
    """Any messages in any order."""
    message = st.one_of(
        st.builds(Message, st.just("system"), _WORDS),
        st.builds(Message, st.just("user"), _WORDS),
        st.builds(Message, st.just("assistant"), _WORDS, _CALLS.map(tuple), native=_natives(provider)),
        st.builds(Message, st.just("tool"), _WORDS, call_id=st.sampled_from(["", "1", "2", "x y"])),
    )
    return st.lists(message, max_size=7)
