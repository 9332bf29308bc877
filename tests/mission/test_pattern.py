"""Patterns of what is said."""

from __future__ import annotations

import pytest

from missiontree.authoring.language.lexicon import Verb
from missiontree.authoring.methods.slots import matches
from missiontree.mission.pattern import fixed_words, forms_of


def slots(pattern: str, text: str, verb: Verb) -> dict[str, str] | None:
    """What the slots of a pattern hold; any run of words but "to" counts as a phrase."""
    words = text.split()
    for form in forms_of(pattern):
        spans = matches(
            form, words, verb, {"bring": ("bring", "take")}, lambda start, end: "to" not in words[start:end]
        )
        if spans is not None:
            return {slot: " ".join(words[start:end]) for slot, (start, end) in spans.items()}
    return None


BRING = Verb("bring", "base", 1)


@pytest.mark.parametrize(
    ("pattern", "text", "expected"),
    [
        ("<bring> {a} to {b}", "bring the box to anna", {"a": "the box", "b": "anna"}),
        ("<bring> {a} [back] to {b}", "bring it back to anna", {"a": "it", "b": "anna"}),
        ("<bring> {a} (to|into) {b}", "bring it into rooms", {"a": "it", "b": "rooms"}),
        ("<bring> {a} <doing> {b}", "bring anna carrying boxes", {"a": "anna", "b": "boxes"}),
        ("<bring> {a}", "bring it to anna", None),
        ("<bring> {a} to {b}", "bring it", None),
        ("<find> {a}", "bring it", None),
    ],
)
def test_pattern_matches_whole_clauses_only(pattern: str, text: str, expected: dict[str, str] | None) -> None:
    assert slots(pattern, text, BRING) == expected


def test_longest_form_comes_first_and_words_are_counted() -> None:
    forms = forms_of("<bring> {a} [all the way] to {b}")
    # bring, all, the, way, to against bring, to
    assert [fixed_words(form) for form in forms] == [5, 2]
