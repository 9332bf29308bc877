"""The pictures of an alternative."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.html.inlined import Picture, inlined
from missiontree.reporting.maps.view import map_svg
from missiontree.reporting.tree.view import tree_svg

FILLING = 1.6
"""A chart and a map gain from all the width there is; a tree is as large as its words."""
MOST_BRANCHES = 200
"""Nodes of a tree over the fleet that can be taken in at a glance."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """
    Pictures of an alternative; None where there is nothing to draw.

    Parameters
    ----------
    tree
        The mission tree, this alternative lit, routines folded; of a plan without one, the tree over the fleet.
    gantt
        The schedule.
    map
        Places and routes.
    branches
        The tree over the fleet, this alternative lit; None if it is too large to be taken in.
    """

    tree: Picture
    gantt: Picture | None
    map: Picture | None
    branches: Picture | None = None

    @property
    def all(self) -> tuple[Picture, ...]:
        """Those there are."""
        return tuple(one for one in (self.tree, self.gantt, self.map, self.branches) if one is not None)

    @property
    def size(self) -> int:
        """Characters of all of them."""
        return sum(len(one.svg) for one in self.all)


def drawn(plan: Plan, rank: int) -> Drawn:
    """Draw an alternative."""
    assert plan.grounding is not None
    scheduled = any(schedule.rank == rank and schedule.actions for schedule in plan.schedules)
    tree = tree_svg(plan.tree if plan.tree is not None else plan.grounding.tree, plan=plan, rank=rank)
    small = plan.tree is not None and len(plan.grounding.tree.nodes) <= MOST_BRANCHES
    branches = tree_svg(plan.grounding.tree, plan=plan, rank=rank) if small else None
    ground = map_svg(plan, rank)
    return Drawn(
        tree=inlined(tree, f"tree-{rank}"),
        gantt=inlined(gantt_svg(plan, rank), f"gantt-{rank}", FILLING) if scheduled else None,
        map=None if ground is None else inlined(ground, f"map-{rank}", FILLING),
        branches=None if branches is None else inlined(branches, f"branches-{rank}"),
    )
