"""What the plan that is chosen is best at."""

from __future__ import annotations

from typing import Literal, get_args

Objective = Literal["utility", "makespan", "utility-makespan", "weighted-team", "weighted-sum"]
"""
What decides between alternatives with their schedules.

``utility``
    The best alternative that has a schedule: how well it is done decides alone.
``makespan``
    The fastest; of equally fast ones that of the highest utility.
``utility-makespan``
    Of the alternatives of the highest utility that can be scheduled the fastest, then that with the least travel, then that with the
    least sum of ends.
``weighted-team``
    The highest alpha * q - beta * d - gamma * c, where q and c are those of all actions together, and d is the team's time: the
    makespan, counted once.
``weighted-sum``
    The same, where d is the robots' time: the sum, over all robots, of the seconds that they act or are on their way.
"""
OBJECTIVES: tuple[Objective, ...] = get_args(Objective)
WEIGHTED = frozenset({"weighted-team", "weighted-sum"})
IN_WORDS: dict[Objective, str] = {
    "utility": "highest utility",
    "makespan": "least makespan",
    "utility-makespan": "highest utility, then least makespan",
    "weighted-team": "weighted worth by team time",
    "weighted-sum": "weighted worth by robot time",
}
