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
    words = _subject_first(words)
    done = _done_by_somebody(words, lexicon) if is_event else None
    return done or _passive(words, lexicon, is_event=is_event) or words


def _subject_first(words: list[Word]) -> list[Word]:
    """The words "shall the gate be closed", as they stand behind "only then", as "the gate shall be closed"."""
    if not words or words[0].low not in {"shall", "should", "must"}:
        return words
    be = next((at for at in range(2, len(words)) if words[at].low == "be"), 0)
    return [*words[1:be], words[0], *words[be:]] if be else words


def _done_by_somebody(words: list[Word], lexicon: Lexicon) -> list[Word] | None:
    """The order in "having delivered the box", "you have found the box", "anyone paints it"; None if there is none."""
    lows = [word.low for word in words]
    if (done := past_verb(lows, 0, lexicon)) is not None:
        return _order(done, words[done.length :])
    if lows[:1] and lows[0] in _ANYBODY and (does := lexicon.verb_at(lows, 1, "third")) is not None:
        return _order(does, words[1 + does.length :])
    have = next((at for at in (1, 2) if lows[at : at + 1] in (["have"], ["has"])), 0)
    done = lexicon.verb_at(lows, have + 1, "past") if have else None
    return _order(done, words[have + 1 + done.length :]) if done and " ".join(lows[:have]) in _DOERS else None


def _passive(words: list[Word], lexicon: Lexicon, *, is_event: bool) -> list[Word] | None:
    """The order in "the box must be found" and, of an event, in "the box is found"; None if there is none, or more than one."""
    lows = [word.low for word in words]
    for place in range(1, min(len(lows), MAX_CLAUSE_WORDS)):
        asked = lows[place] == "be" and lows[place - 1] in MODALS
        if lows[place] not in _AUXILIARIES or not (asked or is_event):
            continue
        behind = place + 1 + (lows[place + 1 : place + 2] in (["been"], ["being"]))
        if (verb := past_verb(lows, behind, lexicon)) is None:
            continue
        rest = words[behind + verb.length :]
        if rest and rest[0].low in {"and", ","}:
            return None
        end = _end_of_subject(lows, place) if asked else place - (lows[place - 1] in {"has", "have"})
        return _order(verb, [*words[:end], *rest])
    return None


def _end_of_subject(lows: list[str], place: int) -> int:
    """How many words stand before the "must", "has to" or "would like to" of a "be"."""
    for wish in _WISHES:
        if place > len(wish) and tuple(lows[place - len(wish) : place]) == wish:
            return place - len(wish)
    return place - 2 if lows[place - 1] == "to" and lows[place - 2] in MUST else place - 1


def _order(verb: Verb, behind: list[Word]) -> list[Word]:
    return [*(Word(part, part) for part in verb.phrase.split()), *behind]


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
