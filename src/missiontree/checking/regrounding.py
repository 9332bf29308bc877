"""The mission tree grounded anew, from the inputs alone: what a plan's own grounding is held against."""

from __future__ import annotations

from typing import NamedTuple

from missiontree.estimation.answers import ReadingOut
from missiontree.mission.brief import MissionBrief
from missiontree.mission.estimator_source import Estimated
from missiontree.mission.grounded import Grounding
from missiontree.mission.plan import Plan
from missiontree.mission.tree import MissionTree
from missiontree.routines.ground import ground


class Regrounding(NamedTuple):
    """
    What came of grounding a tree anew.

    Parameters
    ----------
    tree, brief, estimates
        What it was made of. The user's own estimator is not asked; what it said is read out.
    found
        The grounding, or why there is none.
    """

    tree: MissionTree
    brief: MissionBrief
    estimates: tuple[Estimated, ...]
    found: Grounding | str

    def is_of(self, plan: Plan) -> bool:
        """Whether it was made of these very values of a plan, and not only of equal ones, which would take long to compare."""
        grounding = plan.grounding
        return (
            plan.tree is self.tree
            and plan.brief is self.brief
            and grounding is not None
            and grounding.estimates is self.estimates
        )


def regrounding(tree: MissionTree, brief: MissionBrief, estimates: tuple[Estimated, ...]) -> Regrounding:
    """Ground a tree anew, however damaged it may be."""
    try:
        found: Grounding | str = ground(tree, brief, ReadingOut(estimates) if brief.estimator else None)
    except Exception as error:  # a damaged tree may break whatever grounding relies on
        found = str(error) or type(error).__name__
    return Regrounding(tree, brief, estimates, found)
