"""``missiontree init``: a folder to start from, every file with its comments, in which ``missiontree plan`` works."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.plan import save
from missiontree.cli.screen import say
from missiontree.errors import InputError


def command(
    folder: Annotated[Path, typer.Argument(help="Folder to write into; made if there is none.")] = Path(),
    colour: options.Colour = None,
) -> int:
    """Write a fleet, a scene, a routine, a method and a mission to start from. Nothing is overwritten."""
    from missiontree.samples.catalogue import PROJECT

    sources = sorted(file for file in PROJECT.rglob("*") if file.suffix in {".yaml", ".md"})
    targets = [folder / file.relative_to(PROJECT) for file in sources]
    if taken := [target for target in targets if os.path.lexists(target)]:
        raise InputError(
            "the file is there already",
            file=str(taken[0]),
            accepted="a folder without these files",
            hint="Nothing was written.",
        )
    for source, target in zip(sources, targets, strict=True):
        try:
            target.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError("the folder cannot be made", file=str(target.parent), hint=str(error.strerror)) from error
        save(target, source.read_text(encoding="utf-8"))
        say(f"written {target}", colour=colour)
    step = "" if folder == Path() else f"cd {folder} && "
    say(f"next: {step}missiontree plan", "bold", colour)
    return Exit.DELIVERED
