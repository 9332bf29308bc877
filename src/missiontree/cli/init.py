"""``missiontree init``: a folder to start from, every file with its comments, in which ``missiontree plan`` works."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.files import save
from missiontree.cli.screen import say
from missiontree.errors import InputError
from missiontree.samples.catalogue import SAMPLES, sample_files


def command(
    folder: Annotated[Path, typer.Argument(help="Folder to write into; made if there is none.")] = Path(),
    sample: Annotated[
        str,
        typer.Option("--sample", metavar="NAME", help=f"The sample to write: {', '.join(SAMPLES)}."),
    ] = "site",
    colour: options.Colour = None,
) -> int:
    """Write a mission with its fleet, and its scene, routines and methods if it has some, to start from. Nothing is overwritten."""
    files = {folder / name: source for name, source in sample_files(sample).items()}
    if taken := [target for target in files if os.path.lexists(target)]:
        raise InputError(
            "the file is there already",
            file=str(taken[0]),
            accepted="a folder without these files",
            hint="Nothing was written.",
        )
    for target, source in files.items():
        try:
            target.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError("the folder cannot be made", file=str(target.parent), hint=str(error.strerror)) from error
        save(target, source.read_text(encoding="utf-8"))
        say(f"written {target}", colour=colour)
    step = "" if folder == Path() else f"cd {folder} && "
    say(f"next: {step}missiontree plan", "bold", colour)
    return Exit.DELIVERED
