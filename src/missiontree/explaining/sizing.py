"""
The smallest step of a number that is enough: guesses first, then growing steps, then bisection on whole numbers.

After each step that is enough the one before it is asked for, since what is enough is often the least already, and to show that a step is
not enough takes longest.

Every step is answered by the planner. It is proven that nothing smaller is enough if the step before was proven not to be: more of what
is asked for here never takes a way of doing the mission away. Where that does not hold nobody claims it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

MOST_DOUBLED = 60


class Size(NamedTuple):
    """
    A step that is enough.

    Parameters
    ----------
    step
        The smallest that was found.
    proven
        Whether the step before it is proven not to be enough.
    """

    step: int
    proven: bool


def smallest(
    enough: Callable[[int], bool | None],
    guesses: Iterable[int],
    last: int | None,
    reached: Callable[[int], int] = lambda step: step,
) -> Size | None:
    """
    The smallest step that is enough.

    Parameters
    ----------
    enough
        Whether a step of at least 1 is enough; None if that was not decided.
    guesses
        Steps that may be just enough.
    last
        No step is larger; None if there is no end.
    reached
        Asked of a step that is enough: the smallest that what was found for it would do with. Default: the step itself.

    Returns
    -------
    Size or None
        None if no step was found to be enough.
    """
    known: dict[int, bool | None] = {0: False}

    def ask(step: int) -> bool | None:
        if step not in known:
            known[step] = enough(step)
        return known[step]

    low, high = 0, None
    for guess in sorted({guess for guess in guesses if guess >= 1 and (last is None or guess <= last)}):
        if ask(guess):
            high = guess
            break
        low = guess
    if high is None:
        high = _grown(ask, low, last)
    if high is None:
        return None
    low = max(step for step, answer in known.items() if step < high and answer is not True)
    while high - low > 1 and ask(high - 1):
        high = max(low + 1, min(high - 1, reached(high - 1)))
        middle = (low + high) // 2
        if middle > low and ask(middle):
            high = max(low + 1, min(middle, reached(middle)))
        else:
            low = middle
    if not ask(high):  # what was found for a larger step would do with it, and was not found again
        high = min(step for step, answer in known.items() if answer)
    return Size(high, ask(high - 1) is False)


def _grown(ask: Callable[[int], bool | None], low: int, last: int | None) -> int | None:
    """A step that is enough, found by steps that double."""
    width = max(1, low // 8)
    for _ in range(MOST_DOUBLED):
        step = low + width if last is None else min(last, low + width)
        if ask(step):
            return step
        if step == last:
            return None
        width *= 2
    return None
