"""``missiontree learn``: a plan's tree, whoever built it, becomes a mission method."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from missiontree.cli import options
from missiontree.cli.exits import Exit
from missiontree.cli.files import refuse_unwritable, save
from missiontree.cli.screen import remark
from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.mission.brief import MissionBrief
    from missiontree.mission.tree import MissionTree

MISSION = Path("mission.yaml")


def command(
    plan: Annotated[Path, typer.Argument(help="A plan file, or a tree file.")],
    method_id: Annotated[
        str | None,
        typer.Option("--as", metavar="ID", help="Id of the method. Default: learned_ and the mission's verb."),
    ] = None,
    says: Annotated[
        str | None,
        typer.Option(
            "--says",
            metavar="PATTERN",
            help="The pattern, such as 'rescue {anna} from {barn}'. Default: the mission's own words.",
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="Add the method to this file of methods, which is made if need be."),
    ] = None,
    quiet: options.Quiet = False,
    colour: options.Colour = None,
) -> int:
    """Learn a mission method from a tree."""
    from missiontree.authoring.learning.teaching import method_from
    from missiontree.authoring.learning.writing import added, methods_text
    from missiontree.authoring.methods.method import load_methods

    if method_id is not None:
        _check_id(method_id)
    if says is not None and not says.strip():
        raise InputError(
            "--says '' is no pattern", accepted="words such as 'rescue {anna} from {barn}'", hint="Or leave it out."
        )
    tree, brief = _source(plan)
    files = _listed()
    method = method_from(tree, brief, load_methods(files), method_id or "", says or "")
    if out is None:
        typer.echo(methods_text(method), nl=False)
        place = "the file that you put this into"
    else:
        refuse_unwritable(out)
        from missiontree.formats.source import load_text

        save(out, added(load_text(out) if out.exists() else "", method, str(out)))
        place = str(out)
        if not quiet:
            remark(f"method {method.id} is written to {out}", colour)
    unlisted = out is None or out.resolve() not in [file.resolve() for file in files]
    if not quiet and MISSION.exists() and unlisted:
        names = ", ".join([*(str(file) for file in files), str(out) if out else "FILE"])
        remark(f"it is used once {place} is listed in {MISSION}: methods: [{names}]", colour)
    return Exit.DELIVERED


def _check_id(method_id: str) -> None:
    from missiontree.formats.annotation import ID_IN_WORDS
    from missiontree.mission.value import ID_PATTERN

    if re.fullmatch(ID_PATTERN, method_id, re.ASCII) is None:
        raise InputError(f"--as {method_id!r} is no id", accepted=ID_IN_WORDS)


def _source(path: Path) -> tuple[MissionTree, MissionBrief]:
    """The tree of a plan or of a tree file, and the mission that it is for."""
    from missiontree.formats.document import read_text
    from missiontree.formats.reader import parse
    from missiontree.formats.source import load_text

    text = load_text(path)
    if _is_tree(parse(text, str(path)).data):
        from missiontree.briefing import request_from

        tree = read_text(text, "tree", str(path))
        return tree, request_from(_one_mission(tree.objective), project=MISSION if MISSION.exists() else None).brief
    plan = read_text(text, "plan", str(path))
    if plan.tree is None:
        raise InputError(
            f"the plan has no tree: its outcome is {plan.outcome.replace('_', ' ')}",
            file=str(path),
            hint="Give the plan of a mission that was understood.",
        )
    return plan.tree, plan.brief


def _is_tree(data: Any) -> bool:
    if not isinstance(data, dict):
        return False
    kind = str(data.get("format", "")).partition("/")[0]
    return kind == "tree" or (not kind and "nodes" in data and "objective" in data)


def _one_mission(objective: str) -> str:
    """The objective as words, even if it looks like the name of a file."""
    return f"{' '.join(objective.split())} "


def _listed() -> list[Path]:
    """The methods files that the mission file of this folder lists."""
    if not MISSION.exists():
        return []
    from missiontree.formats.document import read_file

    return [Path(name) for name in read_file(MISSION, "mission").methods]
