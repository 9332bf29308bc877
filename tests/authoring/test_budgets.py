"""What a dialogue has taken, by numbers that can be added up by hand."""

from __future__ import annotations

import pytest

from missiontree.authoring.budgets import Budgets, Meter, estimated_tokens
from missiontree.llm.chat import Message, Tool, ToolCall, Usage

SENT = (Message("user", "abcdef"),)  # 6 bytes: 2 tokens


def meter(**limits: float) -> tuple[Meter, list[float]]:
    """A meter and the clock it reads."""
    now = [50.0]
    return Meter(Budgets(**limits), lambda: now[0]), now  # type: ignore[arg-type]


def answer(tokens: int = 0, cost: float | None = None) -> Message:
    return Message("assistant", usage=Usage(tokens, tokens, cost))


def test_tokens_of_the_provider_are_added_up() -> None:
    metered, now = meter()
    metered.turn(SENT, (), answer(10, 0.5))
    metered.turn(SENT, (), answer(7, 0.25))
    now[0] += 1.5
    spent = metered.spent()
    assert (spent.turns, spent.input_tokens, spent.output_tokens, spent.estimated) == (2, 17, 17, False)
    assert (spent.seconds, spent.cost_usd) == (1.5, 0.75)


def test_money_is_known_only_if_every_turn_tells_it() -> None:
    metered, _ = meter()
    assert metered.spent().cost_usd is None
    metered.turn(SENT, (), answer(1, 0.5))
    metered.turn(SENT, (), answer(1))
    assert metered.spent().cost_usd is None


def test_what_is_not_counted_is_estimated() -> None:
    """Six bytes sent are 2 tokens; 'ää' (4 bytes), 'ab' and '{}' received are 8 bytes, 3 tokens."""
    metered, _ = meter()
    metered.turn(SENT, (), Message("assistant", "ää", (ToolCall("1", "ab", "{}"),)))
    spent = metered.spent()
    assert (spent.input_tokens, spent.output_tokens, spent.estimated) == (2, 3, True)


def test_tools_count_as_what_is_sent() -> None:
    """["a","b",{}] is written as ["a", "b", {}]: 14 bytes, 5 tokens."""
    assert estimated_tokens((), [Tool("a", "b", {})]) == 5


def test_a_lone_surrogate_can_be_counted() -> None:
    assert estimated_tokens([Message("assistant", "\ud800")]) == 1


@pytest.mark.parametrize(
    ("limits", "named"),
    [({"turns": 1}, "turns"), ({"tokens": 20}, "tokens"), ({"seconds": 3}, "seconds")],
)
def test_limits_are_met_exactly(limits: dict[str, float], named: str) -> None:
    """One turn of 10 + 10 tokens in 3 seconds meets each; none before."""
    metered, now = meter(**limits)
    assert metered.over() == ()
    metered.turn(SENT, (), answer(10))
    now[0] += 3
    (reason,) = metered.over()
    assert (reason.rule, reason.needed) == ("budget_exhausted", named)


def test_an_accepted_call_starts_the_count_of_refusals_anew() -> None:
    metered, _ = meter(refusals=2)
    for ok in (False, True, False):
        metered.call(ok, repeated=False)
    assert metered.stuck() == ()
    metered.call(False, repeated=False)
    assert metered.stuck()[0].needed == "refusals one after the other"
    assert (metered.spent().calls, metered.spent().refused) == (4, 3)


def test_repeats_add_up_over_accepted_calls() -> None:
    metered, _ = meter(repeats=2)
    for repeated in (True, False, True):
        metered.call(not repeated, repeated)
    assert metered.stuck()[0].needed == "repeated calls"


def test_answers_that_are_cut_count_as_refusals() -> None:
    metered, _ = meter(refusals=1)
    metered.cut()
    assert metered.stuck()[0].needed == "refusals one after the other"
    assert metered.spent().refused == 0


@pytest.mark.parametrize("limits", [{"turns": 0}, {"seconds": 0.0}, {"reminders": -1}])
def test_budgets_of_nothing_are_refused(limits: dict[str, int]) -> None:
    with pytest.raises(ValueError, match="must be"):
        Budgets(**limits)
