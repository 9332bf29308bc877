"""Clauses in plain order."""

from __future__ import annotations

import pytest

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clauses import clauses_of
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.wording import plain_order, receiver_behind, verbs_repeated
from missiontree.authoring.reading.words import words_of_text

LEXICON = Lexicon()


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("take the dog back to the farm", "take the dog to the farm"),
        ("take the dog home", "take the dog to home"),
        ("take her home", "take her to home"),
        ("bring the box there", "bring the box to there"),
        ("find her home", "find her to home"),  # and no pattern has that
        ("go to Anna's home", "go to Anna's home"),
    ],
)
def test_particles_fall_away_and_home_is_a_destination(text: str, expected: str) -> None:
    (clause,) = clauses_of(words_of_text(text), LEXICON)
    assert " ".join(word.text for word in plain_order(clause)) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("bring Anna the keys", "bring the keys to Anna"),
        ("bring her the keys from the car", "bring the keys from the car to her"),
        ("bring the nurse her bag and the medicine", "bring her bag and the medicine to the nurse"),
        ("bring the box Anna", None),
        ("bring the box the lid", None),  # a box receives nothing
        ("bring Anna and Bob the keys", None),
        ("bring Anna the keys to the lobby", None),
        ("bring Anna", None),
    ],
)
def test_receiver_goes_behind(text: str, expected: str | None) -> None:
    words = words_of_text(text)
    assert " ".join(word.text for word in receiver_behind(words, 1, PhraseReader(LEXICON))) == (expected or text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("go to the gate, then to the lift", ["go to the gate", "go to the lift"]),
        ("find the cat, then the dog", ["find the cat", "find the dog"]),
        ("bring the box to Anna, then the bag to Bob", ["bring the box to Anna", "bring the bag to Bob"]),
        ("find the cat, then it is lost", ["find the cat", "it is lost"]),
    ],
)
def test_verb_is_repeated_behind_then(text: str, expected: list[str]) -> None:
    clauses = verbs_repeated(clauses_of(words_of_text(text), LEXICON), LEXICON)
    assert [clause.text for clause in clauses] == expected
