"""JSON as people are shown it: what cannot be seen, or would turn the text around, is written as an escape."""

from __future__ import annotations

from typing import Any

from missiontree.formats.json_text import json_text
from missiontree.formats.plain import to_plain
from missiontree.reporting.escape import terminal_safe

MOST_CHARACTERS = 120_000


def json_words(value: Any) -> str:
    """A value as JSON text in which every character can be seen; equal to what a file would hold."""
    text = json_text(to_plain(value)).rstrip("\n")
    return text.translate({ord(sign): _escaped(sign) for sign in set(text) if terminal_safe(sign) != sign})


def cut(text: str) -> tuple[str, int]:
    """As much of a text as a page should hold, up to the end of a line, and how many characters are left out."""
    if len(text) <= MOST_CHARACTERS:
        return text, 0
    kept = text[: text.rfind("\n", 0, MOST_CHARACTERS) + 1 or MOST_CHARACTERS]
    return kept, len(text) - len(kept)


def _escaped(sign: str) -> str:
    """The escapes of a character, a surrogate pair above U+FFFF."""
    units = sign.encode("utf-16-be", "surrogatepass")
    return "".join(f"\\u{units[at]:02x}{units[at + 1]:02x}" for at in range(0, len(units), 2))
