"""How long a provider is waited for, and how often it is asked again. One policy for all; the SDKs' own retries are off."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

from missiontree.llm.chat import FaultKind, ProviderError

PASSING: frozenset[FaultKind] = frozenset(
    {"unreachable", "timed_out", "rate_limited", "overloaded", "cut_off", "empty"}
)
"""Faults that may be over in a moment. All others are final: asking again would bring the same."""

T = TypeVar("T")


@dataclass(frozen=True, slots=True, kw_only=True)
class Patience:
    """
    How long to wait for one answer.

    Parameters
    ----------
    attempts
        How often it is asked for in all. Default 4.
    timeout_s
        Seconds without a sign of life after which an attempt is given up. Default 120.
    first_wait_s
        Seconds before the second attempt; each further wait is twice as long. Default 1.
    longest_wait_s
        Longest single wait, in seconds. A provider that asks for more (``Retry-After``) is not waited for. Default 30.
    total_s
        Seconds for all attempts and waits of one answer; no attempt and no wait begins after that. Default 300.
    sleep, clock
        Seconds pass and are told by these.
    """

    attempts: int = 4
    timeout_s: float = 120.0
    first_wait_s: float = 1.0
    longest_wait_s: float = 30.0
    total_s: float = 300.0
    sleep: Callable[[float], None] = time.sleep
    clock: Callable[[], float] = time.monotonic


def asked_patiently(ask: Callable[[], T], patience: Patience) -> T:
    """
    Ask until there is an answer or patience is at its end.

    Parameters
    ----------
    ask
        Asks once; raises ``ProviderError`` if that fails. Must have no effect when it fails, since it is done again.
    patience
        How long and how often.

    Raises
    ------
    ProviderError
        The last fault, with the number of attempts in its words; at once if the fault is not one that passes.
    """
    began, wait = patience.clock(), patience.first_wait_s
    for attempt in range(1, patience.attempts + 1):
        try:
            return ask()
        except ProviderError as fault:
            if fault.kind not in PASSING:
                raise
            pause = wait if fault.retry_after_s is None else max(0.0, fault.retry_after_s)
            left = patience.total_s - (patience.clock() - began)
            if attempt == patience.attempts or pause > min(patience.longest_wait_s, left):
                raise _given_up(fault, attempt) from fault
        patience.sleep(pause)
        wait = min(2 * wait, patience.longest_wait_s)
    raise ValueError(f"patience needs at least 1 attempt, got {patience.attempts}.")


def _given_up(fault: ProviderError, attempts: int) -> ProviderError:
    again = "" if attempts == 1 else f" It was asked {attempts} times."
    later = ""
    if fault.retry_after_s is not None:
        later = f" It asks to wait {fault.retry_after_s:g} s before the next attempt."
    return ProviderError(f"{fault}{later}{again}", fault.kind, fault.hint, fault.retry_after_s)
