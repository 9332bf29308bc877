"""Mission files and routine files: what they hold, and when they hold too little."""

import pytest

from missiontree.errors import InputError
from missiontree.formats.document import read_text
from missiontree.formats.mission_file import MissionFile
from missiontree.formats.routine_file import RoutineFile
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Weights

TEXT = """
mission: Bring the crate to the dock   # no quotes needed
fleet: fleet.yaml
routines: [routines.yaml]
entities:
- {id: crate, kind: object, mass_kg: 12}
weights: {beta: 0.01}
k: 2
"""


def test_a_mission_file_is_read() -> None:
    assert read_text(TEXT, "mission") == MissionFile(
        mission="Bring the crate to the dock",
        fleet="fleet.yaml",
        routines=("routines.yaml",),
        entities=(Entity(id="crate", mass_kg=12),),
        weights=Weights(beta=0.01),
        k=2,
    )


def test_a_mission_file_says_who_and_how_good() -> None:
    text = "mission: Go\nwithout: [mule]\nrequire: [rover, red]\nmin_quality: {Search: 0.8, carry: 0.5}\n"
    file = read_text(text, "mission")
    assert (file.without, file.require) == (("mule",), ("rover", "red"))
    assert file.min_quality == {"Search": 0.8, "carry": 0.5}
    assert read_text("mission: Go\nmin_quality: 0.5\n", "mission").min_quality == 0.5


def test_a_minimum_of_quality_is_no_less_than_0() -> None:
    with pytest.raises(InputError, match=r"min_quality"):
        read_text("mission: Go\nmin_quality: -1\n", "mission")
    with pytest.raises(InputError, match=r"min_quality"):
        read_text("mission: Go\nmin_quality: {Search: -1}\n", "mission")


def test_a_mission_file_needs_words_or_a_tree() -> None:
    assert MissionFile(tree="tree.json").mission == ""
    with pytest.raises(ValueError, match="needs a mission in words, goals, or the path of a tree"):
        MissionFile(mission="  ")


def test_a_mission_file_has_each_entity_once() -> None:
    with pytest.raises(ValueError, match="entity 'a' stands twice"):
        MissionFile(mission="Go", entities=(Entity(id="a"), Entity(id="a")))


def test_a_routine_file_may_build_on_routines_that_are_elsewhere() -> None:
    text = "routines: [{id: Fetch, purpose: Fetch it, arguments: [{name: agent, kinds: [object]}], parts: [{routine: Search}]}]"
    assert [routine.id for routine in read_text(text, "routines").routines] == ["Fetch"]
    with pytest.raises(ValueError, match="at least one routine"):
        RoutineFile(routines=())


def test_times_are_read_and_refused_where_they_make_no_sense() -> None:
    made = read_text(
        "mission: Go\ndeadline_s: 60\ngoals: [{do: Search(keys), release_s: 5, deadline_s: 30.5}]\n", "mission"
    )
    assert (made.deadline_s, made.goals[0].release_s, made.goals[0].deadline_s) == (60, 5, 30.5)
    for text, where in (
        ("mission: Go\ndeadline_s: -1\n", "deadline_s"),
        ("mission: Go\ndeadline_s: soon\n", "deadline_s"),
        ("mission: Go\nrelease_s: 5\n", "release_s"),
        ("goals: [{do: Search(keys), release_s: 9, deadline_s: 8}]\n", "before its release time 9 s"),
    ):
        with pytest.raises(InputError, match=where):
            read_text(text, "mission")


def test_nodes_of_a_tree_file_may_have_times() -> None:
    nodes = "nodes:\n- {id: a, label: A, routine: Search, arguments: {agent: b}, release_s: 2, deadline_s: 9}\n"
    node = read_text("objective: x\n" + nodes, "tree").nodes[0]
    assert (node.release_s, node.deadline_s) == (2, 9)
    with pytest.raises(InputError, match="the deadline 1 s, before its release time 2 s"):
        read_text("objective: x\n" + nodes.replace("deadline_s: 9", "deadline_s: 1"), "tree")
