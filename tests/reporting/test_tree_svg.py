"""The picture of a tree, taken apart again."""

from __future__ import annotations

import pytest
from hypothesis import given, settings

from missiontree.mission.tree import LINK_KINDS, LinkKind
from missiontree.reporting.palette import BLUE, PAPER, QUIET, RED, livery
from missiontree.reporting.tree.ink import LINK_STYLES, XOR_DASHES
from missiontree.reporting.tree.routes import LINK_WORDS
from missiontree.reporting.tree.shape import Badge, Shape
from missiontree.reporting.tree.svg import svg_of
from tests.reporting.shapes import shapes
from tests.reporting.tree_builders import SVG, classes, extents, group, parsed, routine, shape, step, task, words
from tests.reporting.tree_geometry import Box


@given(shapes(60, links=16))
@settings(max_examples=60)
def test_nothing_leaves_the_page(drawn: Shape) -> None:
    root = parsed(svg_of(drawn))
    left, top, width, height = (float(number) for number in root.get("viewBox", "").split())
    assert (left, top) == (0, 0)
    assert (f"{width:g}", f"{height:g}") == (root.get("width"), root.get("height"))
    for element, box in extents(root):
        assert Box(0, 0, width, height).holds(box), element.attrib


@given(shapes(60, links=16))
@settings(max_examples=30)
def test_the_same_tree_gives_the_same_bytes(drawn: Shape) -> None:
    assert svg_of(drawn) == svg_of(drawn)


@given(shapes(40))
@settings(max_examples=60)
def test_words_stay_within_their_boxes(drawn: Shape) -> None:
    root = parsed(svg_of(drawn))
    for node in group(root, "mt-nodes"):
        outline = next(child for child in node if "mt-box" in classes(child))
        [(_, whole)] = list(extents(outline))
        for element, box in extents(node, anchor="middle"):
            if element.tag == f"{SVG}text":
                assert whole.holds(box)


@given(shapes(40))
@settings(max_examples=40)
def test_every_node_is_a_box_with_everything_it_says_as_its_title(drawn: Shape) -> None:
    nodes = group(parsed(svg_of(drawn)), "mt-nodes")
    assert len(nodes) == len(drawn.nodes)
    for element, node in zip(nodes, drawn.nodes, strict=True):
        title = element.findtext(f"{SVG}title") or ""
        assert title.startswith(node.label)
        assert all(badge.text in title for badge in node.team)
        assert node.note in title


def test_tasks_are_round_and_routines_and_actions_are_red_boxes() -> None:
    root = parsed(svg_of(shape(task("all", routine("Search(x)"), task("one", step("Go"), step("Look"))))))
    outlines = [next(part for part in node if "mt-box" in classes(part)) for node in group(root, "mt-nodes")]
    assert [outline.tag.removeprefix(SVG) for outline in outlines] == ["ellipse", "rect", "ellipse", "rect", "rect"]
    assert [outline.get("stroke") == RED for outline in outlines] == [False, True, False, True, True]


def test_gates_have_a_word_and_an_arc_and_choices_are_dashed() -> None:
    root = parsed(svg_of(shape(task("a", task("b", routine("c"), routine("d"), gate="xor"), routine("e")))))
    marks = group(root, "mt-marks")
    assert [mark.text for mark in marks if mark.tag == f"{SVG}text"] == ["AND", "XOR"]
    assert [sorted(classes(mark)) for mark in marks if "mt-arc" in classes(mark)] == [
        ["mt-and", "mt-arc"],
        ["mt-arc", "mt-xor"],
    ]
    dashed = [edge for edge in group(root, "mt-edges") if edge.get("stroke-dasharray")]
    assert [(sorted(classes(edge)), edge.get("stroke-dasharray")) for edge in dashed] == [
        (["mt-edge", "mt-plain", "mt-xor"], XOR_DASHES)
    ] * 2


def test_and_over_one_part_is_not_written_but_a_choice_of_one_is() -> None:
    root = parsed(svg_of(shape(task("a", task("b", routine("c"), gate="xor")))))
    assert [mark.text for mark in group(root, "mt-marks") if mark.tag == f"{SVG}text"] == ["XOR"]
    assert not [mark for mark in group(root, "mt-marks") if "mt-arc" in classes(mark)]


def test_what_one_robot_does_stands_in_a_column_with_arrows_between() -> None:
    tree = shape(task("go", step("one"), step("two"), step("three")))
    root = parsed(svg_of(tree))
    texts = {text.text: (float(text.get("x", 0)), float(text.get("y", 0))) for text in root.iter(f"{SVG}text")}
    assert texts["one"][0] == texts["two"][0] == texts["three"][0]
    assert texts["one"][1] < texts["two"][1] < texts["three"][1]
    orders = [link for link in group(root, "mt-links") if "mt-order" in classes(link)]
    assert [[part.get("stroke") or part.get("fill") for part in order] for order in orders] == [[BLUE, BLUE]] * 2
    # one edge leads to the first action, the arrows lead on
    assert len([edge for edge in group(root, "mt-edges") if "mt-and" in classes(edge)]) == 1
    assert "ends before the other starts" in words(root)


@pytest.mark.parametrize("kind", LINK_KINDS)
def test_links_of_every_kind_are_drawn_with_their_own_pattern_ends_and_word(kind: LinkKind) -> None:
    root = parsed(svg_of(shape(task("all", *(routine(name) for name in "abc")), [("a", "c", kind)])))
    [link] = group(root, "mt-links")
    line = link.find(f"{SVG}path")
    assert line is not None
    style = LINK_STYLES[kind]
    assert line.get("stroke-dasharray", "") == style.dashes
    ends = [sign.removeprefix("mt-") for part in list(link)[1:] for sign in classes(part)]
    assert ends == [sign for sign in (style.start, style.end) if sign]
    said = {word.text or "" for word in group(root, "mt-words") if word.tag == f"{SVG}text"}
    assert said == {LINK_WORDS[kind]} - {""}
    assert style.meaning in words(root)


