"""When two trees are of one structure, and what is said when they are not."""

from __future__ import annotations

from typing import Any

import pytest

from missiontree.authoring.learning.likeness import difference
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, MissionNode, MissionTree

SCENE = Scene(entities=(Entity(id="anna", kind="person"), Entity(id="ben", kind="person")))


def search(name: str, who: str, **more: Any) -> MissionNode:
    return MissionNode(id=name, label=name.upper(), routine="Search", arguments={"agent": who}, **more)


def task(name: str, gate: Any, *children: str) -> MissionNode:
    return MissionNode(id=name, label=name.title(), gate=gate, children=children)


def tree(*nodes: MissionNode, links: tuple[Link, ...] = (), kinds: str = "animal") -> MissionTree:
    ids = {who for node in nodes for who in node.arguments.values()} - set(SCENE.by_id)
    return MissionTree(
        objective="All",
        nodes=nodes,
        links=links,
        entities=tuple(Entity(id=who, kind=kinds) for who in sorted(ids)),
    )


def pair(one: str = "cat", other: str = "dog", gate: str = "and", **more: Any) -> MissionTree:
    return tree(task("all", gate, "a", "b"), search("a", one), search("b", other), **more)


def test_labels_ids_and_tasks_of_one_part_do_not_matter() -> None:
    wrapped = tree(task("all", "and", "first", "y"), task("first", "and", "x"), search("x", "hen"), search("y", "pig"))
    assert difference(pair(), wrapped, SCENE) == ""
    before = pair(links=(Link("a", "b"),))
    wrapped = tree(*wrapped.nodes, links=(Link("first", "y"),))
    assert difference(before, wrapped, SCENE) == ""


def test_links_that_follow_from_others_do_not_matter() -> None:
    nodes = (task("all", "and", "a", "b", "c"), search("a", "cat"), search("b", "dog"), search("c", "hen"))
    chain = (Link("a", "b"), Link("b", "c"))
    assert difference(tree(*nodes, links=chain), tree(*nodes, links=(*chain, Link("a", "c"))), SCENE) == ""
    assert "'A' before 'B' is missing" in difference(tree(*nodes, links=chain), tree(*nodes, links=chain[1:]), SCENE)


def test_nothing_follows_by_way_of_what_may_not_be_done() -> None:
    """B may not be chosen: that A is before B and B before C then says nothing of A and C."""
    nodes = (
        task("all", "and", "a", "either", "c"),
        search("a", "cat"),
        task("either", "xor", "b", "d"),
        search("b", "dog"),
        search("d", "pig"),
        search("c", "hen"),
    )
    chain = (Link("a", "b"), Link("b", "c"))
    added = difference(tree(*nodes, links=chain), tree(*nodes, links=(*chain, Link("a", "c"))), SCENE)
    assert added == "the order 'A' before 'C' is added"
    # Of b and d only one is done, so an order between them orders nothing.
    assert difference(tree(*nodes), tree(*nodes, links=(Link("b", "d"),)), SCENE) == ""


@pytest.mark.parametrize(
    ("other", "words"),
    [
        (pair(gate="xor"), "'All' (xor) stands where 'All' (and) was"),
        (tree(task("all", "and", "a"), search("a", "cat")), "'A' stands where 'All' (and) was"),
        (tree(task("all", "and", "a", "b", "c"), *(search(n, n) for n in "abc")), "'All' has 3 parts ('A', 'B', 'C')"),
        (pair("cat", "cat"), "is not who 'B' is about"),
        (pair(kinds="person"), "is of another kind"),
        (pair("anna", "dog"), "'A' is about anna, 'A' about cat"),
        (tree(task("all", "and", "a", "b"), search("a", "cat", resources=("drone",)), search("b", "dog")), "or robots"),
        (pair(links=(Link("a", "b", "until"),)), "lasts until something else ends"),
    ],
)
def test_each_difference_is_told(other: MissionTree, words: str) -> None:
    assert words in difference(pair(), other, SCENE)


def test_who_is_of_the_scene_is_nobody_else() -> None:
    assert difference(pair("anna"), pair("anna"), SCENE) == ""
    assert difference(pair("anna"), pair("ben"), SCENE) == "'A' is about ben, 'A' about anna"
