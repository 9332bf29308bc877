"""What is said of a schedule in which more robots, or more room, were tried: whether it is shorter, and whether it could be."""

from __future__ import annotations

from typing import Protocol

from missiontree.mission.certificate import Certificate
from missiontree.mission.chain import Addition, Verdict
from missiontree.mission.schedule import ScheduleStatus
from missiontree.reporting.critical.spans import ms


class Scheduled(Protocol):
    """What every kind of schedule knows of itself."""

    @property
    def status(self) -> ScheduleStatus:
        """What is known."""

    @property
    def makespan_s(self) -> float:
        """How long it takes; 0 if there is none."""

    @property
    def certificate(self) -> Certificate:
        """The bound on it, and the method behind the status."""


def verdict_of(anew: Scheduled, now_s: float) -> Verdict:
    """Whether a schedule with an addition is shorter than what there is without it; by no solver's word if not."""
    now = ms(now_s)
    if anew.status in {"optimal", "feasible"} and ms(anew.makespan_s) < now:
        return "shorter"
    bound = anew.certificate.bound if anew.certificate.claim in {"proven", "bounded"} else None
    return "not_shorter" if bound is not None and ms(bound) >= now else "none_found"


def worth(one: Addition) -> tuple[int, int]:
    """The shortest first, then what is proven not to help, then the rest."""
    order = ("shorter", "not_shorter", "none_found")
    return order.index(one.verdict), ms(one.makespan_s) if one.verdict == "shorter" else 0


def not_tried(number: int) -> str:
    """A sentence about so many additions for which there was no time; empty if there are none."""
    if not number:
        return ""
    several = "1 further addition was" if number == 1 else f"{number} further additions were"
    return f"{several} not tried, for want of time."
