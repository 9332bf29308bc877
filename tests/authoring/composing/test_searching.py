"""What follows from who is lost, and from what is brought back."""

from __future__ import annotations

from dataclasses import replace

from missiontree.authoring.composing.composition import Composition
from missiontree.authoring.composing.searching import (
    brought_before_returned,
    found_before_used,
    search_first,
    search_once,
)
from missiontree.authoring.methods.mention import Mention
from missiontree.authoring.methods.outline import Piece
from tests.authoring.composing.goals import LIBRARY, composition, do, goal, links, shape

LOST = Mention("Cat", "Cat", "Lost Cat", "animal", lost=True)
STRAY = Mention("Dog", "Dog", "Stray Dog", "animal", lost=True)


def tops(made: Composition) -> list[object]:
    return [shape(piece) for piece in made.outline.pieces]


def rules(made: Composition) -> list[str]:
    return [notice.rule for notice in made.notices]


def implied(made: Composition) -> list[tuple[str, str]]:
    return [(first.label, second.label) for first, second in made.implied]


def test_who_was_searched_for_is_not_searched_for_again_by_a_later_method() -> None:
    first = do("Search", "cat")
    locate, bring = Piece("Locate", pieces=[do("Search", "cat")]), do("ReachAndTransport", "cat", "anna")
    method = goal("rescue the cat", locate, bring)
    method.outline.link(locate, bring)
    made = Composition()
    search_once([goal("find the cat", first), method], LIBRARY, made)
    # The task that is empty now goes too, and what came after it comes after the first search.
    assert method.outline.pieces == [bring]
    assert method.outline.links == [(first, bring, "precedence")]
    assert rules(made) == ["searched_once"]


def test_who_is_asked_for_twice_in_plain_words_is_searched_for_twice() -> None:
    goals = [goal("find the cat", do("Search", "cat")), goal("find the cat", do("Search", "cat"), relation="then")]
    made = Composition()
    search_once(goals, LIBRARY, made)
    assert [len(one.outline.pieces) for one in goals] == [1, 1]
    assert rules(made) == []


def test_search_within_a_choice_serves_nobody_else() -> None:
    choice = goal(
        "find the cat or the dog", Piece("one", pieces=[do("Search", "cat"), do("Search", "dog")], gate="xor")
    )
    for chosen in (choice, goal("a", do("Search", "cat"), either=True), goal("a", do("Search", "cat"), relation="or")):
        method = goal("rescue the cat", do("Search", "cat"), do("Reach", "cat"))
        search_once([chosen, method], LIBRARY, Composition())
        assert len(method.outline.pieces) == 2


def test_search_with_other_robots_is_another_search() -> None:
    restricted, method = do("Search", "cat"), goal("rescue the cat", do("Search", "cat"), do("Reach", "cat"))
    restricted.resources = ("tele_robot",)
    search_once([goal("find the cat", restricted), method], LIBRARY, Composition())
    assert len(method.outline.pieces) == 2


def test_everybody_who_is_lost_is_searched_for_first_in_the_order_in_which_they_are_named() -> None:
    made = composition(do("Follow", LOST), do("Follow", STRAY), do("Reach", LOST))
    search_first([], LIBRARY, made)
    assert tops(made) == ["Search(Cat)", "Search(Dog)", "Follow(Cat)", "Follow(Dog)", "Reach(Cat)"]
    assert rules(made) == ["search_added", "search_added"]
    assert "Cat is said to be lost" in made.notices[0].message


def test_who_stands_at_an_unknown_position_of_the_scene_is_searched_for_too() -> None:
    nowhere = Mention("cat", "Cat", "Cat", "animal", new=False, known=False)
    made = composition(do("Follow", nowhere))
    search_first([], LIBRARY, made)
    assert tops(made)[0] == "Search(Cat)"
    assert "is at an unknown position" in made.notices[0].message


def test_who_is_not_lost_or_is_searched_for_already_needs_no_search() -> None:
    for pieces in ([do("Follow", "cat")], [do("Follow", LOST), do("Search", LOST)], [do("SearchAndFollow", LOST)]):
        made = composition(*pieces)
        search_first([], LIBRARY, made)
        assert made.outline.pieces == pieces
        assert made.notices == []


def test_search_that_nobody_asked_for_is_done_by_those_that_the_mission_allows() -> None:
    follow, bring = do("Follow", LOST), do("ReachAndTransport", LOST, "anna")
    goals = [
        replace(goal("follow the lost cat", follow), standing=("tele_robot", "social_robot")),
        replace(goal("bring it to Anna", bring), standing=("mobile_scooter", "tele_robot")),
        replace(goal("go to the hall", do("Reach", "hall")), standing=("mobile_scooter",)),  # not about the cat
    ]
    made = composition(follow, bring)
    search_first(goals, LIBRARY, made)
    assert made.outline.pieces[0].resources == ("tele_robot",)


