"""``missiontree check``: what it confirms, and what it takes on trust."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

from missiontree.briefing import request_from
from missiontree.formats.document import write_text
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.planner import author, plan_authored
from missiontree.samples.catalogue import sample_file
from tests.checking.plans import choices, reunite
from tests.cli.running import Shell


def written(plan: Plan, folder: Path) -> str:
    (folder / "plan.json").write_text(write_text(plan, "plan"), encoding="utf-8")
    return "plan.json"


def called_optimal(plan: Plan, schedule: Schedule, method: str) -> Plan:
    """The plan with one schedule said to be the shortest, by some method."""
    proven = Certificate(claim="proven", method=method, bound=schedule.makespan_s)
    claimed = replace(schedule, status="optimal", certificate=proven)
    return replace(plan, schedules=tuple(claimed if one is schedule else one for one in plan.schedules))


def test_what_is_confirmed_needs_no_words(shell: Shell, tmp_path: Path) -> None:
    file = written(reunite(), tmp_path)
    assert shell("check", file).out == "sound: plan.json keeps every rule\n"
    assert json.loads(shell("check", file, "--json").out) == {"sound": True, "findings": [], "taken_on_trust": []}


def test_what_is_taken_on_trust_is_named(shell: Shell, tmp_path: Path) -> None:
    """A schedule that enumeration proved is called optimal by another documented method: the checker cannot tell, and says so."""
    request = request_from(sample_file("harbour"))
    plan = plan_authored(request, author(request), Control())
    tried = next(schedule for schedule in plan.schedules if schedule.certificate.method == "enumeration")
    file = written(called_optimal(plan, tried, "critical_path"), tmp_path)
    ran = shell("check", file)
    assert ran.code == 0
    sound, *trusted = ran.out.splitlines()
    assert sound == "sound: plan.json keeps every rule"
    assert " ".join(trusted).startswith(
        f"not confirmed: That schedule {tried.rank} is optimal is taken on the scheduler's word"
    )
    told = json.loads(shell("check", file, "--json").out)
    assert {claim["rule"] for claim in told["taken_on_trust"]} == {"bound_on_trust"}


def test_a_method_that_nobody_documents_is_a_fault(shell: Shell, tmp_path: Path) -> None:
    plan = choices()
    ran = shell("check", written(called_optimal(plan, plan.schedules[0], "magic"), tmp_path), "--json")
    assert ran.code == 6
    assert [finding["rule"] for finding in json.loads(ran.out)["findings"]] == ["claim_unfounded"]
