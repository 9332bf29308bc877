"""Outlines and pictures of trees."""

from xml.etree import ElementTree

from hypothesis import given
from hypothesis import strategies as st

from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.reporting.escape import one_line
from missiontree.reporting.tree_shape import Shape
from missiontree.reporting.tree_svg import BLUE, RED, svg_of
from missiontree.reporting.tree_view import tree_svg, tree_text
from missiontree.routines.ground import ground
from tests.builders import brief_of, reunite_tree
from tests.reporting.shapes import shapes

SVG = "{http://www.w3.org/2000/svg}"


def parsed(svg: str) -> ElementTree.Element:
    return ElementTree.fromstring(svg)  # noqa: S314 - it is our own


def group(root: ElementTree.Element, name: str) -> list[ElementTree.Element]:
    """Content of a group of the picture; empty if it has none such."""
    return [child for g in root.findall(f"{SVG}g") if g.get("class") == name for child in g]


def words(root: ElementTree.Element) -> str:
    return " ".join(text.text or "" for text in root.iter(f"{SVG}text"))


def test_the_papers_first_mission_as_an_outline() -> None:
    assert tree_text(reunite_tree()) == (
        "Reunite mom with her lost child [AND]\n"
        "├── Locate the Lost Child [AND]\n"
        "│   └── Search(Child)\n"
        "└── Reunite the Child with Mom [AND]\n"
        "    └── ReachAndTransport(Child, Mom)\n"
        '"Locate the Lost Child" ends before "Reunite the Child with Mom" starts\n'
    )


def test_the_grounded_tree_as_an_outline() -> None:
    tree = reunite_tree()
    lines = tree_text(ground(tree, brief_of(tree)).tree).splitlines()
    assert "│   └── Search(Child) [XOR]" in lines
    assert "│       ├── search by Tele-Robot [AND]" in lines
    assert "│       │   └── Report detection of Child to server" in lines


def test_the_papers_first_mission_as_a_picture() -> None:
    root = parsed(tree_svg(reunite_tree()))
    kinds = [next(child.tag for child in node if child.tag != f"{SVG}title") for node in group(root, "nodes")]
    # three tasks are round, two routines are boxes
    assert sorted(kinds) == [f"{SVG}ellipse"] * 3 + [f"{SVG}rect"] * 2
    links = group(root, "links")
    assert [link.get("stroke") for link in links] == [BLUE]
    assert (links[0].get("marker-end") or "").startswith("url(#")
    # only the root has more than one child, so only one gate is marked
    assert [mark.text for mark in group(root, "marks") if mark.tag == f"{SVG}text"] == ["AND"]
    assert not any(edge.get("stroke-dasharray") for edge in group(root, "edges"))


def test_the_grounded_picture_has_frames_dashed_choices_and_actions() -> None:
    tree = reunite_tree()
    grounded = ground(tree, brief_of(tree)).tree
    root = parsed(tree_svg(grounded))
    assert len(group(root, "frames")) == 2  # Search and ReachAndTransport
    dashed = [edge for edge in group(root, "edges") if edge.get("stroke-dasharray")]
    options = sum(len(grounded.children[i]) for i, node in enumerate(grounded.nodes) if node.kind == "xor")
    assert len(dashed) == options == 4
    boxes = [node for node in group(root, "nodes") if node.find(f"{SVG}rect") is not None]
    actions = [node for node in grounded.nodes if node.kind == "action"]
    assert len(boxes) == len(actions)
    assert {rect.get("stroke") for box in boxes for rect in box.findall(f"{SVG}rect")} == {RED}


def named(label: str) -> MissionTree:
    return MissionTree(
        objective=label,
        nodes=(
            MissionNode(id="root", label=label, gate="and", children=("a", "b")),
            MissionNode(id="a", label=label),
            MissionNode(id="b", label="B"),
        ),
        links=(Link("a", "b", "until"),),
    )


def test_names_are_never_markup_or_control() -> None:
    svg = tree_svg(named("<script>\x1b[31malert('&')</script>\u202e"))
    assert "<script" not in svg
    root = parsed(svg)
    assert {element.tag for element in root.iter()} <= {
        SVG + tag for tag in ("svg", "title", "defs", "marker", "path", "rect", "ellipse", "g", "text")
    }
    assert "<script>alert('&')</ script>" in words(root) or "<script>alert('&')</script>" in words(root)
    assert tree_text(named("a\nb\x1b[2Jc")).startswith("a bc [AND]\n")


@given(st.text(st.characters(exclude_categories=()), max_size=60))
def test_any_name_gives_a_picture_and_an_outline_of_as_many_lines(label: str) -> None:
    tree = named(label)
    root = parsed(tree_svg(tree))
    assert root.findtext(f"{SVG}title") == (one_line(label))
    assert len(tree_text(tree).split("\n")) == 3 + 1 + 1  # nodes, a link, the end


@given(shapes())
def test_pictures_are_the_same_every_time_and_nothing_leaves_the_page(shape: Shape) -> None:
    svg = svg_of(shape)
    assert svg == svg_of(shape)
    root = parsed(svg)
    width, height = (float(root.get(side, "")) for side in ("width", "height"))
    for path in (*group(root, "links"), *group(root, "edges")):
        numbers = [float(part.lstrip("MLQ")) for part in (path.get("d") or "").split()]
        assert all(0 <= x <= width for x in numbers[::2])
        assert all(0 <= y <= height for y in numbers[1::2])
    for rect in group(root, "frames"):
        x, y, wide, high = (float(rect.get(name, "")) for name in ("x", "y", "width", "height"))
        assert x >= 0
        assert y >= 0
        assert x + wide <= width
        assert y + high <= height


def test_large_trees_need_no_recursion() -> None:
    depth = 3000
    nodes = [MissionNode(id=f"n{i}", label="x", gate="and", children=(f"n{i + 1}",)) for i in range(depth)]
    tree = MissionTree(objective="x", nodes=(*nodes, MissionNode(id=f"n{depth}", label="x")))
    assert tree_text(tree).count("\n") == depth + 1
    assert tree_svg(tree).count("<ellipse") == depth + 1
