"""A user's own estimator: what counts as one, and what is made of answers that are none."""

from __future__ import annotations

import hashlib
import math
from pathlib import Path
from typing import Any

import pytest

from missiontree import plan
from missiontree.checking import check
from missiontree.cli.gathering import least_quality
from missiontree.errors import InputError
from missiontree.estimation.own import own_estimator
from missiontree.estimation.table import TableEstimator
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Capability, DurationModel, Fleet, RobotType

HALF = Capability(0.5)
FUNCTION = "from missiontree.mission.estimate import Estimate\n\ndef estimate(*question, **about):\n"


class Doubtful:
    """Says the half of what the fleet states."""

    def estimate(self, capability: Capability, *question: Any, **about: str) -> Estimate:
        return Estimate(capability.quality / 2)


def flattering(capability: Capability, *question: Any, **about: str) -> Estimate:
    return Estimate(capability.quality * 2)


def file_of(folder: Path, text: str, name: str = "mine.py") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def answer(given: Any) -> Estimate:
    own = own_estimator(given)
    assert own is not None
    return own.estimate(HALF, 10.0, 0.0, 3.0, 2.0, robot_type="cart", action="lift", rating="carry", at="dock")


def test_an_object_and_a_function_are_asked_and_called_by_their_names() -> None:
    for given, name, quality in ((Doubtful(), "Doubtful", 0.25), (flattering, "flattering", 1.0)):
        own = own_estimator(given)
        assert own is not None
        assert (own.source.name, own.source.digest) == (name, "")
        assert answer(given).quality == quality


def test_the_table_of_the_fleet_is_no_estimator_of_ones_own() -> None:
    assert own_estimator(TableEstimator()) is None
    made = plan("Find the cat", estimator=TableEstimator())
    assert made.brief.estimator is None
    assert made.digests == plan("Find the cat").digests


@pytest.mark.parametrize(
    "text",
    [
        FUNCTION + "    return Estimate(0.75)\n",
        FUNCTION.replace("def estimate(", "class Mine:\n    def estimate(self, ")
        + "        return Estimate(0.75)\n\nestimator = Mine()\n",
    ],
    ids=["function", "object"],
)
def test_a_file_names_a_function_or_an_object(text: str, tmp_path: Path) -> None:
    path = file_of(tmp_path, text)
    own = own_estimator(path)
    assert own is not None
    assert (own.source.name, own.source.digest) == ("mine.py", hashlib.sha256(text.encode()).hexdigest())
    assert answer(path) == Estimate(0.75)


def test_the_question_is_handed_on_whole() -> None:
    asked: list[Any] = []

    def listening(*question: Any, **about: str) -> Estimate:
        asked.append((question, about))
        return Estimate(1)

    answer(listening)
    about = {"robot_type": "cart", "action": "lift", "rating": "carry", "at": "dock"}
    assert asked == [((HALF, 10.0, 0.0, 3.0, 2.0), about)]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("x = 1\n", "the file names no estimator"),
        ("estimate = 3\n", "a int"),
        ("class estimator:\n    def estimate(self): ...\n", "Make an object of it: estimator()."),
        (FUNCTION + "    ...\n\nestimator = 1\n", "names both 'estimator' and 'estimate'"),
        ("import sys\nsys.exit()\n", "SystemExit"),
        ("def estimate(:\n", "SyntaxError"),
        ("\n1 / 0\n", "ZeroDivisionError"),
    ],
)
def test_a_file_that_names_none_is_refused(text: str, words: str, tmp_path: Path) -> None:
    path = file_of(tmp_path, text)
    with pytest.raises(InputError) as caught:
        own_estimator(path)
    assert caught.value.file == str(path)
    assert words in str(caught.value)


def test_a_file_that_is_not_there_or_is_not_python_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no such file"):
        own_estimator(tmp_path / "gone.py")
    with pytest.raises(InputError, match=r"accepted: a Python file"):
        own_estimator(file_of(tmp_path, "", "mine.yaml"))


@pytest.mark.parametrize(
    ("given", "words"), [(3, "a int"), (Doubtful, "Make an object of it: Doubtful()."), (Estimate(1), "a Estimate")]
)
def test_what_cannot_be_asked_is_refused(given: Any, words: str) -> None:
    with pytest.raises(InputError) as caught:
        plan("Find the cat", estimator=given)
    assert words in str(caught.value)


@pytest.mark.parametrize("said", [0.5, None, (0.5, 1, 1), Estimate], ids=str)
def test_an_answer_of_another_type_is_refused_with_the_action(said: Any) -> None:
    with pytest.raises(InputError) as caught:
        answer(lambda *_, **__: said)
    assert "action 'lift' by robot type 'cart' at 'dock'" in str(caught.value)
    assert "an Estimate(quality, duration_s, cost)" in caught.value.accepted


