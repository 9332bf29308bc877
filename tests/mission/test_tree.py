"""The mission tree is well-formed at birth or not at all."""

from __future__ import annotations

import pytest

from missiontree.mission.tree import Link, MissionNode, MissionTree

LEAF = MissionNode(id="leaf", label="Search(cat)", routine="Search", arguments={"agent": "cat"})
OPEN = MissionNode(id="open", label="Later")
ROOT = MissionNode(id="root", label="Root", gate="and", children=("leaf", "open"))


def test_open_leaves_are_tasks_without_children() -> None:
    tree = MissionTree(objective="x", nodes=(ROOT, LEAF, OPEN))
    assert [node.id for node in tree.open_leaves] == ["open"]
    assert list(tree.ancestors("leaf")) == ["root"]
    assert tree.contains("root", "leaf")
    assert not tree.contains("leaf", "root")


@pytest.mark.parametrize(
    ("nodes", "links", "words"),
    [
        ((), (), "at least its root"),
        ((ROOT, OPEN, LEAF), (), "in preorder"),
        ((ROOT, LEAF), (), "a child is listed that is not among the nodes"),
        ((ROOT, LEAF, OPEN, MissionNode(id="stray", label="Stray")), (), "in preorder"),
        ((ROOT, LEAF, LEAF), (), "node 'leaf' stands twice"),
        ((MissionNode(id="root", label="r", gate="and", children=("root",)),), (), "in preorder"),
        ((ROOT, LEAF, OPEN), (Link("leaf", "nowhere"),), "names 'nowhere'"),
        ((ROOT, LEAF, OPEN), (Link("root", "leaf"),), "one contains the other"),
        ((ROOT, LEAF, OPEN), (Link("leaf", "leaf"),), "one contains the other"),
    ],
)
def test_what_is_no_tree_is_refused(nodes: tuple[MissionNode, ...], links: tuple[Link, ...], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        MissionTree(objective="x", nodes=nodes, links=links)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"routine": "Search", "gate": "and", "children": ("a",)}, "routines have no children"),
        ({"arguments": {"agent": "cat"}}, "arguments and resources belong to routines"),
        ({"gate": "and"}, "a gate exactly if it has children"),
        ({"children": ("a",)}, "a gate exactly if it has children"),
    ],
)
def test_a_node_is_a_task_or_a_routine(fields: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        MissionNode(id="n", label="n", **fields)  # type: ignore[arg-type]
