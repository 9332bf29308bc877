"""
Unquoted YAML words: which of them are numbers, truth values or null.

Narrower than YAML 1.1, which PyYAML follows: ``no``, ``on``, ``12:30``, ``0123``, ``0x1F``, ``1_000`` and ``2026-01-02`` are words.
This is the JSON schema of YAML 1.2 with the capitals and bare decimal points of its core schema.
"""

from __future__ import annotations

import math
import re

_NULLS = {"", "~", "null", "Null", "NULL"}
_TRUTH = {"true": True, "True": True, "TRUE": True, "false": False, "False": False, "FALSE": False}
_is_int = re.compile(r"[-+]?(0|[1-9][0-9]*)").fullmatch
_is_float = re.compile(r"[-+]?(\.[0-9]+|(0|[1-9][0-9]*)(\.[0-9]*)?)([eE][-+]?[0-9]+)?").fullmatch
_is_not_finite = re.compile(r"[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)").fullmatch
_MAX_DIGITS = 400

Plain = str | int | float | bool | None


def plain_scalar(word: str) -> Plain:
    """
    What an unquoted word means.

    Raises
    ------
    ValueError
        If it is a number that cannot be held: NaN, infinity, or one too large.
    """
    if word in _NULLS:
        return None
    if word in _TRUTH:
        return _TRUTH[word]
    if _is_not_finite(word):
        raise ValueError(f"{word} is not a number that can be planned with")
    if not _is_float(word):
        return word
    if len(word) > _MAX_DIGITS or not math.isfinite(float(word)):
        raise ValueError(f"a number is too large or too long ({len(word)} characters)")
    return int(word) if _is_int(word) else float(word)
