"""The order of clauses as it was said."""

from __future__ import annotations

from typing import Any

from missiontree.authoring.composing.composition import Composition
from missiontree.authoring.composing.ordering import order_as_said
from missiontree.authoring.composing.units import Unit
from missiontree.authoring.reading.clause import Relation
from missiontree.authoring.reading.outcomes import Goal
from tests.authoring.composing.goals import LIBRARY, composition, do, goal, links

A, B, C, D = ("Search(a)", "Search(b)", "Search(c)", "Search(d)")


def said(relation: Relation, name: str, anchor: int | None = None, routine: str = "Search", **clause: Any) -> Goal:
    return goal(f"{routine} {name}", do(routine, name), relation=relation, anchor=anchor, **clause)


def ordered(*goals: Goal) -> Composition:
    tops = [goal.outline.pieces for goal in goals]
    made = composition(*(piece for pieces in tops for piece in pieces))
    units = [Unit(((index,),)) for index in range(len(goals))]
    order_as_said(goals, tops, units, LIBRARY, made)
    return made


def order(*goals: Goal) -> list[tuple[str, ...]]:
    made = ordered(*goals)
    assert made.doubts == []
    return links(made)


def test_and_says_no_order() -> None:
    assert order(said("start", "a"), said("and", "b", 0), said("start", "c")) == []


def test_then_is_said_of_all_that_and_joins() -> None:
    # a and b, then c and d: each of the first two before each of the others.
    assert order(said("start", "a"), said("and", "b", 0), said("then", "c", 1), said("and", "d", 2)) == [
        (A, C),
        (B, C),
        (A, D),
        (B, D),
    ]


def test_then_is_said_of_the_step_before_and_not_of_all_steps() -> None:
    assert order(said("start", "a"), said("then", "b", 0), said("then", "c", 1)) == [(A, B), (B, C)]


def test_new_sentence_has_nothing_before_it() -> None:
    assert order(said("start", "a"), said("then", "b", 0), said("start", "c"), said("and", "d", 2)) == [(A, B)]


def test_before_and_after_are_said_of_the_clause_they_are_joined_to() -> None:
    """Do a before b; do a after b."""
    assert order(said("start", "a"), said("before", "b", 0)) == [(A, B)]
    assert order(said("start", "a"), said("after", "b", 0)) == [(B, A)]


def test_before_that_is_said_of_what_stands_before() -> None:
    assert order(said("start", "a"), said("earlier", "b", 0)) == [(B, A)]


def test_clause_that_leads_is_said_of_all_that_and_joins_behind_it() -> None:
    """After a, do b and c; before a, do b and c."""
    assert order(said("after", "a", 1), said("start", "b"), said("and", "c", 1)) == [(A, B), (A, C)]
    assert order(said("before", "a", 1), said("start", "b"), said("and", "c", 1)) == [(B, A), (C, A)]


def test_it_ends_with_the_sentence() -> None:
    later = said("and", "c", 1, sentence=1)
    assert order(said("after", "a", 1), said("start", "b"), later) == [(A, B)]


def test_what_shares_its_object_stands_where_the_next_one_stands() -> None:
    """Find a, then find and follow b: no order is said between the last two."""
    assert order(said("start", "a"), said("shares", "b", 2), said("then", "b", 0, routine="Follow")) == [
        (A, B),
        (A, "Follow(b)"),
    ]


def test_in_that_order_is_said_of_all_that_and_joins() -> None:
    assert order(said("start", "a"), said("and", "b", 0), said("and", "c", 1, in_order=True)) == [(A, B), (B, C)]


def test_what_has_no_end_of_its_own_lasts_until_the_other_ends() -> None:
    """Follow a until you find b; while following a, find b; find b while following a."""
    follow_a_until_b = [("Follow(a)", B, "until")]
    assert order(said("start", "a", routine="Follow"), said("until", "b", 0)) == follow_a_until_b
    assert order(said("while", "a", 1, routine="Follow"), said("start", "b")) == follow_a_until_b
    assert order(said("start", "b"), said("while", "a", 0, routine="Follow")) == follow_a_until_b
    assert order(said("start", "a", routine="Follow"), said("while", "b", 0)) == follow_a_until_b


def test_two_that_last_and_two_that_end_go_on_side_by_side() -> None:
    assert order(said("start", "a", routine="Follow"), said("while", "b", 0, routine="Follow")) == []
    assert order(said("start", "a"), said("while", "b", 0)) == []


def test_until_needs_something_that_lasts() -> None:
    made = ordered(said("start", "a"), said("until", "b", 0))
    assert links(made) == []
    assert [doubt.rule for doubt in made.doubts] == ["until_without_open_end"]


def test_meanwhile_is_said_of_the_step_and_belongs_to_it() -> None:
    """Find a; meanwhile follow b; then find c."""
    assert order(said("start", "a"), said("meanwhile", "b", 0, routine="Follow"), said("then", "c", 1)) == [
        ("Follow(b)", A, "until"),
        (A, C),
        ("Follow(b)", C),
    ]


def test_then_is_said_of_what_goes_on_beside_too() -> None:
    """While following a, find b, then find c."""
    assert order(said("while", "a", 1, routine="Follow"), said("start", "b"), said("then", "c", 1)) == [
        ("Follow(a)", B, "until"),
        (B, C),
        ("Follow(a)", C),
    ]


def test_only_the_first_clause_of_a_unit_is_ordered_for_all_of_it() -> None:
    """Either a or b, then c: the choice stands for both."""
    goals = [said("start", "a"), said("or", "b", 0), said("then", "c", 1)]
    choice = do("Search", "choice")
    tops = [[choice], [choice], goals[2].outline.pieces]
    made = composition(choice, *tops[2])
    order_as_said(goals, tops, [Unit(((0,), (1,))), Unit(((2,),))], LIBRARY, made)
    assert links(made) == [("Search(choice)", C)]


def test_anchor_that_is_not_there_orders_nothing() -> None:
    assert order(said("start", "a"), said("after", "b", None), said("after", "d", 9)) == []
