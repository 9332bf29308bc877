"""The sample transcripts: current, marked as scripted, replayable to the byte, right, and instructive in the way that is said of them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import missiontree
from missiontree import plan
from missiontree.authoring.transcript import replay
from missiontree.errors import InputError
from missiontree.evaluation.suite import Setting, load_suite
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.verdict import judge
from missiontree.formats.digest import digest
from missiontree.formats.document import write_text
from missiontree.llm.chat import Message
from missiontree.llm.recording import Answered, Recording, read_recording
from missiontree.mission.plan import Plan
from missiontree.samples.catalogue import PAPER as THE_PAPERS
from missiontree.samples.catalogue import SAMPLES
from missiontree.samples.dialogues import DIALOGUES, FOLDER, mission_file, transcript_file
from scripts.transcripts import SCRIPTS, Script, brief_of, main, played, text_of

DOCS = Path(__file__).parents[2] / "docs" / "how-to"
SUITES = Path(missiontree.__file__).parent / "evaluation" / "suites"
PAPER = [name for name in DIALOGUES if name in SAMPLES]
OTHERS = [name for name in DIALOGUES if name not in SAMPLES]
# What goes wrong in each, by the rule that refuses it; "" stands for a slip that is no refused call.
SLIPS = {
    "campus": ["unknown_routine", ""],
    "construction": ["declaration_contradicted"],
    "farm": ["gate_conflict", "malformed_arguments"],
    "hospital": ["wrong_kind"],
    "shipyard": [""],
    "station": ["not_open_ended"],
    "theatre": ["unknown_parent"],
    "zoo": ["unknown_robot"],
}
CUT_OR_EARLY = ("Your answer was cut off", "The tree is not finished")


def lines_of(name: str) -> list[str]:
    return transcript_file(name).read_text(encoding="utf-8").splitlines()


def recording_of(name: str) -> Recording:
    return read_recording(lines_of(name))


def planned(name: str) -> Plan:
    """The plan that replaying the transcript gives."""
    return plan(mission_file(name), model=f"recorded:{transcript_file(name)}")


def utilities(made: Plan) -> list[float]:
    assert made.ranking is not None
    return [alternative.utility for alternative in made.ranking.alternatives]


@pytest.mark.parametrize("name", DIALOGUES)
def test_a_transcript_is_what_its_dialogue_makes(name: str) -> None:
    """``python -m scripts.transcripts`` makes them again."""
    assert transcript_file(name).read_text(encoding="utf-8") == text_of(played(name))


@pytest.mark.parametrize("name", DIALOGUES)
def test_a_transcript_says_that_it_is_scripted_and_names_no_model(name: str) -> None:
    recording = recording_of(name)
    assert (recording.source, recording.model, recording.endpoint) == ("scripted", "", "")
    assert recording.mission == digest(brief_of(name))


@pytest.mark.parametrize("name", DIALOGUES)
def test_a_transcript_replays_to_the_same_tree_byte_for_byte(name: str) -> None:
    before, again = played(name), replay(lines_of(name), brief_of(name))
    assert (again.status, again.reasons) == (before.status, before.reasons)
    assert again.author == "recorded"
    assert before.tree == again.tree
    if again.tree is not None:
        assert before.tree is not None
        assert write_text(again.tree, "tree") == write_text(before.tree, "tree")
    assert "other_inputs" not in [notice.rule for notice in again.notices]


def test_reunite_comes_to_the_papers_alternatives() -> None:
    # Search 3 * 1.0, reach 2 * 0.3, bring 2 * 1.0: 5.6, by message or by carrying; search by the Transportation Robot 3 * 0.3: 3.5.
    assert utilities(planned("reunite")) == [5.6, 5.6, 3.5, 3.5]


def test_rescue_comes_to_the_papers_alternatives() -> None:
    # Two searches 3 * 1.0 each, reach 2 * 0.3, carry 2 * 1.0: 8.6; each search by the Transportation Robot costs 3 * 0.7 = 2.1.
    assert utilities(planned("rescue")) == [8.6, 6.5, 6.5, 4.4]


@pytest.mark.parametrize("name", ["luggage", "monster"])
def test_the_third_and_fourth_mission_are_delivered(name: str) -> None:
    made = planned(name)
    assert made.outcome == "delivered"
    assert made.tree is not None
    assert not made.tree.open_leaves


def test_the_fifth_mission_cannot_be_done_and_the_capability_is_named() -> None:
    made = planned("restaurants")
    assert made.outcome == "cannot_be_done"
    assert [reason.needed for reason in made.reasons] == ["recommend"]


def suite_missions() -> Iterator[tuple[Setting, SuiteMission]]:
    for suite in ("english", "everyday"):
        yield from load_suite(SUITES / suite).missions()


@pytest.mark.parametrize("name", OTHERS)
def test_the_others_are_right_by_the_suite_they_come_from(name: str) -> None:
    brief = brief_of(name)
    setting, mission = next(found for found in suite_missions() if found[1].say == brief.text)
    assert setting.id == name
    assert setting.brief(mission) == brief
    verdict = judge(mission, played(name), brief)
    assert (verdict.kind, verdict.differences) == ("right", ())


def test_there_are_the_papers_five_and_ten_more() -> None:
    assert (len(PAPER), len(OTHERS)) == (5, 10)
    assert sorted(PAPER) == sorted(THE_PAPERS)


@pytest.mark.parametrize("name", DIALOGUES)
def test_the_slips_of_a_dialogue_are_those_that_it_is_to_teach(name: str) -> None:
    found = []
    for _, entry in recording_of(name).entries:
        if isinstance(entry, Answered) and not entry.ok:
            found.append(json.loads(entry.text)["refused"][0]["rule"])
        elif isinstance(entry, Message) and entry.speaker == "user" and entry.text.startswith(CUT_OR_EARLY):
            found.append("")
    assert found == SLIPS.get(name, [])


@pytest.mark.parametrize("name", DIALOGUES)
def test_a_model_thinks_before_it_calls(name: str) -> None:
    said = [entry for _, entry in recording_of(name).entries if isinstance(entry, Message)]
    assert all(message.text for message in said)


def test_the_documentation_lists_them_as_they_are() -> None:
    page = (DOCS / "record-and-replay.md").read_text(encoding="utf-8")
    rows = [f"| `{name}` | {says} |" for name, says in DIALOGUES.items()]
    assert "\n".join(rows) in page
    shown = re.findall(r"```json\n(.*?)```", page, re.DOTALL)
    assert [line for line in shown[0].splitlines() if line not in lines_of("reunite")] == []


def test_the_documentation_names_the_missions_that_are_not_to_be_measured_by() -> None:
    found = {mission.say: mission.id for _, mission in suite_missions()}
    ids = ", ".join(f"`{found[brief_of(name).text]}`" for name in OTHERS)
    assert f"({ids})" in (DOCS / "fine-tune.md").read_text(encoding="utf-8")


def test_the_folders_hold_what_is_listed_and_nothing_else() -> None:
    assert sorted(file.stem for file in FOLDER.glob("*.jsonl")) == sorted(DIALOGUES)
    assert sorted(file.stem for file in FOLDER.glob("*.yaml")) == sorted(OTHERS)
    assert sorted(file.stem for file in SCRIPTS.glob("*.yaml")) == sorted(DIALOGUES)


@pytest.mark.parametrize("look_up", [transcript_file, mission_file])
def test_a_name_that_there_is_not_is_refused_with_those_there_are(look_up: object) -> None:
    assert callable(look_up)
    with pytest.raises(InputError, match=r"no sample transcript 'picnic'(?s:.*)accepted: reunite, rescue"):
        look_up("picnic")


def test_a_script_that_says_too_little_or_too_much_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    turns = Script(tuple({"says": "Done."} for _ in range(9)))
    monkeypatch.setattr("scripts.transcripts.script_of", lambda name: turns)
    with pytest.raises(ValueError, match="reunite: 9 turns are written, 3 were said"):
        played("reunite")  # stopped, reminded twice, given up


def test_the_maker_writes_what_is_not_current_and_the_check_only_tells(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("scripts.transcripts.DIALOGUES", {"mine": ""})
    monkeypatch.setattr("scripts.transcripts.transcript_file", lambda name: tmp_path / f"{name}.jsonl")
    monkeypatch.setattr("sys.argv", ["transcripts", "--check"])
    with pytest.raises(SystemExit, match="1"):
        main()
    assert capsys.readouterr().out == "mine.jsonl is not current\n1 transcripts, 1 of them changed\n"
    assert not list(tmp_path.iterdir())
    monkeypatch.setattr("sys.argv", ["transcripts"])
    with pytest.raises(SystemExit, match="0"):
        main()
    assert (tmp_path / "mine.jsonl").read_bytes() == transcript_file("mine").read_bytes()
