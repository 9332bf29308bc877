"""``missiontree check``: does a plan from anywhere keep every rule?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.screen import say, show


def command(
    plan: Annotated[
        Path, typer.Argument(help="A plan file; with --instance, a schedule as schedule --json prints it.")
    ],
    instance: Annotated[
        Path | None,
        typer.Option("--instance", metavar="FILE", help="The instance from elsewhere that it is a schedule of."),
    ] = None,
    as_json: options.AsJson = False,
    colour: options.Colour = None,
) -> int:
    """Check a plan against the inputs it carries, by two checkers that share nothing with the solvers, nor with each other."""
    from missiontree.checking import check, taken_on_trust
    from missiontree.formats.document import read_file, to_plain
    from missiontree.reporting.text import findings_view

    if instance is not None:
        return _check_schedule(plan, instance, as_json, colour)
    value = read_file(plan, "plan")
    findings = check(value)
    trusted = taken_on_trust(value) if not findings else ()
    if as_json:
        _tell([to_plain(finding) for finding in findings], [to_plain(claim) for claim in trusted])
    elif findings:
        _count(len(findings), plan, colour)
        show(findings_view(findings), colour)
    else:
        say(f"sound: {plan} keeps every rule", "green", colour)
        for claim in trusted:
            say(f"not confirmed: {claim.message}", "yellow", colour)
    return Exit.FAULTS if findings else Exit.DELIVERED


def _check_schedule(file: Path, instance_file: Path, as_json: bool, colour: bool | None) -> int:
    """The same of a schedule of an instance from elsewhere."""
    from missiontree.instances import check_schedule, read_instance, read_schedule

    instance = read_instance(instance_file)
    schedule = read_schedule(file, instance)
    faults = check_schedule(instance, schedule)
    bound = schedule.certificate.bound
    trusted = [] if faults or bound is None else [f"none is shorter than {bound:g} s ({schedule.certificate.method})"]
    if as_json:
        _tell([fault._asdict() for fault in faults], [{"message": claim} for claim in trusted])
    elif faults:
        _count(len(faults), file, colour)
        for fault in faults:
            say(f"  {fault.message}", "", colour)
    else:
        say(f"sound: {file} keeps every rule of {instance_file}", "green", colour)
        for claim in trusted:
            say(f"not confirmed: {claim}", "yellow", colour)
    return Exit.FAULTS if faults else Exit.DELIVERED


def _tell(findings: list[Any], trusted: list[Any]) -> None:
    import json

    told = {"sound": not findings, "findings": findings, "taken_on_trust": trusted}
    typer.echo(json.dumps(told, indent=2))


def _count(count: int, file: Path, colour: bool | None) -> None:
    say(f"{count} fault{'s' if count != 1 else ''} found in {file}", "bold red", colour)
