"""Several readings of one clause to one goal."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.authoring.methods.outline import Outline, Piece, leaf_of
from missiontree.authoring.reading.choosing import both_of, choice_of, option_of
from missiontree.authoring.reading.outcomes import Goal
from missiontree.mission.reason import Reason
from missiontree.routines.library import built_in
from tests.authoring.reading.heard import clause_of, mention

SEARCH = built_in().by_id["Search"]
CLAUSE = clause_of("find the cat or the dog")
GUESS = Reason(rule="description_unused", message="It is red.", severity="assumption")


def search(label: str) -> Piece:
    return leaf_of(SEARCH, (mention(label, "animal"),))


def goal(*pieces: Piece, text: str = "find the cat", slots: int = 1, assumptions: tuple[Reason, ...] = ()) -> Goal:
    return Goal(clause_of(text), Outline(list(pieces)), text, assumptions, slots)


def shown(pieces: Sequence[Piece]) -> list[object]:
    """Labels, with what stands below a task behind it."""
    return [piece.label if piece.routine else (piece.label, piece.gate, shown(piece.pieces)) for piece in pieces]


def test_choice_hangs_its_options_below_one_task() -> None:
    made = choice_of(CLAUSE, [goal(search("Cat")), goal(search("Dog"))])
    assert shown(made.outline.pieces) == [("Find the Cat or the Dog", "xor", ["Search(Cat)", "Search(Dog)"])]


def test_options_that_ask_for_the_same_are_no_choice() -> None:
    made = choice_of(CLAUSE, [goal(search("Cat")), goal(search("Cat"))])
    assert shown(made.outline.pieces) == ["Search(Cat)"]


def test_what_all_options_ask_for_is_done_whatever_is_chosen() -> None:
    """Find the cat and the dog or bird."""
    made = choice_of(CLAUSE, [goal(search("Cat"), search("Dog")), goal(search("Cat"), search("Bird"))])
    assert shown(made.outline.pieces) == [
        "Search(Cat)",
        ("Find the Cat or the Dog", "xor", ["Search(Dog)", "Search(Bird)"]),
    ]


def test_options_with_an_order_of_their_own_stay_whole_and_keep_it() -> None:
    cat, dog = search("Cat"), search("Dog")
    ordered = goal(cat, dog)
    ordered.outline.link(cat, dog)
    made = choice_of(CLAUSE, [ordered, goal(search("Cat"), search("Bird"), text="find the bird")])
    assert shown(made.outline.pieces) == [
        (
            "Find the Cat or the Dog",
            "xor",
            [
                ("Find the Cat", "and", ["Search(Cat)", "Search(Dog)"]),
                ("Find the Bird", "and", ["Search(Cat)", "Search(Bird)"]),
            ],
        )
    ]
    assert made.outline.links == [(cat, dog, "precedence")]


def test_both_are_done_and_keep_their_order() -> None:
    cat, dog = search("Cat"), search("Dog")
    first, second = goal(cat, slots=3), goal(dog, slots=2)
    second.outline.link(cat, dog)
    made = both_of(CLAUSE, [first, second])
    assert shown(made.outline.pieces) == ["Search(Cat)", "Search(Dog)"]
    assert made.outline.links == [(cat, dog, "precedence")]
    assert made.slots == 2  # no more than the shorter says


def test_reading_names_all_and_says_the_same_once() -> None:
    goals = [
        goal(search("Cat"), assumptions=(GUESS,)),
        goal(search("Dog"), text="find the dog", assumptions=(GUESS,)),
        goal(search("Dog"), text="find the dog"),
    ]
    made = choice_of(CLAUSE, goals)
    assert made.reading == "find the cat or find the dog"
    assert made.assumptions == (GUESS,)
    assert made.clause is CLAUSE
    assert both_of(CLAUSE, goals).reading == "find the cat and find the dog"


def test_option_of_one_piece_needs_no_task() -> None:
    cat, dog = search("Cat"), search("Dog")
    assert option_of([cat], "find it") is cat
    assert shown([option_of([cat, dog], "find both of them")]) == [
        ("Find Both of Them", "and", ["Search(Cat)", "Search(Dog)"])
    ]
