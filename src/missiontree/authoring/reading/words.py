"""A text to its words and signs, in the form in which they are read."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass

MAX_WORDS = 1000
MARK = "@"  # begins a word that stands for a robot; no word of a text does, since signs are words of their own
STOPS = frozenset(".!?;:")
ARTICLES = frozenset({"the", "a", "an"})
POSSESSIVES = frozenset({"my", "your", "his", "her", "its", "our", "their"})
POINTING = frozenset({"this", "that", "these", "those"})
DETERMINERS = ARTICLES | POSSESSIVES | POINTING
"""What a noun phrase begins with."""
OBJECTS = DETERMINERS | {"it", "him", "them", "all", "both", "every", "each"}
"""What the object of a verb begins with, if it is no bare noun."""
MODALS = frozenset({"must", "should", "shall", "to"})
MUST = frozenset({"has", "have", "needs", "need", "is", "are", "ought"})
_TITLES = frozenset({"mr", "mrs", "ms", "dr", "prof"})
_WORD = re.compile(r"\w+(?:['\-.,:]\w+)*|\S")
_QUOTES = str.maketrans(
    {"’": "'", "‘": "'", "“": " ", "”": " ", '"': " ", "„": " ", "«": " ", "»": " ", "‐": "-", "‑": "-"}
)
_DASH = re.compile(r"\s[-\u2013\u2014]+\s|\u2014")
_ANDS = (("as", "well", "as"), ("along", "with"), ("together", "with"))
_GO = frozenset(
    {
        "go",
        "come",
        "drive",
        "walk",
        "head",
        "return",
        "travel",
        "fly",
        "going",
        "driving",
        "walking",
        "heading",
        "returning",
    }
)
_ALONE = frozenset({"home", "there"})


@dataclass(frozen=True, slots=True)
class Word:
    """A word as it is written, and in small letters."""

    text: str
    low: str


def words_of_text(text: str) -> tuple[Word, ...]:
    """The words and signs of a text; look-alike signs made alike, quotation marks left out."""
    plain = _DASH.sub(" , ", unicodedata.normalize("NFC", text).translate(_QUOTES))
    words = [Word(word, word.lower()) for word in _WORD.findall(plain)]
    words = _joined_up(_without_number_word(words))
    for place in range(len(words) - 1, 0, -1):  # "go home" as "go to home"
        if words[place].low in _ALONE and words[place].text.islower() and words[place - 1].low in _GO:
            words.insert(place, Word("", "to"))
    return tuple(
        word
        for place, word in enumerate(words)
        if not (word.low == "." and place and words[place - 1].low in _TITLES) and not _needless(words, place)
    )


def _without_number_word(words: list[Word]) -> list[Word]:
    """The words with "dock number 1" and "dock #1" as "dock 1"."""
    return [
        word
        for place, word in enumerate(words)
        if not (
            word.low in {"number", "nr", "#"}
            and place
            and words[place + 1 : place + 2]
            and words[place + 1].low[0].isdigit()
        )
    ]


def _joined_up(words: list[Word]) -> list[Word]:
    """The words with "as well as", "along with" and "together with" as "and"."""
    made: list[Word] = []
    place = 0
    while place < len(words):
        width = next((len(w) for w in _ANDS if tuple(word.low for word in words[place : place + len(w)]) == w), 0)
        if width and made and place + width < len(words):
            made.append(Word(" ".join(word.text for word in words[place : place + width]), "and"))
            place += width
            continue
        made.append(words[place])
        place += 1
    return made


def _needless(words: list[Word], place: int) -> bool:
    """Whether a comma only sets off what describes: "Anna, who is lost" and "the safe, which is heavy, to the hall"."""
    if words[place].low != ",":
        return False
    following = words[place + 1].low if place + 1 < len(words) else ""
    if following in {"who", "which", "whose"}:
        return True
    if following in MODALS | MUST | {"can", "will"} and words[place - 1].low not in STOPS:
        return bool({"who", "which", "whose"} & {word.low for word in words[max(0, place - 14) : place]})
    before = [word.low for word in words[max(0, place - 10) : place]]
    return following in {"to", "into", "onto"} and bool({"who", "which", "whose"} & set(before))


def is_mark(lows: list[str], place: int) -> bool:
    return place < len(lows) and lows[place].startswith(MARK) and len(lows[place]) > len(MARK)
