"""``missiontree check``: does a plan from anywhere keep every rule?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.screen import say, show


def command(
    plan: Annotated[Path, typer.Argument(help="A plan file.")],
    as_json: options.AsJson = False,
    colour: options.Colour = None,
) -> int:
    """Check a plan against the inputs it carries, by two checkers that share nothing with the solvers, nor with each other."""
    import json

    from missiontree.checking import check, taken_on_trust
    from missiontree.formats.document import read_file, to_plain
    from missiontree.reporting.text import findings_view

    value = read_file(plan, "plan")
    findings = check(value)
    trusted = taken_on_trust(value) if not findings else ()
    if as_json:
        told = {
            "sound": not findings,
            "findings": [to_plain(finding) for finding in findings],
            "taken_on_trust": [to_plain(claim) for claim in trusted],
        }
        typer.echo(json.dumps(told, indent=2))
    elif findings:
        count = len(findings)
        say(f"{count} fault{'s' if count != 1 else ''} found in {plan}", "bold red", colour)
        show(findings_view(findings), colour)
    else:
        say(f"sound: {plan} keeps every rule", "green", colour)
        for claim in trusted:
            say(f"not confirmed: {claim.message}", "yellow", colour)
    return Exit.FAULTS if findings else Exit.DELIVERED
