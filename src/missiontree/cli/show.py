"""``missiontree show``: a plan from a file, as a person wants to see it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import OUTCOMES
from missiontree.cli.plan import save
from missiontree.cli.screen import show
from missiontree.errors import InputError

if TYPE_CHECKING:
    from rich.console import RenderableType

    from missiontree.mission.plan import Plan


def command(
    plan: Annotated[Path, typer.Argument(help="A plan file, as `missiontree plan --out` writes it.")],
    tree: Annotated[
        Path | None, typer.Option("--tree", metavar="FILE", help="Draw the mission tree into this SVG file.")
    ] = None,
    transcript: Annotated[bool, typer.Option("--transcript", help="Print the dialogue that built the tree.")] = False,
    order: Annotated[
        int | None,
        typer.Option("--order", metavar="RANK", help="Print the topological order of each robot in an alternative."),
    ] = None,
    as_json: options.AsJson = False,
    colour: options.Colour = None,
) -> int:
    """Show a plan."""
    from missiontree.formats.document import read_file, write_text

    value = read_file(plan, "plan")
    if tree is not None and value.tree is not None:
        from missiontree.reporting.tree_view import tree_svg

        save(tree, tree_svg(value.tree))
    if transcript:
        typer.echo("\n".join(value.provenance.transcript))
    elif order is not None:
        show(_order(value, order), colour)
    elif as_json:
        typer.echo(write_text(value, "plan"), nl=False)
    else:
        show(_view(plan, value), colour)
    return OUTCOMES[value.outcome]


def _order(plan: Plan, rank: int) -> RenderableType:
    """Each robot's actions in a topological order, as the paper gives them (section III-C): no clock, only what comes before what."""
    from missiontree.reporting.text import orders_view
    from missiontree.scheduling.precedence import order_by_robot, task_graph

    alternatives = plan.ranking.alternatives if plan.ranking else ()
    if plan.grounding is None or not 1 <= rank <= len(alternatives):
        ranks = f"1 to {len(alternatives)}" if alternatives else "the plan has no alternatives"
        raise InputError(f"--order {rank}", accepted=ranks)
    tree, alternative = plan.grounding.tree, alternatives[rank - 1]
    assigned = next((one.assignments for one in plan.schedules if one.rank == rank), ()) or alternative.witness
    robots = {filled.role: filled.robot_type for filled in alternative.roles}
    robots |= {filled.role: filled.robot for filled in assigned}
    return orders_view(tree, order_by_robot(task_graph(tree, alternative.choices), robots))


def _view(path: Path, plan: Plan) -> RenderableType:
    from missiontree.reporting.text import plan_view

    try:
        return plan_view(plan)
    except InputError as error:
        raise replace(error, file=str(path)) from error
