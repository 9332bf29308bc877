"""The seam: what every allocator is."""

from __future__ import annotations

from typing import Protocol

from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree


class Allocator(Protocol):
    """Finds the best ways to staff a grounded tree."""

    def __call__(self, tree: GroundedTree, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """
        Rank alternatives.

        Parameters
        ----------
        tree
            The mission over the fleet.
        fleet
            Counts, limits and budgets.
        weights
            What makes utility.
        k
            How many alternatives are asked for, at least 1.
        control
            Time limit, stop token, progress, seed.
        """
        ...
