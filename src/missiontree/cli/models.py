"""``missiontree models``: which models this machine can use, each of them tried."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.screen import show

if TYPE_CHECKING:
    from rich.table import Table

    from missiontree.llm.trying import Tried, TriedModel

MARKS = {"ready": ("✓", "green"), "lacking": ("-", "dim"), "failed": ("✗", "red")}
MOST_SHOWN = 12


def command(
    model: Annotated[
        str | None,
        typer.Option(
            "--model",
            metavar="MODEL",
            help="Ask this one model to call a function, and say what its endpoint supports.",
        ),
    ] = None,
    base_url: options.BaseUrl = None,
    as_json: options.AsJson = False,
    colour: options.Colour = None,
) -> int:
    """List the models that can be used here, and try each: providers are asked for their lists, one model to call a function."""
    from missiontree.llm.feature_memory import usual_path
    from missiontree.llm.opening import Settings
    from missiontree.llm.patience import Patience
    from missiontree.llm.trying import try_model, try_providers

    settings = Settings(base_url=base_url or "", memory=usual_path(), patience=Patience(attempts=1))
    if model is not None:
        return _tell_one(try_model(model, settings), as_json, colour)
    tried = list(try_providers(settings))
    if as_json:
        typer.echo(json.dumps([asdict(one) for one in tried], indent=2))
    else:
        show(_table(tried), colour)
    return Exit.DELIVERED


def _table(tried: list[Tried]) -> Table:
    from rich.table import Table
    from rich.text import Text

    from missiontree.reporting.text import words

    table = Table(box=None, padding=(0, 2, 0, 0), show_header=False)
    for one in tried:
        mark, style = MARKS[one.state]
        names = ", ".join(one.models[:MOST_SHOWN])
        more = f" and {len(one.models) - MOST_SHOWN} more" if len(one.models) > MOST_SHOWN else ""
        table.add_row(
            Text(mark, style=style), words(one.name), words(one.says + (f". Models: {names}{more}" if names else ""))
        )
    return table


def _tell_one(tried: TriedModel, as_json: bool, colour: bool | None) -> int:
    from rich.padding import Padding

    from missiontree.reporting.text import words

    if as_json:
        features = asdict(tried.features) if tried.features is not None else None
        plain = asdict(tried) | {"features": features, "fault": str(tried.fault) if tried.fault else None}
        typer.echo(json.dumps(plain, indent=2))
    else:
        for line in lines(tried):
            show(Padding(words(line.lstrip()), (0, 0, 0, len(line) - len(line.lstrip()))), colour)
    return Exit.DELIVERED if tried.calls else Exit.FAILED


def lines(tried: TriedModel) -> list[str]:
    """What came of asking a model, in words."""
    if tried.fault is not None:
        return [f"✗ {tried.name}: {tried.fault}", *([f"  {tried.fault.hint}"] if tried.fault.hint else [])]
    if not tried.calls:
        return [f"✗ {tried.name} answers, but calls no function when it is asked to; it is of no use here."]
    told = [f"✓ {tried.name} calls functions."]
    if tried.calls_together is not None:
        told.append(
            "  several calls in one answer: " + ("yes" if tried.calls_together else "no; a dialogue takes more turns")
        )
    if tried.features is not None:
        left = ", ".join(name.replace("_", " ") for name in tried.features.missing)
        told.append(f"  left out from now on, since its endpoint does not support it: {left or 'nothing'}")
    if tried.usage is not None:
        told.append(f"  asking took {tried.usage.input_tokens} + {tried.usage.output_tokens} tokens")
    return told
