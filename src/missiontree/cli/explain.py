"""``missiontree explain``: why a mission cannot be done, and the smallest changes that would make it possible."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from missiontree.cli import options
from missiontree.cli.asking import Asked, answer, tell
from missiontree.cli.exits import OUTCOMES
from missiontree.cli.files import refuse_unwritable
from missiontree.cli.gathering import author_named, budgets_from, gather
from missiontree.cli.interrupt import controlled
from missiontree.cli.plan import deliver
from missiontree.cli.screen import remark, show
from missiontree.cli.watching import authored
from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.authoring.outcome import Authored
    from missiontree.mission.explanation import Explanation
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
    k: options.Alternatives = None,
    model: options.Model = None,
    base_url: options.BaseUrl = None,
    replay: options.Replay = None,
    max_turns: options.MaxTurns = None,
    max_tokens: options.MaxTokens = None,
    max_seconds: options.MaxSeconds = None,
    kinds: options.Kinds = None,
    costs: Annotated[
        list[str] | None,
        typer.Option(
            "--cost",
            metavar="KIND=N",
            help="What a kind of change costs, as in add_robot=4 or add_robot.rover=1; may be given several times. "
            "Default: the mission file's costs, else those of the documentation.",
        ),
    ] = None,
    most: Annotated[
        int, typer.Option("--repairs", metavar="N", help="How many repairs are listed at most. Default 6.")
    ] = 6,
    repair: Annotated[
        int | None,
        typer.Option("--repair", metavar="N", help="Apply repair N to a copy, and show the plan that results."),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out", metavar="FILE", help="Write the plan of --repair, or of a question, to this file, as JSON."
        ),
    ] = None,
    why_not: Annotated[
        str | None,
        typer.Option(
            "--why-not",
            metavar="QUESTION",
            help="Ask of a plan why it is not otherwise: 'Tele-Robot for Search(cat)', 'Tele-Robot', or 'alternative 3'.",
        ),
    ] = None,
    why_not_robot: Annotated[
        str | None,
        typer.Option(
            "--why-not-robot", metavar="TYPE", help="Why does no robot of this type do it? With --for: that part."
        ),
    ] = None,
    for_part: Annotated[
        str | None, typer.Option("--for", metavar="PART", help="Of --why-not-robot: a part of the mission, by name.")
    ] = None,
    why_not_rank: Annotated[
        int | None,
        typer.Option("--why-not-rank", metavar="N", help="Why is alternative N not the first, and what does it lose?"),
    ] = None,
    time_limit: options.TimeLimit = None,
    seed: options.Seed = None,
    as_json: options.AsJson = False,
    quiet: options.Quiet = False,
    colour: options.Colour = None,
) -> int:
    """
    Say why a mission cannot be done and what would make it possible; a plan file may stand in the mission's place.

    Of a plan that is delivered: why it is not otherwise (--why-not), and what would change without a robot (--without).
    """
    from missiontree.explaining.explain import explained, request_of
    from missiontree.explaining.pricing import priced
    from missiontree.planner import plan_authored

    plan = plan_given(mission)
    asked = Asked(why_not, why_not_robot, for_part, why_not_rank, tuple(without or ()) if plan is not None else ())
    if plan is not None:
        refuse_beside_plan(
            fleet=fleet, scene=scene, routines=routines, methods=methods, sample=sample, weights=weights, require=require,
            min_quality=min_quality, estimator=estimator, accumulate=accumulate, diverse=diverse, replay=replay, kinds=kinds,
        )  # fmt: skip
    if out is not None and repair is None and not asked:
        raise InputError("--out is given without --repair", accepted="--repair N or --why-not, whose plan is written")
    if asked and repair is not None:
        raise InputError("--repair is given beside a question", accepted="one of them")
    if most < 1:
        raise InputError(f"--repairs {most}", accepted="a whole number of at least 1")
    refuse_unwritable(out)
    if plan is not None:
        request = request_of(plan)
    else:
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
            k=k,
            allocator=None,
            model=author_named(model, replay),
            base_url=base_url,
            budgets=budgets_from(max_turns, max_tokens, max_seconds),
            kinds=kinds,
            seed=seed,
        )
        if not (quiet or as_json):
            for source in request.sources:
                remark(f"using {source}", colour)
    request = replace(request, costs=priced(costs or (), request.costs))
    made = authored(request, quiet or as_json, colour) if plan is None else None
    if asked:
        with controlled(time_limit, request.seed) as control:
            known_plan = plan if plan is not None else plan_authored(request, _authored(made), control)
            told = answer(asked, known_plan, request, control)
        return tell(told, asked, out, as_json, colour)
    with controlled(time_limit, request.seed) as control:
        most = max(most, repair or 0)
        whole = plan if plan is not None else plan_authored(request, _authored(made), control)
        known = explained(whole, request, control, most)
        repaired = None if repair is None else known.repaired(repair, control)
    if repaired is None:
        show_explanation(known.told, as_json, colour)
        return OUTCOMES[known.told.outcome]
    deliver(repaired, out, None, as_json, quiet, colour, False)
    return OUTCOMES[repaired.outcome]


def _authored(made: Authored | None) -> Authored:
    assert made is not None, "a mission that is no plan was authored"
    return made


def refuse_beside_plan(**given: object) -> None:
    """
    Refuse inputs beside a plan, which carries its own.

    Raises
    ------
    InputError
        Naming the first of them.
    """
    for name, value in given.items():
        if value is not None:
            raise InputError(
                f"--{name.replace('_', '-')} is given beside a plan, which carries its inputs",
                accepted="the mission in place of its plan, or the plan alone",
            )


def plan_given(mission: str | None) -> Plan | None:
    """The plan that stands in the mission's place, if a file does that is one."""
    import json

    from missiontree.formats.document import read_file
    from missiontree.formats.source import load_text

    if mission is None or not mission.endswith(".json") or not Path(mission).is_file():
        return None
    try:
        head = json.loads(load_text(Path(mission)))
    except ValueError:
        return None  # whoever reads it as a mission says what is wrong with it
    if not isinstance(head, dict) or not str(head.get("format", "")).startswith("plan/"):
        return None
    plan: Plan = read_file(Path(mission), "plan")
    return plan


def show_explanation(told: Explanation, as_json: bool, colour: bool | None) -> None:
    """Print the explanation. As JSON it stands without the plans, which are as long as all else together."""
    from missiontree.formats.document import write_text
    from missiontree.reporting.explanation_view import explanation_view

    if as_json:
        repairs = tuple(replace(repair, plan=None) for repair in told.repairs)
        nearest = None if told.nearest is None else replace(told.nearest, plan=None)
        typer.echo(write_text(replace(told, plan=None, repairs=repairs, nearest=nearest), "explanation"), nl=False)
    else:
        show(explanation_view(told), colour)
