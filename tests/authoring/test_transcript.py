import json
from dataclasses import replace

import pytest

from missiontree.authoring.author import author_tree
from missiontree.authoring.outcome import Authored
from missiontree.authoring.transcript import Origin, Transcript, replay
from missiontree.errors import InputError
from missiontree.formats.document import write_text
from missiontree.llm.recorded import RecordedModel
from missiontree.llm.scripted import ScriptedModel, Turn
from missiontree.mission.brief import MissionBrief
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.reason import Reason
from tests.authoring.conftest import REUNITE

SCRIPT: list[Turn] = [
    [("HierarchicalTree_init", {"objective": REUNITE}), ("printTree", "{nonsense")],
    [
        ("introduceEntity", {"name": "Zoë\u2028 \ud800", "kind": "person"}),
        ("introduceEntity", {"name": "Zoë", "kind": "person"}),
    ],
    [
        (
            "attachMultiSubTrees",
            {
                "parentString": REUNITE,
                "treeNames": ["SearchTree", "ReachTree"],
                "treeArguments": [["Child"], ["zoë"]],
                "LogicalConstraint": "AND",
                "constraintPairs": [[0, 1]],
            },
        )
    ],
]


@pytest.fixture
def made(brief: MissionBrief) -> Authored:
    """A dialogue with refusals, other alphabets and half a character in it."""
    return author_tree(brief, ScriptedModel(SCRIPT))


def entries(made: Authored) -> list[dict[str, object]]:
    return [json.loads(line) for line in made.transcript]


def damaged(made: Authored, number: int, **changes: object) -> list[str]:
    """The lines with some keys of one (counted from 1) changed."""
    lines = list(made.transcript)
    lines[number - 1] = json.dumps(json.loads(lines[number - 1]) | changes)
    return lines


def test_lines_are_canonical_and_ascii(made: Authored) -> None:
    for line in made.transcript:
        assert line.isascii()
        assert line.splitlines() == [line]
        assert line == json.dumps(json.loads(line), sort_keys=True, separators=(",", ":"))


def test_the_header_says_where_the_turns_came_from(made: Authored) -> None:
    header = entries(made)[0]
    assert (header["format"], header["source"], header["model"]) == ("transcript/2", "scripted", "")
    assert isinstance(header["mission"], str)
    assert len(header["mission"]) == 64  # SHA-256 in hexadecimal


def test_every_message_call_and_answer_is_kept(made: Authored) -> None:
    kinds = [(entry["kind"], entry.get("speaker", entry.get("ok"))) for entry in entries(made)[1:]]
    assert kinds == [
        ("message", "system"),
        ("message", "user"),
        ("message", "assistant"),
        ("answer", True),
        ("answer", False),
        ("message", "assistant"),
        ("answer", False),
        ("answer", True),
        ("message", "assistant"),
        ("answer", True),
        ("message", "assistant"),
        ("end", None),
    ]


def test_a_replay_gives_the_same_tree_byte_for_byte(made: Authored, brief: MissionBrief) -> None:
    again = replay(made.transcript, brief)
    assert again.status == made.status == "complete"
    assert write_text(again.tree, "tree") == write_text(made.tree, "tree")
    assert (again.notices, again.assumptions, again.transcript) == (made.notices, made.assumptions, made.transcript)
    assert again.author == "recorded"


def test_a_recorded_model_holds_the_same_dialogue(made: Authored, brief: MissionBrief) -> None:
    again = author_tree(brief, RecordedModel(made.transcript), origin=Origin("recorded"))
    assert write_text(again.tree, "tree") == write_text(made.tree, "tree")
    assert again.transcript[1:] == made.transcript[1:]


def test_a_replay_with_other_inputs_judges_anew_and_says_so(made: Authored, brief: MissionBrief) -> None:
    """Nobody of this fleet can search, so nothing can be attached."""
    other = replace(brief, fleet=Fleet((RobotType(id="walker", count=1, capabilities={"reach": 1.0}),)))
    again = replay(made.transcript, other)
    assert "other_inputs" in [notice.rule for notice in again.notices]
    assert again.status == "incomplete"
    assert [reason.rule for reason in again.reasons] == ["open_leaf"]


