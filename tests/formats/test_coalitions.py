"""Missions of coalitions: what they become, and how whatever is wrong with one is said."""

from __future__ import annotations

import json
from typing import Any

import pytest

from missiontree.errors import InputError
from missiontree.formats.importers.coalitions import coalitions_of, looks_like_coalitions
from missiontree.formats.reader import parse

GOOD: dict[str, Any] = {
    "Q": [[1, 0], [0, 1]],
    "R": [[0, 0], [1, 1.0], [0.0, 1], [0, 0]],
    "T_e": [0, 4, 2.5, 0],
    "task_locations": [[0, 0], [3, 4], [6, 8], [0, 0]],
    "precedence_constraints": [[1, 2]],
    "ref": 24.5,
}


def test_tasks_lie_between_start_and_end() -> None:
    mission = coalitions_of(parse(json.dumps(GOOD), "m.json"))
    assert mission.skills == ((0,), (1,))
    assert [(task.needs, task.duration_s, task.x_m, task.y_m) for task in mission.tasks] == [
        ((0, 1), 4.0, 3.0, 4.0),
        ((1,), 2.5, 6.0, 8.0),
    ]
    assert (mission.start, mission.end, mission.precedence, mission.reference_s) == ((0, 0), (0, 0), ((0, 1),), 24.5)
    assert mission.travel[2] == (5000, 10000, 0, 0)


def test_it_is_known_by_its_keys() -> None:
    assert looks_like_coalitions(GOOD)
    assert not looks_like_coalitions({"kind": [0], "parent": [-1]})
    assert not looks_like_coalitions([GOOD])


@pytest.mark.parametrize(
    ("changes", "where", "said"),
    [
        ({"Q": None}, "", "'Q' is missing"),
        ({"q": 1}, "q", "'q' is not known"),
        ({"Q": 3}, "Q", "3 stands here"),
        ({"Q": []}, "Q", "there are 0 rows"),
        ({"Q": [[1, 0]] * 13}, "Q", "there are 13 rows"),
        ({"Q": [[], []]}, "Q[0]", "there are 0 skills"),
        ({"Q": [[1, 0], [1]]}, "Q[1]", "the row has 1 entries, and there are 2 skills"),
        ({"Q": [[1, 2], [0, 1]]}, "Q[0][1]", "2 stands here"),
        ({"Q": [[1, True], [0, 1]]}, "Q[0][1]", "true (a truth value) stands here"),
        ({"R": [[0, 0]]}, "R", "there are 1 rows"),
        ({"R": [[0, 0], [1], [0, 1], [0, 0]]}, "R[1]", "the row has 1 entries"),
        ({"R": [[0, 0], 5, [0, 1], [0, 0]]}, "R[1]", "5 stands here"),
        ({"R": [[1, 0], [1, 1], [0, 1], [0, 0]]}, "R[0]", "task 0 is the start and needs a skill"),
        ({"R": [[0, 0], [1, 1], [0, 1], [0, 1]]}, "R[3]", "task 3 is the end and needs a skill"),
        ({"T_e": [0, 4, 2]}, "T_e", "the list has 3 entries, and there are 4 tasks"),
        ({"T_e": [0, -4, 2, 0]}, "T_e[1]", "-4 stands here"),
        ({"T_e": [0, "4", 2, 0]}, "T_e[1]", "'4' (text) stands here"),
        ({"T_e": [0, 4, 2, 1]}, "T_e[3]", "task 3 is the end and takes 1 s"),
        ({"task_locations": [[0, 0]]}, "task_locations", "the list has 1 entries"),
        ({"task_locations": [[0, 0], [3], [6, 8], [0, 0]]}, "task_locations[1]", "a list of 1 stands here"),
        ({"task_locations": [[0, 0], [3, None], [6, 8], [0, 0]]}, "task_locations[1][1]", "nothing (null) stands here"),
        ({"task_locations": [[0, 0], [3, 2e9], [6, 8], [0, 0]]}, "task_locations[1][1]", "2000000000.0 stands here"),
        ({"precedence_constraints": 5}, "precedence_constraints", "5 stands here"),
        ({"precedence_constraints": [[1]]}, "precedence_constraints[0]", "a list of 1 stands here"),
        ({"precedence_constraints": [[1, 3]]}, "precedence_constraints[0]", "the pair [1, 3] stands here"),
        ({"precedence_constraints": [[1, 1]]}, "precedence_constraints[0]", "the pair [1, 1] stands here"),
        ({"precedence_constraints": [[1, 2], [2, 1]]}, "precedence_constraints[0]", "the precedence runs in a circle"),
        ({"ref": "x"}, "ref", "'x' (text) stands here"),
    ],
)
def test_what_is_wrong_is_said_with_place_and_line(changes: dict[str, Any], where: str, said: str) -> None:
    data = {key: value for key, value in (GOOD | changes).items() if value is not None}
    with pytest.raises(InputError) as caught:
        coalitions_of(parse(json.dumps(data, indent=1), "m.json"))
    assert said in caught.value.message
    assert (caught.value.file, caught.value.where) == ("m.json", where)
    assert caught.value.line >= 1


def test_something_else_is_refused() -> None:
    with pytest.raises(InputError, match="a list of 0 stands here"):
        coalitions_of(parse("[]", "m.json"))
