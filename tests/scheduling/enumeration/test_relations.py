"""What comes first in any case, and who may be in whose way, read off small missions."""

from __future__ import annotations

from missiontree.scheduling.enumeration.relations import Relations
from missiontree.scheduling.precedence import task_graph
from tests.scheduling.instances import Instance, Part, mission, move, work


def relations_of(made: Instance) -> Relations:
    return Relations(task_graph(made.tree, made.alternative.choices))


def test_what_starts_first_in_any_case_is_earlier() -> None:
    """Two actions of one role, the second role after the first, and a third role beside them: activities 0, 1 | 2 | 3."""
    made = mission(
        [Part("a", "x", [work(1), work(1)]), Part("b", "y", [work(1)]), Part("c", "z", [work(1)])], [("a", "b")]
    )
    assert relations_of(made).earlier == [set(), {0}, {0, 1}, set()]


def test_rivals_are_those_without_an_order_that_move_or_need_the_same() -> None:
    """a brings the box to q; b works at the box; c works at q; d brings another thing. Only a and b are in each other's way."""
    parts = [
        Part("a", "x", [move("q", "box")]),
        Part("b", "y", [work(1, at="box")]),
        Part("c", "z", [work(1, at="q")]),
        Part("d", "w", [move("q", "crate")]),
    ]
    assert relations_of(mission(parts)).rivals == [{1}, {0}, set(), set()]
    assert relations_of(mission(parts, [("a", "b")])).rivals == [set(), set(), set(), set()]


def test_two_that_bring_the_same_are_rivals() -> None:
    made = mission([Part("a", "x", [move("q", "box")]), Part("b", "y", [move("p", "box")])])
    assert relations_of(made).rivals == [{1}, {0}]
