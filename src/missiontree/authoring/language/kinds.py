"""What kind of thing a common noun names, for entities that no scene describes. A guess that is always stated as an assumption."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import yaml

from missiontree.authoring.matching import words_of

_PREPOSITIONS = frozenset(
    {"of", "in", "on", "at", "with", "near", "from", "by", "under", "behind", "beside", "inside", "outside"}
)
_FILE = Path(__file__).with_name("kinds.yaml")


def kind_of(phrase: str) -> str | None:
    """
    Base kind of what a noun phrase names: ``person``, ``animal``, ``object`` or ``place``; None if its noun is not known.

    The noun is the last word before a preposition ("the old woman with the bag": woman); compounds of the list go first ("fire
    station" is a place, whatever a fire is).
    """
    words = words_of(phrase)
    end = next((index for index, word in enumerate(words) if index and word in _PREPOSITIONS), len(words))
    nouns = _nouns()
    for start in range(max(0, end - 3), end):
        for form in _singulars(" ".join(words[start:end])):
            if form in nouns:
                return nouns[form]
    return None


@cache
def _nouns() -> dict[str, str]:
    lists: dict[str, list[str]] = yaml.safe_load(_FILE.read_text(encoding="utf-8"))
    return {noun: kind for kind, nouns in lists.items() for noun in nouns}


def _singulars(noun: str) -> tuple[str, ...]:
    """The noun, and what it may be the plural of."""
    forms = [noun]
    if noun.endswith("ies"):
        forms.append(noun[:-3] + "y")
    if noun.endswith("es"):
        forms.append(noun[:-2])
    if noun.endswith("s"):
        forms.append(noun[:-1])
    return tuple(forms)
