"""The seam: what every scheduler is."""

from __future__ import annotations

from typing import Protocol

from missiontree.mission.alternative import Alternative
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import NO_TERMS, Terms


class Scheduler(Protocol):
    """Gives every role a robot and every action a time."""

    def __call__(
        self,
        tree: GroundedTree,
        alternative: Alternative,
        fleet: Fleet,
        scene: Scene,
        control: Control,
        terms: Terms = NO_TERMS,
    ) -> Schedule:
        """
        Schedule one alternative.

        Parameters
        ----------
        tree
            The mission over the fleet.
        alternative
            Which actions are done, by which types.
        fleet
            Robots, where they start, their budgets.
        scene
            Where things are and the ways between, introduced entities included.
        control
            Time limit, stop token, progress, seed.
        terms
            Who is left out or required, and what the scene holds for the whole mission. Default: nothing of all this.
        """
        ...
