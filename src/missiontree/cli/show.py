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
    elif as_json:
        typer.echo(write_text(value, "plan"), nl=False)
    else:
        show(_view(plan, value), colour)
    return OUTCOMES[value.outcome]


def _view(path: Path, plan: Plan) -> RenderableType:
    from missiontree.reporting.text import plan_view

    try:
        return plan_view(plan)
    except InputError as error:
        raise replace(error, file=str(path)) from error
