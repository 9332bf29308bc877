"""Goals in mission files: read, written, explained, and refused with the line."""

from __future__ import annotations

import pytest

from missiontree.errors import InputError
from missiontree.formats.document import json_schema, read_text, write_text
from missiontree.formats.inputs import inputs_of
from missiontree.formats.mission_file import MissionFile
from missiontree.mission.brief import MissionBrief
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.goal import Goal
from missiontree.routines.library import built_in

TEXT = """
goals:
  - {name: save, method: rescue, slots: {victim: [Anna, Tom], site: barn}}
  - task: Tidy up
    gate: xor
    after: [save]
    goals:
      - {do: "ReachAndTransport(red box, depot)", by: [crane]}
      - {do: Follow(dog), until: save, not_by: [crane]}
"""
GOALS = (
    Goal(name="save", method="rescue", slots={"victim": ("Anna", "Tom"), "site": "barn"}),
    Goal(
        task="Tidy up",
        gate="xor",
        after=("save",),
        goals=(
            Goal(do="ReachAndTransport(red box, depot)", by=("crane",)),
            Goal(do="Follow(dog)", until="save", not_by=("crane",)),
        ),
    ),
)
CRANE = Fleet((RobotType(id="crane", count=1),))


def test_goals_are_read_and_written() -> None:
    file = read_text(TEXT, "mission")
    assert file == MissionFile(goals=GOALS)
    assert read_text(write_text(file, "mission"), "mission") == file


def test_a_brief_keeps_its_goals_and_names_them_among_its_inputs() -> None:
    brief = MissionBrief(text="Tidy", fleet=CRANE, routines=built_in(), goals=GOALS)
    assert read_text(write_text(brief, "brief"), "brief") == brief
    assert inputs_of(brief, None)["goals"] == GOALS
    assert "goals" not in inputs_of(MissionBrief(text="Tidy", fleet=CRANE, routines=built_in()), None)


def test_a_brief_refuses_robot_types_that_its_fleet_does_not_have() -> None:
    with pytest.raises(
        ValueError, match=r"'ReachAndTransport.*' names robot type 'crane', which the fleet does not have"
    ):
        MissionBrief(text="Tidy", fleet=Fleet((RobotType(id="drone", count=1),)), routines=built_in(), goals=GOALS)


def test_goals_and_a_tree_are_not_given_together() -> None:
    with pytest.raises(ValueError, match="either goals or the path of a tree"):
        MissionFile(goals=GOALS, tree="tree.json")


@pytest.mark.parametrize(
    ("line", "written", "number", "words"),
    [
        ("", "- {do: Search(dog), name: a, after: [a]}", 3, "cannot wait for 'a'"),
        ("- {do: Search(keys), name: a}", "- {do: Search(dog), name: a}", 4, "goal 'a' stands twice"),
        (
            "- {do: Search(keys), name: a}",
            "- {do: Search(dog), after: [b]}",
            4,
            "refers to goal 'b'; named goals are: a",
        ),
        ("- {do: Search(keys), name: a}", "- {do: Search, name: b}", 4, "'Search' is not of the form"),
        ("- {do: Search(keys), name: a}", "- {name: b}", 4, "one of do"),
        ("- {do: Search(keys), name: a}", "- {method: rescue, slots: {victim: 5}}", 4, "found 5"),
        ("- {do: Search(keys), name: a}", "- {do: Search(dog), gate: or}", 4, "found 'or'"),
        ("- {do: Search(keys), name: a}", "- {do: Search(dog), with: {x: y}}", 4, "a goal has no field 'with'"),
        (
            "- {do: Search(keys), name: a}",
            "- {do: Reach(a, b)}",
            4,
            "a comma ends a value: put text that holds one in quotes",
        ),
    ],
)
def test_what_the_file_shows_to_be_wrong_is_refused_with_its_line(
    line: str, written: str, number: int, words: str
) -> None:
    with pytest.raises(InputError) as caught:
        read_text(f"mission: Tidy up\ngoals:\n{line}{chr(10) if line else ''}{written}\n", "mission", "m.yaml")
    assert caught.value.line == number
    assert words in str(caught.value)


def test_the_schema_explains_goals_within_goals() -> None:
    goal = json_schema("mission")["$defs"]["Goal"]
    assert goal["properties"]["goals"]["items"] == {"$ref": "#/$defs/Goal"}
    assert goal["properties"]["slots"]["description"].startswith("What the slots of the method are filled with")
    assert goal["additionalProperties"] is False
