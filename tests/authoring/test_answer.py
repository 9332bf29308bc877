"""Refusals as a model reads them."""

from __future__ import annotations

import json

from missiontree.authoring.answer import Answer
from missiontree.mission.reason import Reason


def lacks(robot: str, needed: str) -> Reason:
    return Reason(rule="capability_missing", message=f"{robot} has no {needed}.", robot=robot, needed=needed)


def test_the_nearest_miss_comes_first_and_what_is_out_anyway_is_named_together() -> None:
    """A cart can carry and is too weak. Drone and rover carry nothing, so that they may not enter the yard does not matter."""
    weak = Reason(
        rule="limit_too_low", message="cart: payload_kg 90, needed 900.", robot="cart", needed="payload_kg 900"
    )
    zone = Reason(rule="zone_forbidden", message="drone may not enter the yard.", robot="drone", needed="zone yard")
    first = Reason(rule="no_robot_able", message="No robot can do it.", hint="Edit the fleet.")
    answer = Answer(ok=False, reasons=(first, zone, lacks("drone", "carry"), lacks("rover", "carry"), weak))
    assert json.loads(answer.text)["refused"] == [
        {
            "rule": "no_robot_able",
            "message": "No robot can do it.",
            "hint": "If no other routine serves the mission, call declareImpossible with what is missing.",
        },
        {
            "rule": "nearly_able",
            "message": "Nearest to being able: cart lacks only payload_kg 900; rover lacks only the capability carry.",
        },
        {"rule": "limit_too_low", "message": "cart: payload_kg 90, needed 900."},
        {"rule": "capability_missing", "message": "drone, rover: no carry."},
    ]


def test_a_robot_that_there_is_not_is_not_replaced_by_another() -> None:
    unknown = Reason(rule="unknown_robot", message="There is no robot type 'Otto'.", hint="Robot types are: cart.")
    (told,) = json.loads(Answer(ok=False, reasons=(unknown,)).text)["refused"]
    assert told["hint"] == (
        "Robot types are: cart. If the mission insists on it, call declareImpossible; put no other in its place."
    )


def test_answers_are_written_without_blanks() -> None:
    assert Answer(ok=True, data={"nodes": [1, 2]}).text == '{"ok":true,"nodes":[1,2]}'
