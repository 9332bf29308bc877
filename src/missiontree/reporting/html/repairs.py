"""What would make a mission possible, as the page shows it."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.explanation import Explanation, Repair
from missiontree.reporting.explanation_view import CLAIMS
from missiontree.reporting.html.quantity import number


@dataclass(frozen=True, slots=True)
class Shown:
    """
    A repair.

    Parameters
    ----------
    words, note
        What to change; what it costs, what is known of it, and what comes of it.
    """

    words: str
    note: str


def repairs(told: Explanation) -> tuple[Shown, ...]:
    """Repairs, cheapest first."""
    return tuple(Shown(repair.words, _note(repair)) for repair in told.repairs)


def _note(repair: Repair) -> str:
    return (
        f"Cost {number(repair.cost)}; {CLAIMS[repair.claim]}. The plan that results has utility {number(repair.utility)} "
        f"and ends after {number(round(repair.makespan_s, 1))} s."
    )
