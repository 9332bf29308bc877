"""What is said of a picture to those who cannot see it."""

from __future__ import annotations

from dataclasses import replace

from missiontree.reporting.palette import livery
from missiontree.reporting.tree.folding import folded
from missiontree.reporting.tree.shape import Badge, ShapeNode
from missiontree.reporting.tree.words import MOST_TOLD, description, folding_words, title_of
from tests.reporting.tree_builders import routine, shape, step, task

ROBOT = (Badge("Tele-Robot · 1", livery(0)),)


def test_a_title_says_everything_about_a_box() -> None:
    node = ShapeNode("n", "Find the cat", "Search(cat)", "task", "xor", team=ROBOT, state="lit", hidden=1200)
    assert title_of(node) == (
        "Find the cat; Search(cat); exactly one of its parts; by Tele-Robot · 1; 1,200 nodes folded; chosen"
    )
    assert title_of(ShapeNode("n", "x", "", "task", "and", state="quiet")) == "x; all of its parts; not chosen"
    assert title_of(ShapeNode("n", "x", "", "routine", None)) == "x"


def test_a_description_counts_what_there_is() -> None:
    tree = shape(
        task("a", task("b", step("c"), step("d")), routine("e"), routine("f", kind="impossible")),
        [("b", "e", "precedence"), ("e", "f", "precedence"), ("c", "e", "until")],
    )
    assert description(tree, tree, None, 0) == (
        "A mission tree: 2 tasks, 1 routine, 2 actions, 1 task that nobody can do, 2 links of precedence, 1 link of until."
    )


def test_a_description_tells_who_does_what_in_the_alternative_that_is_lit() -> None:
    parts = [routine(f"r{number}", state="lit", team=ROBOT) for number in range(MOST_TOLD + 2)]
    tree = shape(task("a", *parts, routine("idle", state="quiet", team=ROBOT), state="lit"))
    told = description(tree, tree, 2, 3)
    assert "Alternative 2 of 3 is lit. Who does what: r0 by Tele-Robot · 1; r1 by Tele-Robot · 1;" in told
    assert told.endswith(f"r{MOST_TOLD - 1} by Tele-Robot · 1, and 2 more.")
    assert "idle" not in told


def test_folding_is_told_with_the_links_that_are_left_out() -> None:
    parts = [task(f"t{number}", *(routine(f"r{number}{leaf}") for leaf in range(9))) for number in range(2)]
    whole = shape(task("a", *parts), [("r00", "r01", "precedence")])
    small = folded(whole, 5)
    assert folding_words(small, whole).startswith("18 of 21 nodes are folded, and 1 link with them")
    assert "18 of 21 nodes are folded" in description(small, whole, None, 0)
    assert folding_words(whole, whole) == ""
    unlinked = replace(whole, links=())
    assert folding_words(folded(unlinked, 5), unlinked).startswith("18 of 21 nodes are folded: ")
