"""``missiontree schema``: the JSON Schema of a document, so that editors can complete and explain."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from missiontree.cli.exits import Exit
from missiontree.cli.files import save
from missiontree.errors import InputError


def command(
    kind: Annotated[
        str | None, typer.Argument(help="fleet, scene, routines, mission, plan, … Without it: the list.")
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="Write to this file; with no kind: every schema into this folder."),
    ] = None,
) -> int:
    """Print the JSON Schema of a kind of document."""
    import json

    from missiontree.authoring.methods.method import MethodFile
    from missiontree.evaluation.suite_file import SuiteFile
    from missiontree.formats.document import KINDS
    from missiontree.formats.schema import schema_of

    # Methods are known to the author alone, suites to its examiner.
    kinds = {**KINDS, "methods": MethodFile, "suite": SuiteFile}
    if kind is not None and kind not in kinds:
        raise InputError(f"there is no document {kind!r}", accepted=", ".join(kinds))
    if kind is None and out is None:
        typer.echo("\n".join(kinds))
        return Exit.DELIVERED
    texts = {name: json.dumps(schema_of(kinds[name], name), indent=2) + "\n" for name in ([kind] if kind else kinds)}
    for name, text in texts.items():
        if out is None:
            typer.echo(text, nl=False)
            continue
        if kind is None:
            out.mkdir(parents=True, exist_ok=True)
        save(out if kind else out / f"{name}.schema.json", text)
    return Exit.DELIVERED
