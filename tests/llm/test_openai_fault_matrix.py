"""A sample of the fault matrix: every fault, streamed and whole, once at one turn, and for ever at the first."""

from __future__ import annotations

import pytest

from benchmarks.fault_matrix import TURNS, Cell, cells, faultless, tree_before, wrong_in
from tests.llm.endpoint_faults import CASES, Case

NUMBERED = list(enumerate(CASES))
PASSING = [(number, case) for number, case in NUMBERED if case.fate == "passes"]


def names(numbered: list[tuple[int, Case]]) -> list[str]:
    return [case.name for _, case in numbered]


def test_without_a_fault_the_dialogue_builds_the_tree_that_its_calls_say() -> None:
    seen = faultless()
    assert (seen.authored.status, seen.violations, seen.naps) == ("complete", (), ())
    assert seen.authored.tree == tree_before(len(TURNS) + 1)
    assert seen.requests == len(TURNS)


@pytest.mark.parametrize(("number", "case"), NUMBERED, ids=names(NUMBERED))
@pytest.mark.parametrize("stream", [True, False])
def test_a_fault_met_at_one_turn_comes_to_what_it_must(number: int, case: Case, stream: bool) -> None:
    """Where silence is the fault, the client waits a second for it; the next attempt is answered far sooner than that."""
    cell = Cell(case, turn=1 + (number + stream) % len(TURNS), stream=stream, for_ever=False)
    assert wrong_in(cell, timeout_s=1) == []


@pytest.mark.parametrize(("number", "case"), PASSING, ids=names(PASSING))
def test_a_fault_that_does_not_pass_ends_the_dialogue_after_four_attempts(number: int, case: Case) -> None:
    """At the first turn no answer is ever waited for, so the patience with silence can be as short as one likes."""
    cell = Cell(case, turn=1, stream=bool(number % 2), for_ever=True)
    assert wrong_in(cell, timeout_s=0.05) == []


def test_the_whole_matrix_has_every_fault_at_every_turn_streamed_and_whole() -> None:
    """32 faults x 5 turns x 2, and the 16 that may pass once more for ever: 320 + 160."""
    assert len(CASES) == 32
    assert sum(case.fate == "passes" for case in CASES) == 16
    assert len(list(cells())) == 480


def test_a_wrong_cell_is_seen() -> None:
    """A fault that is final, said to pass, is wrong in status, in tree and in what was slept."""
    final = next(case for case in CASES if case.name == "HTML page")
    claimed = Case(final.name, final.fault, "passes", "failed")
    wrong = wrong_in(Cell(claimed, turn=2, stream=True, for_ever=False))
    assert [line.partition(":")[0] for line in wrong] == [
        "seconds slept",
        "status",
        "tree",
        "calls that applied",
        "requests",
        "transcript",
    ]
