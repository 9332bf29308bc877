"""Where in a document something stands, and how to show to a person what stands there."""

from __future__ import annotations

import re
from typing import Any

Path = tuple[str | int, ...]

_PLAIN_KEY = re.compile(r"[A-Za-z_$][A-Za-z0-9_$-]*").fullmatch
_SHOWN = 60
NOWHERE = object()
"""Stands for what is not there; None may well be."""


def where(path: Path) -> str:
    """The path as people write it: ``types[0].limits.max_speed_mps``."""
    text = ""
    for step in path:
        if isinstance(step, int):
            text += f"[{step}]"
        elif _PLAIN_KEY(step) and len(step) <= _SHOWN:
            text += f".{step}" if text else step
        else:
            text += f"[{quoted(step)}]"
    return text


def quoted(text: str) -> str:
    """The text in quotes, shortened, with everything escaped that a terminal would act on."""
    return repr(text if len(text) <= _SHOWN else f"{text[:_SHOWN]}...")


def found(data: Any) -> str:
    """What stands there, in words."""
    if data is None:
        return "nothing (null)"
    if isinstance(data, bool):
        return f"{str(data).lower()} (a truth value)"
    if isinstance(data, int | float):
        number = str(data) if isinstance(data, float) or abs(data) < 10**40 else "a number of more than 40 digits"
        return f"{number} (too large to hold)" if number in {"inf", "-inf"} else number
    if isinstance(data, str):
        return f"{quoted(data)} (text)"
    if isinstance(data, list):
        return f"a list of {len(data)}"
    return f"a mapping with the keys {', '.join(quoted(key) for key in list(data)[:4])}" if data else "an empty mapping"


def child(data: Any, step: int | str) -> Any:
    """What stands one step further; ``NOWHERE`` if nothing does."""
    try:
        return data[step]
    except (KeyError, IndexError, TypeError):
        return NOWHERE