def test_what_is_chosen_is_thick_marked_and_ticked_and_the_rest_is_thin_and_grey() -> None:
    tree = shape(
        task(
            "all",
            routine("this", state="lit"),
            routine("that", state="quiet"),
            gate="xor",
            state="lit",
        )
    )
    root = parsed(svg_of(tree, rank=2, ranks=3))
    boxes = {
        (node.findtext(f"{SVG}title") or "").split(";")[0]: next(part for part in node if "mt-box" in classes(part))
        for node in group(root, "mt-nodes")
    }
    assert float(boxes["this"].get("stroke-width", 0)) > 2 * float(boxes["that"].get("stroke-width", 0))
    assert boxes["that"].get("stroke") == QUIET
    lit = [edge for edge in group(root, "mt-edges") if classes(edge) >= {"mt-lit", "mt-xor"}]
    quiet = [edge for edge in group(root, "mt-edges") if "mt-quiet" in classes(edge)]
    assert len(lit) == len(quiet) == 1
    assert float(lit[0].get("stroke-width", 0)) > 2 * float(quiet[0].get("stroke-width", 0))
    assert len(group(root, "mt-glows")) == 2  # the stem and the chosen edge
    assert [mark.tag for mark in group(root, "mt-marks") if "mt-tick" in classes(mark)] == [
        f"{SVG}circle",
        f"{SVG}path",
    ]
    assert "alternative 2 of 3" in words(root)
    assert "not chosen" in words(root)


def test_links_of_what_is_not_chosen_are_quiet_too() -> None:
    tree = shape(
        task("all", *(routine(name, state=state) for name, state in (("a", "lit"), ("b", "quiet"))), state="lit"),
        [("a", "b", "until")],
    )
    [link] = group(parsed(svg_of(tree)), "mt-links")
    assert "mt-quiet" in classes(link)
    assert {part.get("stroke") for part in link} == {QUIET}


def test_a_folded_subtree_is_a_pile_that_says_how_much_it_holds() -> None:
    parts = [task(f"task {number}", *(routine(f"r{number}{letter}") for letter in "abcdefghij")) for number in range(3)]
    root = parsed(svg_of(shape(task("all", *parts)), most=10))
    nodes = group(root, "mt-nodes")
    assert len(nodes) == 4
    assert [sum("mt-pile" in classes(part) for part in node) for node in nodes] == [0, 2, 2, 2]
    assert words(root).count("… 10 nodes") == 3
    assert any(line.startswith("30 of 34 nodes are folded") for line in words(root))
    assert "30 of 34 nodes are folded" in (root.findtext(f"{SVG}desc") or "")


def test_badges_of_many_robots_are_hatched_and_the_patterns_stand_in_the_picture() -> None:
    """The hues repeat from the eleventh robot on, with a pattern over them."""
    parts = [routine(f"r{place}", team=(Badge(f"Robot {place}", livery(place)),)) for place in (0, 10, 20)]
    root = parsed(svg_of(shape(task("all", *parts)), prefix="own"))
    swatches = [part for node in group(root, "mt-nodes") for part in node if "mt-swatch" in classes(part)]
    patterns = {f"url(#{pattern.get('id')})" for pattern in root.iter(f"{SVG}pattern")}
    assert [swatch.get("fill") in patterns for swatch in swatches] == [False, True, True]
    assert len({swatch.get("fill") for swatch in swatches}) == 3
    assert all((pattern.get("id") or "").startswith("own-") for pattern in root.iter(f"{SVG}pattern"))


def test_quiet_badges_keep_the_robots_swatch_but_not_its_tint() -> None:
    badge = (Badge("Robot", livery(0)),)
    root = parsed(
        svg_of(shape(task("all", routine("a", team=badge, state="lit"), routine("b", team=badge, state="quiet"))))
    )
    lit, quiet = [next(part for part in node if "mt-tag" in classes(part)) for node in group(root, "mt-nodes")[1:]]
    assert (lit.get("fill"), quiet.get("fill")) == (livery(0).hue.tint, PAPER)
    assert sum("mt-swatch" in classes(part) for node in group(root, "mt-nodes") for part in node) == 2


def test_long_words_are_broken_and_what_is_cut_ends_in_an_ellipsis_and_stands_in_the_title() -> None:
    long = "Pneumonoultramicroscopicsilicovolcanoconiosis" * 2
    endless = " ".join(f"word{number}" for number in range(400))
    root = parsed(svg_of(shape(task("all", routine(long), routine(endless)))))
    lines = words(root)
    assert long not in lines
    assert long in "".join(lines)
    assert any(line.endswith("…") for line in lines)
    titles = [node.findtext(f"{SVG}title") for node in group(root, "mt-nodes")]
    assert titles[1:] == [long, endless]


def test_the_picture_has_a_name_and_a_description_for_those_who_cannot_see_it() -> None:
    root = parsed(svg_of(shape(task("Help", routine("a"), routine("b")), [("a", "b", "precedence")])))
    assert root.get("role") == "img"
    assert root.findtext(f"{SVG}title") == "Help"
    assert root.findtext(f"{SVG}desc") == "A mission tree: 1 task, 2 routines, 1 link of precedence."


def test_a_picture_stands_alone() -> None:
    tags = {
        element.tag.removeprefix(SVG) for element in parsed(svg_of(shape(task("a", routine("b"), routine("c"))))).iter()
    }
    assert tags <= {"svg", "title", "desc", "rect", "ellipse", "circle", "path", "g", "text"}
