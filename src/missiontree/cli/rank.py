"""``missiontree rank``: the k best ways to staff a tree that is already there, and what is proven of them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.interrupt import controlled
from missiontree.cli.screen import remark, show
from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.allocation.flat import Flat
    from missiontree.mission.aim import Accumulate, Aim
    from missiontree.mission.alternative import Ranking
    from missiontree.mission.estimate import Weights
    from missiontree.mission.fleet import Fleet


class Problem(NamedTuple):
    """
    A tree, ready to be ranked.

    Parameters
    ----------
    flat
        The tree over its robots, in the form that allocators work on.
    fleet, weights
        The robots, and what makes utility.
    not_kept
        What the file asks for and this ranking does not keep; empty if nothing.
    aim
        What the file asks of the best.
    """

    flat: Flat
    fleet: Fleet
    weights: Weights
    not_kept: str
    aim: Aim


def command(
    file: Annotated[
        Path, typer.Argument(help="A tree in columns (JSON), or a plan as `missiontree plan --out` writes it.")
    ],
    k: Annotated[int, typer.Option("--k", "-k", "--alternatives", metavar="K", help="How many alternatives.")] = 10,
    allocator: Annotated[
        str, typer.Option("--allocator", metavar="NAME", help="exact, pruned, pruned_as_printed or exhaustive.")
    ] = "exact",
    no_budgets: Annotated[bool, typer.Option("--no-budgets", help="Rank as if no budget limited the robots.")] = False,
    accumulate: options.AccumulateText = None,
    diverse: options.DiverseFlag = None,
    disjoint: Annotated[
        bool,
        typer.Option("--disjoint", help="Keep what a tree in columns says of disjoint robots; else it is left out."),
    ] = False,
    time_limit: Annotated[
        float | None, typer.Option("--time-limit", metavar="SECONDS", help="Seconds that ranking may take.")
    ] = None,
    seed: options.Seed = None,
    as_json: options.AsJson = False,
    colour: options.Colour = None,
) -> int:
    """Rank the ways to staff a tree that is already there: the k best, and what is proven of them."""
    from time import perf_counter

    from missiontree.allocation.aimed import allocator_for
    from missiontree.cli.gathering import accumulate_named
    from missiontree.cli.rank_view import Told, json_of, view_of

    if k < 1:
        raise InputError(f"--k {k}", accepted="a whole number of at least 1")
    how = accumulate_named(accumulate)
    problem = _problem(file, budgets=not no_budgets, disjoint=disjoint)
    if problem.not_kept and not as_json:
        remark(problem.not_kept, colour)
    aim = aimed(problem.aim, how, diverse)
    allocate = allocator_for(allocator, aim)
    started = perf_counter()
    with controlled(time_limit, seed or 0) as control:
        ranking = allocate(problem.flat, problem.fleet, problem.weights, k, control)
        if ranking.status == "unknown" and control.stop():
            raise KeyboardInterrupt
        elapsed_s = perf_counter() - started
        told = Told(problem.flat, ranking, allocator, k, seed or 0, time_limit, elapsed_s, problem.not_kept, aim)
        if as_json:
            typer.echo(json_of(told), nl=False)
        else:
            show(view_of(told), colour)
    return _exit(ranking)


def aimed(aim: Aim, accumulate: Accumulate | None, diverse: bool | None) -> Aim:
    """An aim, changed as far as something else is asked for."""
    return replace(
        aim,
        accumulate=aim.accumulate if accumulate is None else accumulate,
        diverse=aim.diverse if diverse is None else diverse,
    )


def _exit(ranking: Ranking) -> Exit:
    if ranking.alternatives:
        return Exit.DELIVERED
    return Exit.CANNOT_BE_DONE if ranking.status == "infeasible" else Exit.EXHAUSTED


def _problem(file: Path, *, budgets: bool, disjoint: bool) -> Problem:
    from missiontree.formats.importers.tree_json import looks_like_tree
    from missiontree.formats.reader import parse
    from missiontree.formats.source import load_text

    text = load_text(file)
    parsed = parse(text, str(file))
    if not looks_like_tree(parsed.data):
        if disjoint:
            raise InputError("--disjoint: this file is not a tree in columns", file=str(file))
        return _of_plan(text, str(file), budgets=budgets)
    from missiontree.allocation.columns import flat_of_columns
    from missiontree.formats.importers.tree_grounded import fleet_of
    from missiontree.formats.importers.tree_json import columns_of
    from missiontree.mission.aim import PLAIN_AIM
    from missiontree.mission.columns import WEIGHTS

    columns = columns_of(parsed)
    if columns.count is not None:
        raise parsed.refusal(
            "ranking takes trees of single robots", ("count",), "no count; `missiontree schedule` keeps it"
        )
    flat = flat_of_columns(columns, budgets=budgets, disjoint=disjoint)
    count = len(columns.disjoint)
    named = f"what the file says of disjoint robots, at {count} AND{'s' if count > 1 else ''}"
    not_kept = f"not kept: {named} (--disjoint keeps it)" if count and not disjoint else ""
    return Problem(flat, fleet_of(columns, budgets=budgets), WEIGHTS, not_kept, PLAIN_AIM)


def _of_plan(text: str, source: str, *, budgets: bool) -> Problem:
    from missiontree.allocation.flat import flatten, without_budgets
    from missiontree.formats.document import read_text

    plan = read_text(text, "plan", source)
    if plan.grounding is None:
        raise InputError("the plan holds no grounded tree, so there is nothing to rank", file=source, where="grounding")
    flat = flatten(plan.grounding.tree, plan.brief.fleet, plan.brief.weights, plan.brief.terms)
    return Problem(flat if budgets else without_budgets(flat), plan.brief.fleet, plan.brief.weights, "", plan.brief.aim)
