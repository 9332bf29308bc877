"""One run: what is asked, what is judged, what it took."""

from pathlib import Path

import pytest

from missiontree.authoring.budgets import Budgets
from missiontree.errors import InputError
from missiontree.evaluation.contestant import Contestant
from missiontree.evaluation.examiner import Examiner, Task
from missiontree.evaluation.run import Run
from missiontree.llm.chat import ChatModel, ProviderError
from tests.evaluation.contestants import FIND, ROUTINES, attach, failing, missions_in, player, suite_folder

ALONE = Examiner()


def made(folder: Path, contestant: Contestant, mission: str, examiner: Examiner = ALONE, text: str = "") -> Run:
    missions = missions_in(folder, text) if text else missions_in(folder)
    setting, found = next((setting, one) for setting, one in missions if one.id == mission)
    return examiner(Task(contestant, found, setting.brief(found), "d", 1))


def test_a_right_plan_is_told_with_what_it_took(tmp_path: Path) -> None:
    """A turn that calls and a turn that is done; ten tokens heard and five said in each. By the clock three seconds pass."""
    ticks = iter((5.0, 8.0))
    run = made(tmp_path, player("good", cost_usd=0.01), "home-find", Examiner(clock=lambda: next(ticks)))
    assert (run.kind, run.status, run.score, run.got, run.fault) == ("right", "complete", 1.0, "Search(Anna)", "")
    assert run.seconds == 3.0
    assert run.spent is not None
    assert (run.spent.turns, run.spent.calls, run.spent.cost_usd) == (2, 2, 0.02)
    assert (run.spent.input_tokens, run.spent.output_tokens) == (20, 10)
    assert run.key == ("good", "home-find", 1, "d")


def test_a_wrong_plan_is_told_with_its_differences(tmp_path: Path) -> None:
    run = made(tmp_path, player("bad", {FIND: attach(FIND, "Reach(Anna)")}), "home-find")
    assert (run.kind, run.got, run.score) == ("wrong", "Reach(Anna)", 0.0)
    assert run.differences == ("missing: Search(Anna)", "not expected: Reach(Anna)")


def test_a_decline_is_told_with_its_reasons(tmp_path: Path) -> None:
    run = made(tmp_path, player("good"), "home-paint")
    assert (run.kind, run.status, run.got) == ("right", "cannot_be_done", "")
    assert "paint is missing" in run.reasons[0]


def test_a_model_that_fails_gives_a_result(tmp_path: Path) -> None:
    contestant = failing("down", lambda: ProviderError("It is down.", "overloaded"))
    run = made(tmp_path, contestant, "home-find")
    assert (run.kind, run.status, run.score) == ("no_answer", "provider_failed", 0.0)
    assert (run.fault, run.reasons) == ("provider_overloaded", ("It is down.",))


def test_a_model_that_cannot_be_made_gives_a_result_as_well(tmp_path: Path) -> None:
    def make() -> ChatModel:
        raise ProviderError("The package is missing.", "not_installed")

    run = made(tmp_path, Contestant("none", make), "home-find")
    assert (run.kind, run.fault, run.reasons) == (
        "no_answer",
        "provider_not_installed",
        ("The package is missing.",),
    )
    assert run.spent is None


def test_a_budget_that_runs_out_is_no_answer(tmp_path: Path) -> None:
    run = made(tmp_path, player("good"), "home-find", Examiner(budgets=Budgets(turns=1)))
    assert (run.kind, run.status, run.fault) == ("no_answer", "exhausted", "")


def test_a_dialogue_is_ended_when_it_is_to_stop(tmp_path: Path) -> None:
    run = made(tmp_path, player("good"), "home-find", Examiner(stop=lambda: True))
    assert (run.status, run.spent and run.spent.turns) == ("exhausted", 0)


def test_the_offline_author_is_a_contestant_without_a_language_model(tmp_path: Path) -> None:
    run = made(tmp_path, Contestant("offline", "offline"), "home-visit")
    assert (run.kind, run.spent) == ("right", None)


def test_a_name_that_is_no_model_is_bad_input_and_says_where(tmp_path: Path) -> None:
    with pytest.raises(InputError) as refusal:
        made(tmp_path, Contestant("x", "splendid"), "home-find")
    assert refusal.value.__notes__ == [f"while x was put to mission home-find: {FIND}"]


BOTH = "Inspect the pump and the valve."
CHARGED = f"""\
format: suite/1
setting: home
fleet: fleet.yaml
routines: [routines.yaml]
missions:
  - id: home-both
    say: {BOTH}
    plan: [Inspect(Pump), Inspect(Valve)]
"""
FLEET = """\
format: fleet/1
types:
  - {id: rover, count: 1, capabilities: {look: 1}, limits: {energy_j: 10}}
"""
INSPECTED = player("good", {BOTH: attach(BOTH, "Inspect(Pump)", "Inspect(Valve)")})


def charged(folder: Path, examiner: Examiner, outcome: str = "", energy_j: int = 10) -> Run:
    suite_folder(folder)
    (folder / "suite/home/fleet.yaml").write_text(FLEET.replace("10", str(energy_j)), encoding="utf-8")
    (folder / "suite/home/routines.yaml").write_text(ROUTINES, encoding="utf-8")
    return made(folder, INSPECTED, "home-both", examiner, CHARGED + outcome)


def test_the_tree_alone_is_right_though_nobody_has_the_energy(tmp_path: Path) -> None:
    """Two inspections at 8 J each need 16 J; the only rover has 10 J. The tree knows nothing of that."""
    assert charged(tmp_path, Examiner()).kind == "right"


def test_a_whole_plan_is_judged_by_what_planning_comes_to(tmp_path: Path) -> None:
    run = charged(tmp_path, Examiner(whole=True))
    assert (run.kind, run.status) == ("declined_though_possible", "cannot_be_done")
    assert run.differences == ("a plan was expected; planning came to cannot_be_done",)
    assert any("energy_j" in reason for reason in run.reasons)


def test_that_it_cannot_be_done_may_be_what_is_right(tmp_path: Path) -> None:
    outcome = "    outcome: cannot_be_done\n"
    assert charged(tmp_path, Examiner(whole=True), outcome).kind == "right"
    run = charged(tmp_path, Examiner(whole=True), outcome, energy_j=16)
    assert (run.kind, run.differences) == ("wrong", ("the mission cannot be done as planned; the plan was delivered",))


def test_an_impossible_mission_may_show_only_when_it_is_planned(tmp_path: Path) -> None:
    declined = CHARGED.replace("    plan: [Inspect(Pump), Inspect(Valve)]\n", "")
    text = f"{declined}    declined: impossible\n    because: energy\n"
    charged(tmp_path, Examiner())
    assert made(tmp_path, INSPECTED, "home-both", Examiner(), text).kind == "wrong"
    assert made(tmp_path, INSPECTED, "home-both", Examiner(whole=True), text).kind == "right"
