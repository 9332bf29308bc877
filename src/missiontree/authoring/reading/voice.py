"""What is to be done, said in another way than as an order: in the passive, as something that happens, as something to have done."""

from __future__ import annotations

from missiontree.authoring.language.lexicon import Lexicon, Verb, phrases_of
from missiontree.authoring.reading.clause import MAX_CLAUSE_WORDS
from missiontree.authoring.reading.words import MODALS, MUST, Word

_AUXILIARIES = frozenset({"is", "are", "be", "gets", "been"})
_DOERS = frozenset({"you", "we", "they", "the robots", "the robot", "a robot", "robots"})
_CAUSES = phrases_of("statements", "causes")
_ANYBODY = frozenset({"somebody", "someone", "anybody", "anyone"})
_WISHES = (("would", "like", "to"), ("wants", "to"), ("want", "to"), ("wishes", "to"), ("asks", "to"))
_TO_BE: frozenset[str] = frozenset({"a", "an", "the"})


def active(words: list[Word], lexicon: Lexicon, *, is_event: bool) -> list[Word]:
    """
    Turn "the forklift must be found" and "you have found the forklift" into "find the forklift"; other words stay as they are.

    "The forklift is found" asks for something only as an event that something else waits for; alone it is a statement.
    """
    if words and words[0].low in {"shall", "should", "must"}:  # "only then shall the gate be closed"
        be = next((at for at in range(2, len(words)) if words[at].low == "be"), 0)
        words = [*words[1:be], words[0], *words[be:]] if be else words
    lows = [word.low for word in words]
    if is_event and (done := past_verb(lows, 0, lexicon)) is not None:  # "having delivered the box"
        return [*(Word(part, part) for part in done.phrase.split()), *words[done.length :]]
    if is_event and (place := next((at for at in (1, 2) if lows[at : at + 1] in (["have"], ["has"])), 0)):
        verb = lexicon.verb_at(lows, place + 1, "past")
        if verb is not None and " ".join(lows[:place]) in _DOERS:
            return [*(Word(part, part) for part in verb.phrase.split()), *words[place + 1 + verb.length :]]
    if is_event and lows[:1] and lows[0] in _ANYBODY and (does := lexicon.verb_at(lows, 1, "third")) is not None:
        return [*(Word(part, part) for part in does.phrase.split()), *words[1 + does.length :]]
    for place in range(1, min(len(lows), MAX_CLAUSE_WORDS)):
        if lows[place] not in _AUXILIARIES:
            continue
        behind = place + 1 + (lows[place + 1 : place + 2] in (["been"], ["being"]))
        asked = lows[place] == "be" and lows[place - 1] in MODALS
        must = place - 2 if lows[place - 1] == "to" and lows[place - 2] in MUST else place - 1
        must = next(
            (place - len(w) for w in _WISHES if place > len(w) and tuple(lows[place - len(w) : place]) == w), must
        )
        if (asked or is_event) and (verb := past_verb(lows, behind, lexicon)) is not None:
            if words[behind + verb.length : behind + verb.length + 1] and words[behind + verb.length].low in {
                "and",
                ",",
            }:
                return words
            end = must if asked else place - 1 if lows[place - 1] in {"has", "have"} else place
            active = [Word(part, part) for part in verb.phrase.split()]
            return [*active, *words[:end], *words[behind + verb.length :]]
    return words


def caused(words: list[Word], lexicon: Lexicon) -> list[Word]:
    """Turn "have the crate moved to the hall" and "I need the crate taken to the hall" into "move the crate to the hall"."""
    lows = [word.low for word in words]
    start = next((len(phrase) for phrase in _CAUSES if tuple(lows[: len(phrase)]) == phrase), 0)
    if not start:
        return words
    for place in range(start + 1, min(len(lows), MAX_CLAUSE_WORDS)):
        if lows[place - 1] in _TO_BE or (verb := past_verb(lows, place, lexicon)) is None:
            continue
        if lows[place - 1] in {"that", "who", "which", "was", "been"}:
            continue
        if lows[place - 1] in {"is", "are"} and lows[0] not in {"make", "ensure", "see"}:
            continue
        end = (
            place - 2
            if lows[place - 2 : place] == ["to", "be"]
            else place - 1
            if lows[place - 1] in _AUXILIARIES
            else place
        )
        return [*(Word(part, part) for part in verb.phrase.split()), *words[start:end], *words[place + verb.length :]]
    return words


def past_verb(lows: list[str], place: int, lexicon: Lexicon) -> Verb | None:
    """The verb that begins there; in "moved to the hall", *move* and not *move to*, which asks whoever moves."""
    verb = lexicon.verb_at(lows, place, "past")
    if verb is None or verb.length == 1 or verb.phrase.split()[-1] not in {"to", "from"}:
        return verb
    return lexicon.verb_at(lows[: place + 1], place, "past") or verb
