"""Below which options of which choices leaves hang."""

from __future__ import annotations

from missiontree.authoring.composing.options import Options
from missiontree.authoring.methods.outline import Piece
from tests.authoring.composing.goals import composition, do


def test_options_of_a_choice_within_a_choice() -> None:
    outside, first, second, inner = do("Reach", "a"), do("Reach", "b"), do("Reach", "c"), do("Reach", "d")
    within = Piece("within", pieces=[second, inner], gate="xor")
    choice = Piece("choice", pieces=[first, Piece("and", pieces=[within])], gate="xor")
    options = Options(composition(outside, choice).outline)
    assert options.exclude(first, second)
    assert options.exclude(second, inner)
    assert not options.exclude(outside, first)
    assert options.done_with(outside, inner)  # whatever is chosen
    assert not options.done_with(inner, outside)
    assert not options.done_with(first, second)
    assert options.done_with(first, first)