def test_search_that_only_one_option_needs_stands_in_that_option() -> None:
    task = Piece("bring it", pieces=[do("ReachAndTransport", LOST, "anna")])
    made = composition(Piece("one", pieces=[do("Reach", "hall"), task], gate="xor"))
    search_first([], LIBRARY, made)
    assert tops(made) == [
        ("one", "xor", ["Reach(hall)", ("bring it", "and", ["Search(Cat)", "ReachAndTransport(Cat, anna)"])])
    ]


def test_option_that_is_one_routine_gets_a_task_for_the_search() -> None:
    made = composition(Piece("one", pieces=[do("Reach", "hall"), do("Follow", LOST)], gate="xor"))
    search_first([], LIBRARY, made)
    assert tops(made) == [
        ("one", "xor", ["Reach(hall)", ("Find Cat for Follow(Cat)", "and", ["Search(Cat)", "Follow(Cat)"])])
    ]


def test_search_that_several_options_need_goes_before_the_choice() -> None:
    made = composition(Piece("one", pieces=[do("Reach", LOST), do("Follow", LOST)], gate="xor"))
    search_first([], LIBRARY, made)
    assert tops(made) == ["Search(Cat)", ("one", "xor", ["Reach(Cat)", "Follow(Cat)"])]


def test_who_is_searched_for_is_found_before_anything_else_is_done_with_them() -> None:
    made = composition(
        do("Follow", "cat"), do("Search", "cat"), do("Reach", "dog"), do("ReachAndTransport", "cat", "dog")
    )
    found_before_used(LIBRARY, made)
    assert implied(made) == [
        ("Search(cat)", "Follow(cat)"),
        ("Search(cat)", "ReachAndTransport(cat, dog)"),
    ]
    assert rules(made) == ["order_added", "order_added"]
    assert links(made) == []  # what nobody said may still fall away


def test_order_that_was_said_is_kept_whichever_way_it_goes() -> None:
    follow, search = do("Follow", "cat"), do("Search", "cat")
    for pair in ((follow, search), (search, follow)):
        made = composition(follow, search)
        made.outline.link(*pair)
        found_before_used(LIBRARY, made)
        assert made.implied == []


def test_two_searches_and_two_options_have_no_order() -> None:
    made = composition(do("Search", "cat"), do("Search", "cat"))
    found_before_used(LIBRARY, made)
    assert made.implied == []
    made = composition(Piece("one", pieces=[do("Search", "cat"), do("Follow", "cat")], gate="xor"))
    found_before_used(LIBRARY, made)
    assert made.implied == []


def test_what_is_brought_back_is_brought_away_before() -> None:
    away, back = do("ReachAndTransport", "pump", "field"), do("ReachAndTransport", "pump", "shed")
    other = do("ReachAndTransport", "hose", "field")
    first = goal("bring the pump and the hose to the field", away, other)
    returning = goal("take the pump back", back, relation="and", anchor=0)
    for returns, expected in ((True, [(away.label, back.label)]), (False, [])):
        made = composition(away, other, back)
        returning = replace(returning, returns=returns)
        brought_before_returned([first, returning], made)
        assert implied(made) == expected
        assert rules(made) == ["order_added"] * len(expected)


def test_order_that_was_said_is_not_added() -> None:
    away, back = do("ReachAndTransport", "pump", "field"), do("ReachAndTransport", "pump", "shed")
    made = composition(away, back)
    made.outline.link(away, back)
    returning = goal("take the pump back", back, relation="then", anchor=0)
    returning = replace(returning, returns=True)
    brought_before_returned([goal("bring the pump to the field", away), returning], made)
    assert made.implied == []


def test_search_that_a_choice_may_take_away_serves_nobody_outside_it() -> None:
    inside = Piece("one", pieces=[do("Search", LOST), do("Reach", "hall")], gate="xor")
    made = composition(inside, do("Follow", LOST))
    search_first([], LIBRARY, made)
    assert tops(made)[0] == "Search(Cat)"
    assert rules(made) == ["search_added"]


def test_search_outside_a_choice_serves_every_option() -> None:
    made = composition(do("Search", LOST), Piece("one", pieces=[do("Follow", LOST), do("Reach", "hall")], gate="xor"))
    search_first([], LIBRARY, made)
    assert rules(made) == []


def test_event_that_both_are_found_takes_no_search_away() -> None:
    cat, dog = do("Search", "cat"), do("Search", "dog")
    event = goal("the cat and the dog are found", do("Search", "cat"), do("Search", "dog"), relation="after")
    made = Composition()
    search_once([goal("find the cat", cat), goal("find the dog", dog), event], LIBRARY, made)
    assert len(event.outline.pieces) == 2  # what they stand for is told apart later, and nothing was done twice
    assert rules(made) == []
