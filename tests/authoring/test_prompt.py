"""What a model is told: data stands quoted under its ids, and the mission alone is the operator's word."""

from __future__ import annotations

import json
from dataclasses import replace

from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.prompt import opening, reminder, review
from missiontree.mission.area import Zone
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from tests.authoring.conftest import REUNITE
from tests.builders import reunite_tree


def block(text: str, head: str) -> list[dict[str, object]]:
    """The JSON that stands under a heading."""
    decoded, _ = json.JSONDecoder().raw_decode(text.split(f"{head}:\n")[1])
    assert isinstance(decoded, list)
    return decoded


def test_the_mission_is_the_users_word_and_wants_calls(scenic: MissionBrief) -> None:
    _, user = opening(TreeBuilder(scenic))
    assert (user.speaker, user.text, user.must_call) == ("user", f"The mission: {REUNITE}", True)


def test_the_scene_is_quoted(scenic: MissionBrief) -> None:
    system, _ = opening(TreeBuilder(scenic))
    scene = block(system.text, "Scene")
    assert [entity["id"] for entity in scene] == ["gate", "child", "mom", "dog_1", "dog_2"]
    assert scene[0]["label"] == "North Gate"
    assert scene[1]["aliases"] == ["the boy", "Jüngster"]
    assert "label" not in scene[2], "a label that is the id says nothing more"


def test_routines_say_what_they_take_and_who_can_do_them(scenic: MissionBrief) -> None:
    system, _ = opening(TreeBuilder(scenic))
    search = next(entry for entry in block(system.text, "Routines") if entry["routine"] == "SearchTree(agent)")
    assert search["can_be_done_by"] == ["tele_robot", "transportation_robot"]
    assert str(search["purpose"]).startswith("Search for")


def test_ways_that_take_fewer_kinds_are_told_apart(scenic: MissionBrief) -> None:
    """Carrying takes all that the routine takes; following a message, persons only."""
    system, _ = opening(TreeBuilder(scenic))
    routines = block(system.text, "Routines")
    transport = next(entry for entry in routines if entry["routine"] == "TransportTree(agent, location)")
    assert transport["can_be_done_by"] == {
        "carry": ["transportation_robot"],
        "message_display (agent: person)": ["social_robot"],
    }


def test_zones_are_told(brief: MissionBrief) -> None:
    fleet = Fleet((RobotType(id="cart", count=1, zones=("yard",), capabilities={"reach": 1.0}),))
    yard = Zone(id="yard")
    scene = Scene(zones=(yard,), entities=(Entity(id="crate", zone="yard"),))
    system, _ = opening(TreeBuilder(replace(brief, fleet=fleet, scene=scene)))
    assert block(system.text, "Robot types of the team")[0]["zones"] == ["yard"]
    assert block(system.text, "Scene")[0]["zone"] == "yard"


def test_robot_types_are_quoted_with_their_numbers(brief: MissionBrief) -> None:
    system, _ = opening(TreeBuilder(brief))
    robots = {entry["id"]: entry for entry in block(system.text, "Robot types of the team")}
    assert robots["tele_robot"]["count"] == 2
    assert "search" in robots["tele_robot"]["capabilities"]  # type: ignore[operator]


def test_robots_with_names_are_told_by_name(brief: MissionBrief) -> None:
    """So that a mission that asks for Otto can be given to the type he is of."""
    carts = RobotType(id="cart", robots=(Robot(id="otto"), Robot(id="anna")), capabilities={"reach": 1.0})
    system, _ = opening(TreeBuilder(replace(brief, fleet=Fleet((carts,)))))
    (told,) = block(system.text, "Robot types of the team")
    assert told == {"id": "cart", "count": 2, "called": ["otto", "anna"], "capabilities": ["reach"]}


def test_mass_and_position_of_a_thing_are_told_as_far_as_they_are_known(brief: MissionBrief) -> None:
    crate = Entity(id="crate", mass_kg=40.0, note="n" * 1000)
    system, _ = opening(TreeBuilder(replace(brief, scene=Scene(entities=(crate,)))))
    assert block(system.text, "Scene") == [
        {"id": "crate", "kind": "object", "position": "unknown", "mass_kg": 40.0, "note": ["n" * 300 + "..."]}
    ]


def test_long_scenes_are_cut_and_say_so(brief: MissionBrief) -> None:
    scene = Scene(entities=tuple(Entity(id=f"box_{number}") for number in range(230)))
    system, _ = opening(TreeBuilder(replace(brief, scene=scene)))
    assert len(block(system.text, "Scene")) == 200
    assert "... and 30 more, listed by listRoutines" in system.text


def test_without_a_scene_the_missions_names_are_used(brief: MissionBrief) -> None:
    system, _ = opening(TreeBuilder(brief))
    assert "Call things as the mission calls them." in system.text
    assert system.text.endswith("Scene:\nNone is described.")


def test_a_reminder_says_what_is_missing_and_wants_calls() -> None:
    faults = [Reason(rule="open_leaf", message=f"Task {number} is open.", hint="Close it.") for number in range(60)]
    said = reminder(faults)
    assert said.must_call
    assert "- Task 0 is open. Close it.\n" in said.text
    assert "Task 49 is open" in said.text
    assert "Task 50 is open" not in said.text
    assert "- ... and 10 more\n" in said.text


def test_a_review_quotes_the_tree_and_lets_the_model_be_silent() -> None:
    said = review(reunite_tree(), ())
    quoted, _ = json.JSONDecoder().raw_decode(said.text.split("as data: ")[1])
    assert quoted.splitlines()[0].startswith("- ")
    assert not said.must_call
    assert "simple reader" not in said.text


def test_a_review_tells_what_speaks_against_the_tree() -> None:
    said = review(reunite_tree(), [Reason(rule="no_robot_able", message='No robot can do "it".')])
    assert r'because of ["No robot can do \"it\"."]' in said.text
