"""The seam: what every allocator is."""

from __future__ import annotations

from typing import Protocol

from missiontree.allocation.flat import Flat
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree


class Allocator(Protocol):
    """Finds the best ways to staff a grounded tree."""

    def __call__(self, tree: GroundedTree | Flat, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """
        Rank alternatives.

        Parameters
        ----------
        tree
            The mission over the fleet; or the same flattened, which is how terms of the mission come in, see
            :func:`missiontree.allocation.flat.flatten`. Then fleet and weights are in it already.
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
