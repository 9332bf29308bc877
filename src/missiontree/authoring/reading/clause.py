"""A part of the mission that asks for one thing."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from missiontree.authoring.language.lexicon import Verb
from missiontree.authoring.reading.words import Word

Relation = Literal["start", "and", "then", "earlier", "meanwhile", "before", "after", "while", "until", "shares", "or"]
MAX_CLAUSE_WORDS = 60
SUBORDINATE = frozenset({"before", "after", "while", "until"})
Doubt = Literal["", "first", "last"]
_BLANK_BEFORE_SIGN = re.compile(r" (?=[,)])")


@dataclass(frozen=True, slots=True)
class Clause:
    """
    A part of the mission that asks for one thing.

    Parameters
    ----------
    words
        Its words from the verb on, or all of them if no verb is understood.
    verb
        The verb it begins with; None if none is understood.
    relation
        How it is joined to ``anchor``: itself *before*, *after*, *while* ... the other says so. ``earlier``: it ends before the other
        starts. ``or``: one of the two is done. ``shares``: it has no object of its own and takes that of the clause behind it.
    anchor
        Index of the clause it is joined to; None if to none.
    passed_over
        Words that change nothing, left out of ``words``.
    decisive
        Words that change what is asked for; if there are any, the clause is not understood.
    asked
        Robot types that are named to do it, once for each naming; any of one naming may.
    without
        Robot types that are left out.
    throughout
        Robot types that alone are asked for in the whole mission; none means any.
    leads
        Whether those asked are named before the verb.
    either
        Whether a choice begins here that ends with the clause joined by *or*.
    in_order
        Whether what it asks for is to be done in the order in which it is named.
    pause
        Whether a comma stands before the *and* that joins it.
    listed
        Whether a comma alone joins it.
    opens, closes
        Whether it is said to be the first, or the last, of all.
    doubt
        What is not clear about its order. ``first``: that is said of it though orders stand before it, and it may go before those or not.
        ``last``: "at the end" and the like stand behind a list, and it may be said of its last part alone.
    own_subject
        Whether it says itself who or what it is about: "the box must be found".
    sentence
        Number of its sentence.
    """

    words: tuple[Word, ...]
    verb: Verb | None = None
    relation: Relation = "start"
    anchor: int | None = None
    passed_over: tuple[str, ...] = ()
    decisive: tuple[str, ...] = ()
    asked: tuple[tuple[str, ...], ...] = ()
    without: tuple[str, ...] = ()
    throughout: tuple[str, ...] = ()
    leads: bool = False
    either: bool = False
    in_order: bool = False
    pause: bool = False
    listed: bool = False
    own_subject: bool = False
    opens: bool = False
    closes: bool = False
    doubt: Doubt = ""
    sentence: int = 0

    @property
    def robots(self) -> tuple[str, ...]:
        """Robot types that may do it, going by what is asked for; none means any."""
        return self.asked[0] if self.asked else ()

    @property
    def text(self) -> str:
        """The words as they were written."""
        return _BLANK_BEFORE_SIGN.sub("", " ".join(word.text for word in self.words if word.text))
