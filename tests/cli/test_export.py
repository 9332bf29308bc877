"""``missiontree export-training``: from recorded dialogues on disk to a file that a trainer takes."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import pytest

from missiontree.authoring.author import author_tree
from missiontree.authoring.budgets import Budgets
from missiontree.authoring.transcript import Origin
from missiontree.briefing import request_from
from missiontree.cli.exits import Exit
from missiontree.llm.recorded import RecordedModel
from missiontree.llm.scripted import ScriptedModel
from missiontree.samples.dialogues import DIALOGUES, mission_file, transcript_file
from tests.authoring.conftest import REUNITE
from tests.authoring.trainer import accept
from tests.cli.running import Shell

DECLINED = {"mine", "restaurants"}
SCENE = (
    "format: scene/1\nentities:\n  - {id: child, kind: person, label: Child}\n  - {id: mom, kind: person, label: Mom}\n"
)
TOKENS = re.compile(r"about [0-9,]+ tokens")  # they change with the words that a model is told
EVIL = "from pathlib import Path\nPath('ran').write_text('')\nROUTINES = []\n"


def lines(file: str) -> list[str]:
    return Path(file).read_text(encoding="utf-8").splitlines()


def copied(name: str, to: str) -> None:
    Path(to).parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(transcript_file(name), to)


def held(record: str, words: str, model: str = "small", **files: Any) -> None:
    """Record a dialogue about a mission of one's own, by saying again what is said in a sample."""
    brief = request_from(words, **files).brief
    speaker = RecordedModel(transcript_file("reunite").read_text(encoding="utf-8").splitlines())
    made = author_tree(brief, speaker, origin=Origin("ollama", model))
    assert made.status == "complete"
    Path(record).parent.mkdir(exist_ok=True)
    Path(record).write_text("\n".join(made.transcript), encoding="utf-8")


def test_the_samples_become_data(shell: Shell) -> None:
    ran = shell("export-training", "--samples", "--out", "training.jsonl")
    assert (ran.code, ran.out) == (Exit.DELIVERED, "")
    made = [accept(line) for line in lines("training.jsonl")]
    assert len(made) == len(DIALOGUES) - len(DECLINED) == 13
    assert "training.jsonl: 13 of 15 dialogues (13 scripted), about " in ran.err
    left_out = [line for line in ran.err.splitlines() if line.startswith("left out ")]
    assert len(left_out) == 2
    for name, line in zip(sorted(DECLINED, reverse=True), left_out, strict=True):
        assert f"{transcript_file(name)}: its mission was declared impossible; such dialogues are taken only if" in line


def test_rightly_declined_missions_and_slips_are_taken_if_asked_for(shell: Shell) -> None:
    ran = shell("export-training", "--samples", "--with-impossible", "--keep-slips", "--out", "training.jsonl")
    assert "15 of 15 dialogues" in ran.err
    made = [accept(line) for line in lines("training.jsonl")]
    weights = [message for example in made for message in example["messages"] if message.get("weight") == 0]
    # campus: a misspelt routine and an early stop; construction, hospital, shipyard, station, theatre, zoo: one each; farm: one of
    # its two, since the other is malformed.
    assert len(weights) == 9


def test_without_a_file_the_data_is_printed(shell: Shell) -> None:
    ran = shell("export-training", str(transcript_file("reunite")))
    assert ran.code == Exit.DELIVERED
    assert [message["role"] for message in accept(ran.out.removesuffix("\n"))["messages"]][:2] == ["system", "user"]
    assert "printed: 1 of 1 dialogues (1 scripted)" in ran.err
    assert shell("export-training", str(transcript_file("reunite")), "-q").err == ""


def test_a_folder_stands_for_its_transcripts_and_not_for_what_was_made_of_them(shell: Shell) -> None:
    copied("reunite", "runs/one.jsonl")
    copied("theatre", "runs/two.jsonl")
    Path("runs/fleet.json").write_text("{}", encoding="utf-8")
    for _ in range(2):  # the second time its own output lies in the folder
        ran = shell("export-training", "runs", "--out", "runs/training.jsonl")
        assert (ran.code, len(lines("runs/training.jsonl"))) == (Exit.DELIVERED, 2)
        assert "runs/training.jsonl: 2 of 2 dialogues (2 scripted)" in ran.err
    ran = shell("export-training", "runs", "--out", "other.jsonl")
    assert "left out runs/training.jsonl:1: the format is None" in ran.err
    assert "2 of 3 dialogues" in ran.err


def test_the_mission_is_found_by_a_mission_file(shell: Shell) -> None:
    for name in ("farm", "zoo"):
        copied(name, f"runs/{name}.jsonl")
    ran = shell("export-training", "runs", "--out", "t.jsonl")
    assert ran.code == Exit.BAD_INPUT
    assert ran.err.count("its mission is not known; name its mission file, or the files given to plan") == 2
    assert "bad input: none of 2 dialogues can be taken" in ran.err
    assert not Path("t.jsonl").exists()
    named = [part for name in ("farm", "zoo") for part in ("--mission", str(mission_file(name)))]
    assert "2 of 2 dialogues" in shell("export-training", "runs", "--out", "t.jsonl", *named).err


