"""How a mission was understood, as it is shown."""

from __future__ import annotations

from pathlib import Path

from missiontree import plan
from missiontree.mission.entity import Entity
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.reporting.reading_view import reading_text
from tests.builders import paper_fleet

SCENE = Scene(
    places=(Entity(id="lobby", kind="place", label="Lobby", position=Position(0, 0)),),
    entities=(
        Entity(id="anna", kind="person", label="Anna", place="lobby"),
        Entity(id="cat", kind="animal", last_seen=Position(1, 1)),
        Entity(id="box", label="Box", position=Position(2, 2)),
    ),
)


def planned(text: str, scene: Scene | None = None) -> Plan:
    return plan(text, fleet=paper_fleet(), scene=scene)


def parts(text: str) -> dict[str, list[str]]:
    """The lines below each title, without their indent."""
    found: dict[str, list[str]] = {}
    for block in text.split("\n\n"):
        title, *lines = block.splitlines()
        found[title] = [line.strip() for line in lines]
    return found


def test_delivered_mission_is_shown_part_by_part() -> None:
    shown = parts(reading_text(planned("Find the cat and bring it to Anna"), width=200))
    assert list(shown) == [
        "Reading: Find the cat and bring it to Anna",
        "Clauses",
        "Who and what is meant",
        "Order",
        "Done on your behalf",
        "Assumed",
    ]
    assert shown["Clauses"] == [
        "1. 'Find the cat': routine Search, find {agent}; agent = the cat (Cat)",
        "2. 'bring it to Anna': routine ReachAndTransport, bring {agent} to {location}; "
        "agent = it (Cat), location = Anna (Anna)",
    ]
    assert shown["Order"] == ['"Search(Cat)" ends before "ReachAndTransport(Cat, Anna)" starts']
    assert shown["Done on your behalf"] == [
        "+ Search(Cat) goes before ReachAndTransport(Cat, Anna), though no order was said."
    ]


def rows(made: Plan) -> list[list[str]]:
    return [line.split(maxsplit=2) for line in parts(reading_text(made, width=200))["Who and what is meant"]]


def test_entities_stand_once_in_the_order_of_the_tree_with_where_they_are_known_from() -> None:
    assert rows(planned("Find the cat, then bring it to Anna", SCENE)) == [
        ["name", "kind", "known from  position"],
        ["cat", "animal", "the scene   last seen"],
        ["Anna", "person", "the scene   at Lobby"],
    ]
    assert rows(planned("Go to the box", SCENE))[1:] == [["Box", "object", "the scene   known"]]
    assert rows(planned("Go to the box"))[1:] == [["Box", "object", "the words   unknown"]]


def test_entity_that_the_mission_file_declares_is_known_from_there(tmp_path: Path) -> None:
    mission = tmp_path / "mission.yaml"
    mission.write_text(
        "format: mission/1\nmission: Go to the box\nentities: [{id: box, label: Box}]\n", encoding="utf-8"
    )
    assert rows(plan(mission))[1:] == [["Box", "object", "the mission file  unknown"]]


def test_mission_without_an_order_says_so() -> None:
    assert parts(reading_text(planned("Go to the lobby")))["Order"] == ["none is said"]


def test_what_was_not_understood_stands_in_its_clause_and_among_the_reasons() -> None:
    shown = parts(reading_text(planned("Find the cat. The cat is old."), width=300))
    assert list(shown)[1:] == ["Clauses", "Why it is not planned"]
    assert shown["Clauses"][1].startswith("2. not understood: 'The cat is old'")
    assert shown["Why it is not planned"][0].startswith("✗ 'The cat is old' is not understood")


def test_goal_that_nobody_serves_is_understood() -> None:
    shown = parts(reading_text(planned("Repair the door"), width=200))
    assert shown["Clauses"] == [
        "1. 'Repair the door': understood as a goal (repair) that no method and no routine serves"
    ]
    assert "Who and what is meant" not in shown  # the tree has no routine


def test_mission_without_words_is_shown_as_such() -> None:
    assert next(iter(parts(reading_text(planned("  "))))) == "Reading: (no words)"


def test_no_line_is_wider_than_asked_or_ends_in_blanks() -> None:
    lines = reading_text(planned("Find the cat and bring it to Anna"), width=40).splitlines()
    assert max(map(len, lines)) <= 40
    assert all(line == line.rstrip() for line in lines)


def test_words_of_a_user_are_words_and_nothing_else() -> None:
    text = reading_text(planned("Find the [red]cat[/red]"), width=300)
    assert "Reading: Find the [red]cat[/red]" in text  # shown as written, not obeyed
