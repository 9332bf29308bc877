"""Somebody or something that is spoken of."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.reading.plurals import is_plural


@dataclass(frozen=True, slots=True)
class Phrase:
    """
    Somebody or something that is spoken of.

    Parameters
    ----------
    name
        What it is called, without article, states and descriptions: ``child``, ``red ball``, ``room 12``.
    determined
        Whether it stands with an article or a possessive; a bare "mom" is a name.
    states
        Words such as ``lost`` or ``heavy``, which are not part of what it is called.
    description
        What is said of it behind the noun: ``trapped in a building on fire``.
    pronoun
        ``thing``, ``person``, ``several`` or ``place`` if it is a pronoun; empty if it is not.
    lost
        Whether the words say that nobody knows where it is, or that it cannot come by itself.
    every
        Whether all that are called so are meant: "all crates".
    count
        How many are meant: "the three crates"; None if that is not said.
    other
        Whether those that were not named so far are meant: "the other one".
    ordinal
        Which of several, from 1: "the second crate"; None if that is not said.
    without
        Who is left out of all that are meant: "all crates but the red one".
    text
        As it was written.
    """

    name: str
    text: str
    determined: bool = False
    states: tuple[str, ...] = ()
    description: str = ""
    pronoun: str = ""
    lost: bool = False
    every: bool = False
    count: int | None = None
    other: bool = False
    ordinal: int | None = None
    without: tuple[Phrase, ...] = ()

    @property
    def several(self) -> bool:
        """Whether more than one is meant, going by the words: "all staff", "crates"; not "Thomas", which is a name."""
        name_of_its_own = not self.determined and self.name[:1].isupper() and kind_of(self.name) is None
        one = self.text.lower().split()[:1] in (["a"], ["an"], ["one"], ["this"], ["that"])
        return self.every or self.count is not None or (not one and is_plural(self.name) and not name_of_its_own)

    @property
    def is_own_name(self) -> bool:
        """Whether it is written as a name of its own: "Rose", and neither "the rose" nor "ROSE" nor "rose"."""
        first = self.name[:1].isupper() and not (len(self.name) > 1 and self.name == self.name.upper())
        return first and not self.determined and len(self.name.split()) == 1

    @property
    def full(self) -> str:
        """The name with its states."""
        return " ".join((*self.states, self.name))


def kind_of_phrase(phrase: Phrase) -> str | None:
    """Base kind of what a phrase names, going by its noun; a name of its own is taken to be a person's."""
    head, _, last = phrase.name.rpartition(" ")
    numbered = (
        head if head and (last[-1].isdigit() or (last[:1].isupper() and kind_of(phrase.name) is None)) else phrase.name
    )
    kind = kind_of(numbered)
    if phrase.is_own_name and kind in {None, "object", "animal"} and not is_plural(phrase.name):
        return "person"  # Rose, Leo and Bill are people
    proper = not phrase.determined and phrase.name[:1].isupper()
    return kind or ("person" if proper else None)
