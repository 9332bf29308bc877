"""``missiontree export-training``: recorded dialogues that ended in a checked tree become data to fine-tune a chat model on."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.exporting import Export
from missiontree.cli.files import refuse_unwritable, save
from missiontree.cli.gathering import gather
from missiontree.cli.recordings import files_of, from_file
from missiontree.cli.screen import remark
from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.briefing import Request


def command(
    paths: Annotated[
        list[Path] | None,
        typer.Argument(
            metavar="PATH...",
            help="Transcripts (plan --record), plans (plan --out, .json), or folders, which stand for the .jsonl files in them.",
        ),
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE", help="Write the data to this file. Default: print it.")
    ] = None,
    samples: Annotated[
        bool, typer.Option("--samples", help="Take the transcripts that come with missiontree, which are scripted.")
    ] = False,
    sources: Annotated[
        list[str] | None,
        typer.Option(
            "--source",
            metavar="NAME",
            help="Only dialogues from here (openai, scripted, ...); may be given several times.",
        ),
    ] = None,
    keep_slips: Annotated[
        bool,
        typer.Option(
            "--keep-slips",
            help="Keep refused calls, answers that were cut and early stops, with what followed; these messages have weight 0.",
        ),
    ] = False,
    with_impossible: Annotated[
        bool, typer.Option("--with-impossible", help="Take missions, too, that were rightly declared impossible.")
    ] = False,
    mission: Annotated[
        list[Path] | None,
        typer.Option(
            "--mission",
            metavar="FILE",
            help="A mission file whose fleet, scene and routines were used; may be given several times.",
        ),
    ] = None,
    fleet: options.FleetFile = None,
    scene: options.SceneFile = None,
    routines: options.RoutineFiles = None,
    weights: options.WeightsText = None,
    kinds: options.Kinds = None,
    as_json: options.AsJson = False,
    quiet: options.Quiet = False,
    colour: options.Colour = None,
) -> int:
    """Make data to fine-tune a model on of recorded dialogues."""
    from missiontree.authoring.finetuning import Choice

    refuse_unwritable(out)
    if as_json and out is None:
        raise InputError("--json is given, and the data is printed", accepted="--json with --out FILE")

    def here(words: str) -> Request:
        return gather(
            f"{words} ",  # the blank keeps words from being taken for the name of a file
            None,
            fleet=fleet,
            scene=scene,
            routines=routines,
            methods=None,
            weights=weights,
            k=None,
            allocator=None,
            model=None,
            kinds=kinds,
            seed=None,
        )

    looked_at = [here, *map(from_file, mission or ())]
    for source in looked_at:
        source("A mission.")  # what is wrong with the options is wrong with every transcript
    files = [*files_of(paths or [], out), *(_samples() if samples else ())]
    if not files:
        raise InputError("no transcripts are given", accepted="files or folders, or --samples")
    export = Export(Choice(slips=keep_slips, impossible=with_impossible), frozenset(sources or ()))
    for file in files:
        export.take(file, looked_at)
    if not quiet:
        for name, why in export.left_out:
            remark(f"left out {name}: {why}", colour)
    if not export.taken:
        raise InputError(
            f"none of {len(files)} dialogues can be taken", hint="See above for the reasons, or leave out --quiet."
        )
    _deliver(export, out, as_json)
    if not quiet:
        remark(export.summary(str(out or "printed")), colour)
    return Exit.DELIVERED


def _deliver(export: Export, out: Path | None, as_json: bool) -> None:
    from missiontree.formats.json_text import json_text

    text = "".join(f"{line}\n" for line in export.taken)
    if out is None:
        typer.echo(text, nl=False)
        return
    save(out, text)
    if as_json:
        typer.echo(json_text(export.index()), nl=False)


def _samples() -> Iterator[Path]:
    from missiontree.samples.dialogues import DIALOGUES, transcript_file

    return map(transcript_file, DIALOGUES)
