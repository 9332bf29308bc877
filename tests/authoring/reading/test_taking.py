"""Taking and bringing the same thing is one errand."""

from __future__ import annotations

import pytest

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clauses import clauses_of
from missiontree.authoring.reading.taking import errands_joined
from missiontree.authoring.reading.words import words_of_text

LEXICON = Lexicon()


def joined(text: str) -> list[str]:
    return [clause.text for clause in errands_joined(clauses_of(words_of_text(text), LEXICON), LEXICON)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("pick up the box and bring it to Anna", ["bring the box to Anna"]),
        ("get the keys, then take them to the lobby", ["take the keys to the lobby"]),
        ("recover the laptop and return it to Anna", ["return the laptop to Anna"]),
        ("go home, collect the box and bring it to Anna", ["go home", "bring the box to Anna"]),
    ],
)
def test_one_errand(text: str, expected: list[str]) -> None:
    assert joined(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "pick up the box and bring the ball to Anna",
        "take the box to the hall and bring it to Anna",
        "pick up the box and follow it",
        "find the box and bring it to Anna",
        "do not pick up the box and bring it to Anna",
        "pick up the box before bringing it to Anna",
    ],
)
def test_two_errands(text: str) -> None:
    assert len(joined(text)) == 2


def test_what_is_joined_to_an_errand_stays_joined_to_it() -> None:
    clauses = errands_joined(
        clauses_of(words_of_text("pick up the box and bring it to Anna, then go home"), LEXICON), LEXICON
    )
    assert [(clause.relation, clause.anchor) for clause in clauses] == [("start", None), ("then", 0)]
