"""``missiontree schedule``: an instance from elsewhere, its choices and its times decided together."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.interrupt import controlled
from missiontree.cli.live import LiveLine
from missiontree.cli.pictures import Asked, refuse_impossible, write_pictures
from missiontree.cli.screen import remark, show
from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.instances import Instance
    from missiontree.mission.chain import WhySoLong
    from missiontree.mission.coalitions import CoalitionSchedule
    from missiontree.mission.control import Control
    from missiontree.mission.plan import Plan
    from missiontree.mission.tree_schedule import TreeSchedule

LIMIT_S = 60.0
MOST_EXPLAINED = 5_000
"""Scheduled actions above which it is not said in passing why a schedule takes so long."""
MOST_IN_A_HURRY = 2_000
"""Nodes of a tree above which it is not said after somebody said stop or a short limit: a quarter of a second for 15,000."""
SHORT_S = 10.0
MOST_ANEW_S = 20.0
"""What scheduling anew with more robots may take, if it is asked what would shorten a schedule."""


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
    gantt: Annotated[
        Path | None, typer.Option("--gantt", metavar="FILE", help="Draw the schedule into this .svg or .png file.")
    ] = None,
    why_so_long: Annotated[
        bool,
        typer.Option(
            "--why-so-long",
            help="Print the whole critical chain, and which robot would shorten it: it is scheduled anew with each, in 20 s more.",
        ),
    ] = False,
    seed: options.Seed = None,
    as_json: options.AsJson = False,
    colour: options.Colour = None,
) -> int:
    """Schedule an instance from elsewhere for the least makespan: which way, by whom, and when."""
    from time import perf_counter

    from missiontree.cli.schedule_view import Told, json_of, view_of
    from missiontree.instances import read_recognised, schedule_instance

    asked = Asked(gantt=gantt)
    refuse_impossible(asked)

    if not 0 <= bound_share <= 1:
        raise InputError(f"--bound-share {bound_share:g}", accepted="a share from 0 to 1")
    if solver and not _solver_there() and not as_json:
        remark("CP-SAT is not installed (pip install ortools), so it is not asked", colour)
    form, instance = read_recognised(file)
    started = perf_counter()
    line = LiveLine(as_json)
    with controlled(time_limit, seed or 0, line.report) as control:
        with line:
            asks = solver and _solver_there()
            schedule = schedule_instance(instance, control, solver=asks, bound_share=bound_share)
        elapsed = perf_counter() - started
        hurried = control.stop() or (time_limit < SHORT_S and control.ended())
        asked_for = gantt is not None or why_so_long
        plan = _as_plan(instance, schedule, file.name, asked_for=asked_for, hurried=hurried)
        why = _length(plan, instance, control, time_limit, solver=asks) if plan is not None and why_so_long else None
        told = Told(form, instance, schedule, file.name, seed or 0, time_limit, elapsed, plan, why)
        if as_json:
            typer.echo(json_of(told), nl=False)
        else:
            show(view_of(told), colour)
        if plan is None and gantt is not None:
            remark("nothing is scheduled, so nothing is drawn", colour)
        for drawn in write_pictures(plan, asked) if plan is not None else ():
            remark(f"written to {drawn}", colour)
    return Exit.CANNOT_BE_DONE if schedule.status == "infeasible" else Exit.DELIVERED


def _length(plan: Plan, instance: Instance, control: Control, time_limit_s: float, *, solver: bool) -> WhySoLong:
    """Why it is so long, and what would shorten it, which may take as long again, and 20 s at most."""
    from missiontree.explaining.instance_length import instance_length
    from missiontree.mission.control import Control

    again = Control(time_limit_s=min(time_limit_s, MOST_ANEW_S), stop=control.stop, seed=control.seed)
    return instance_length(plan, instance, again, solver=solver)


def _as_plan(
    instance: Instance, schedule: TreeSchedule | CoalitionSchedule, title: str, *, asked_for: bool, hurried: bool
) -> Plan | None:
    """The schedule as a plan, if it is asked for, or small enough to be looked at in passing; large trees in a hurry are not."""
    from missiontree.instances import plan_of_instance
    from missiontree.mission.columns import TreeColumns
    from missiontree.mission.tree_schedule import TreeSchedule

    if schedule.status not in {"optimal", "feasible"}:
        return None
    many = schedule.start_s if isinstance(schedule, TreeSchedule) else schedule.visits
    too_long = hurried and isinstance(instance, TreeColumns) and len(instance.kind) > MOST_IN_A_HURRY
    explained = len(many) <= MOST_EXPLAINED and not too_long
    return plan_of_instance(instance, schedule, title) if asked_for or explained else None


def _solver_there() -> bool:
    from importlib.util import find_spec

    return find_spec("ortools") is not None
