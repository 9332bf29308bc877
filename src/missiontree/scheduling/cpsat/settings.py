"""How much the scheduler may do."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Settings:
    """
    Limits of constraint programming for one alternative.

    Parameters
    ----------
    longest_s
        Seconds if no time limit is set, and at most.
    largest
        Size of a model beyond which it is not solved; None (default) means any.
    deterministic
        The same answer every time, unless time cuts it short. Default false.
    tidy
        Whether travel and the sum of ends are made small, too, once the makespan is known to be least. Default true.
    first_steps, last_steps
        Steps of trying everything out before the solver is asked, and afterwards, if its word is not confirmed.
    regrouping
        Limit of the large neighbourhood search: its rounds times the roles of the mission. None means that time alone limits it in missions
        of many roles. Default None.
    spanned
        Places of a type up to which spanning trees bound the mission. Default 1,000.
    """

    longest_s: float
    largest: int | None = None
    deterministic: bool = False
    tidy: bool = True
    first_steps: int = 1_000
    last_steps: int = 20_000
    regrouping: int | None = None
    spanned: int = 1_000
