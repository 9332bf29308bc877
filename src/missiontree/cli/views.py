"""What ``missiontree show`` prints: the whole plan, or one of its pictures as characters."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

from missiontree.cli.ranks import as_chosen, best_rank, known_rank, nothing, scheduled_rank
from missiontree.cli.screen import PIPE_WIDTH
from missiontree.errors import InputError

if TYPE_CHECKING:
    from rich.console import RenderableType

    from missiontree.mission.plan import Plan

VIEWS = ("plan", "tree", "schedule", "map", "team", "order")


def known_view(name: str) -> str:
    """
    The view, if there is one of that name.

    Raises
    ------
    InputError
        With those there are.
    """
    if name not in VIEWS:
        raise InputError(f"--view {name}", accepted=", ".join(VIEWS))
    return name


def view_of(plan: Plan, name: str, rank: int | None, unfolded: bool) -> RenderableType:
    """
    A view of a plan for the terminal.

    Parameters
    ----------
    plan
        The plan.
    name
        One of ``VIEWS``.
    rank
        Rank of the alternative that is shown. None: what the objective chooses, else the best that has a schedule; in the tree none.
    unfolded
        Whether the tree is that of all ways to do it, by every robot type.

    Raises
    ------
    InputError
        If the plan lacks what is to be shown, or points at nodes or roles that it does not hold.
    """
    from missiontree.reporting.references import refuse_dangling

    refuse_dangling(plan)
    if rank is not None:
        known_rank(plan, rank, "--rank")
    shown = as_chosen(plan, rank)
    views: dict[str, Callable[[], RenderableType]] = {
        "plan": lambda: _plan(plan),
        "tree": lambda: _tree(plan, rank, unfolded),
        "schedule": lambda: _schedule(shown, scheduled_rank(shown, rank, "--view schedule")),
        "map": lambda: _map(shown, rank),
        "team": lambda: _team(plan),
        "order": lambda: order_view(shown, scheduled_rank(shown, rank, "--view order")),
    }
    return views[name]()


def order_view(plan: Plan, rank: int) -> RenderableType:
    """Each robot's actions in a topological order, as the paper gives them (section III-C): no clock, only what comes before what."""
    from missiontree.reporting.text import orders_view
    from missiontree.scheduling.precedence import order_by_robot, task_graph

    assert plan.ranking is not None
    assert plan.grounding is not None
    tree, alternative = plan.grounding.tree, plan.ranking.alternatives[rank - 1]
    assigned = next((one.assignments for one in plan.schedules if one.rank == rank), ()) or alternative.witness
    robots = {filled.role: filled.robot_type for filled in alternative.roles}
    robots |= {filled.role: filled.robot for filled in assigned}
    return orders_view(tree, order_by_robot(task_graph(tree, alternative.choices), robots))


def _plan(plan: Plan) -> RenderableType:
    from missiontree.reporting.text import plan_view

    return plan_view(plan)


def _tree(plan: Plan, rank: int | None, unfolded: bool) -> RenderableType:
    from rich.text import Text

    from missiontree.reporting.tree.view import tree_text

    tree = plan.grounding.tree if unfolded and plan.grounding is not None else plan.tree
    if tree is None or (unfolded and plan.grounding is None):
        raise nothing("--view tree", "no tree over the fleet" if unfolded else "no tree")
    return Text(tree_text(tree, plan=plan, rank=rank).rstrip())


def _schedule(plan: Plan, rank: int) -> RenderableType:
    from rich.console import Group
    from rich.text import Text

    from missiontree.reporting.called import called
    from missiontree.reporting.gantt.time import in_words
    from missiontree.reporting.team.lines import team_lines
    from missiontree.reporting.text import words
    from missiontree.reporting.timeline.view import timeline

    assert plan.ranking is not None
    assert plan.grounding is not None
    alternative = plan.ranking.alternatives[rank - 1]
    schedule = next(one for one in plan.schedules if one.rank == rank)
    title = f"{called(plan, rank).capitalize()}: utility {alternative.utility:g}, {in_words(schedule.makespan_s)}"
    team = (words(line) for line in team_lines(plan.grounding.tree, alternative, plan))
    return Group(Text(title, style="bold"), *team, Text(""), timeline(schedule, plan))


def _map(plan: Plan, rank: int | None) -> RenderableType:
    from missiontree.reporting.maps.text import map_view

    width = shutil.get_terminal_size((PIPE_WIDTH, 24)).columns if sys.stdout.isatty() else PIPE_WIDTH
    found = map_view(plan, rank if rank is not None else best_rank(plan), width)
    if found is None:
        raise nothing("--view map", "nothing with a position")
    return found


def _team(plan: Plan) -> RenderableType:
    from missiontree.reporting.team.table import team_table

    found = team_table(plan)
    if found is None:
        raise nothing("--view team", "no alternatives")
    return found
