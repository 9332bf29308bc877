"""The questions of ``missiontree explain``: words, JSON, files, exit codes."""

from __future__ import annotations

import json
from pathlib import Path

from missiontree.checking import check
from missiontree.formats.document import read_file, read_text
from missiontree.mission.why_not import WhyNot
from tests.cli.running import Shell

CAT = "Rescue cat trapped in a building on fire"


def test_a_question_about_a_plan_is_answered_and_the_plan_asked_for_is_written(shell: Shell) -> None:
    shell("plan", CAT, "--out", "plan.json", "--quiet")
    ran = shell("explain", "plan.json", "--why-not", "Transportation Robot for Search(cat)", "--out", "other.json")
    assert ran.code == 0
    assert "Possible, but worth less" in ran.out
    assert "Search(Cat): Transportation Robot instead of Tele-Robot, utility −2.1." in ran.out

    assert check(read_file(Path("other.json"), "plan")) == ()


def test_an_answer_is_a_document(shell: Shell) -> None:
    shell("plan", CAT, "--out", "plan.json", "--quiet")
    ran = shell("explain", "plan.json", "--why-not-rank", "3", "--json")
    answer = read_text(ran.out, "why_not")
    assert isinstance(answer, WhyNot)
    assert (answer.verdict, answer.asked_utility) == ("worse", 6.5)
    assert "plan" not in json.loads(ran.out)


def test_what_cannot_be_done_without_a_robot_ends_with_1(shell: Shell) -> None:
    shell("plan", CAT, "--out", "plan.json", "--quiet")
    assert shell("explain", "plan.json", "--without", "transportation").code == 1
    assert shell("explain", "plan.json", "--without", "tele_robot-1").code == 0


def test_a_mission_in_words_is_planned_and_then_asked_about(shell: Shell) -> None:
    ran = shell("explain", CAT, "--why-not-robot", "Tele-Robot", "--for", "Search(cat)")
    assert ran.code == 0
    assert "It is so" in ran.out


def test_two_questions_at_once_are_refused(shell: Shell) -> None:
    ran = shell("explain", CAT, "--why-not", "3", "--why-not-rank", "3")
    assert ran.code == 2
    assert "one question at a time" in ran.err


def test_a_part_is_planned_where_the_whole_cannot_be_done_and_the_exit_code_stays_1(shell: Shell) -> None:
    without = ("--without", "transportation_robot")
    ran = shell("plan", CAT, *without, "--partial", "--out", "part.json", "--report", "part.html")
    assert ran.code == 1
    assert "this is a plan for a part of it" in ran.out
    assert shell("check", "part.json").code == 0
    assert shell("show", "part.json").code == 1
    weighed = shell("plan", CAT, *without, "--partial", "--part", "Search(cat)=3", "--json")
    assert json.loads(weighed.out)["partial"]["total"] == 5
    assert shell("plan", CAT, *without, "--partial", "--part", "Search(cat)=0").code == 2
    unknown = shell("plan", CAT, "--part", "Serch(cat)=3")  # of a mission that can be done as a whole
    assert (unknown.code, "'Serch(cat)'" in unknown.err) == (2, True)


def test_a_mission_file_says_how_much_parts_count(shell: Shell) -> None:

    Path("m.yaml").write_text(f'mission: {CAT}\nwithout: [transportation_robot]\nparts: {{"Serch(cat)": 2}}\n')
    refused = shell("plan", "m.yaml", "--partial")
    assert refused.code == 2
    assert "Did you mean Search(Cat)" in refused.err
