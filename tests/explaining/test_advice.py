"""What is evident before a language model is asked: shown before anything is spent, told in the plan, and never in the way."""

from __future__ import annotations

import pytest

from missiontree.authoring.nearly_able import nearly_able
from missiontree.briefing import Request, request_from
from missiontree.cli.watching import advised
from missiontree.explaining.advice import advice_on, asks_a_model
from missiontree.mission.reason import Reason

CARRY = "Carry the cat to the vet, then find the keys"


def asked_of(model: str, mission: str = CARRY, without: tuple[str, ...] = ()) -> Request:
    return request_from(mission, model=model, without=without)


def test_what_no_robot_can_do_is_said_before_a_model_is_asked() -> None:
    (advice,) = advice_on(asked_of("openai:gpt", without=("transportation_robot", "social_robot")))
    assert (advice.rule, advice.severity) == ("advice", "notice")
    assert advice.message == (
        'No robot of this fleet can do "Transport(Cat, Vet)". Nearest to being able: mobile_scooter lacks only the capability '
        "carry; tele_robot lacks only the capability carry."
    )


def test_a_goal_that_no_routine_serves_is_said() -> None:
    (advice,) = advice_on(asked_of("openai:gpt", "Recommend best Italian restaurants in the area"))
    assert "needs the capability recommend" in advice.message


def test_a_mission_that_can_be_done_or_that_is_not_understood_earns_none() -> None:
    assert advice_on(asked_of("openai:gpt", "Reunite mom with her lost child")) == ()
    assert advice_on(asked_of("openai:gpt", "Blorf the zonk")) == ()


def test_of_a_mission_that_is_not_understood_routines_are_told_that_nobody_can_do() -> None:
    request = asked_of("openai:gpt", "Blorf the zonk", without=("transportation_robot", "social_robot"))
    assert [advice.node for advice in advice_on(request)] == ["Transport", "ReachAndTransport"]


@pytest.mark.parametrize(("model", "asks"), [("offline", False), ("recorded:x.jsonl", False), ("openai:gpt", True)])
def test_only_models_that_may_cost_money_are_advised_about(model: str, asks: bool) -> None:
    assert asks_a_model(asked_of(model)) is asks


def test_advice_is_shown_on_standard_error_unless_it_is_to_be_quiet(capsys: pytest.CaptureFixture[str]) -> None:
    request = asked_of("openai:gpt", without=("transportation_robot", "social_robot"))
    assert advised(request, quiet=False, colour=False) == advice_on(request)
    said = capsys.readouterr().err
    assert 'advice: No robot of this fleet can do "Transport(Cat, Vet)".' in said
    assert "no verdict" in said
    assert advised(request, quiet=True, colour=False) == advice_on(request)
    assert capsys.readouterr().err == ""


def refusal(robot: str, rule: str, needed: str, found: str = "", way: str = "carry") -> Reason:
    return Reason(rule=rule, message=f"{robot} cannot do it by {way}: no.", robot=robot, needed=needed, found=found)


def test_who_lacks_one_thing_is_named_numbers_first_and_who_lacks_more_is_not() -> None:
    reasons = [
        refusal("scooter", "capability_missing", "carry"),
        refusal("arm", "limit_too_low", "payload_kg 12", "payload_kg 4"),
        refusal("probe", "capability_missing", "carry"),
        refusal("probe", "limit_too_low", "payload_kg 12", "payload_kg 1"),
        refusal("guest", "left_out", "scooter, arm"),
    ]
    assert nearly_able(reasons) == (
        "Nearest to being able: arm lacks only payload_kg 12 (it has payload_kg 4); scooter lacks only the capability carry."
    )
    assert nearly_able(reasons[2:]) == ""
