from hypothesis import given
from hypothesis import strategies as st

from missiontree.authoring.edits import depth_of, with_children, with_links, without
from missiontree.mission.tree import Gate, Link, MissionNode, MissionTree
from tests.builders import reunite_tree

BARE = MissionTree(objective="x", nodes=(MissionNode(id="n0", label="x"),))


def test_children_go_behind_those_that_the_parent_has() -> None:
    tree = with_children(reunite_tree(), "locate", [MissionNode(id="ask", label="Ask")], "and")
    assert [node.id for node in tree.nodes] == ["root", "locate", "search", "ask", "reunite", "transport"]
    assert tree.by_id["locate"].children == ("search", "ask")


def test_a_single_child_reads_and() -> None:
    one = with_children(BARE, "n0", [MissionNode(id="a", label="a")], "xor")
    assert one.root.gate == "and"
    assert with_children(one, "n0", [MissionNode(id="b", label="b")], "xor").root.gate == "xor"


def test_links_into_what_is_removed_fall_with_it() -> None:
    tree = with_links(reunite_tree(), [Link("search", "transport"), Link("search", "reunite", "same_robot")])
    smaller, dropped = without(tree, "reunite")
    assert [node.id for node in smaller.nodes] == ["root", "locate", "search"]
    assert len(dropped) == 3  # the tree's own and the two added all end at or below reunite
    assert smaller.links == ()


def test_the_root_stands_on_level_one() -> None:
    assert [depth_of(reunite_tree(), node) for node in ("root", "locate", "search")] == [1, 2, 3]


@given(
    st.lists(st.tuples(st.integers(0, 10**6), st.integers(1, 3), st.sampled_from(["and", "xor"])), max_size=8),
    st.integers(0, 10**6),
)
def test_what_is_added_and_taken_away_leaves_what_was(additions: list[tuple[int, int, Gate]], place: int) -> None:
    """Each change gives a tree that is well-formed by birth; taking new children away again gives the tree before."""
    tree = BARE
    for where, count, wish in additions:
        parent = tree.nodes[where % len(tree.nodes)]
        gate = parent.gate if parent.gate is not None and len(parent.children) > 1 else wish
        new = [MissionNode(id=f"n{len(tree.nodes) + number}", label="t") for number in range(count)]
        tree = with_children(tree, parent.id, new, gate)
    parent = tree.nodes[place % len(tree.nodes)]
    grown = with_children(tree, parent.id, [MissionNode(id="extra", label="t")], parent.gate or "and")
    assert without(grown, "extra") == (tree, ())
