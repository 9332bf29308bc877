"""What a plan's checker said, as far as a page tells it."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.reason import Reason


@dataclass(frozen=True, slots=True)
class Checked:
    """
    What a plan's checker said.

    Parameters
    ----------
    faults
        Rules that the plan breaks; empty if it keeps them all.
    trusted
        Claims that could not be confirmed.
    """

    faults: tuple[Reason, ...] = ()
    trusted: tuple[Reason, ...] = ()
