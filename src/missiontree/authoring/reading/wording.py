"""Clauses in plain order: what is left out is put back, particles fall away, and the receiver goes behind a "to"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clauses import Clause, Word
from missiontree.authoring.reading.phrases import PhraseReader

TO = "to|into|onto|toward|towards"
ANY = f"{TO}|at|in|on|from|with|for|inside|near|against|under|over|around|between|about|by"
_PREPOSITIONS = frozenset(ANY.split("|"))
_DETERMINERS = frozenset(
    {"the", "a", "an", "her", "his", "my", "our", "their", "its", "your", "this", "that", "these", "those"}
)
_PARTICLES = frozenset({"back", "over", "along", "away", "down", "up", "out"})
_RECEIVERS = frozenset({"him", "her", "them"})


def verbs_repeated(clauses: Sequence[Clause], lexicon: Lexicon) -> tuple[Clause, ...]:
    """The clauses; one without a verb behind "then" has the verb of the one before: "go to the gate, then to the lift"."""
    kept: list[Clause] = []
    for clause in clauses:
        before = kept[-1] if kept else None
        lacks = clause.verb is None and clause.relation == "then" and before is not None and before.verb is not None
        kept.append(_with_verb(clause, before, lexicon) if lacks and before is not None else clause)
    return tuple(kept)


def _with_verb(clause: Clause, before: Clause, lexicon: Lexicon) -> Clause:
    assert before.verb is not None
    if before.verb.form != "base" or any(
        word.low in {"is", "are", "was", "were", "has", "have"} for word in clause.words
    ):
        return clause
    phrase = before.verb.phrase.split()
    behind = clause.words[1:] if phrase[-1] == clause.words[0].low else clause.words
    words = (*(Word(part, part) for part in phrase), *behind)
    verb = lexicon.verb_at([word.low for word in words], 0, "base")
    return replace(clause, words=words, verb=verb) if verb == replace(before.verb, length=len(phrase)) else clause


def with_object(clause: Clause, following: Clause | None) -> Clause:
    """The clause, with the object of the one behind it if it shares that."""
    assert clause.verb is not None
    base = tuple(Word(part, part) for part in clause.verb.phrase.split())
    rest = clause.words[clause.verb.length :]
    if clause.relation == "shares" and following is not None and following.verb is not None and not rest:
        behind = following.words[following.verb.length :]
        end = next((place for place, word in enumerate(behind) if place and word.low in TO.split("|")), len(behind))
        rest = behind[:end]
    return replace(clause, words=(*base, *rest))


def plain_order(clause: Clause) -> tuple[Word, ...]:
    """The words with "back to" as "to", and "home" and "there" behind a "to"."""
    words: list[Word] = []
    assert clause.verb is not None
    for place, word in enumerate(clause.words):
        following = clause.words[place + 1].low if place + 1 < len(clause.words) else ""
        if place >= clause.verb.length and word.low in _PARTICLES and following in {*_PREPOSITIONS, "home", "there"}:
            continue
        before = words[-1].low if words else ""
        if word.low in {"home", "there"} and not following and place > clause.verb.length:
            object_her = before == "her" and place == clause.verb.length + 1
            if object_her or not (before in _PREPOSITIONS | _DETERMINERS or before.endswith("'s")):
                words.append(Word("to", "to"))
        words.append(word)
    return tuple(words)


def receiver_behind(words: tuple[Word, ...], start: int, phrases: PhraseReader) -> tuple[Word, ...]:
    """
    "Bring Anna the keys" as "bring the keys to Anna"; other words stay as they are.

    Parameters
    ----------
    words
        A clause that begins with a verb of bringing.
    start
        Index of the first word behind the verb.
    phrases
        Reads what is brought and who receives it.
    """
    if any(word.low in TO.split("|") for word in words[start:]):
        return words
    splits = [
        place
        for place in range(start + 1, len(words))
        if words[place].low in _DETERMINERS
        and _is_receiver(words[start:place], phrases)
        and phrases.phrases(words[place:])
    ]
    if len(splits) != 1:
        return words
    place = splits[0]
    return (*words[:start], *words[place:], Word("to", "to"), *words[start:place])


def _is_receiver(words: tuple[Word, ...], phrases: PhraseReader) -> bool:
    """Whether the words are one person or animal, and nothing else that could be brought."""
    if len(words) == 1 and words[0].low in _RECEIVERS:
        return True
    read = phrases.phrases(words)
    if read is None or len(read) != 1 or read[0].pronoun or read[0].description:
        return False
    return phrases.kind_of(read[0]) in {"person", "animal"}
