"""
How names are compared.

Robots, routines and entities are matched exactly, letter case aside. Only the name of a *parent* may be a little off, since a model
often rewords the task it has just made; a match of that kind is always announced. Look-alike letters of another script never
match: folding is canonical (NFC), not by compatibility, no letter becomes a plain one by it, and a word is near another only if both
are written in the same script and, accents aside, in the same alphabet.
"""

from __future__ import annotations

import difflib
import unicodedata
from collections.abc import Iterable
from itertools import groupby

_ARTICLES = frozenset({"the", "a", "an"})
_LINKING_WORDS = frozenset({"and", "with", "of", "for", "to", "in", "on", "at", "from", "her", "his", "its", "their"})
_LONG_WORD = 5
_MISSPELT_WORD = 4
_LONGEST_SHOWN = 80
_LONGEST_COMPARED = 200
_ALIKE = 0.5
_AS_ALIKE = 0.15


def same_name(name: str) -> str:
    """The form under which names of routines, robots and entities are compared: letter case and outer blanks aside."""
    return _folded(" ".join(name.split()))


def words_of(name: str) -> tuple[str, ...]:
    """The words of a name, letter case and punctuation aside."""
    return tuple(_folded(word) for word in _split(name))


def without_articles(name: str) -> tuple[str, ...]:
    """The words of a name, articles aside as well; the "A" of "Gate A" and of "Gate A to dock" is none."""
    words = _split(name)
    return tuple(
        _folded(word)
        for place, word in enumerate(words)
        if word.lower() not in _ARTICLES or place == len(words) - 1 or (word == "A" and place)
    )


def is_near(name: str, other: str, long: int = _LONG_WORD) -> bool:
    """
    Whether two names mean the same but for linking words ("and" for "with") and one slip in a long word.

    Words that carry meaning must be the same and stand in the same order; numbers must be equal.

    Parameters
    ----------
    name, other
        The names.
    long
        From how many letters on a word is long. Default 5.
    """
    own, its = (tuple(w for w in without_articles(n) if w not in _LINKING_WORDS) for n in (name, other))
    if len(own) != len(its) or not own:
        return False
    return all(one == two or _one_slip(one, two, long) for one, two in zip(own, its, strict=True))


def is_misspelt(name: str, other: str) -> bool:
    """
    Whether two names differ in accents alone, or by one letter in words of four letters and more; numbers must be equal.

    For asking back only: who is called Otto may not be who is called Ottmar, or Ötto.
    """
    own, its = words_of(_without_accents(name)), words_of(_without_accents(other))
    if not own or len(own) != len(its):
        return False
    return all(one == two or _one_slip(one, two, _MISSPELT_WORD) for one, two in zip(own, its, strict=True))


def suggestions(name: str, known: Iterable[str], count: int = 3) -> list[str]:
    """Names that look most like the given one, best first; for a person or a model to pick from."""
    by_form = {same_name(candidate): candidate for candidate in known}
    form = same_name(name)[:_LONGEST_COMPARED]
    near = difflib.get_close_matches(form, by_form, n=count, cutoff=_ALIKE)
    likeness = [difflib.SequenceMatcher(None, found, form).ratio() for found in near]
    return [by_form[found] for found, alike in zip(near, likeness, strict=True) if alike >= likeness[0] - _AS_ALIKE]


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A hint naming the nearest matches; empty if nothing is near."""
    near = suggestions(name, known)
    return f"Did you mean {' or '.join(repr(candidate) for candidate in near)}?" if near else ""


def listed(names: Iterable[str], most: int = 20) -> str:
    """Names separated by commas, the first few of a long list."""
    every = list(names)
    tail = f" and {len(every) - most} more" if len(every) > most else ""
    return ", ".join(every[:most]) + tail if every else "none"


def quoted(name: str) -> str:
    """A name that came from outside, in quotes, its control characters escaped, and cut if it is long."""
    return repr(name if len(name) <= _LONGEST_SHOWN else f"{name[:_LONGEST_SHOWN]}...")


def _split(name: str) -> list[str]:
    """The words of a name as they are written, without punctuation."""
    return "".join(" " if unicodedata.category(letter)[0] in "PZ" else letter for letter in name).split()


def _folded(text: str) -> str:
    """The text with letter case aside, look-alikes of plain letters left as they are."""
    if text.isascii():
        return text.lower()
    return "".join(
        "".join(part) if disguised else unicodedata.normalize("NFC", "".join(part)).casefold()
        for disguised, part in groupby(text, _is_disguised)
    )


def _is_disguised(letter: str) -> bool:
    """Whether folding would make plain letters of one that only looks like them: the long s, the Kelvin sign, a ligature."""
    if letter.isascii() or letter in "ßẞ":  # in capitals it is written SS
        return False
    return unicodedata.normalize("NFC", letter).casefold().isascii()


def _without_accents(name: str) -> str:
    parts = unicodedata.normalize("NFD", name)
    return "".join(part for part in parts if not unicodedata.combining(part))


def _one_slip(one: str, two: str, shortest: int) -> bool:
    """Whether two long words of one script differ by one letter left out, put in, changed, or by two swapped."""
    if min(len(one), len(two)) < shortest or _has_digit(one + two):
        return False
    if _scripts(one) != _scripts(two) or _without_accents(one).isascii() != _without_accents(two).isascii():
        return False  # Latin script has look-alikes of its own: a dotless i, an alpha
    start = 0
    while start < min(len(one), len(two)) and one[start] == two[start]:
        start += 1
    left, right = one[start:], two[start:]
    if left[1:] == right[1:] or left[1:] == right or left == right[1:]:
        return True
    return left[2:] == right[2:] and left[:2] == right[1::-1]


def _scripts(word: str) -> set[str]:
    return {unicodedata.name(letter, "?").split(" ")[0] for letter in word}


def _has_digit(word: str) -> bool:
    return any(letter.isnumeric() for letter in word)
