"""Somebody or something that is spoken of."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.phrase import Phrase, kind_of_phrase


def the(name: str) -> Phrase:
    return Phrase(name=name, text=f"the {name}", determined=True)


def bare(name: str) -> Phrase:
    return Phrase(name=name, text=name)


@pytest.mark.parametrize(
    ("phrase", "several"),
    [
        (the("crate"), False),
        (the("crates"), True),
        (bare("crates"), True),
        (bare("Thomas"), False),  # a name
        (bare("Crates"), True),  # a noun at the beginning of a sentence
        (the("Jacksons"), True),
        (Phrase(name="crate", text="every crate", determined=True, every=True), True),
        (Phrase(name="sheep", text="two sheep", determined=True, count=2), True),
        (Phrase(name="crate", text="the second crate", determined=True, ordinal=2), False),
    ],
)
def test_several_are_meant(phrase: Phrase, several: bool) -> None:
    assert phrase.several is several


@pytest.mark.parametrize(
    ("phrase", "own"),
    [
        (bare("Rose"), True),
        (the("Rose"), False),
        (bare("rose"), False),
        (bare("ROSE"), False),  # everything is written so
        (bare("Rose Brown"), False),
        (bare("J"), True),
    ],
)
def test_name_of_its_own_is_one_word_with_a_capital_and_no_article(phrase: Phrase, own: bool) -> None:
    assert phrase.is_own_name is own


@pytest.mark.parametrize(
    ("phrase", "kind"),
    [
        (the("nurse"), "person"),
        (the("dog"), "animal"),
        (the("crate"), "object"),
        (the("kitchen"), "place"),
        (the("room 12"), "place"),
        (the("Gallery A"), "place"),
        (the("fire station"), "place"),
        (bare("Rose"), "person"),
        (bare("Otto Blorp"), "person"),
        (the("blorp"), None),
        (bare("blorp"), None),
        (the("happiness"), None),
    ],
)
def test_kind_is_that_of_the_noun_or_a_person_by_name(phrase: Phrase, kind: str | None) -> None:
    assert kind_of_phrase(phrase) == kind


def test_full_name_has_its_states() -> None:
    assert Phrase(name="child", text="her lost old child", states=("lost", "old")).full == "lost old child"
    assert the("child").full == "child"
