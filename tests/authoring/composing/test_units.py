"""Which clauses stand together as one choice."""

from __future__ import annotations

from missiontree.authoring.composing.units import Unit, units_of
from missiontree.authoring.reading.clause import Relation
from missiontree.mission.reason import Reason
from tests.authoring.composing.goals import goal


def units(*relations: Relation | tuple[Relation, str]) -> tuple[list[tuple[tuple[int, ...], ...]], list[str]]:
    """Options of each unit, and the clauses at which it is not clear how far a choice reaches."""
    goals = []
    for number, said in enumerate(relations):
        relation, *marks = (said,) if isinstance(said, str) else said
        goals.append(goal(f"clause {number}", relation=relation, **dict.fromkeys(marks, True)))
    doubts: list[Reason] = []
    made = units_of(goals, doubts)
    assert all(doubt.rule == "choice_unclear" for doubt in doubts)
    return [unit.options for unit in made], [doubt.found for doubt in doubts]


def test_most_units_are_one_clause() -> None:
    assert units("start", "and", "then", "before") == ([((0,),), ((1,),), ((2,),), ((3,),)], [])
    assert units() == ([], [])


def test_or_joins_two_and_more() -> None:
    assert units("start", "or") == ([((0,), (1,))], [])
    assert units("start", "or", "or") == ([((0,), (1,), (2,))], [])


def test_what_comes_after_a_choice_in_a_sentence_of_its_own_is_no_part_of_it() -> None:
    assert units("start", "or", "start") == ([((0,), (1,)), ((2,),)], [])
    assert units("start", "or", "then") == ([((0,), (1,)), ((2,),)], [])


def test_either_begins_a_choice_and_holds_what_is_joined_to_it() -> None:
    """Either find the cat and follow it, or find the dog."""
    assert units(("start", "either"), "and", "or") == ([((0, 1), (2,))], [])
    assert units(("start", "either"), "then", "or") == ([((0, 1), (2,))], [])
    assert units("start", ("and", "either"), "shares", "or") == ([((0,),), ((1, 2), (3,))], [])


def test_last_option_of_either_goes_on_with_and_up_to_a_pause() -> None:
    """Either find the cat or find the dog and follow it(, and go home)."""
    assert units(("start", "either"), "or", "and") == ([((0,), (1, 2))], [])
    options, doubts = units(("start", "either"), "or", ("and", "pause"))
    assert options == [((0,), (1,)), ((2,),)]
    # With the pause it is another unit, yet it may have been meant as part of the last option.
    assert doubts == ["clause 2"]


def test_how_far_a_choice_without_either_reaches_is_asked() -> None:
    """Do this and do that or do something else: the last instead of both, or of the second."""
    assert units("start", "and", "or")[1] == ["clause 2"]
    assert units("start", "or", "and")[1] == ["clause 2"]


def test_or_at_the_beginning_has_nothing_to_choose_from() -> None:
    assert units("or") == ([((0,),)], [])


def test_all_clauses_of_a_unit_in_order() -> None:
    assert Unit(((0, 1), (2,))).indexes == (0, 1, 2)
