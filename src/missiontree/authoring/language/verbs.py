"""English verbs, whether any routine serves them or not: an order with a verb that nobody serves is an order all the same."""

from __future__ import annotations

from functools import cache
from pathlib import Path

_TABLE = Path(__file__).with_name("verbs.txt")


@cache
def english_verbs() -> frozenset[str]:
    """Every English verb of one word in its base form; derived from WordNet by ``scripts/make_verbs.py``."""
    lines = _TABLE.read_text(encoding="ascii").splitlines()
    return frozenset(word for line in lines if not line.startswith("#") for word in line.split())