@pytest.mark.parametrize(
    "numbers", ["-1", "float('nan')", "float('inf')", "'good'", "True", "1, -1", "1, 1, -1", "10 ** 400"]
)
def test_a_number_that_is_none_is_told_with_its_line(numbers: str, tmp_path: Path) -> None:
    path = file_of(tmp_path, FUNCTION + f"    return Estimate({numbers})\n")
    with pytest.raises(InputError) as caught:
        answer(path)
    assert (caught.value.file, caught.value.line) == (str(path), 4)
    assert "action 'lift' by robot type 'cart'" in caught.value.message


@pytest.mark.parametrize("numbers", [(2e9,), (0, 2e9), (0, 0, 2e9)])
def test_a_number_too_large_to_rank_by_is_refused(numbers: tuple[float, ...]) -> None:
    with pytest.raises(InputError, match="at most 1,000,000,000"):
        answer(lambda *_, **__: Estimate(*numbers))


def test_an_estimate_that_its_weight_makes_too_large_is_refused() -> None:
    with pytest.raises(InputError, match="counts for more than 1,000,000,000"):
        plan("Find the cat", estimator=lambda *_, **__: Estimate(1e6), weights=Weights(1e4))


def test_numbers_are_made_plain() -> None:
    said = answer(lambda *_, **__: Estimate(1, -0.0, 3))
    assert [type(number) for number in (said.quality, said.duration_s, said.cost)] == [float] * 3
    assert math.copysign(1, said.duration_s) == 1


def test_code_that_fails_is_told_with_file_line_and_action(tmp_path: Path) -> None:
    path = file_of(tmp_path, FUNCTION + "    return deeper()\n\n\ndef deeper():\n    return {}['cart']\n")
    with pytest.raises(InputError) as caught:
        answer(path)
    error = caught.value
    assert (error.file, error.line) == (str(path), 8)
    assert error.message == "the estimator fails for action 'lift' by robot type 'cart' at 'dock': KeyError: 'cart'"


def test_code_that_ends_the_program_is_told_too(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="SystemExit"):
        answer(file_of(tmp_path, FUNCTION + "    raise SystemExit(0)\n"))


def test_an_object_that_fails_is_told_with_the_file_of_its_code() -> None:
    def failing(*_: Any, **__: str) -> Estimate:
        raise LookupError("no such robot")

    with pytest.raises(InputError) as caught:
        answer(failing)
    assert (Path(caught.value.file), caught.value.line > 0) == (Path(__file__), True)


def test_a_function_of_other_arguments_is_told_what_it_is_called_with() -> None:
    with pytest.raises(InputError) as caught:
        answer(lambda capability: Estimate(1))
    assert "estimate(capability, nominal_s, nominal_cost, travel_m, travel_s, robot_type=…" in caught.value.hint


def test_no_answer_of_the_checker_depends_on_the_estimator_being_there() -> None:
    """Half of 3 x 1.0 and 3 x 0.3. A plan of the same numbers that names no estimator is refused."""
    made = plan("Find the cat", estimator=Doubtful())
    assert made.ranking is not None
    assert [one.utility for one in made.ranking.alternatives] == pytest.approx([1.5, 0.45])
    assert check(made) == ()


def test_the_minimum_holds_for_what_the_estimator_says() -> None:
    """Half of 1.0 is below 0.6, though the fleet states more; twice 0.3 is not, though the fleet states less."""
    least = least_quality(["0.6"])
    refused = plan("Find the cat", estimator=Doubtful(), min_quality=least)
    assert refused.outcome == "cannot_be_done"
    assert "Tele-Robot is not good enough for Search(Cat): quality of search 0.5" in " ".join(
        reason.message for reason in refused.reasons
    )
    assert check(refused) == ()
    made = plan("Find the cat", estimator=flattering, min_quality=least)
    assert made.ranking is not None
    assert [one.utility for one in made.ranking.alternatives] == pytest.approx([6.0, 1.8])
    assert check(made) == ()


def test_schedules_take_the_duration_without_travel() -> None:
    """Twice the nominal 5, 60 and 2 seconds, whatever it adds for travel; by the fleet they would take 10 s more each."""

    def slow(capability: Capability, nominal_s: float | None, *question: Any, **about: str) -> Estimate:
        return Estimate(1, 2 * (nominal_s or 0))

    search = Capability(1.0, duration=DurationModel(plus_s=10))
    fleet = Fleet((RobotType(id="scout", count=1, capabilities={"search": search}),))
    made = plan("Find the cat", fleet=fleet, estimator=slow)
    assert made.schedules[0].makespan_s == 134
    assert plan("Find the cat", fleet=fleet).schedules[0].makespan_s == 97


def test_an_estimator_that_says_what_the_table_says_gives_the_same_plan() -> None:
    mission = "Reunite mom with her lost child"
    weights = Weights(1, 0.01, 0.1)
    own = plan(mission, estimator=lambda *question, **about: TableEstimator().estimate(*question), weights=weights)
    table = plan(mission, weights=weights)
    assert own.grounding is not None
    assert table.grounding is not None
    assert own.grounding.tree == table.grounding.tree
    assert (own.ranking, own.schedules) == (table.ranking, table.schedules)
    assert {said.robot_type for said in own.grounding.estimates} == {
        "tele_robot",
        "transportation_robot",
        "social_robot",
    }
    assert table.grounding.estimates == ()
