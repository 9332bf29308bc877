"""``missiontree schedule``: an instance from elsewhere, its choices and its times decided together."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.interrupt import controlled
from missiontree.cli.rank import seldom_collected
from missiontree.cli.screen import remark, show
from missiontree.errors import InputError

LIMIT_S = 60.0


def command(
    file: Annotated[
        Path,
        typer.Argument(help="A flexible job shop (text), a mission of coalitions (JSON) or a tree in columns (JSON)."),
    ],
    time_limit: Annotated[
        float, typer.Option("--time-limit", metavar="SECONDS", help="Seconds that it may take. Default 60.")
    ] = LIMIT_S,
    solver: Annotated[
        bool, typer.Option("--solver/--no-solver", help="Ask CP-SAT where bounds and search leave a gap. Default yes.")
    ] = True,
    bound_share: Annotated[
        float,
        typer.Option(
            "--bound-share", metavar="SHARE", help="Of CP-SAT's time, from 0 to 1: for raising the bound. Default 0."
        ),
    ] = 0.0,
    seed: options.Seed = None,
    as_json: options.AsJson = False,
    colour: options.Colour = None,
) -> int:
    """Schedule an instance from elsewhere for the least makespan: which way, by whom, and when."""
    from time import perf_counter

    from missiontree.cli.schedule_view import Told, json_of, view_of
    from missiontree.instances import read_instance, schedule_instance

    if not 0 <= bound_share <= 1:
        raise InputError(f"--bound-share {bound_share:g}", accepted="a share from 0 to 1")
    if solver and not _solver_there() and not as_json:
        remark("CP-SAT is not installed (pip install ortools), so it is not asked", colour)
    with seldom_collected():
        instance = read_instance(file)
        started = perf_counter()
        with controlled(time_limit, seed or 0) as control:
            schedule = schedule_instance(instance, control, solver=solver and _solver_there(), bound_share=bound_share)
            told = Told(instance, schedule, file.name, seed or 0, time_limit, perf_counter() - started)
            if as_json:
                typer.echo(json_of(told), nl=False)
            else:
                show(view_of(told), colour)
    return Exit.CANNOT_BE_DONE if schedule.status == "infeasible" else Exit.DELIVERED


def _solver_there() -> bool:
    from importlib.util import find_spec

    return find_spec("ortools") is not None
