"""The paper's missions take at most 4 turns, and their last turn's whole context at most 6,000 tokens."""

from __future__ import annotations

from dataclasses import replace

import pytest

from benchmarks.dialogue_size import MISSIONS, Size, bytes_of, held_again, size_of, table
from missiontree.samples.catalogue import PAPER

SIZE = Size(mission="x", turns=4, calls=1, context=18_000, system=1, said=1, told=1, tools=1)


@pytest.mark.parametrize("mission", MISSIONS)
def test_the_papers_missions_keep_within_their_size(mission: str) -> None:
    size = size_of(mission)
    assert size.turns <= 4
    assert size.tokens <= 6_000
    assert not size.too_long


def test_these_are_the_papers_five() -> None:
    assert set(MISSIONS) == set(PAPER)


def test_a_token_is_three_bytes_rounded_up() -> None:
    assert (SIZE.tokens, SIZE.too_long) == (6_000, False)
    longer = replace(SIZE, context=18_001)
    assert (longer.tokens, longer.too_long) == (6_001, True)
    assert replace(SIZE, turns=5).too_long


def test_the_context_is_all_that_was_sent_for_the_last_turn() -> None:
    _, witness = held_again("reunite")
    messages, tools = witness.sent
    assert [message.speaker for message in messages] == [
        *("system", "user"),
        *("assistant", "tool"),
        *("assistant", "tool"),
        *("assistant", "tool", "tool"),
    ]
    size = size_of("reunite")
    # Ten messages and the envelope leave a few commas and brackets that belong to no part.
    assert 0 < size.context - (size.system + size.said + size.told + size.tools) < 100
    assert size.tools > sum(len(tool.description) for tool in tools)


def test_bytes_are_those_of_utf_8_without_blanks() -> None:
    assert bytes_of({"a": ["ü", 1]}) == len('{"a":["') + 2 + len('",1]}')


def test_the_table_has_a_row_per_mission() -> None:
    assert "| x | 4 | 1 | 18,000 | 6,000 | 1 | 1 | 1 | 1 |" in table([SIZE]).splitlines()
