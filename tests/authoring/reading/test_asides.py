"""What a clause says beside what it asks for."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.asides import without_asides
from missiontree.authoring.reading.phrases import PhraseReader
from tests.authoring.reading.heard import LEXICON, clause_of

PHRASES = PhraseReader(LEXICON)


@pytest.mark.parametrize(
    ("text", "kept", "rule"),
    [
        ("bring the keys to Anna, not to Bob", "bring the keys to Anna", "contrast_unused"),
        # With no preposition it may take somebody out of those named, which the reader of the goal has to rule out.
        ("find the cat, not the dog", "find the cat", "exception_unused"),
        ("find the cat instead of the dog", "find the cat", "exception_unused"),
        ("find the cat rather than the dog", "find the cat", "exception_unused"),
    ],
)
def test_whom_it_is_not_for_is_left_out_and_told(text: str, kept: str, rule: str) -> None:
    clause, (reason,) = without_asides(clause_of(text), PHRASES, LEXICON)
    assert clause.text == kept
    assert clause.decisive == ()
    assert (reason.rule, reason.severity) == (rule, "assumption")
    assert "says what is not meant; nothing is planned for it" in reason.message


@pytest.mark.parametrize("how", ["so that", "in order that"])
def test_what_it_is_good_for_is_left_out_and_told(how: str) -> None:
    clause, (reason,) = without_asides(clause_of(f"bring the ladder to Anna {how} she can work"), PHRASES, LEXICON)
    assert clause.text == "bring the ladder to Anna"
    assert (reason.rule, reason.severity) == ("purpose_unused", "assumption")
    assert f"'{how} she can work' says what is intended" in reason.message


@pytest.mark.parametrize(
    "text",
    [
        "bring the keys to Anna",
        "bring the keys to Anna, not quickly",  # how, and not whom
        "bring the keys to Anna, not him",  # nobody knows whom
        "bring the keys to Anna, not in the hall",  # nothing of that form is in what is asked for
        "bring the keys to Anna, not to Bob and Cleo",
        "find the cat, not the dog in the hall",
        "not the dog",
    ],
)
def test_other_words_stay(text: str) -> None:
    clause = clause_of(text)
    assert without_asides(clause, PHRASES, LEXICON) == (clause, ())


def test_what_else_changes_what_is_asked_for_still_does() -> None:
    clause, reasons = without_asides(clause_of("bring only the keys to Anna, not to Bob"), PHRASES, LEXICON)
    assert clause.decisive == ("only",)
    assert len(reasons) == 1
