"""
What kind of thing a common noun names, for entities that no scene describes. A guess that is always stated as an assumption.

``kinds.yaml`` is made by hand and has the last word; ``nouns.txt`` is derived from WordNet and knows what stands in no list of ours.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path

import yaml

from missiontree.authoring.matching import words_of

_PREPOSITIONS = frozenset(
    {"of", "in", "on", "at", "with", "near", "from", "by", "under", "behind", "beside", "inside", "outside"}
)
_BY_HAND = Path(__file__).with_name("kinds.yaml")
_TABLE = Path(__file__).with_name("nouns.txt")
_ABSTRACT = "abstract"
_NAMES = "names"
_LONGEST_COMPOUND = 3
_PLURAL_ENDINGS = (("men", "man"), ("ies", "y"), ("ves", "f"), ("ves", "fe"), ("es", ""), ("s", ""))


def kind_of(phrase: str) -> str | None:
    """
    Base kind of what a noun phrase names: ``person``, ``animal``, ``object`` or ``place``.

    None if its noun is not known, or names nothing that one could find or carry. The noun is the last word before a preposition
    ("the old woman with the bag": woman); compounds that are known go first ("fire station" is a place, whatever a fire is).
    """
    found = _found(phrase)
    return found if found != _ABSTRACT else None


def is_abstract(phrase: str) -> bool:
    """Whether the noun of a phrase names, in everyday speech, what no robot can find, follow, reach or carry: "happiness"."""
    return _found(phrase) == _ABSTRACT


def is_listed(phrase: str) -> bool:
    """Whether a compound stands in the list made by hand as it is: "lost property office"."""
    return " ".join(words_of(phrase)) in _by_hand()


def _found(phrase: str) -> str | None:
    words = words_of(phrase)
    end = next((index for index, word in enumerate(words) if index and word in _PREPOSITIONS), len(words))
    lists = (_by_hand(),) if _is_given_name(phrase) else (_by_hand(), _table())
    for start in range(max(0, end - _LONGEST_COMPOUND), end):
        for form in _singulars(" ".join(words[start:end])):
            for nouns in lists:
                if form in nouns:
                    return nouns[form]
    return None


def _is_given_name(phrase: str) -> bool:
    """Whether somebody may be called so: "Rose" with a capital and by itself, and neither "rose" nor "ROSE"."""
    name = phrase.strip()
    return name.istitle() and name.lower() in _given_names()


@cache
def _by_hand() -> dict[str, str]:
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    lists: dict[str, list[str]] = yaml.load(_BY_HAND.read_text(encoding="utf-8"), Loader=loader)  # noqa: S506 - both are safe
    return {noun: kind for kind, nouns in lists.items() for noun in nouns}


@cache
def _table() -> dict[str, str]:
    return {noun: kind for kind, nouns in _lists().items() if kind != _NAMES for noun in nouns}


@cache
def _given_names() -> frozenset[str]:
    return frozenset(_lists()[_NAMES])


@cache
def _lists() -> dict[str, list[str]]:
    lines = (line for line in _TABLE.read_text(encoding="ascii").splitlines() if not line.startswith("#"))
    return {kind: nouns.split(", ") for kind, _, nouns in (line.partition(": ") for line in lines)}


def _singulars(noun: str) -> Iterator[str]:
    """The noun, and what it may be the plural of."""
    yield noun
    for ending, singular in _PLURAL_ENDINGS:
        if noun.endswith(ending):
            yield noun.removesuffix(ending) + singular
