"""Whom a pronoun means."""

from __future__ import annotations

import pytest

from missiontree.authoring.methods.mention import Mention, UnclearError
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.pronouns import antecedent, fits, gender_of
from tests.authoring.reading.heard import mention

CAT, DOG = mention("Cat", "animal"), mention("Dog", "animal")
MOM, DAD, ANNA = (mention(name, "person", determined=False) for name in ("Mom", "Dad", "Anna"))
VISITOR = mention("Visitor", "person")
CHILD = mention("Child", "person")
BOX, KEYS = mention("Box"), mention("Keys", plural=True)
SHEEP = mention("Sheep", "animal", plural=True)
HALL, LAB = mention("Hall", "place"), mention("Lab", "place")

IT, HER, HIM, THERE = (
    Phrase(name=word, text=word, pronoun=pronoun)
    for word, pronoun in (("it", "thing"), ("her", "person"), ("him", "person"), ("there", "place"))
)
THEM = Phrase(name="them", text="them", pronoun="several")
BOTH = Phrase(name="them", text="both of them", pronoun="several", count=2)

Said = list[list[tuple[Mention, ...]]]


@pytest.mark.parametrize(
    ("phrase", "said", "expected"),
    [
        (IT, [[(CAT,)], [(DOG,)]], ["Dog"]),  # the nearest
        (IT, [[(CAT,)], [(HALL,)]], ["Cat"]),  # a place only if there is nothing else
        (IT, [[(HALL,)]], ["Hall"]),
        (IT, [[(KEYS, BOX)]], ["Box"]),
        (IT, [[(SHEEP,)]], ["Sheep"]),  # one or several
        (HER, [[(MOM,), (DAD,)]], ["Mom"]),
        (HIM, [[(MOM,), (DAD,)]], ["Dad"]),
        (HIM, [[(MOM,)], [(BOX,)], [(DOG,)]], ["Dog"]),  # an animal may be "him", a box may not
        (THERE, [[(BOX,), (LAB,)], [(CAT,)]], ["Lab"]),
        (THERE, [[(LAB,), (HALL,)]], ["Hall"]),  # where the way went
        (THEM, [[(CAT, DOG)]], ["Cat", "Dog"]),
        (THEM, [[(CAT,)], [(HALL,)], [(DOG,)]], ["Cat", "Dog"]),
        (THEM, [[(KEYS,)]], ["Keys"]),
        (BOTH, [[(CAT,)], [(DOG,)]], ["Cat", "Dog"]),
    ],
)
def test_pronoun_means(phrase: Phrase, said: Said, expected: list[str]) -> None:
    assert [one.label for one in antecedent(phrase, said)] == expected


@pytest.mark.parametrize(
    ("phrase", "said", "question"),
    [
        (IT, [], "not clear what 'it' means"),
        (IT, [[(MOM,)]], "not clear what 'it' means"),
        (IT, [[(CAT, DOG)]], "'it' may mean Cat or Dog; say which one"),
        (IT, [[(HALL,), (LAB,)]], "not clear what 'it' means"),
        (HER, [[(MOM,), (ANNA,)]], "'her' may mean Mom or Anna"),
        (HER, [[(DAD,)]], "not clear what 'her' means"),
        (THERE, [[(BOX,)]], "not clear what 'there' means"),
        (THEM, [[(HALL, LAB)]], "not clear what 'them' means"),
        (THEM, [[(CAT, DOG), (BOX, KEYS)]], "may mean Cat or Dog or Box or Keys"),
        (BOTH, [[(CAT,)], [(DOG,)], [(BOX,)]], "'both of them' may mean"),
    ],
)
def test_pronoun_may_be_a_question(phrase: Phrase, said: Said, question: str) -> None:
    with pytest.raises(UnclearError, match=question):
        antecedent(phrase, said)


def test_who_stands_beside_a_pronoun_is_not_meant_by_it() -> None:
    """Bring him to Dad: somebody else."""
    said: Said = [[(CHILD,)], [(DAD,)]]
    assert antecedent(HIM, said) == (DAD,)
    assert antecedent(HIM, said, beside={"Dad"}) == (CHILD,)


def test_child_may_be_it_and_a_grown_up_may_not() -> None:
    assert fits(CHILD, IT)
    assert not fits(ANNA, IT)
    assert fits(ANNA, HER)
    assert fits(VISITOR, HER)
    assert fits(VISITOR, HIM)  # the word does not say


@pytest.mark.parametrize(
    ("name", "gender"),
    [
        ("Mrs Brown", "female"),
        ("Mr Brown", "male"),
        ("Brown", None),
        ("old woman", "female"),
        ("Mother's brother", "male"),  # hers, and not she
        ("lady king", None),  # the words say both
        ("HER", "female"),
    ],
)
def test_gender_is_what_the_words_say(name: str, gender: str | None) -> None:
    assert gender_of(name) == gender
