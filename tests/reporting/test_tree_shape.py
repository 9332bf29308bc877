"""Trees in the form in which they are shown."""

from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, Role
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.reporting.tree.shape import NO_NAMES, Names, ShapeNode, link_words, shape_of


def authored(*links: Link) -> MissionTree:
    return MissionTree(
        objective="Help",
        nodes=(
            MissionNode(id="root", label="Help\nall", gate="xor", children=("open", "call", "named")),
            MissionNode(id="open", label="Search(cat)"),
            MissionNode(id="call", label="Search(cat)", routine="Search", arguments={"agent": "cat"}),
            MissionNode(
                id="named", label="Find it", routine="Search", arguments={"agent": "cat"}, resources=("drone", "cart")
            ),
        ),
        links=links,
    )


def action(role: int, sync: int | None = None) -> Action:
    estimate = Estimate(1)
    return Action(
        name="look", text="Look", role=role, robot_type="cart", capability="search", estimate=estimate, sync=sync
    )


def test_authored_nodes() -> None:
    shape = shape_of(authored())
    assert shape.nodes == (
        ShapeNode("root", "Help all", "", "task", "xor"),
        ShapeNode("open", "Search(cat)", "no routine yet", "task", None),
        ShapeNode("call", "Search(cat)", "", "routine", None),
        ShapeNode("named", "Find it", "Search(cat), only drone or cart", "routine", None),
    )
    assert shape.children == ((1, 2, 3), (), (), ())
    assert shape.frames == ()


def noted(
    label: str, agent: str, *entities: Entity, names: Names = NO_NAMES, resources: tuple[str, ...] | None = None
) -> str:
    node = MissionNode(id="leaf", label=label, routine="Search", arguments={"agent": agent}, resources=resources)
    root = MissionNode(id="root", label="Help", gate="and", children=("leaf",))
    return shape_of(MissionTree(objective="Help", nodes=(root, node), entities=entities), names).nodes[1].note


def test_label_hides_the_call_only_if_it_reads_as_that_call() -> None:
    assert noted("Search(Red crate)", "red_crate") == ""
    assert noted("Search(Cat)", "cat_2", Entity(id="cat_2", label="Cat")) == ""
    assert noted("Search(Otto)", "lobby") == "Search(lobby)"
    # Without the entity's own label at hand, what the scene calls it is no proof of who it is.
    assert noted("Search(Cat)", "cat_2") == "Search(cat_2)"
    assert noted("Search(Cat)", "cat_2", names=Names(entities={"cat_2": "Cat"})) == ""
    # What the tree itself introduces is what the tree is about.
    tom = Entity(id="cat_2", label="Tom")
    assert noted("Search(Cat)", "cat_2", tom, names=Names(entities={"cat_2": "Cat"})) == "Search(cat_2)"


def test_robot_types_are_called_as_people_call_them() -> None:
    names = Names(robot_types={"scout_mk2": "Scout\nMk II"})
    assert noted("Search(cat)", "cat", resources=("scout_mk2", "cart"), names=names) == "only Scout Mk II or cart"
    assert noted("Search(cat)", "cat", resources=()) == "only nobody"


def test_links_are_sentences_and_equal_labels_are_told_apart() -> None:
    links = (
        Link("open", "named"),
        Link("call", "named", "same_robot"),
        Link("call", "named", "different_robot"),
        Link("named", "call", "until"),
    )
    assert list(link_words(shape_of(authored(*links)))) == [
        '"Search(cat)" (open) ends before "Find it" starts',
        '"Search(cat)" (call) and "Find it" are done by one and the same robot',
        '"Search(cat)" (call) and "Find it" are done by different robots',
        '"Find it" lasts until "Search(cat)" (call) ends',
    ]


def test_grounded_nodes_and_the_frames_of_their_routines() -> None:
    tree = GroundedTree(
        objective="Help",
        nodes=(
            GroundedNode(parent=-1, kind="and", label="Help", source="root"),
            GroundedNode(parent=0, kind="xor", label="Search(cat)", source="search"),
            GroundedNode(parent=1, kind="and", label="search by Cart", source="search"),
            GroundedNode(parent=2, kind="action", label="Look", source="search", action=action(0, sync=1)),
            GroundedNode(parent=0, kind="xor", label="Reach(moon)", source="reach"),
        ),
        roles=(Role(label="Search(cat)", source="search"),),
        links=(GroundedLink(1, 4),),
    )
    shape = shape_of(tree)
    assert [node.kind for node in shape.nodes] == ["task", "task", "task", "action", "impossible"]
    assert [node.gate for node in shape.nodes] == ["and", "xor", "and", None, None]
    assert [node.role for node in shape.nodes] == [None, None, None, 0, None]
    assert shape.nodes[3].note == "joint work 2"
    assert shape.sizes == [5, 3, 2, 1, 1]
    assert shape.nodes[4].note == "nobody can do it"
    assert shape.frames == (1,)
    assert shape.links == ((1, 4, "precedence"),)


def test_foreign_trees_have_no_frames() -> None:
    tree = GroundedTree(
        objective="Help",
        nodes=(
            GroundedNode(parent=-1, kind="and", label="Help"),
            GroundedNode(parent=0, kind="action", label="Look", action=action(0)),
        ),
        roles=(Role(label="alone"),),
    )
    assert shape_of(tree).frames == ()
