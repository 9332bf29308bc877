"""Who stays out, who takes part, and how good every action must be, said on the command line or to ``plan()``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from missiontree import InputError, plan
from missiontree.briefing import request_from
from missiontree.cli.gathering import least_quality
from tests.cli.running import Shell

MISSION = """
mission: Find the cat
without: [mobile_scooter]
require: [tele_robot]
min_quality: {Search: 0.2, carry: 0.1}
"""


@pytest.fixture
def mission(tmp_path: Path) -> Path:
    path = tmp_path / "mission.yaml"
    path.write_text(MISSION, encoding="utf-8")
    return path


def test_names_are_added_to_those_of_the_mission_file_and_the_minimum_takes_its_place(mission: Path) -> None:
    brief = request_from(
        mission, without=["social_robot", "mobile_scooter"], require=["tele_robot-1"], min_quality={"Search": 0.5}
    ).brief
    assert brief.without == ("mobile_scooter", "social_robot")  # a name that both have stands once
    assert brief.require == ("tele_robot", "tele_robot-1")
    assert brief.min_quality == {"Search": 0.5}


def test_what_is_not_given_is_as_the_mission_file_says(mission: Path) -> None:
    brief = request_from(mission).brief
    assert (brief.without, brief.require) == (("mobile_scooter",), ("tele_robot",))
    assert brief.min_quality == {"Search": 0.2, "carry": 0.1}


def test_a_minimum_of_nothing_lifts_the_one_of_the_mission_file(mission: Path) -> None:
    assert request_from(mission, min_quality=0).brief.min_quality == 0


def test_plan_keeps_what_it_is_given() -> None:
    """Tele-robots search at 1.0, the transportation robot at 0.3: with the first left out, three actions give 0.9."""
    made = plan("Find the cat", without=["tele_robot"])
    assert made.ranking is not None
    assert [alternative.utility for alternative in made.ranking.alternatives] == pytest.approx([0.9])
    kept = plan("Find the cat", min_quality=0.5).ranking
    assert kept is not None
    assert [alternative.utility for alternative in kept.alternatives] == [3.0]
    required = plan("Find the cat", require=["transportation_robot"]).ranking
    assert required is not None
    assert [alternative.utility for alternative in required.alternatives] == pytest.approx([0.9])


def test_the_command_line_keeps_them(shell: Shell) -> None:
    ran = shell("plan", "Find the cat", "--without", "tele_robot-1", "--without", "tele_robot-2", "--json")
    assert ran.code == 0, ran
    made = json.loads(ran.out)
    assert made["brief"]["without"] == ["tele_robot-1", "tele_robot-2"]
    assert [one["utility"] for one in made["ranking"]["alternatives"]] == pytest.approx([0.9])
    ran = shell("plan", "Find the cat", "--min-quality", "Search=0.8", "--min-quality", "carry=0.5,reach=0", "--json")
    made = json.loads(ran.out)
    assert made["brief"]["min_quality"] == {"Search": 0.8, "carry": 0.5, "reach": 0}
    assert [one["utility"] for one in made["ranking"]["alternatives"]] == [3.0]
    ran = shell("plan", "Find the cat", "--require", "transportation_robot", "--json")
    assert [one["utility"] for one in json.loads(ran.out)["ranking"]["alternatives"]] == pytest.approx([0.9])


def test_a_minimum_that_nobody_reaches_ends_as_cannot_be_done(shell: Shell) -> None:
    ran = shell("plan", "Find the cat", "--min-quality", "1.5")
    assert ran.code == 1
    assert "Tele-Robot is not good enough" in ran.out


def test_comparing_keeps_them(shell: Shell) -> None:
    ran = shell("compare", "Find the cat", "--without", "tele_robot", "--json")
    assert {tuple(run["utilities"]) for run in json.loads(ran.out)} == {(0.9,)}
    assert "tele_robto" in shell("compare", "Find the cat", "--require", "tele_robto").err


@pytest.mark.parametrize(
    ("option", "name", "near"),
    [
        ("--without", "tele_robto", "the nearest is 'tele_robot'"),
        ("--require", "social_robot_1", "the nearest is 'social_robot-1'"),
        ("--min-quality", "serach=0.5", "the nearest is 'search'"),
        ("--without", "zzz", "it has mobile_scooter, tele_robot"),
        ("--min-quality", "zzz=1", "routines are Search"),
    ],
)
def test_an_unknown_name_is_answered_with_the_nearest_and_all_there_are(
    shell: Shell, option: str, name: str, near: str
) -> None:
    ran = shell("plan", "Find the cat", option, name)
    assert ran.code == 2
    assert near in " ".join(ran.err.split())
    assert option.removeprefix("--").replace("-", "_") in ran.err


def test_who_is_required_and_left_out_is_a_contradiction(shell: Shell) -> None:
    ran = shell("plan", "Find the cat", "--without", "tele_robot", "--require", "tele_robot")
    assert ran.code == 2
    assert "take it off one of the two" in " ".join(ran.err.split())


@pytest.mark.parametrize(
    ("texts", "words"),
    [
        ([""], "'' is not a number"),
        (["good"], "'good' is not a number"),
        (["-0.5"], "at least 0"),
        (["nan"], "at least 0"),
        (["inf"], "at least 0"),
        (["0.5", "0.6"], "stands beside others"),
        (["0.5,Search=1"], "stands beside others"),
        (["=1"], "has no name"),
        (["Search=1", "Search=2"], "'Search' stands twice"),
        (["Search="], "'' is not a number"),
    ],
)
def test_a_minimum_that_is_none_is_refused(texts: list[str], words: str) -> None:
    with pytest.raises(InputError, match="--min-quality") as caught:
        least_quality(texts)
    assert words in str(caught.value)
    assert "Search=0.8,carry=0.5" in caught.value.accepted


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"without": "tele_robot"}, "a list of robot types and robots"),
        ({"require": {"tele_robot": 1}}, "a list of robot types and robots"),
        ({"require": [3]}, "must be an id"),
        ({"min_quality": "0.5"}, "a number of at least 0"),
        ({"min_quality": True}, "a number of at least 0"),
        ({"min_quality": {"Search": -1}}, "at least 0"),
        ({"min_quality": float("nan")}, "at least 0"),
    ],
)
def test_an_argument_of_another_form_is_refused_in_words(arguments: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError) as caught:
        plan("Find the cat", **arguments)
    assert words in str(caught.value)
