"""What a clause says beside what it asks for: whom it is not for ("not to Bob"), and what it is good for ("so that she can ...")."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.wording import PREPOSITIONS
from missiontree.authoring.reading.words import Word
from missiontree.mission.reason import Reason

_CONTRASTS = (("not",), ("and", "not"), ("but", "not"), ("instead", "of"), ("rather", "than"))
_PURPOSES = (("so", "that"), ("in", "order", "that"))


def without_asides(clause: Clause, phrases: PhraseReader, lexicon: Lexicon) -> tuple[Clause, tuple[Reason, ...]]:
    """
    The clause without a closing contrast or purpose, and an assumption for what was left out.

    The rule of the assumption is ``exception_unused`` for a contrast that may take somebody out of several: "but not pump 4".
    """
    for what, starts in (("contrast", _CONTRASTS), ("purpose", _PURPOSES)):
        place = _last(clause.words, starts)
        if not place or clause.verb is None or place <= clause.verb.length:
            continue
        width = max(len(start) for start in starts if _is_at(clause.words, place, start))
        behind = clause.words[place + width :]
        if what == "purpose" and lexicon.decisive.within([word.low for word in behind]):
            continue  # "so that she can work if it rains" holds a condition
        bare_not = clause.words[place].low == "not" and clause.words[place - 1].low not in {",", "and", "but"}
        if what == "contrast" and (bare_not or not _is_contrast(behind, clause.words[:place], phrases)):
            continue
        kept = clause.words[:place]
        while kept and kept[-1].low == ",":
            kept = kept[:-1]
        decisive = tuple(phrase for phrase, _, _ in lexicon.decisive.within([word.low for word in kept]))
        said = " ".join(word.text for word in clause.words[place:])
        like_before = behind[0].low in PREPOSITIONS  # "to Anna, not to Bob" takes nobody out of several
        reason = Reason(
            rule="purpose_unused" if what == "purpose" else "contrast_unused" if like_before else "exception_unused",
            message=f"{said!r} says what is {'not meant' if what == 'contrast' else 'intended'}; nothing is planned for it.",
            severity="assumption",
        )
        return replace(clause, words=kept, decisive=decisive), (reason,)
    return clause, ()


def _last(words: Sequence[Word], starts: Sequence[tuple[str, ...]]) -> int:
    """Where the last of these words begin; 0 if they do not stand there."""
    found = [(at, start) for at in range(len(words) - 1, 0, -1) for start in starts if _is_at(words, at, start)]
    if not found:
        return 0
    end = found[0][0] + len(found[0][1])  # of "not" and "but not", the longer that ends there
    return min(at for at, start in found if at + len(start) == end)


def _is_at(words: Sequence[Word], place: int, start: tuple[str, ...]) -> bool:
    return tuple(word.low for word in words[place : place + len(start)]) == start


def _is_contrast(behind: tuple[Word, ...], before: tuple[Word, ...], phrases: PhraseReader) -> bool:
    """Whether the words are somebody else, named as the last was: with the same preposition, or with none."""
    preposition = behind[:1] and behind[0].low in PREPOSITIONS
    if preposition and all(word.low != behind[0].low for word in before):
        return False
    read = phrases.phrases(behind[1:] if preposition else behind)
    return read is not None and len(read) == 1 and not read[0].pronoun and not read[0].description