def test_a_mission_file_of_the_same_name_need_not_be_named(shell: Shell) -> None:
    copied("farm", "runs/farm.jsonl")
    folder = mission_file("farm").parent
    text = mission_file("farm").read_text(encoding="utf-8").replace("../..", str(folder.parent.parent))
    Path("runs/farm.yaml").write_text(text, encoding="utf-8")
    assert shell("export-training", "runs", "--out", "t.jsonl").code == Exit.DELIVERED
    Path("runs/farm.yaml").write_text("format: fleet/1\ntypes: []\n", encoding="utf-8")
    ran = shell("export-training", "runs", "--out", "t.jsonl")
    assert "left out runs/farm.jsonl: its mission is not known" in ran.err


def test_the_files_given_to_plan_can_be_given_again(shell: Shell) -> None:
    Path("world.txt").write_text(SCENE, encoding="utf-8")
    held("mine.jsonl", REUNITE, scene="world.txt")
    unknown = shell("export-training", "mine.jsonl", "--out", "t.jsonl")
    assert unknown.code == Exit.BAD_INPUT
    assert "left out mine.jsonl: its mission is not known" in unknown.err
    ran = shell("export-training", "mine.jsonl", "--out", "t.jsonl", "--scene", "world.txt")
    assert (ran.code, "1 of 1 dialogues (1 ollama:small)" in ran.err) == (Exit.DELIVERED, True)
    missing = shell("export-training", "mine.jsonl", "--out", "t.jsonl", "--scene", "nowhere.yaml")
    assert (missing.code, "nowhere.yaml" in missing.err) == (Exit.BAD_INPUT, True)


def test_weights_and_kinds_belong_to_a_mission_too(shell: Shell) -> None:
    held("mine.jsonl", REUNITE, weights=(1.0, 0.5), check_kinds=False)
    assert shell("export-training", "mine.jsonl").code == Exit.BAD_INPUT
    assert shell("export-training", "mine.jsonl", "--weights", "1,0.5", "--no-kinds").code == Exit.DELIVERED


def test_missions_in_words_belong_to_the_folder_that_they_were_planned_in(shell: Shell) -> None:
    Path("scene.yaml").write_text(SCENE, encoding="utf-8")
    Path("mission.yaml").write_text("format: mission/1\nmission: Something else.\n", encoding="utf-8")
    held("deep.jsonl", REUNITE, project=Path("mission.yaml"))
    Path("runs").mkdir()
    Path("deep.jsonl").rename("runs/deep.jsonl")
    assert shell("export-training", "runs", "--out", "t.jsonl").code == Exit.DELIVERED
    for name in ("scene", "mission"):  # they may lie beside the transcript as well
        Path(f"{name}.yaml").rename(f"runs/{name}.yaml")
    assert shell("export-training", "runs", "--out", "t.jsonl").code == Exit.DELIVERED


def test_words_that_look_like_a_file_are_words(shell: Shell) -> None:
    held("odd.jsonl", REUNITE)
    text = Path("odd.jsonl").read_text(encoding="utf-8")
    Path("odd.jsonl").write_text(text.replace(f"The mission: {REUNITE}", "The mission: mission.yaml"), encoding="utf-8")
    ran = shell("export-training", "odd.jsonl")
    assert "left out odd.jsonl: its mission is not known" in ran.err


def test_a_plan_holds_its_mission(shell: Shell) -> None:
    name = str(mission_file("zoo"))
    assert shell("plan", name, "--replay", str(transcript_file("zoo")), "-q", "--out", "zoo.json").code == 0
    ran = shell("export-training", "zoo.json", "--out", "t.jsonl")
    assert ran.code == Exit.DELIVERED
    direct = shell("export-training", str(transcript_file("zoo")))
    assert direct.out == Path("t.jsonl").read_text(encoding="utf-8")


def test_a_plan_that_no_model_authored_is_left_out(shell: Shell) -> None:
    assert shell("plan", "Find the keys", "-q", "--out", "keys.json").code == Exit.DELIVERED
    ran = shell("export-training", "keys.json")
    assert ran.code == Exit.BAD_INPUT
    assert "left out keys.json: it holds calls only, and no words to a model" in ran.err


def test_a_damaged_transcript_is_named_with_its_line_and_the_others_are_taken(shell: Shell) -> None:
    whole = transcript_file("reunite").read_text(encoding="utf-8").splitlines()
    Path("cut.jsonl").write_text("\n".join(whole[:-1]), encoding="utf-8")
    Path("torn.jsonl").write_text("\n".join([*whole[:4], whole[4][:30], *whole[5:]]), encoding="utf-8")
    Path("bent.jsonl").write_text("\n".join(whole).replace('"ok":true', '"ok":false', 1), encoding="utf-8")
    copied("reunite", "whole.jsonl")
    ran = shell("export-training", "cut.jsonl", "torn.jsonl", "bent.jsonl", "whole.jsonl", "--out", "t.jsonl")
    assert ran.code == Exit.DELIVERED
    last = len(whole) - 1
    assert f"left out cut.jsonl:{last}: the transcript is cut off: its end line is missing" in ran.err
    assert "left out torn.jsonl:5: the line is not JSON" in ran.err
    assert "left out bent.jsonl:5: call 't0001c001' of HierarchicalTree_init is accepted now and was refused" in ran.err
    assert "t.jsonl: 1 of 4 dialogues" in ran.err


