"""Plain data as JSON text that people can read and compare line by line, that stays small, and that no terminal obeys."""

from __future__ import annotations

import json
import re
from typing import Any

_WIDTH = 120
_ALWAYS_BROKEN = 2
_ENCODER = json.JSONEncoder(ensure_ascii=False, allow_nan=False)
# Characters that act instead of being seen and that JSON lets stand: C1 controls, directions, what has no width, line and
# paragraph separators, halves of pairs, and the last two of each plane. The joiners of Persian, Hindi and emoji stay.
_ACTING = re.compile(
    "[\x7f-\x9f\xad\u0600-\u0605\u061c\u06dd\u070f\u0890\u0891\u08e2\u180e\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ud800-\udfff"
    "\ufeff\ufff9-\ufffb\ufffe\uffff\U000110bd\U000110cd\U00013430-\U0001345f\U0001bca0-\U0001bca3\U0001d173-\U0001d17a"
    "\U000e0001-\U000e007f"
    + "".join(f"{chr(plane + 0xFFFE)}{chr(plane + 0xFFFF)}" for plane in range(0x10000, 0x110000, 0x10000))
    + "]"
)


def json_text(plain: Any) -> str:
    """
    JSON, a member or entry to a line where it fits, ending with a newline.

    The outermost two levels are always broken; below them only what is longer than a line. A character that acts instead of
    being seen (a direction, a control, half of a pair) is written by its number, so that the text can always be encoded and shown.
    """
    return _laid_out(plain, 0, {}) + "\n"


def _laid_out(plain: Any, level: int, names: dict[str, str]) -> str:
    """A value at a level; ``names`` remembers what members are called, for the same few names come again and again."""
    # Values nest a handful of levels deep (trees are lists of nodes), so recursion has a bound that no input can move.
    if not isinstance(plain, dict | list) or not plain:
        return _compact(plain)
    if level >= _ALWAYS_BROKEN and _may_fit(plain) and len(text := _compact(plain)) + 2 * level <= _WIDTH:
        return text
    inner = "  " * (level + 1)
    if isinstance(plain, dict):
        for key in plain:
            if key not in names:
                names[key] = _compact(key)
        lines = [f"{inner}{names[key]}: {_laid_out(member, level + 1, names)}" for key, member in plain.items()]
    else:
        lines = [inner + _laid_out(member, level + 1, names) for member in plain]
    start, end = "{}" if isinstance(plain, dict) else "[]"
    return start + "\n" + ",\n".join(lines) + "\n" + "  " * level + end


def _may_fit(plain: dict[str, Any] | list[Any]) -> bool:
    """Whether there are few enough entries for a line; each takes 3 characters at least, "0, ", or 7 with a name, "" included."""
    return len(plain) * (7 if isinstance(plain, dict) else 3) <= _WIDTH


def _compact(plain: Any) -> str:
    text = _ENCODER.encode(plain)
    return text if text.isascii() and "\x7f" not in text else _ACTING.sub(_by_number, text)


def _by_number(found: re.Match[str]) -> str:
    return json.dumps(found[0])[1:-1]
