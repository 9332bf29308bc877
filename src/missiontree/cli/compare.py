"""``missiontree compare``: every allocator on one mission, and what each of them lost."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, NamedTuple

import typer

from missiontree.cli import options
from missiontree.cli.exits import OUTCOMES, Exit
from missiontree.cli.gathering import author_named, gather
from missiontree.cli.interrupt import controlled
from missiontree.cli.losses import loss_of, utilities_shown
from missiontree.cli.screen import show
from missiontree.cli.watching import authored as watched

if TYPE_CHECKING:
    from rich.table import Table

    from missiontree.mission.alternative import Ranking

DEFAULT_LIMIT_S = 30.0
COLUMNS = ("allocator", "found", "utilities", "status", "lost", "best loss", "examined", "time")
TEXTS = {"allocator", "utilities", "status", "lost"}


class Run(NamedTuple):
    """One allocator's answer."""

    allocator: str
    ranking: Ranking
    elapsed_s: float


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
    kinds: options.Kinds = None,
    time_limit: options.TimeLimit = None,
    seed: options.Seed = None,
    as_json: options.AsJson = False,
    colour: options.Colour = None,
) -> int:
    """Rank one mission's alternatives with every allocator: what each finds, what it loses of the best, how long it takes."""
    import json

    from rich.text import Text

    from missiontree.allocation.aimed import allocators_for
    from missiontree.allocation.flat import flatten
    from missiontree.formats.document import to_plain
    from missiontree.reporting.text import reason_line, said_once
    from missiontree.routines.ground import ground

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
        kinds=kinds,
        seed=seed,
    )
    authored = watched(request, as_json, colour)
    if authored.status != "complete" or authored.tree is None:
        outcome = authored.status if authored.status != "complete" else "incomplete"
        if as_json:
            reasons = [to_plain(reason) for reason in authored.reasons]
            typer.echo(json.dumps({"outcome": outcome, "reasons": reasons}, indent=2))
        else:
            for reason in said_once(authored.reasons):
                show(reason_line(reason), colour)
        return OUTCOMES[outcome]
    brief = request.brief
    flat = flatten(ground(authored.tree, brief, request.estimator).tree, brief.fleet, brief.weights, brief.terms)
    runs = []
    for name, allocate in allocators_for(brief.aim).items():
        started = time.perf_counter()
        with controlled(DEFAULT_LIMIT_S if time_limit is None else time_limit, request.seed) as control:
            ranking = allocate(flat, brief.fleet, brief.weights, request.k, control)
        runs.append(Run(name, ranking, time.perf_counter() - started))
    if as_json:
        typer.echo(json.dumps([_plain(run, runs, request.k) for run in runs], indent=2))
    else:
        show(_table(runs, request.k), colour)
        for run in runs:
            for reason in run.ranking.reasons[:3]:
                show(Text(f"{run.allocator}: ").append_text(reason_line(reason)), colour)
    return Exit.DELIVERED if runs[0].ranking.alternatives else Exit.CANNOT_BE_DONE


def _table(runs: list[Run], k: int) -> Table:
    from rich.table import Table

    rankings = [run.ranking for run in runs]
    losses = [loss_of(ranking, rankings, k) for ranking in rankings]
    columns = [name for name in COLUMNS if name != "best loss" or any(loss.lost for loss in losses)]
    table = Table(box=None, padding=(0, 2, 0, 0), header_style="dim")
    for name in columns:
        table.add_column(name, justify="left" if name in TEXTS else "right", no_wrap=name == "allocator")
    for run, loss in zip(runs, losses, strict=True):
        cells = {
            "allocator": run.allocator,
            "found": str(len(run.ranking.alternatives)),
            "utilities": utilities_shown(run.ranking.alternatives),
            "status": run.ranking.status,
            "lost": f"{len(loss.lost)}: {utilities_shown(loss.lost)}" if loss.lost else "0",
            "best loss": loss.shown,
            "examined": str(run.ranking.examined),
            "time": f"{run.elapsed_s * 1000:.1f} ms",
        }
        table.add_row(*(cells[name] for name in columns))
    return table


def _plain(run: Run, runs: list[Run], k: int) -> dict[str, object]:
    loss = loss_of(run.ranking, [other.ranking for other in runs], k)
    return {
        "allocator": run.allocator,
        "status": run.ranking.status,
        "utilities": [alternative.utility for alternative in run.ranking.alternatives],
        "lost": [alternative.utility for alternative in loss.lost],
        "best_loss": loss.best_loss,
        "examined": run.ranking.examined,
        "time_s": round(run.elapsed_s, 6),
    }
