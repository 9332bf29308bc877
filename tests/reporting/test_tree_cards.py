"""Boxes hold their words and their badges."""

from __future__ import annotations

import math
from collections.abc import Iterator

from hypothesis import given
from hypothesis import strategies as st

from missiontree.reporting.palette import livery
from missiontree.reporting.text_box import text_width
from missiontree.reporting.tree.cards import (
    LINE,
    MOST_TAGS,
    NOTE_LINE,
    NOTE_SIZE,
    SIZE,
    TAG_HEIGHT,
    TAG_LINE,
    TAG_ROOM,
    Card,
    card_of,
    note_of,
)
from missiontree.reporting.tree.shape import Badge, ShapeKind, ShapeNode

NAMES = ("", "Tele-Robot · 2", "A very long name of a robot type that nobody would ever want to read")


@given(
    st.text(alphabet="abmW (_母", max_size=400),
    st.sampled_from(("", "no routine yet", "Search(cat), only drone or cart")),
    st.sampled_from(("task", "routine", "action", "impossible", "more")),
    st.lists(st.sampled_from(NAMES), max_size=6),
    st.sampled_from((0, 1, 4800)),
)
def test_words_and_badges_stay_within_their_box(
    label: str, note: str, kind: ShapeKind, team: list[str], hidden: int
) -> None:
    badges = tuple(Badge(name, livery(place)) for place, name in enumerate(team))
    card = card_of(ShapeNode("n", " ".join(label.split()), note, kind, None, team=badges, hidden=hidden))
    for half, top, bottom in parts(card):
        assert -card.height / 2 <= top < bottom <= card.height / 2
        assert half <= min(card.breadth(top), card.breadth(bottom))


def parts(card: Card) -> Iterator[tuple[float, float, float]]:
    """Half of the width, upper edge and lower edge of what is written: letters fill most of a line's height, badges theirs."""
    top = -card.text_height / 2
    for line in card.lines:
        yield text_width(line, SIZE) / 2, top + 0.2 * LINE, top + 0.95 * LINE
        top += LINE
    for line in card.note:
        yield text_width(line, NOTE_SIZE) / 2, top + 0.2 * NOTE_LINE, top + 0.95 * NOTE_LINE
        top += NOTE_LINE
    for tag in card.tags:
        assert text_width(tag.text, NOTE_SIZE) < tag.width
        yield tag.width / 2, top + TAG_LINE - TAG_HEIGHT, top + TAG_LINE
        top += TAG_LINE


def test_an_ellipse_is_lower_and_narrower_at_its_sides() -> None:
    # a circle of radius 5: 3 aside, its edge is 4 away, and so the other way round; a rectangle's edge is where it is
    circle, square = Card((), (), 10, 10, round=True), Card((), (), 10, 10, round=False)
    assert (circle.reach(3), circle.breadth(3)) == (4, 4)
    assert (square.reach(3), square.breadth(3)) == (5, 5)
    assert circle.reach(7) == 0


def test_no_word_of_a_task_is_broken_if_it_fits_into_a_line() -> None:
    card = card_of(ShapeNode("n", "SearchAndFollow(Monster)", "", "task", "and"))
    assert card.lines == ("SearchAndFollow(", "Monster)")


def test_lines_of_a_box_are_about_equally_long() -> None:
    def lines(label: str) -> tuple[str, ...]:
        return card_of(ShapeNode("n", label, "", "action", None)).lines

    assert lines("Get Woman location to reach") == ("Get Woman", "location to reach")
    assert lines("Search(loading dock 3)") == (
        "Search(loading dock 3)",
    )  # little more than a line: nothing is left alone


def test_ellipses_are_neither_towers_nor_needles() -> None:
    long = "Find the visitor and guide her to the gate, then bring the red crate to the workshop and inspect the crane."
    for label in (long, "Locate the Lost Child", "A"):
        card = card_of(ShapeNode("n", label, "", "task", "and"))
        assert 1 < card.width / card.height < 4.5
    assert math.isclose(card_of(ShapeNode("n", "A", "", "task", "and")).width, 84)


def test_badges_that_are_too_many_are_counted_and_names_that_are_too_long_are_cut() -> None:
    badges = tuple(Badge(f"r{number}", livery(number)) for number in range(6))
    shown = [tag.text for tag in card_of(ShapeNode("n", "x", "", "routine", None, team=badges)).tags]
    assert shown == ["r0", "r1", "r2", "and 3 more"]
    assert len(shown) == MOST_TAGS
    [tag] = card_of(ShapeNode("n", "x", "", "routine", None, team=(Badge(NAMES[2], livery(0)),))).tags
    assert tag.text.endswith("…")
    assert text_width(tag.text, NOTE_SIZE) <= TAG_ROOM


def test_notes_say_how_much_is_folded() -> None:
    assert note_of(ShapeNode("n", "x", "", "task", None, hidden=1)) == "… 1 node"
    assert note_of(ShapeNode("n", "x", "Search(y)", "task", None, hidden=4800)) == "Search(y), … 4,800 nodes"
    assert note_of(ShapeNode("", "and 480 more", "", "more", None, hidden=900)) == "900 nodes"
    assert note_of(ShapeNode("n", "x", "", "task", None)) == ""
