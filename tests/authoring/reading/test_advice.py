"""What is said about robots that a tree cannot ask for, and what to say instead."""

from __future__ import annotations

import pytest

from missiontree.authoring.methods.method import built_in_methods
from missiontree.authoring.offline import author_offline
from missiontree.mission.brief import MissionBrief
from missiontree.mission.fleet import Capability, Fleet, Robot, RobotType
from missiontree.mission.reason import Reason
from missiontree.routines.library import built_in

ABLE = {name: Capability(quality=1.0) for name in ("search", "reach")}
FLEET = Fleet(
    types=(
        RobotType(id="guide", label="Guide", capabilities=ABLE, robots=(Robot(id="ada"), Robot(id="max_2"))),
        RobotType(id="mule", label="Mule", capabilities=ABLE, count=2),
    )
)


def reason(text: str) -> Reason:
    made = author_offline(MissionBrief(text=text, fleet=FLEET, routines=built_in()), built_in_methods())
    assert made.status == "incomplete"
    return made.reasons[0]


@pytest.mark.parametrize(
    "text",
    [
        "Find the cup with ada",
        "Find the cup by Ada",
        "Ada, find the cup",
        "Use ada to find the cup",
        "Send ada to the lobby",
        "Search the workshop for the cup with ada",
        "Have Ada find the cup",
    ],
)
def test_robot_with_a_name_of_its_own_is_asked_for_by_its_type(text: str) -> None:
    assert reason(text).rule == "single_robot"
    assert "'ada' is one robot of the type Guide" in reason(text).message
    assert "say 'with the Guide'" in reason(text).message


def test_robot_id_of_several_words_is_known_too() -> None:
    assert "'max_2' is one robot of the type Guide" in reason("Find the cup with max_2").message


def test_leaving_out_what_is_no_robot_of_the_fleet_names_all_that_may() -> None:
    assert "'without'" in reason("Find the cup without the drone").message
    assert "'with the Guide' or 'with the Mule'" in reason("Find the cup without the drone").hint


def test_leaving_out_something_else_is_not_taken_for_a_robot() -> None:
    assert "Robots" not in reason("Go to the lobby without Anna").hint


@pytest.mark.parametrize("text", ["Use the drone", "Use the drone to find the cup", "Let the drone find the cup"])
def test_robot_that_nobody_has_brings_up_the_types_and_no_verb_that_looks_alike(text: str) -> None:
    assert "names no robot type of the fleet (Guide, Mule)" in reason(text).message
    assert "Did you mean" not in reason(text).hint


def test_robot_that_is_told_nothing_is_told_how_to_be() -> None:
    assert "'Use the Mule to find ...'" in reason("Use the mule.").hint


def test_slip_in_a_verb_still_brings_up_the_verb() -> None:
    assert "Did you mean 'search'" in reason("Serch the cup").hint
