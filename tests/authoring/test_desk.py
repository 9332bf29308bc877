"""Where an author without a model makes its calls."""

from __future__ import annotations

import json

from missiontree.authoring.desk import Desk
from missiontree.authoring.transcript import replay
from missiontree.mission.reason import Reason
from tests.builders import brief_of

BRIEF = brief_of("Find  the cat")
ATTACH = {
    "parentString": "Find the cat",
    "treeNames": ["SearchTree"],
    "treeArguments": [["cat"]],
    "LogicalConstraint": "AND",
    "constraintPairs": [],
}
GUESS = Reason(rule="words_unused", message="It is red.", severity="assumption")
NOTICE = Reason(rule="search_added", message="Added.", severity="notice")
LACK = Reason(rule="capability_missing", message="Nobody can sing.", needed="sing")


def begun() -> Desk:
    desk = Desk(BRIEF)
    assert desk.call("HierarchicalTree_init", {"objective": "Find the cat"}).ok
    return desk


def lines(transcript: tuple[str, ...]) -> list[dict[str, object]]:
    return [json.loads(line) for line in transcript]


def test_one_call_is_one_turn_with_its_answer() -> None:
    desk = begun()
    desk.call("attachMultiSubTrees", ATTACH)
    made = desk.ended("complete")
    # A header, two turns of a message and an answer, and the end.
    assert len(made.transcript) == 6
    assert lines(made.transcript)[0]["source"] == "offline"
    assert lines(made.transcript)[-1]["kind"] == "end"
    assert '"call-1"' in made.transcript[1]
    assert '"call-2"' in made.transcript[3]
    assert desk.calls == 2


def test_refused_call_is_answered_and_kept_and_changes_nothing() -> None:
    desk = begun()
    tree = desk.box.builder.tree
    answer = desk.call("attachMultiSubTrees", {**ATTACH, "treeNames": ["SingTree"]})
    assert not answer.ok
    assert answer.reasons[0].rule == "unknown_routine"
    assert desk.box.builder.tree is tree
    assert len(desk.ended("incomplete", answer.reasons).transcript) == 6


def test_end_tells_notices_from_assumptions_and_says_each_once() -> None:
    desk = begun()
    desk.reading = ("read so",)
    desk.remarks += [GUESS, NOTICE, GUESS]
    made = desk.ended("incomplete", [LACK])
    assert (made.status, made.reasons, made.reading, made.author) == ("incomplete", (LACK,), ("read so",), "offline")
    assert made.notices == (NOTICE,)
    assert made.assumptions == (GUESS,)


def test_what_answers_noted_is_kept_with_what_the_author_notes() -> None:
    desk = begun()
    desk.call("attachMultiSubTrees", ATTACH)  # an entity of the words is introduced with an assumption
    desk.remarks.append(GUESS)
    made = desk.ended("complete")
    assert made.assumptions[-1] == GUESS
    assert "cat" in made.assumptions[0].message


def test_declaration_begins_the_tree_if_there_is_none() -> None:
    made = Desk(BRIEF).declared_impossible((LACK,), "sing")
    assert (made.status, made.reasons) == ("cannot_be_done", (LACK,))
    assert made.tree is not None
    assert made.tree.objective == "Find the cat"  # blanks put right
    calls = "".join(made.transcript)
    assert calls.index("HierarchicalTree_init") < calls.index("declareImpossible")


def test_declaration_leaves_a_tree_that_stands() -> None:
    desk = begun()
    desk.call("attachMultiSubTrees", ATTACH)
    made = desk.declared_impossible((LACK,), "sing")
    assert "".join(made.transcript).count("HierarchicalTree_init") == 1
    assert made.tree is not None
    assert len(made.tree.nodes) == 2


def test_transcript_replays_to_the_same_end() -> None:
    desk = begun()
    desk.call("attachMultiSubTrees", ATTACH)
    desk.reading, desk.remarks = ("read so",), [GUESS, NOTICE]
    made = desk.ended("complete")
    again = replay(made.transcript, BRIEF)
    assert (again.tree, again.status, again.reading) == (made.tree, made.status, made.reading)
    assert set(again.assumptions) == set(made.assumptions)
