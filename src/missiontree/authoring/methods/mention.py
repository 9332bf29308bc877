"""Somebody or something that the mission speaks of, as the tree-building calls name it."""

from __future__ import annotations

from dataclasses import dataclass
from textwrap import shorten

_SMALL = frozenset(
    {"the", "a", "an", "and", "or", "of", "in", "on", "at", "to", "with", "for", "from", "by", "into", "her", "his", "its", "their"}
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Mention:
    """
    Somebody or something, as the calls name it.

    Parameters
    ----------
    name
        Id of an entity of the scene, or the name under which it is introduced.
    label, full
        What people read, without and with its states.
    kind
        Its base kind.
    determined
        Whether "the" goes before it.
    new
        Whether the scene does not have it.
    known
        Whether the scene knows where it is.
    lost
        Whether the words say that it is lost.
    plural
        Whether it is more than one.
    """

    name: str
    label: str
    full: str
    kind: str
    determined: bool = True
    new: bool = True
    known: bool = False
    lost: bool = False
    plural: bool = False

    @property
    def to_be_found(self) -> bool:
        """Whether it has to be searched for before anything else is done with it."""
        return self.lost or (not self.new and not self.known and self.kind != "place")


class UnclearError(Exception):
    """What is meant cannot be said; carries a sentence that asks. Never leaves the reading of a clause."""


def topic(name: str, full: str = "") -> Mention:
    """What is only spoken of, and is nobody of the scene."""
    return Mention(title(name), title(name), title(full or name), "object")


MOST_OF_A_HEADING = 160


def heading(text: str) -> str:
    """The text as the label of a task: a :func:`title`, cut behind a word where it is longer than anybody reads."""
    return shorten(title(text), MOST_OF_A_HEADING, placeholder=" …")


def title(text: str) -> str:
    """The text as a heading: small words small, all others with a capital letter."""
    words = text.split()
    return " ".join(
        word if index and word.lower() in _SMALL else word[:1].upper() + word[1:] for index, word in enumerate(words)
    )
