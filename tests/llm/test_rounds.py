"""Each call with its answer, the user first and last."""

from __future__ import annotations

import pytest
from hypothesis import given

from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.rounds import BEGIN, DEEPEST, GO_ON, UNANSWERED, named_apart, plain_arguments, rounds_of
from tests.llm.histories import MISSION, answered, called, dialogues


def test_answers_stand_in_the_order_of_their_calls() -> None:
    asked = called(("1", "a", "{}"), ("2", "a", "{}"))
    said = rounds_of([MISSION, asked, answered("2", "two"), answered("1", "one")]).said
    assert said[1].answers == ("one", "two")


def test_an_answer_belongs_to_the_last_calls_even_if_the_user_spoke_between() -> None:
    said = rounds_of([MISSION, called(("1", "a", "{}")), Message("user", "Wait."), answered("1", "one")]).said
    assert said[1].answers == ("one",)


def test_ids_that_come_again_belong_to_their_own_turn() -> None:
    turns = [called(("1", "a", "{}")), answered("1", "first"), called(("1", "a", "{}")), answered("1", "second")]
    assert [entry.answers for entry in rounds_of([MISSION, *turns]).said] == [(), ("first",), ("second",)]


def test_answers_to_calls_of_one_id_go_to_each_in_turn() -> None:
    asked = called(("1", "a", "{}"), ("1", "b", "{}"))
    said = rounds_of([MISSION, asked, answered("1", "to a"), answered("1", "to b"), answered("1", "to nobody")]).said
    assert said[1].answers == ("to a", "to b")


def test_a_blank_answer_says_that_there_is_none() -> None:
    assert rounds_of([MISSION, called(("1", "a", "{}")), answered("1", " ")]).said[1].answers == (UNANSWERED,)


def test_system_texts_are_one() -> None:
    rounds = rounds_of([Message("system", "One."), MISSION, Message("system", " "), Message("system", "Two.")])
    assert (rounds.system, len(rounds.said)) == ("One.\n\nTwo.", 1)


@given(dialogues("anybody"))
def test_any_dialogue_begins_and_ends_with_the_user_and_leaves_no_call_open(dialogue: list[Message]) -> None:
    said = rounds_of(dialogue).said
    assert said[0].message.speaker == "user"
    assert said[-1].message.speaker == "user" or said[-1].answers
    assert all(len(entry.answers) == len(entry.message.calls) for entry in said)
    assert all(
        text.strip() for entry in said for text in (entry.message.text, *entry.answers) if not entry.message.calls
    )


def test_what_is_put_in_says_so() -> None:
    said = rounds_of([Message("assistant", "Hm.")]).said
    assert [entry.message.text for entry in said] == [BEGIN, "Hm.", GO_ON]
    assert rounds_of([MISSION, called(("1", "a", "{}"))]).said[1].answers == (UNANSWERED,)


def nested(levels: int) -> str:
    """An object that many levels deep, itself the first."""
    return '{"x":' * levels + "1" + "}" * levels


@pytest.mark.parametrize(
    ("arguments", "taken"),
    [
        ('{"x": [1, 2.5, null, true, "a"]}', True),
        (nested(DEEPEST), True),
        (nested(DEEPEST + 1), False),
        ('{"x": 1e999}', False),
        ('{"x": ' + "9" * 400 + "}", False),
        ("[1]", False),
        ("{", False),
    ],
)
def test_arguments_are_taken_if_every_provider_takes_them(arguments: str, taken: bool) -> None:
    assert bool(plain_arguments(ToolCall("1", "a", arguments))) is taken


def test_ids_are_kept_if_they_are_new_and_made_if_there_are_none() -> None:
    assert named_apart(["a", "", "a"], [MISSION]) == ("a", "call-1-2", "call-1-3")


def test_ids_that_are_taken_are_not_given_again() -> None:
    dialogue = [called(("a", "f", "{}"), ("call-1-1", "f", "{}"))]
    assert named_apart(["a", ""], dialogue) == ("call-1-1-again", "call-1-2")
