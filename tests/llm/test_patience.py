"""Hand-derived waits: the clock is a list, and sleeping moves it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from missiontree.llm.chat import FaultKind, ProviderError
from missiontree.llm.patience import PASSING, Patience, asked_patiently


class Clock:
    """Seconds that pass only when somebody sleeps."""

    def __init__(self) -> None:
        self.now, self.slept = 100.0, list[float]()

    def sleep(self, seconds: float) -> None:
        self.slept.append(seconds)
        self.now += seconds

    def patience(self, **limits: float) -> Patience:
        return Patience(sleep=self.sleep, clock=lambda: self.now, **limits)  # type: ignore[arg-type]


def failing(*faults: ProviderError) -> Callable[[], str]:
    left = list(faults)

    def ask() -> str:
        if left:
            raise left.pop(0)
        return "answer"

    return ask


def busy(retry_after_s: float | None = None) -> ProviderError:
    return ProviderError("busy", "rate_limited", retry_after_s=retry_after_s)


def test_an_answer_needs_no_wait() -> None:
    clock = Clock()
    assert asked_patiently(failing(), clock.patience()) == "answer"
    assert clock.slept == []


def test_waits_double_up_to_the_longest() -> None:
    clock = Clock()
    ask = failing(*[busy()] * 5)
    assert asked_patiently(ask, clock.patience(attempts=6, first_wait_s=2, longest_wait_s=7)) == "answer"
    assert clock.slept == [2, 4, 7, 7, 7]


def test_what_the_provider_asks_for_is_waited_for() -> None:
    clock = Clock()
    assert asked_patiently(failing(busy(5), busy(0)), clock.patience()) == "answer"
    assert clock.slept == [5, 0]


def test_nobody_sleeps_beyond_the_cap() -> None:
    clock = Clock()
    with pytest.raises(ProviderError, match=r"wait 3600 s before the next attempt\.$") as given_up:
        asked_patiently(failing(busy(3600)), clock.patience())
    assert clock.slept == []
    assert (given_up.value.kind, given_up.value.retry_after_s) == ("rate_limited", 3600)


def test_attempts_run_out() -> None:
    clock = Clock()
    with pytest.raises(ProviderError, match="asked 3 times"):
        asked_patiently(failing(*[busy()] * 9), clock.patience(attempts=3))
    assert clock.slept == [1, 2]


def test_the_total_bounds_waits() -> None:
    """1 + 2 have passed; a wait of 4 would end at 7, past 6."""
    clock = Clock()
    with pytest.raises(ProviderError, match="asked 3 times"):
        asked_patiently(failing(*[busy()] * 9), clock.patience(attempts=9, total_s=6))
    assert clock.slept == [1, 2]


@pytest.mark.parametrize("kind", ["unauthorised", "no_such_model", "bad_request", "context_overflow", "failed"])
def test_what_will_not_pass_is_not_asked_again(kind: FaultKind) -> None:
    assert kind not in PASSING
    clock = Clock()
    with pytest.raises(ProviderError, match=r"^no$"):
        asked_patiently(failing(ProviderError("no", kind)), clock.patience())
    assert clock.slept == []


def test_no_attempt_is_a_mistake_of_the_caller() -> None:
    with pytest.raises(ValueError, match="at least 1"):
        asked_patiently(failing(), Clock().patience(attempts=0))