def test_what_was_declined_stays_declined(brief: MissionBrief) -> None:
    script = [[("declareImpossible", {"missing": "recommend", "reason": "No routine."})]]
    made = author_tree(brief, ScriptedModel(script))
    again = replay(made.transcript, brief)
    assert (again.status, again.reasons) == ("cannot_be_done", made.reasons)


def test_what_was_not_understood_stays_so(brief: MissionBrief) -> None:
    made = author_tree(brief, ScriptedModel([]))
    lines = damaged(made, len(made.transcript), reading=["nothing"])
    again = replay(lines, brief)
    assert (again.status, again.reasons, again.reading) == ("incomplete", made.reasons, ("nothing",))


def test_the_authors_own_remarks_are_kept(brief: MissionBrief) -> None:
    """Those that no answer holds: the dialogue itself is empty here."""
    notice = Reason(rule="reworded", message="Read otherwise.", severity="notice")
    assumption = Reason(rule="guessed", message="Taken so.", severity="assumption")
    again = replay(Transcript(brief, Origin("offline")).end("incomplete", (), (), (notice, assumption)), brief)
    assert (again.notices, again.assumptions) == ((notice,), (assumption,))


def test_a_status_that_the_calls_do_not_bear_out_is_not_believed(brief: MissionBrief) -> None:
    made = author_tree(brief, ScriptedModel(SCRIPT[:1]))
    assert made.status == "incomplete"
    last = len(made.transcript)
    again = replay(damaged(made, last, status="complete", reasons=[]), brief)
    assert (again.status, [reason.rule for reason in again.reasons]) == ("incomplete", ["open_leaf"])
    with pytest.raises(InputError, match="no call declares it"):
        replay(damaged(made, last, status="cannot_be_done"), brief)


@pytest.mark.parametrize(
    ("number", "changes", "said"),
    [
        (1, {"format": "transcript/1"}, "the format is 'transcript/1'"),
        (1, {"source": 7}, "source is 7"),
        (1, {"further": 1}, "the line has the keys"),
        (3, {"speaker": "robot"}, "the speaker is 'robot'"),
        (4, {"finish": "tired"}, "finish is 'tired'"),
        (4, {"usage": [1]}, "usage is [1]"),
        (4, {"usage": [1, True]}, "usage is [1, True]"),
        (4, {"usage": [1, 2, -0.5]}, "usage is [1, 2, -0.5]"),
        (4, {"usage": [1, 2, 3, 4]}, "usage is [1, 2, 3, 4]"),
        (4, {"calls": [7]}, "a call is 7"),
        (4, {"calls": [{"id": "x"}]}, "the line has the keys id"),
        (5, {"kind": "guess"}, "no kind of line 'guess'"),
        (5, {"kind": ["end"]}, "no kind of line"),
        (5, {"ok": "true"}, "ok is 'true'"),
        (5, {"call": "call-9-9"}, "was not asked for"),
        (5, {"ok": False}, "is accepted now and was refused"),
        (6, {"ok": True}, "is refused now and was accepted"),
        (13, {"status": "splendid"}, "no status 'splendid'"),
        (13, {"reasons": [7]}, "one of the reasons is none"),
        (13, {"reasons": [{"rule": "x y", "message": "m"}]}, "one of the reasons is none"),
        (13, {"remarks": [{"rule": "r"}]}, "one of the remarks is none"),
        (13, {"spent": {"turns": -1}}, "spent cannot be read"),
        (13, {"spent": {"beers": 1}}, "spent cannot be read"),
        (13, {"reading": [7]}, "reading is not a list of texts"),
    ],
)
def test_damage_is_named_with_its_line(
    made: Authored, brief: MissionBrief, number: int, changes: dict[str, object], said: str
) -> None:
    with pytest.raises(InputError) as error:
        replay(damaged(made, number, **changes), brief)
    assert error.value.line == number
    assert said in error.value.message


def test_a_transcript_cut_off_anywhere_is_refused(made: Authored, brief: MissionBrief) -> None:
    """After any whole line, and in the middle of the last."""
    for kept in range(len(made.transcript)):
        with pytest.raises(InputError):
            replay(made.transcript[:kept], brief)
    with pytest.raises(InputError, match="not JSON"):
        replay([*made.transcript[:-1], made.transcript[-1][:-1]], brief)
    with pytest.raises(InputError, match="after the end"):
        replay([*made.transcript, made.transcript[-1]], brief)
