"""Routines files: text to values."""

from __future__ import annotations

from typing import Any

import yaml
from pydantic import TypeAdapter, ValidationError

from missiontree.errors import InputError
from missiontree.mission.routine import RoutineFile

FORMAT = "routines/1"


def read_routines(text: str, source: str) -> RoutineFile:
    """The routines of a text in YAML or JSON; `source` names it in messages."""
    try:
        plain: Any = yaml.safe_load(text)
    except yaml.YAMLError as error:
        raise InputError(f"this is not YAML: {error}", file=source) from error
    if not isinstance(plain, dict) or plain.pop("format", FORMAT) != FORMAT:
        raise InputError("this is not a file of routines.", file=source, accepted=f"format: {FORMAT}")
    try:
        return TypeAdapter(RoutineFile).validate_python(plain)
    except ValidationError as error:
        first = error.errors()[0]
        raise InputError(first["msg"], file=source, where=".".join(map(str, first["loc"]))) from error
