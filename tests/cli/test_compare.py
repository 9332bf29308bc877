"""``missiontree compare`` on a mission that cannot be compared."""

import json

from tests.cli.running import Shell


def test_json_stays_json_when_the_mission_is_not_understood(shell: Shell) -> None:
    ran = shell("compare", "lorem ipsum dolor", "--json")
    assert ran.code == 5
    answer = json.loads(ran.out)
    assert answer["outcome"] == "incomplete"
    assert "lorem" in answer["reasons"][0]["message"]
