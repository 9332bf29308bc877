"""``missiontree show``: a plan from a file, as a person wants to see it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import OUTCOMES
from missiontree.cli.lengths import show_length
from missiontree.cli.pictures import Asked, refuse_impossible, write_pictures
from missiontree.cli.ranks import as_chosen, known_rank, option_named, scheduled_rank
from missiontree.cli.screen import remark, show
from missiontree.cli.views import known_view, order_view, view_of
from missiontree.errors import InputError


def command(
    plan: Annotated[Path, typer.Argument(help="A plan file, as `missiontree plan --out` writes it.")],
    tree: Annotated[
        Path | None, typer.Option("--tree", metavar="FILE", help="Draw the mission tree into this .svg or .png file.")
    ] = None,
    gantt: Annotated[
        Path | None, typer.Option("--gantt", metavar="FILE", help="Draw the schedule into this .svg or .png file.")
    ] = None,
    map_file: Annotated[
        Path | None, typer.Option("--map", metavar="FILE", help="Draw the map into this .svg or .png file.")
    ] = None,
    report: Annotated[
        Path | None, typer.Option("--report", metavar="FILE", help="Write everything into this one .html file.")
    ] = None,
    front_plot: options.FrontPlot = None,
    option: Annotated[
        str | None,
        typer.Option(
            "--option",
            metavar="N",
            help="Show an option of the front, by its number, or the one that is chosen (--option chosen), in place of the alternatives.",
        ),
    ] = None,
    rank: Annotated[
        int | None,
        typer.Option(
            "--rank",
            metavar="N",
            help="Alternative to be shown. Default: what the objective chooses, else the best that has a schedule; in the tree, none.",
        ),
    ] = None,
    unfolded: Annotated[
        bool, typer.Option("--unfolded", help="Show the tree with every way to do it, by every robot type.")
    ] = False,
    view: Annotated[
        str,
        typer.Option(
            "--view", metavar="NAME", help="Print the plan (default), or its tree, schedule, map, team or order alone."
        ),
    ] = "plan",
    transcript: Annotated[bool, typer.Option("--transcript", help="Print the dialogue that built the tree.")] = False,
    order: Annotated[
        int | None,
        typer.Option("--order", metavar="RANK", help="Print the topological order of each robot in an alternative."),
    ] = None,
    why_so_long: Annotated[
        bool,
        typer.Option(
            "--why-so-long",
            help="Print why the schedule is as long as it is, and which robot would shorten it: it is scheduled anew with that robot.",
        ),
    ] = False,
    time_limit: Annotated[
        float,
        typer.Option(
            "--time-limit",
            metavar="SECONDS",
            help="Seconds that scheduling anew may take, with --why-so-long. Default 20.",
        ),
    ] = 20.0,
    as_json: options.AsJson = False,
    colour: options.Colour = None,
) -> int:
    """Show a plan."""
    from missiontree.formats.document import read_file, write_text

    asked = Asked(tree, gantt, map_file, report, front_plot, rank, unfolded)
    refuse_impossible(asked)
    if known_view(view) == "plan" and not asked.files and (rank is not None or unfolded):
        view = "tree" if unfolded else "schedule"
    value = read_file(plan, "plan")
    try:
        if option is not None:
            value = option_named(value, option)
        written = write_pictures(value, asked)
        if transcript:
            typer.echo("\n".join(value.provenance.transcript))
        elif why_so_long:
            asked_for = as_chosen(value, rank)
            show_length(asked_for, scheduled_rank(asked_for, rank, "--why-so-long"), time_limit, as_json, colour)
        elif order is not None:
            show(order_view(value, known_rank(value, order, "--order")), colour)
        elif as_json:
            typer.echo(write_text(value, "plan"), nl=False)
        else:
            show(view_of(value, view, rank, unfolded), colour)
    except InputError as error:
        if error.file:
            raise
        raise replace(error, file=str(plan)) from error
    for file in written:
        remark(f"written to {file}", colour)
    return OUTCOMES[value.outcome]
