"""Like parts of a tree about those of a list are one; all others stay as they are."""

from __future__ import annotations

from missiontree.authoring.learning.merging import Merged
from missiontree.mission.tree import Gate, MissionNode, MissionTree


def task(name: str, gate: Gate, *children: str) -> MissionNode:
    return MissionNode(id=name, label=name, gate=gate, children=children)


def search(name: str, who: str) -> MissionNode:
    return MissionNode(id=name, label=name, routine="Search", arguments={"agent": who})


def merged(*nodes: MissionNode, listed: frozenset[str] = frozenset({"cat", "dog"})) -> Merged:
    tree = MissionTree(objective="all", nodes=nodes)
    return Merged(tree, lambda node: node.routine or node.gate, listed)


def test_what_is_below_like_tasks_is_put_together() -> None:
    made = merged(
        task("all", "and", "one", "two", "c"),
        task("one", "and", "a"),
        search("a", "cat"),
        task("two", "and", "b"),
        search("b", "dog"),
        search("c", "hen"),  # in no list
    )
    assert made.children["all"] == ("one", "c")
    assert made.children["one"] == ("a",)
    assert (made.stands_for["two"], made.stands_for["b"], made.stands_for["c"]) == ("one", "a", "c")


def test_options_of_a_choice_stay_apart() -> None:
    made = merged(task("all", "xor", "a", "b"), search("a", "cat"), search("b", "dog"))
    assert made.children["all"] == ("a", "b")
