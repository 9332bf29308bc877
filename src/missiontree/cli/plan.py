"""``missiontree plan``: a sentence, a mission file, or the folder one stands in, becomes a plan."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import OUTCOMES
from missiontree.cli.files import refuse_clashing, refuse_unwritable, save
from missiontree.cli.gathering import author_named, budgets_from, gather
from missiontree.cli.interrupt import Kept, controlled
from missiontree.cli.live import LiveLine
from missiontree.cli.pictures import Asked, refuse_impossible, write_pictures
from missiontree.cli.screen import remark, show
from missiontree.cli.watching import authored, hint_at_keys

if TYPE_CHECKING:
    from missiontree.authoring.outcome import Authored
    from missiontree.briefing import Request
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
    without: options.Without = None,
    require: options.Require = None,
    min_quality: options.MinQualityText = None,
    estimator: options.EstimatorFile = None,
    accumulate: options.AccumulateText = None,
    diverse: options.DiverseFlag = None,
    partial: Annotated[
        bool,
        typer.Option(
            "--partial",
            help="Where the mission cannot be done, plan the largest part of it that can; exit code 1 all the same.",
        ),
    ] = False,
    part: options.PartWeights = None,
    return_home: options.ReturnHomeFlag = None,
    objective: options.ObjectiveText = None,
    front: Annotated[
        bool,
        typer.Option("--front", help="Seek plans from the best staffed to the fastest, none of them beaten in both."),
    ] = False,
    k: options.Alternatives = None,
    allocator: Annotated[
        str | None,
        typer.Option("--allocator", metavar="NAME", help="exact (default), pruned, pruned_as_printed or exhaustive."),
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option(
            "--scheduler",
            metavar="NAME",
            help="greedy: at once; cpsat: as short as possible, proven where it can be; auto: greedy, then cpsat where that is "
            "quick. Default: greedy; auto with --front, or an objective that looks at schedules.",
        ),
    ] = None,
    model: options.Model = None,
    base_url: options.BaseUrl = None,
    replay: options.Replay = None,
    record: Annotated[
        Path | None,
        typer.Option(
            "--record", metavar="FILE", help="Write the dialogue that built the tree to this file, as JSON lines."
        ),
    ] = None,
    max_turns: options.MaxTurns = None,
    max_tokens: options.MaxTokens = None,
    max_seconds: options.MaxSeconds = None,
    kinds: options.Kinds = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out", metavar="FILE", help="Write the plan to this file, as JSON; with --quiet nothing is printed then."
        ),
    ] = None,
    report: Annotated[
        Path | None,
        typer.Option("--report", metavar="FILE", help="Write all there is to see into this one .html file."),
    ] = None,
    front_plot: options.FrontPlot = None,
    explain_reading: Annotated[
        bool,
        typer.Option(
            "--explain-reading",
            help="Show how the words were read, instead of the plan: clauses, methods, who is meant, order, assumptions.",
        ),
    ] = False,
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
        without=without,
        require=require,
        min_quality=min_quality,
        estimator=estimator,
        accumulate=accumulate,
        diverse=diverse,
        return_home=return_home,
        objective=objective,
        front=front or front_plot is not None,
        k=k,
        allocator=allocator,
        scheduler=scheduler,
        model=author_named(model, replay),
        base_url=base_url,
        budgets=budgets_from(max_turns, max_tokens, max_seconds),
        kinds=kinds,
        seed=seed,
        parts=part,
    )
    for file in (out, record):
        refuse_unwritable(file)
    refuse_clashing({"--out": out, "--record": record, "--report": report, "--front-plot": front_plot})
    asked = Asked(report=report, front_plot=front_plot)
    refuse_impossible(asked)
    from missiontree.planner import check_methods, plan_authored

    check_methods(request)
    if not (quiet or as_json):
        for source in request.sources:
            remark(f"using {source}", colour)
        hint_at_keys(request, colour)
    made = authored(request, quiet or as_json, colour)
    _refuse_other_parts(request, made)
    line = LiveLine(quiet or as_json)
    kept = Kept("scheduling")
    with controlled(time_limit, request.seed, line.report, kept) as control:
        with line:
            plan = plan_authored(request, made, control)
        kept.anything = True
        if plan.outcome == "exhausted" and control.stop():
            raise KeyboardInterrupt
        whole = plan
        if partial and plan.outcome in {"cannot_be_done", "exhausted"}:
            plan = _in_part(plan, request, made, control, quiet or as_json, colour)
        deliver(plan, out, record, as_json, quiet, colour, explain_reading)
        if not (quiet or as_json or explain_reading):
            hint_at_repairs(whole, plan is not whole, request, control, colour)
        if front_plot is not None and plan.front is None:
            remark("there is no front to be drawn", colour)
            asked = replace(asked, front_plot=None)
        for file in write_pictures(plan, asked):
            if not (quiet or as_json):
                remark(f"written to {file}", colour)
    return OUTCOMES[plan.outcome]


def _refuse_other_parts(request: Request, made: Authored) -> None:
    """Weights of what is no part of the mission, also where the whole mission can be done and they play no part."""
    from missiontree.explaining.weighing import weights_of

    if made.status == "complete" and made.tree is not None and request.brief.parts:
        weights_of(made.tree, request.brief.parts)


def _in_part(whole: Plan, request: Request, made: Authored, control: Control, quiet: bool, colour: bool | None) -> Plan:
    """The plan for the largest part of a mission that can be done; the plan as it is if there is none."""
    from missiontree.explaining.nearest import nearest_part

    found = nearest_part(whole, request, made, control)
    if found is None and not quiet:
        remark("no part of the mission that can be done was found", colour)
    return found or whole


def hint_at_repairs(whole: Plan, in_part: bool, request: Request, control: Control, colour: bool | None) -> None:
    """Of a mission that cannot be done: the best change that would make it possible, and where to see more."""
    from missiontree.explaining.explain import explained
    from missiontree.explaining.of_plan import worth_explaining
    from missiontree.reporting.explanation_view import hint_view

    if worth_explaining(whole):
        told = explained(whole, request, control, 1).told
        view = hint_view(replace(told, nearest=None) if in_part else told)
        if view.renderables:
            show(view, colour)


def deliver(
    plan: Plan,
    out: Path | None,
    record: Path | None,
    as_json: bool,
    quiet: bool,
    colour: bool | None,
    explain_reading: bool,
) -> None:
    """Print the plan and write the files asked for."""
    from missiontree.formats.document import write_text

    if out is not None:
        save(out, write_text(plan, "plan"))
    if record is not None:
        save(record, "".join(f"{line}\n" for line in plan.provenance.transcript))
    if as_json:
        typer.echo(write_text(plan, "plan"), nl=False)
        return
    if explain_reading:
        from missiontree.reporting.reading_view import reading_view

        show(reading_view(plan), colour)
    elif not quiet or out is None:
        from missiontree.reporting.text import plan_view

        show(plan_view(plan), colour)
    if out is not None and not quiet:
        remark(f"written to {out}", colour)
