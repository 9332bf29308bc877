"""Outlines and pictures of trees, as the doors ask for them."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree import plan
from missiontree.errors import InputError
from missiontree.mission.alternative import selected_nodes
from missiontree.mission.plan import Plan
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.reporting.escape import one_line
from missiontree.reporting.palette import BLUE, RED
from missiontree.reporting.tree.view import tree_svg, tree_text
from missiontree.routines.ground import ground
from missiontree.samples.catalogue import sample_file
from tests.builders import brief_of, reunite_tree
from tests.reporting.tree_builders import SVG, classes, group, parsed, words


@pytest.fixture(scope="module")
def reunite() -> Plan:
    return plan(sample_file("reunite"))


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


def test_the_outline_of_an_alternative_says_who_does_what(reunite: Plan) -> None:
    assert reunite.tree is not None
    assert reunite.grounding is not None
    lines = tree_text(reunite.tree, plan=reunite, rank=1).splitlines()
    assert any(line.startswith("│   └── Search(Child): Tele-Robot") for line in lines)
    grounded = tree_text(reunite.grounding.tree, plan=reunite, rank=1)
    assert reunite.ranking is not None
    selected = set(selected_nodes(reunite.grounding.tree, reunite.ranking.alternatives[0].choices))
    assert grounded.count("(not chosen)") == len(reunite.grounding.tree.nodes) - len(selected)


def test_the_papers_first_mission_as_a_picture() -> None:
    root = parsed(tree_svg(reunite_tree()))
    kinds = [next(child.tag for child in node if "mt-box" in classes(child)) for node in group(root, "mt-nodes")]
    # three tasks are round, two routines are boxes
    assert sorted(kinds) == [f"{SVG}ellipse"] * 3 + [f"{SVG}rect"] * 2
    [link] = group(root, "mt-links")
    assert [part.get("stroke") or part.get("fill") for part in link] == [BLUE, BLUE]
    # only the root has more than one child, so only one gate is marked
    assert [mark.text for mark in group(root, "mt-marks") if mark.tag == f"{SVG}text"] == ["AND"]
    assert not any(edge.get("stroke-dasharray") for edge in group(root, "mt-edges"))


def test_the_grounded_picture_has_frames_dashed_choices_and_actions() -> None:
    tree = reunite_tree()
    grounded = ground(tree, brief_of(tree)).tree
    root = parsed(tree_svg(grounded))
    frames = group(root, "mt-frames")
    assert len(frames) == 2  # Search and ReachAndTransport
    assert {frame.get("stroke") for frame in frames} == {RED}
    dashed = [edge for edge in group(root, "mt-edges") if edge.get("stroke-dasharray")]
    options = sum(len(grounded.children[i]) for i, node in enumerate(grounded.nodes) if node.kind == "xor")
    assert len(dashed) == options == 4
    boxes = [node for node in group(root, "mt-nodes") if "mt-action" in classes(node)]
    assert len(boxes) == sum(node.kind == "action" for node in grounded.nodes)


def test_with_a_rank_the_mission_tree_shows_the_robots_of_that_alternative(reunite: Plan) -> None:
    assert reunite.tree is not None
    drawn = {rank: words(parsed(tree_svg(reunite.tree, plan=reunite, rank=rank))) for rank in (1, 2)}
    assert "Transportation Robot" in drawn[1]
    assert "Social Robot" in drawn[2]
    assert "alternative 2 of 4" in drawn[2]


def test_unfolded_is_the_grounded_tree_with_the_same_alternative_lit(reunite: Plan) -> None:
    assert reunite.tree is not None
    assert reunite.grounding is not None
    unfolded = tree_svg(reunite.tree, plan=reunite, rank=1, unfolded=True)
    assert unfolded == tree_svg(reunite.grounding.tree, plan=reunite, rank=1)
    assert unfolded == tree_svg(reunite.grounding.tree, plan=reunite, rank=1, unfolded=True)
    assert "Detect Child" in words(parsed(unfolded))
    assert len(group(parsed(unfolded), "mt-frames")) == 2


def test_no_more_nodes_are_drawn_than_asked_for(reunite: Plan) -> None:
    assert reunite.tree is not None
    root = parsed(tree_svg(reunite.tree, plan=reunite, rank=1, unfolded=True, most=12))
    assert len(group(root, "mt-nodes")) <= 12


def test_what_is_asked_for_in_vain_is_refused(reunite: Plan) -> None:
    tree = reunite.tree
    assert tree is not None
    with pytest.raises(InputError, match="together with a plan"):
        tree_svg(tree, rank=1)
    with pytest.raises(InputError, match="1 to 4"):
        tree_svg(tree, plan=reunite, rank=9)
    with pytest.raises(InputError, match="no grounded tree"):
        tree_svg(tree, unfolded=True)
    with pytest.raises(InputError, match="no grounded tree"):
        tree_svg(tree, plan=replace(reunite, grounding=None, ranking=None, schedules=()), unfolded=True)
    with pytest.raises(InputError, match="not the plan's"):
        tree_svg(named("another"), plan=reunite)
    with pytest.raises(InputError, match="1 or more"):
        tree_svg(tree, most=0)


def test_an_equal_tree_is_the_plans_tree(reunite: Plan) -> None:
    assert reunite.tree is not None
    copy = replace(reunite.tree)
    assert copy is not reunite.tree
    assert tree_svg(copy, plan=reunite) == tree_svg(reunite.tree, plan=reunite)


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
        SVG + tag for tag in ("svg", "title", "desc", "path", "rect", "ellipse", "circle", "g", "text")
    }
    assert "<script>alert('&')</script>" in "".join(words(root))
    assert tree_text(named("a\nb\x1b[2Jc")).startswith("a bc [AND]\n")


@given(st.text(st.characters(exclude_categories=()), max_size=60))
def test_any_name_gives_a_picture_and_an_outline_of_as_many_lines(label: str) -> None:
    tree = named(label)
    root = parsed(tree_svg(tree))
    assert root.findtext(f"{SVG}title") == (one_line(label))
    assert len(tree_text(tree).split("\n")) == 3 + 1 + 1  # nodes, a link, the end


def test_large_trees_need_no_recursion() -> None:
    depth = 3000
    nodes = [MissionNode(id=f"n{i}", label="x", gate="and", children=(f"n{i + 1}",)) for i in range(depth)]
    tree = MissionTree(objective="x", nodes=(*nodes, MissionNode(id=f"n{depth}", label="x")))
    assert tree_text(tree).count("\n") == depth + 1
    assert tree_svg(tree, most=10_000).count('class="mt-box"') == depth + 1
    assert tree_svg(tree).count('class="mt-box"') == 500
