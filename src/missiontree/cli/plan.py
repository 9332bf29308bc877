"""``missiontree plan``: a sentence, a mission file, or the folder one stands in, becomes a plan."""

from __future__ import annotations

import signal
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import OUTCOMES
from missiontree.cli.gathering import gather
from missiontree.cli.screen import answers, remarks
from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.mission.control import Control
    from missiontree.mission.plan import Plan


def command(
    mission: options.Mission = None,
    fleet: options.FleetFile = None,
    scene: options.SceneFile = None,
    routines: options.RoutineFiles = None,
    methods: options.MethodFiles = None,
    sample: options.Sample = None,
    weights: options.WeightsText = None,
    k: options.Alternatives = None,
    allocator: Annotated[
        str | None, typer.Option("--allocator", help="exact (default), pruned, pruned_as_printed or exhaustive.")
    ] = None,
    model: options.Model = None,
    kinds: options.Kinds = None,
    out: Annotated[Path | None, typer.Option("--out", help="Write the plan to this file, as JSON.")] = None,
    transcript: Annotated[
        Path | None,
        typer.Option("--transcript", help="Write the dialogue that built the tree to this file, as JSON lines."),
    ] = None,
    time_limit: options.TimeLimit = None,
    seed: options.Seed = None,
    as_json: options.AsJson = False,
    quiet: options.Quiet = False,
    colour: options.Colour = None,
) -> int:
    """Plan a mission."""
    request = gather(
        mission,
        sample,
        fleet=fleet,
        scene=scene,
        routines=routines,
        methods=methods,
        weights=weights,
        k=k,
        allocator=allocator,
        model=model,
        kinds=kinds,
        seed=seed,
    )
    from missiontree.planner import plan_request

    if not (quiet or as_json):
        for source in request.sources:
            remarks(colour).print(f"using {source}", style="dim", markup=False)
    plan = plan_request(request, control_of(time_limit, request.seed))
    deliver(plan, out, transcript, as_json, quiet, colour)
    return OUTCOMES[plan.outcome]


def control_of(time_limit: float | None, seed: int) -> Control:
    """Limits of this run; the first Ctrl-C asks long work to stop with what it has, the second interrupts."""
    from missiontree.mission.control import Control

    if time_limit is not None and not time_limit >= 0:
        raise InputError(f"--time-limit {time_limit}", accepted="a number of seconds of at least 0")
    asked: list[bool] = []

    def ask(signum: int, frame: object) -> None:
        asked.append(True)
        signal.signal(signal.SIGINT, signal.default_int_handler)

    signal.signal(signal.SIGINT, ask)
    return Control(time_limit_s=time_limit, stop=lambda: bool(asked), seed=seed)


def deliver(
    plan: Plan, out: Path | None, transcript: Path | None, as_json: bool, quiet: bool, colour: bool | None
) -> None:
    """Print the plan and write the files asked for."""
    from missiontree.formats.document import write_text

    if out is not None:
        save(out, write_text(plan, "plan"))
    if transcript is not None:
        save(transcript, "".join(f"{line}\n" for line in plan.provenance.transcript))
    if as_json:
        typer.echo(write_text(plan, "plan"), nl=False)
        return
    if not quiet or out is None:
        from missiontree.reporting.text import plan_view

        answers(colour).print(plan_view(plan))
    if out is not None and not quiet:
        remarks(colour).print(f"\nwritten to {out}", style="dim", markup=False)


def save(path: Path, text: str) -> None:
    """
    Write a file whole.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError("the file cannot be written", file=str(path), hint=error.strerror or str(error)) from error
