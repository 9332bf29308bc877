"""What a model wrote is a turn to the letter, or it is none."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.local_history import turn_text
from missiontree.llm.local_turn import read_turn, thought_in

TURN = '{"thought":"Find \\"Tim\\" \\u00fc","calls":[{"name":"a","arguments":{"x":[1,"\\u00e4"]}},{"name":"b","arguments":{}}]}'


def test_a_turn_has_its_thought_and_calls_with_arguments_as_they_were_written() -> None:
    assert read_turn(TURN, turn=3) == (
        'Find "Tim" ü',
        (ToolCall("call-3-1", "a", '{"x":[1,"\\u00e4"]}'), ToolCall("call-3-2", "b", "{}")),
    )


def test_a_turn_may_be_words_alone_or_calls_alone() -> None:
    assert read_turn('{"thought":"Done.","calls":[]}', turn=1) == ("Done.", ())
    assert read_turn('{"thought":"","calls":[{"name":"a","arguments":{}}]}', 1)[1] == (ToolCall("call-1-1", "a", "{}"),)


@pytest.mark.parametrize("end", range(len(TURN)))
def test_a_turn_that_is_cut_anywhere_is_none(end: int) -> None:
    with pytest.raises(ValueError, match=r"expected|Expecting|Unterminated|Invalid"):
        read_turn(TURN[:end], turn=1)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "Let me think.",
        TURN + " ",
        " " + TURN,
        TURN + TURN,
        "```json\n" + TURN + "\n```",
        '{"thought": "a","calls":[]}',
        '{"calls":[],"thought":"a"}',
        '{"thought":"a"}',
        '{"thought":1,"calls":[]}',
        '{"thought":"a","calls":null}',
        '{"thought":"a","calls":[{}]}',
        '{"thought":"a","calls":[{"name":"a"}]}',
        '{"thought":"a","calls":[{"name":1,"arguments":{}}]}',
        '{"thought":"a","calls":[{"name":"a","arguments":[]}]}',
        '{"thought":"a","calls":[{"name":"a","arguments":"{}"}]}',
        '{"thought":"a","calls":[{"name":"a","arguments":{}},]}',
        '{"thought":"a","calls":[{"name":"a","arguments":{},"more":1}]}',
        '{"thought":"a","calls":[],"more":1}',
        '{"thought":"a\nb","calls":[]}',
        '{"thought":"a","calls":[{"name":"a","arguments":' + "[" * 100_000,
        '{"thought":"a","calls":[{"name":"a","arguments":' + '{"a":' * 100_000,
    ],
)
def test_what_is_nearly_a_turn_is_none(text: str) -> None:
    with pytest.raises(ValueError, match=r"expected|Expecting|Invalid|nested"):
        read_turn(text, turn=1)


@given(st.text(), st.text(max_size=3))
def test_a_thought_grows_letter_by_letter_into_what_is_read_at_the_end(thought: str, name: str) -> None:
    """Surrogates aside, which no model under the grammar can write."""
    text = turn_text(Message("assistant", thought, (ToolCall("1", name, "{}"),)))
    so_far = ""
    for end in range(len(text) + 1):
        now = thought_in(text[:end])
        assert now.startswith(so_far)
        so_far = now
    assert so_far == read_turn(text, turn=1)[0] == thought


@pytest.mark.parametrize(
    ("text", "thought"),
    [
        ("", ""),
        ("Let me think.", ""),
        ('{"thought":', ""),
        ('{"thought":"', ""),
        ('{"thought":"a', "a"),
        ('{"thought":"a\\', "a"),
        ('{"thought":"a\\u00', "a"),
        ('{"thought":"a\\u00e4', "aä"),
        ('{"thought":"a\\\\', "a\\"),
        ('{"thought":"a\\"b","calls":["', 'a"b'),
        ('{"thought":"\\ud800', "?"),
    ],
)
def test_half_a_letter_is_waited_for(text: str, thought: str) -> None:
    assert thought_in(text) == thought
