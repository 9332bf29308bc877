"""Numbers as pictures write them: short, and the same on every machine."""

from __future__ import annotations


def n(number: float) -> str:
    """A coordinate with at most one decimal: ``12``, ``12.5``; never ``-0``."""
    text = f"{number:.1f}".removesuffix(".0")
    return text if text != "-0" else "0"
