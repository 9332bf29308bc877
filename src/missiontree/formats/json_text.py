"""Plain data as JSON text that people can read and compare line by line, and that stays small."""

from __future__ import annotations

import json
from typing import Any

_WIDTH = 120
_ALWAYS_BROKEN = 2


def json_text(plain: Any) -> str:
    """
    JSON, a member or entry to a line where it fits, ending with a newline.

    The outermost two levels are always broken; below them only what is longer than a line.
    """
    return _laid_out(plain, 0) + "\n"


def _laid_out(plain: Any, level: int) -> str:
    # Values nest a handful of levels deep (trees are lists of nodes), so recursion has a bound that no input can move.
    if not isinstance(plain, dict | list) or not plain:
        return _compact(plain)
    if level >= _ALWAYS_BROKEN and len(text := _compact(plain)) + 2 * level <= _WIDTH:
        return text
    inner = "  " * (level + 1)
    if isinstance(plain, dict):
        lines = [f"{inner}{_compact(key)}: {_laid_out(member, level + 1)}" for key, member in plain.items()]
    else:
        lines = [inner + _laid_out(member, level + 1) for member in plain]
    start, end = "{}" if isinstance(plain, dict) else "[]"
    return start + "\n" + ",\n".join(lines) + "\n" + "  " * level + end


def _compact(plain: Any) -> str:
    return json.dumps(plain, ensure_ascii=False, allow_nan=False)
