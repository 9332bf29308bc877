"""Mean, least utility and different teams on the whole road: files, words, schedules, check, screen."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from missiontree import check, plan
from missiontree.briefing import request_from
from missiontree.errors import InputError
from missiontree.formats.document import read_text, write_text
from missiontree.mission.aim import Aim
from missiontree.mission.plan import Plan
from missiontree.reporting.html.origin import origin
from missiontree.reporting.text import plan_text
from missiontree.samples.catalogue import sample_file

STRONG = (
    "types:\n"
    "  - {id: strong, count: 1, place: far, capabilities: {reach: 1, carry: 1},"
    " limits: {max_speed_mps: 1, energy_j: 50}, uses_per_m: {energy_j: 1}}\n"
)
WEAK = "  - {id: weak, count: 1, place: near, capabilities: {reach: 0.5, carry: 0.5}, limits: {max_speed_mps: 1}}\n"
SCENE = (
    "places: [{id: near, position: {x_m: 0, y_m: 0}}, {id: goal, position: {x_m: 9, y_m: 0}},"
    " {id: far, position: {x_m: 99, y_m: 0}}]\n"
    "entities: [{id: crate, place: near}]\n"
    "roads: {roads: [{ends: [near, goal]}, {ends: [goal, far]}]}\n"
)


def told(made: Plan) -> list[tuple[float, set[str]]]:
    """Utility and team of each alternative."""
    assert made.ranking is not None
    return [(one.utility, {filled.robot_type for filled in one.roles}) for one in made.ranking.alternatives]


def bring(folder: Path, fleet: str) -> Plan:
    """The best of each team, of robots of which the strong one has too little energy to get to the crate."""
    (folder / "fleet.yaml").write_text(fleet, encoding="utf-8")
    (folder / "scene.yaml").write_text(SCENE, encoding="utf-8")
    return plan(
        "Bring the crate to the goal",
        fleet=folder / "fleet.yaml",
        scene=folder / "scene.yaml",
        k=1,
        diverse=True,
    )


def test_means_of_the_papers_second_mission() -> None:
    """Ten actions in each: 8.6 / 10, twice 6.5 / 10, 4.4 / 10."""
    made = plan(sample_file("rescue"), accumulate="mean")
    assert [utility for utility, _ in told(made)] == [0.86, 0.65, 0.65, 0.44]
    assert (made.brief.aim, check(made)) == (Aim(accumulate="mean"), ())


def test_the_weakest_action_of_the_papers_second_mission() -> None:
    """Reaching the cat is done at 0.3 in all of them."""
    made = plan(sample_file("rescue"), accumulate="min")
    assert [utility for utility, _ in told(made)] == [0.3] * 4
    assert check(made) == ()


def test_different_teams_of_the_papers_second_mission() -> None:
    """The two of 6.5 have the team of the best and are left out; the last does all of it with one type."""
    made = plan(sample_file("rescue"), diverse=True)
    assert told(made) == [(8.6, {"tele_robot", "transportation_robot"}), (4.4, {"transportation_robot"})]
    assert made.ranking is not None
    assert (made.ranking.status, made.ranking.certificate.method) == ("exact", "team_partition")
    assert "2 alternatives of different teams, best first (every rank proven)" in plan_text(made)
    assert ("teams", "no two alternatives have the same") in origin(made)
    assert check(made) == ()


def test_a_plan_keeps_what_was_asked_for() -> None:
    made = plan(sample_file("reunite"), accumulate="mean", diverse=True)
    again = read_text(write_text(made, "plan"), "plan")
    assert again.brief.aim == Aim(accumulate="mean", diverse=True)
    assert {"accumulate", "diverse"} <= again.digests.keys()
    assert "mean utility" in plan_text(made)
    assert ("of an alternative", "mean utility of its actions") in origin(made)
    assert plan(sample_file("reunite")).digests.keys().isdisjoint({"accumulate", "diverse"})


def test_a_team_that_cannot_be_scheduled_stays_and_the_next_is_of_another_team(tmp_path: Path) -> None:
    """Allocation counts an approach as nothing, and a schedule the 99 J that the strong robot does not have."""
    made = bring(tmp_path, STRONG + WEAK)
    assert [team for _, team in told(made)] == [{"strong"}, {"weak"}]
    assert [schedule.status == "infeasible" for schedule in made.schedules] == [True, False]
    assert (made.outcome, check(made)) == ("delivered", ())


def test_that_no_team_s_best_can_be_scheduled_is_no_proof_that_nothing_can_be(tmp_path: Path) -> None:
    made = bring(tmp_path, STRONG)
    assert (made.outcome, made.reasons[-1].rule) == ("exhausted", "one_per_team")
    assert check(made) == ()


def test_the_mission_file_says_it_and_arguments_go_before_it(tmp_path: Path) -> None:
    file = tmp_path / "mission.yaml"
    file.write_text("mission: Find the cat\naccumulate: min\ndiverse: true\n", encoding="utf-8")
    assert request_from(file).brief.aim == Aim(accumulate="min", diverse=True)
    assert request_from(file, accumulate="sum", diverse=False).brief.aim == Aim()
    assert request_from(file, diverse=False).brief.aim == Aim(accumulate="min")


@pytest.mark.parametrize("line", ["accumulate: average", "accumulate: 3", "diverse: 2", "diverse: maybe"])
def test_a_mission_file_that_says_something_else_is_refused(line: str) -> None:
    with pytest.raises(InputError, match=line.partition(":")[0]) as caught:
        read_text(f"mission: Find the cat\n{line}\n", "mission")
    assert caught.value.line == 2


def test_other_arguments_are_refused_in_words() -> None:
    with pytest.raises(InputError, match="accumulate is 'average'") as caught:
        plan("Find the cat", accumulate="average")  # type: ignore[arg-type]
    assert caught.value.accepted == "sum, mean or min"
    with pytest.raises(InputError, match="diverse is 'yes'"):
        plan("Find the cat", diverse="yes")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="the allocator 'pruned' ranks by sums alone"):
        plan("Find the cat", accumulate="mean", allocator="pruned")
    with pytest.raises(InputError, match="the allocator 'pruned_as_printed' ranks by sums alone"):
        plan("Find the cat", diverse=True, allocator="pruned_as_printed")


def test_every_word_of_the_aim_is_in_the_schema() -> None:
    from missiontree.formats.document import json_schema

    fields = json_schema("mission")["properties"]
    assert json.dumps(fields["accumulate"]["enum"]) == '["sum", "mean", "min"]'
    assert fields["diverse"]["type"] == "boolean"
