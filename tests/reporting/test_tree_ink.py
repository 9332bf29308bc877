"""How lines look: links are told apart without colour, and heads meet their boxes."""

from __future__ import annotations

from itertools import combinations
from xml.etree import ElementTree

import pytest

from missiontree.mission.tree import LINK_KINDS, LinkKind
from missiontree.reporting.palette import INK, MUTED, QUIET, RED
from missiontree.reporting.tree.ink import (
    EDGE_WIDTH,
    LINK_STYLES,
    LINK_WIDTH,
    NODE_WIDTH,
    box_colours,
    line_colour,
    link_line,
    rounded,
    towards,
    words_colour,
)
from missiontree.reporting.tree.routes import LINK_WORDS


def test_links_differ_in_pattern_in_ends_and_in_words() -> None:
    for one, other in combinations(LINK_KINDS, 2):
        assert LINK_STYLES[one].dashes != LINK_STYLES[other].dashes
        assert (LINK_STYLES[one].start, LINK_STYLES[one].end) != (LINK_STYLES[other].start, LINK_STYLES[other].end)
        assert LINK_WORDS[one] != LINK_WORDS[other]


def test_directed_links_have_one_marked_end_and_mutual_ones_two_alike() -> None:
    assert LINK_STYLES["precedence"].start == LINK_STYLES["until"].start == ""
    for style in (LINK_STYLES["same_robot"], LINK_STYLES["different_robot"]):
        assert style.start == style.end != ""


def test_lit_is_thicker_and_quiet_is_thinner_than_plain() -> None:
    for widths in (EDGE_WIDTH, NODE_WIDTH, LINK_WIDTH):
        assert widths["quiet"] < widths["plain"] < widths["lit"]


def test_quiet_things_are_grey_and_their_words_still_readable() -> None:
    assert (line_colour("quiet", RED), line_colour("lit", RED), line_colour("plain")) == (QUIET, RED, INK)
    assert (words_colour("quiet"), words_colour("lit")) == (MUTED, INK)
    assert box_colours("routine", "quiet")[1] == QUIET
    assert box_colours("routine", "lit")[1] == RED
    assert box_colours("task", "plain")[1] == INK


@pytest.mark.parametrize("kind", LINK_KINDS)
def test_a_link_ends_where_its_last_point_is(kind: LinkKind) -> None:
    """Heads point at it, with or without a bar before it; dots and rings lie round it."""
    points = ((0.0, 0.0), (0.0, 40.0), (100.0, 40.0))
    line, *ends = (ElementTree.fromstring(part) for part in link_line(kind, points, "plain"))  # noqa: S314 - our own
    last = ends[-1]
    if last.tag == "circle":
        assert (last.get("cx"), last.get("cy")) == ("100", "40")
        assert line.get("d", "").endswith("L100 40")
    elif kind in {"precedence", "hand_over"}:
        assert last.get("d") == "M91 44.5 L100 40 L91 35.5 Z"  # nine long, nine wide
        assert line.get("d", "").endswith("L92 40")  # hidden under the head
    else:
        assert (
            last.get("d") == "M88 44.5 L97 40 L88 35.5 Z M97 44.5 L97 35.5"
        )  # three before the box, so that its bar shows


def test_corners_are_rounded_by_no_more_than_half_of_what_they_join() -> None:
    assert rounded([(0, 0), (10, 0), (10, 4)]) == "M0 0 L5 0 Q10 0 10 2 L10 4"
    assert rounded([(0, 0), (100, 0), (100, 100)]) == "M0 0 L94 0 Q100 0 100 6 L100 100"


def test_going_nowhere_stays_where_it_is() -> None:
    assert towards((3, 4), (3, 4), 10) == (3, 4)
    assert towards((0, 0), (3, 4), 10) == (6, 8)
