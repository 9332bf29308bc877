"""Clauses in plain order: what is left out is put back, particles fall away, and the receiver goes behind a "to"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.authoring.language.lexicon import Lexicon, Verb
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.words import DETERMINERS, Word

TO = "to|into|onto|toward|towards"
ANY = f"{TO}|at|in|on|from|with|for|inside|near|against|under|over|around|between|about|by"
ANY_BUT_WITH = "|".join(word for word in ANY.split("|") if word != "with")
PREPOSITIONS = frozenset(ANY.split("|"))
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
    if clause.words[0].low == "back":
        return _back(clause, before, lexicon)
    behind = clause.words[1:] if phrase[-1] == clause.words[0].low else clause.words
    words = (*(Word(part, part) for part in phrase), *behind)
    verb = lexicon.verb_at([word.low for word in words], 0, "base")
    return replace(clause, words=words, verb=verb) if verb == replace(before.verb, length=len(phrase)) else clause


def _back(clause: Clause, before: Clause, lexicon: Lexicon) -> Clause:
    """The words "then back" with the verb and the object of the clause before: "take the pump to the field, then back"."""
    assert before.verb is not None
    rest = before.words[before.verb.length :]
    end = next((at for at, word in enumerate(rest) if word.low in {*TO.split("|"), "from"}), len(rest))
    goals = set(lexicon.goals_of.get(before.verb.phrase, ()))
    verb = (Word("go", "go"),) if "reach" in goals else tuple(Word(part, part) for part in before.verb.phrase.split())
    words = (*verb, *(() if "reach" in goals else rest[:end]), *clause.words)
    read = lexicon.verb_at([word.low for word in words], 0, "base")
    return clause if read is None else replace(clause, words=words, verb=read)


def not_until(clauses: Sequence[Clause], lexicon: Lexicon) -> tuple[Clause, ...]:
    """Words such as "do not do this until that is done" as "do this after that is done"."""
    kept = list(clauses)
    for index, clause in enumerate(kept):
        main = kept[clause.anchor] if clause.anchor is not None and clause.anchor < len(kept) else None
        if clause.relation != "until" or main is None or not set(main.decisive) <= _NOT or not main.decisive:
            continue
        width = next(
            (len(no.split()) for no in _NOT if [w.low for w in main.words[: len(no.split())]] == no.split()), 0
        )
        verb = lexicon.verb_at([word.low for word in main.words], width, "base") if width else None
        if verb is not None and clause.anchor is not None:
            kept[clause.anchor] = replace(main, words=main.words[width:], verb=verb, decisive=())
            kept[index] = replace(clause, relation="after")
    return tuple(kept)


_NOT = frozenset({"do not", "don't", "never"})


def with_object(clause: Clause, following: Clause | None) -> tuple[Word, ...]:
    """The words of a clause, the verb in its base form, with the object of the one behind it if it shares that."""
    assert clause.verb is not None
    base = tuple(Word(part, part) for part in clause.verb.phrase.split())
    if clause.verb.form == "base":
        base = clause.words[: clause.verb.length]
    rest = clause.words[clause.verb.length :]
    if clause.relation == "shares" and following is not None and following.verb is not None and not rest:
        behind = following.words[following.verb.length :]
        end = next((place for place, word in enumerate(behind) if place and word.low in TO.split("|")), len(behind))
        rest = behind[:end]
    return (*base, *rest)


MOVING = frozenset({"bring", "transport", "guide", "put"})
"""Goals that move somebody or something."""
GOING = MOVING | {"reach"}
"""Goals that lead somewhere."""


def plain_order(clause: Clause, *, moves: bool = True) -> tuple[Word, ...]:
    """The words with "back to" as "to", and "home" and "there" behind a "to"; "there" falls away if nothing moves."""
    words: list[Word] = []
    assert clause.verb is not None
    length = len(clause.verb.phrase.split())
    for place, word in enumerate(clause.words):
        following = clause.words[place + 1].low if place + 1 < len(clause.words) else ""
        if place >= length and word.low in _PARTICLES and following in {*PREPOSITIONS, "home", "there"}:
            continue
        before = words[-1].low if words else ""
        if word.low in {"home", "there"} and not following and place > length:
            object_her = before == "her" and place == length + 1
            if object_her or not (before in PREPOSITIONS | DETERMINERS or before.endswith("'s")):
                words.append(Word("to", "to"))
        words.append(word)
    return tuple(words)


_GOING = frozenset({"going", "driving", "walking", "flying"})
_BACK = frozenset({"it", "him", "her", "them", "there"})


def exception_first(words: tuple[Word, ...], length: int) -> tuple[Word, ...]:
    """Words such as "bring all crates to the hall except the red one" with the exception behind the crates."""
    lows = [word.low for word in words]
    place = next((at for at in range(len(lows) - 1, length, -1) if lows[at] in {"except", "but", "excluding"}), 0)
    goal = next((at for at in range(length, place) if lows[at] in TO.split("|")), 0)
    if not place or not goal or not {"all", "every", "each", "everyone", "everybody"} & set(lows[length:goal]):
        return words
    end = place - (lows[place - 1] == ",")
    return (*words[:goal], *words[place:], *words[goal:end])


def without_message(words: tuple[Word, ...], lexicon: Lexicon) -> tuple[Word, ...]:
    """The words without what somebody is warned of: "that the gate closes", "to leave the hall"."""
    lows = [word.low for word in words]
    for place in range(2, len(lows)):
        if lows[place] == "that" or (lows[place] == "to" and lexicon.verb_at(lows, place + 1, "base") is not None):
            return words[:place]
    return words


def by_doing(clause: Clause, lexicon: Lexicon) -> Clause | None:
    """
    The clause with the verb of how it is done: "get Anna to the lobby by guiding her" as "guide Anna to the lobby".

    None if it does not say how, or in another way than by moving somebody, or by going there for having a look.
    """
    words = clause.words
    assert clause.verb is not None
    length = len(clause.verb.phrase.split())
    place = next((at for at in range(len(words) - 1, length, -1) if words[at].low == "by"), 0)
    lows = [word.low for word in words]
    doing = lexicon.verb_at(lows, place + 1, "gerund") if place else None
    if doing is None and place and lows[place + 1 : place + 2] in (["going"], ["driving"], ["walking"], ["flying"]):
        doing = Verb(lows[place + 1], "gerund", 1)
    if doing is None or not {word.low for word in words[place + 1 + doing.length :]} <= _BACK | {"to"}:
        return None
    goals, how = set(lexicon.goals_of.get(clause.verb.phrase, ())), set(lexicon.goals_of.get(doing.phrase, ()))
    moved = goals & {"bring", "transport", "guide"} and how & {"bring", "transport", "guide"}
    looked = "look at" in goals and ("reach" in how or doing.phrase in _GOING)
    if not (moved or looked):
        return None
    verb = doing.phrase.split() if moved else clause.verb.phrase.split()
    rest = words[length:place]
    changed = (*(Word(part, part) for part in verb), *rest)
    return replace(clause, words=changed, verb=lexicon.verb_at([word.low for word in changed], 0, "base"))


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
        if words[place].low in DETERMINERS
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
