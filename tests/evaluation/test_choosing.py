"""Ways of choosing, listed by hand."""

from missiontree.evaluation.choosing import MOST_WAYS, ways_of_choosing
from missiontree.evaluation.expected import Group


def ways(shape: Group | int) -> list[list[int]]:
    return [sorted(way) for way in ways_of_choosing(shape)]


def test_without_a_choice_all_is_done() -> None:
    assert ways(Group("and", (0, 1, 2))) == [[0, 1, 2]]
    assert ways(0) == [[0]]


def test_each_branch_of_a_choice_is_a_way() -> None:
    assert ways(Group("xor", (0, Group("and", (1, 2))))) == [[0], [1, 2]]


def test_choices_side_by_side_multiply() -> None:
    shape = Group("and", (0, Group("xor", (1, 2)), Group("xor", (3, 4))))
    assert ways(shape) == [[0, 1, 3], [0, 1, 4], [0, 2, 3], [0, 2, 4]]


def test_more_than_a_thousand_ways_are_cut_there_and_many_choices_are_no_trouble() -> None:
    shape = Group("and", tuple(Group("xor", (2 * n, 2 * n + 1)) for n in range(2_000)))
    assert len(ways_of_choosing(shape)) == MOST_WAYS