def test_the_documentation_shows_what_is_said(shell: Shell) -> None:
    """One dialogue ended well, one ran out of turns, one file was cut off."""
    held("runs/wed.jsonl", REUNITE, model="qwen3")
    text = Path("runs/wed.jsonl").read_text(encoding="utf-8")
    Path("runs/tue.jsonl").write_text("\n".join(text.splitlines()[:8]), encoding="utf-8")
    endless = ScriptedModel(lambda messages, tools: [("HierarchicalTree_init", {"objective": f"{len(messages)}"})])
    budgets = Budgets(refusals=1_000, calls=1_000)
    spent = author_tree(request_from(REUNITE).brief, endless, budgets, Origin("ollama", "qwen3"))
    Path("runs/mon.jsonl").write_text("\n".join(spent.transcript), encoding="utf-8")
    page = (Path(__file__).parents[2] / "docs/how-to/fine-tune.md").read_text(encoding="utf-8")
    commands = re.findall(r"```sh\nmissiontree (export-training .*)\n```", page)
    shown = re.findall(r"```text\n(.*?)```", page, re.DOTALL)
    assert len(commands) == len(shown) == 2
    for command, text in zip(commands, shown, strict=True):
        ran = shell(*command.split())
        assert TOKENS.sub("", ran.err) == TOKENS.sub("", text)


def test_the_same_dialogue_is_taken_once(shell: Shell) -> None:
    copied("reunite", "a.jsonl")
    copied("reunite", "b.jsonl")
    ran = shell("export-training", "a.jsonl", "b.jsonl", "a.jsonl", "--out", "t.jsonl")
    assert len(lines("t.jsonl")) == 1
    assert "left out b.jsonl: a.jsonl holds the same dialogue" in ran.err
    assert "1 of 2 dialogues" in ran.err


def test_only_dialogues_of_some_sources_can_be_taken(shell: Shell) -> None:
    copied("reunite", "a.jsonl")
    text = Path("a.jsonl").read_text(encoding="utf-8")
    head = text.replace('"model":""', '"model":"gpt-x"', 1).replace('"source":"scripted"', '"source":"openai"', 1)
    Path("b.jsonl").write_text(head, encoding="utf-8")
    ran = shell("export-training", "a.jsonl", "b.jsonl", "--source", "openai", "--out", "t.jsonl")
    assert "left out a.jsonl: it comes from scripted" in ran.err
    assert "t.jsonl: 1 of 2 dialogues (1 openai:gpt-x)" in ran.err
    assert "gpt-x" not in Path("t.jsonl").read_text(encoding="utf-8")


def test_json_says_of_each_line_where_it_comes_from(shell: Shell) -> None:
    copied("theatre", "a.jsonl")
    copied("mine", "b.jsonl")
    ran = shell("export-training", "a.jsonl", "b.jsonl", "--out", "t.jsonl", "--json", "-q")
    told = json.loads(ran.out)
    assert told["lines"] == [
        {"line": 1, "file": "a.jsonl", "source": "scripted", "model": "", "status": "complete", "refused": 1}
    ]
    assert [left["file"] for left in told["left_out"]] == ["b.jsonl"]
    refused = shell("export-training", "a.jsonl", "--json")
    assert (refused.code, "--json with --out FILE" in refused.err) == (Exit.BAD_INPUT, True)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((), "no transcripts are given"),
        (("nothing.jsonl",), "nothing.jsonl: there is no such file"),
        (("empty",), "empty: there are no transcripts in this folder"),
        (("--samples", "--out", "nowhere/t.jsonl"), "the file cannot be written"),
        (("--samples", "--mission", "nowhere.yaml"), "nowhere.yaml"),
    ],
)
def test_bad_input_is_refused_in_words(shell: Shell, arguments: tuple[str, ...], words: str) -> None:
    Path("empty").mkdir()
    ran = shell("export-training", *arguments)
    assert (ran.code, ran.out) == (Exit.BAD_INPUT, "")
    assert words in ran.err


def test_routines_in_python_beside_a_transcript_are_not_run_unasked(shell: Shell) -> None:
    copied("theatre", "runs/theatre.jsonl")
    Path("runs/evil.py").write_text(EVIL, encoding="utf-8")
    for name in ("mission", "theatre"):
        mission = "format: mission/1\nmission: x\nroutines: [evil.py]\n"
        Path(f"runs/{name}.yaml").write_text(mission, encoding="utf-8")
    assert shell("export-training", "runs", "--out", "t.jsonl").code == Exit.DELIVERED
    assert not Path("ran").exists()
    assert shell("export-training", "runs", "--out", "t.jsonl", "--mission", "runs/mission.yaml").code == Exit.BAD_INPUT
    assert Path("ran").exists(), "a file that is named is taken as plan takes it"
