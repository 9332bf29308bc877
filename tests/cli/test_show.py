"""``missiontree show`` with a plan that was damaged by hand."""

import json
from pathlib import Path

from tests.cli.running import Shell


def test_a_plan_that_points_nowhere_is_bad_input_and_can_still_be_checked(shell: Shell, tmp_path: Path) -> None:
    shell("plan", "--sample", "reunite", "--out", "plan.json", "--quiet")
    plan = json.loads((tmp_path / "plan.json").read_text(encoding="utf-8"))
    plan["schedules"][0]["actions"][0]["leaf"] = 9999
    (tmp_path / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    shown = shell("show", "plan.json")
    assert shown.code == 2, shown
    assert "plan.json: schedules[0].actions[0].leaf: node 9999" in shown.err
    assert shell("check", "plan.json").code == 6
