"""Clauses of which one is done."""

from __future__ import annotations

from missiontree.authoring.composing.choosing import chosen
from missiontree.authoring.composing.composition import Composition
from missiontree.authoring.composing.units import Unit
from missiontree.authoring.methods.outline import Piece
from missiontree.authoring.reading.outcomes import Goal
from tests.authoring.composing.goals import LIBRARY, composition, do, goal, links, shape


def hung(unit: Unit, *goals: Goal) -> tuple[list[object], Composition, list[list[Piece]]]:
    tops = [goal.outline.pieces for goal in goals]
    made = composition(*(piece for pieces in tops for piece in pieces))
    chosen(unit, goals, tops, LIBRARY, made)
    return [shape(piece) for piece in made.outline.pieces], made, tops


def cat() -> Goal:
    return goal("find the cat", do("Search", "cat"))


def dog() -> Goal:
    return goal("find the dog", do("Search", "dog"), relation="or", anchor=0)


def hall() -> Goal:
    return goal("go to the hall", do("Reach", "hall"))


def test_unit_of_one_is_no_choice() -> None:
    shapes, _, _ = hung(Unit(((0,),)), cat(), hall())
    assert shapes == ["Search(cat)", "Reach(hall)"]


def test_options_hang_below_one_task_where_the_first_of_them_stood() -> None:
    shapes, _, tops = hung(Unit(((1,), (2,))), hall(), cat(), dog())
    assert shapes == [
        "Reach(hall)",
        ("Find the Cat or Find the Dog", "xor", ["Search(cat)", "Search(dog)"]),
    ]
    # From then on the task stands for both clauses.
    assert tops[1] == tops[2]
    assert tops[1][0].gate == "xor"


def test_option_of_several_clauses_is_a_task_and_keeps_its_order() -> None:
    """Either find the cat, then follow it, or find the dog."""
    follow = goal("follow it", do("Follow", "cat"), relation="then", anchor=0)
    shapes, made, _ = hung(Unit(((0, 1), (2,))), cat(), follow, dog())
    assert shapes == [
        (
            "Find the Cat or Find the Dog",
            "xor",
            [("Find the Cat, Follow It", "and", ["Search(cat)", "Follow(cat)"]), "Search(dog)"],
        )
    ]
    assert links(made) == [("Search(cat)", "Follow(cat)")]


def test_three_options_are_three() -> None:
    bird = goal("find the bird", do("Search", "bird"), relation="or", anchor=1)
    shapes, _, _ = hung(Unit(((0,), (1,), (2,))), cat(), dog(), bird)
    assert shapes == [
        ("Find the Cat or Find the Dog or Find the Bird", "xor", ["Search(cat)", "Search(dog)", "Search(bird)"])
    ]
