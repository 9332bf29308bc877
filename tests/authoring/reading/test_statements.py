"""Statements of what is lost or in danger."""

from __future__ import annotations

import pytest

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clauses import clauses_of
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.statements import Statement, statement_of
from missiontree.authoring.reading.words import words_of_text

LEXICON = Lexicon()


def stated(text: str) -> Statement | None:
    return statement_of(clauses_of(words_of_text(text), LEXICON)[0], PhraseReader(LEXICON), LEXICON)


@pytest.mark.parametrize(
    ("text", "names", "lost", "hazards"),
    [
        ("The cat is lost", ["cat"], True, ()),
        ("My dog has escaped", ["dog"], True, ()),
        ("The keys have gone missing", ["keys"], True, ()),
        ("The dog and the cat are lost", ["dog", "cat"], True, ()),
        ("The house is on fire", ["house"], False, ("fire",)),
        ("Anna is trapped in the burning barn", ["Anna"], True, ("fire",)),
    ],
)
def test_statement(text: str, names: list[str], lost: bool, hazards: tuple[str, ...]) -> None:
    found = stated(text)
    assert found is not None
    assert [phrase.name for phrase in found.phrases] == names
    assert found.lost is lost
    assert found.hazards == hazards


@pytest.mark.parametrize(
    "text",
    [
        "The cat is in the kitchen",
        "The cat is black",
        "The cat was lost",
        "The cat has been found",
        "It is lost",
        "Is the cat lost",
        "The cat is",
        "Find the cat that is lost",
        "The cat is lost and hungry",
    ],
)
def test_no_statement_of_use(text: str) -> None:
    assert stated(text) is None
