"""Files to values and back. Every document says what it is in its first line: ``format: fleet/1``."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import fields, replace
from pathlib import Path
from typing import Any, TypeVar

from missiontree.errors import InputError
from missiontree.formats.annotation import in_words
from missiontree.formats.fault import nearest
from missiontree.formats.json_text import json_text
from missiontree.formats.mission_file import MissionFile
from missiontree.formats.parsed import Parsed
from missiontree.formats.place import quoted
from missiontree.formats.plain import to_plain
from missiontree.formats.reach import INPUTS, refuse_far
from missiontree.formats.reader import parse
from missiontree.formats.routine_file import RoutineFile
from missiontree.formats.schema import schema_of
from missiontree.formats.source import load_text
from missiontree.formats.validation import to_value
from missiontree.mission.alternative import Alternative, Ranking
from missiontree.mission.brief import MissionBrief
from missiontree.mission.chain import WhySoLong
from missiontree.mission.explanation import Explanation
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree, Grounding
from missiontree.mission.plan import Plan
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.tree import MissionTree
from missiontree.mission.why_not import WhyNot

__all__ = ["KINDS", "json_schema", "read_as", "read_file", "read_text", "to_plain", "write_text"]

KINDS: dict[str, type[Any]] = {
    "fleet": Fleet,
    "scene": Scene,
    "routines": RoutineFile,
    "mission": MissionFile,
    "tree": MissionTree,
    "brief": MissionBrief,
    "grounded": GroundedTree,
    "grounding": Grounding,
    "alternative": Alternative,
    "ranking": Ranking,
    "schedule": Schedule,
    "plan": Plan,
    "why_so_long": WhySoLong,
    "explanation": Explanation,
    "why_not": WhyNot,
}
"""Name of each kind of document to its value. All are in version 1."""

_NOT_FIELDS = ("format", "$schema")
T = TypeVar("T")


def read_file(path: Path, kind: str) -> Any:
    """
    Read a file.

    Parameters
    ----------
    path
        The file, UTF-8. A name that ends in ``.json`` must hold JSON, any other may hold YAML or JSON.
    kind
        Kind of document expected, one of ``KINDS``.

    Raises
    ------
    InputError
        If it cannot be read or is no such document; says where and what is accepted.
    """
    return read_text(load_text(path), kind, str(path))


def read_text(text: str, kind: str, source: str = "<text>") -> Any:
    """Read a document that is already text; ``source`` is what messages call it. See :func:`read_file`."""
    return read_as(text, kind, KINDS[kind], source)


def read_as(text: str, kind: str, cls: type[T], source: str = "<text>") -> T:
    """Read a document of a kind that is not among ``KINDS``, such as one that only a single stage knows."""
    parsed = parse(text, source)
    if parsed.data is None:
        raise InputError("the file is empty", file=source, line=1, accepted=in_words(cls))
    if not isinstance(parsed.data, dict):
        return to_value(parsed, cls)
    _check_format(parsed, kind)
    own = {key: member for key, member in parsed.data.items() if key not in _NOT_FIELDS}
    _check_looks(parsed, kind, cls, own)
    if kind in INPUTS:
        refuse_far(parsed)
    return to_value(replace(parsed, data=own), cls)


def write_text(value: Any, kind: str) -> str:
    """
    The document of a value, as JSON text; equal values give equal text.

    Raises
    ------
    TypeError
        If the value is not of that kind.
    """
    if not isinstance(value, KINDS[kind]):
        raise TypeError(f"a {type(value).__name__} is not a {kind}.")
    return json_text({"format": f"{kind}/1", **to_plain(value)})


def json_schema(kind: str) -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of a kind of document, for editors to complete and explain by."""
    return schema_of(KINDS[kind], kind)


def _check_format(parsed: Parsed, kind: str) -> None:
    given = parsed.data.get("format", f"{kind}/1")
    if given == f"{kind}/1":
        return
    accepted = f"{kind}/1"
    match = re.fullmatch(r"([a-z_]+)/([0-9]{1,9})", given) if isinstance(given, str) else None
    if match is None:
        hint = nearest(given, (accepted,)) if isinstance(given, str) else ""
        raise parsed.refusal(f"{quoted(str(given))} is not the format of a document", ("format",), accepted, hint)
    if match[1] == kind:
        raise parsed.refusal(
            f"version {match[2]} of {kind} files is not known to this missiontree", ("format",), accepted
        )
    if match[1] in KINDS:
        raise parsed.refusal(
            f"this is a {match[1]} file, a {kind} file was expected",
            ("format",),
            accepted,
            f"Give it as the {match[1]} instead.",
        )
    raise parsed.refusal(
        f"{quoted(match[1])} is not a kind of document", ("format",), accepted, nearest(match[1], tuple(KINDS))
    )


def _check_looks(parsed: Parsed, kind: str, cls: type[Any], own: Mapping[str, Any]) -> None:
    """Say which file it probably is, if nothing in it is ours and all of it belongs to another kind."""
    if "format" in parsed.data or not own or set(own) & {field.name for field in fields(cls)}:
        return
    for other, value in KINDS.items():
        if set(own) <= {field.name for field in fields(value)}:
            raise parsed.refusal(
                f"this looks like a {other} file, a {kind} file was expected",
                (next(iter(own)),),
                in_words(cls),
                f"Give it as the {other} instead.",
            )
