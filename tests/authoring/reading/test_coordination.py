"""Where a clause is cut that says several things."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.coordination import MAX_OPTIONS, Cut, choices, gaps, has_choice
from missiontree.authoring.reading.words import words_of_text
from tests.authoring.reading.heard import shown


def cuts(text: str, verb_length: int = 1) -> list[Cut]:
    return list(choices(words_of_text(text), verb_length))


def variants(text: str, verb_length: int = 1) -> list[list[str]]:
    return [[shown(words) for words in cut.variants] for cut in cuts(text, verb_length)]


def test_nearest_option_comes_first_and_shares_the_most_words() -> None:
    """The reader takes the first cut that means something; "the the kitchen" is nothing."""
    assert variants("find the lobby or the kitchen") == [
        ["find the lobby", "find the the kitchen"],
        ["find the lobby", "find the kitchen"],
    ]
    assert [cut.whole for cut in cuts("find the lobby or the kitchen")] == [False, True]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("bring the box to the lobby or the lab", ["bring the box to the lobby", "bring the box to the lab"]),
        ("bring the box to the lobby or to the lab", ["bring the box to the lobby", "bring the box to the lab"]),
        ("bring the box or the bag to the lab", ["bring the box to the lab", "bring the bag to the lab"]),
        ("bring the red or blue box to the lab", ["bring the red box to the lab", "bring the blue box to the lab"]),
        ("find the red or the blue box", ["find the red box", "find the blue box"]),
        ("find the marble bust or the bronze one", ["find the marble bust", "find the bronze bust"]),
        ("find room 12 or 13", ["find room 12", "find room 13"]),
        ("find the cat, the dog or the bird", ["find the cat", "find the dog", "find the bird"]),
        ("find the cat or the dog or the bird", ["find the cat", "find the dog", "find the bird"]),
        ("bring it into the hall or onto the roof", ["bring it into the hall", "bring it onto the roof"]),
    ],
)
def test_options_are_said_in_full(text: str, expected: list[str]) -> None:
    assert expected in variants(text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("find either the cat or the dog", [["find the cat", "find the dog"]]),
        ("bring the box either to the hall or to the lab", [["bring the box to the hall", "bring the box to the lab"]]),
        ("find either the cat and the dog or the bird", [["find the cat and the dog", "find the bird"]]),
    ],
)
def test_either_says_where_the_choice_begins(text: str, expected: list[list[str]]) -> None:
    assert variants(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "find the cat and the dog",
        "find cat and dog or bird",  # this and that or those: either of two things
        "find the cat or the dog and the bird",
        "find Anna in the hall or at the gate",  # where she is, is not where she is found
        "find the cat or",
    ],
)
def test_no_choice_that_can_be_cut(text: str) -> None:
    whole = [cut for cut in cuts(text) if cut.whole]
    assert whole == []


def test_mixture_of_and_and_or_is_not_cut_across_the_and() -> None:
    for text in ("find cat and dog or bird", "find the cat and the dog or the bird", "find the cat or dog and bird"):
        assert all("and" not in shown(option).split() for cut in cuts(text) for option in cut.options)


def test_so_many_options_and_no_more() -> None:
    names = [f"the {word}" for word in ["cat", "dog", "bird", "fox", "hen", "pig", "cow"]]
    most = f"find {', '.join(names[1:6])} or {names[6]}"
    assert [len(cut.options) for cut in cuts(most) if cut.whole] == [MAX_OPTIONS]
    assert [cut for cut in cuts(f"find {', '.join(names[:6])} or {names[6]}") if cut.whole] == []


def test_or_within_the_verb_is_no_choice() -> None:
    assert cuts("find or follow the cat", verb_length=3) == []


def test_every_variant_begins_with_the_verb_and_options_differ() -> None:
    for cut in cuts("go to the hall, the lab or the yard", verb_length=2):
        assert all(shown(words[:2]) == "go to" for words in cut.variants)
        assert len(cut.variants) == len(cut.options)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "bring Anna to the lobby and Bob to the lab",
            [("bring Anna to the lobby", "bring Bob to the lab")],
        ),
        (
            "bring Anna to the lobby, Bob to the lab and Cleo to the gate",
            [
                ("bring Anna to the lobby", "bring Bob to the lab and Cleo to the gate"),
                ("bring Anna to the lobby , Bob to the lab", "bring Cleo to the gate"),
            ],
        ),
        ("bring Anna to the lobby, and Bob to the lab", [("bring Anna to the lobby ,", "bring Bob to the lab")]),
        ("bring and Bob", []),
        ("bring Anna to the lobby and", []),
        ("bring Anna to the lobby", []),
    ],
)
def test_one_verb_for_two(text: str, expected: list[tuple[str, str]]) -> None:
    found = [(shown(first), shown(second)) for first, second in gaps(words_of_text(text), 1)]
    assert found == expected


def test_choice_is_an_or() -> None:
    assert has_choice(words_of_text("the cat or the dog"))
    assert not has_choice(words_of_text("the orange cat"))
