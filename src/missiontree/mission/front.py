"""Alternatives with their schedules that stand for a choice between "best staffed" and "fastest", and the one that is chosen."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.alternative import Alternative
from missiontree.mission.certificate import Certificate
from missiontree.mission.schedule import Schedule
from missiontree.mission.value import Count, Value


@dataclass(frozen=True, slots=True, kw_only=True)
class Option(Value):
    """
    An alternative with a schedule.

    Parameters
    ----------
    alternative
        The staffing. Its rank is its place among the options, from 1, not that in the ranking, in which it may not be listed.
    schedule
        Its schedule, of the same rank.
    certificate
        What is known of the option, not of its rank. On a front, ``proven``: no alternative of at least this utility has a shorter
        schedule, and none of a higher utility one that is no longer.
    """

    alternative: Alternative
    schedule: Schedule
    certificate: Certificate

    def _check(self) -> None:
        if self.alternative.rank != self.schedule.rank:
            raise ValueError(
                f"an alternative of rank {self.alternative.rank} has a schedule of rank {self.schedule.rank}."
            )


@dataclass(frozen=True, slots=True, kw_only=True)
class Front(Value):
    """
    The utility-makespan front: options none of which is beaten in both, from the best staffed to the fastest.

    Parameters
    ----------
    options
        By falling utility, and so by falling makespan.
    found
        How many options were found; where these are more than are listed, both ends are, and some between them.
    certificate
        ``proven``: there is no option beyond those found. ``unproven``: there may be; ``limit`` says what ended the search.
    """

    options: tuple[Option, ...]
    found: Count
    certificate: Certificate


@dataclass(frozen=True, slots=True, kw_only=True)
class Chosen(Value):
    """
    What the objective of the mission chooses, where that is not utility alone.

    Parameters
    ----------
    option
        The alternative, of rank 1, and its schedule. Its certificate is that of the choice. ``proven``: nothing is better by the
        objective; travel and sum of ends, where they decide between equals, are those found. ``bounded``: nothing is better than
        ``bound``, a makespan in seconds or a worth.
    worth
        What it comes to by the objective: the makespan in seconds (``makespan``, ``utility-makespan``), or
        alpha * q - beta * d - gamma * c.
    """

    option: Option
    worth: float
