"""The words of a clause to the clause: verb first, without what only opens it, passes the time of day, or names robots."""

from __future__ import annotations

from missiontree.authoring.language.lexicon import Lexicon, phrases_of
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.voice import active, caused
from missiontree.authoring.reading.words import MARK, Word, is_mark

_DOING = tuple(
    tuple(who.split())
    for who in ("you are", "we are", "they are", "the robots are", "robots are", "a robot is", "the robot is")
)
_IN_ORDER = phrases_of("statements", "in_order")


def finished(words: tuple[Word, ...], lexicon: Lexicon, *, is_event: bool) -> Clause:
    marks = [place for place, word in enumerate(words) if is_mark([word.low], 0)]
    asked = tuple(dict.fromkeys(tuple(words[place].low.removeprefix(MARK).split("|")) for place in marks))
    before, _ = without_openings(list(words[: marks[0]]), lexicon) if marks else ([], ())
    leads = bool(marks) and lexicon.verb_at([word.low for word in before], 0, "base", "gerund") is None
    words = tuple(word for place, word in enumerate(words) if place not in marks)
    kept, passed = without_openings(list(words), lexicon)
    doers = next((len(who) for who in _DOING if is_event and tuple(word.low for word in kept[: len(who)]) == who), 0)
    if lexicon.verb_at([word.low for word in kept], doers, "gerund") is not None:
        kept = kept[doers:]  # "while you are looking for it"
    kept, in_order = _without_order(kept)
    kept, more = _without_passed_over(kept, lexicon)
    while kept and kept[-1].low == ",":
        kept.pop()
    kept, _ = without_openings(kept, lexicon)
    before = kept
    kept = caused(kept, lexicon)
    kept = kept if kept is not before else active(kept, lexicon, is_event=is_event)
    kept = _particle_to_verb(kept, lexicon)
    lows = [word.low for word in kept]
    verb = lexicon.verb_at(lows, 0, "base", "gerund")
    return Clause(
        words=tuple(kept),
        verb=verb,
        passed_over=(*passed, *more),
        decisive=tuple(phrase for phrase, _, _ in lexicon.decisive.within(lows)),
        asked=asked,
        leads=leads,
        in_order=in_order,
        own_subject=kept is not before,
    )


def says_something(words: list[Word], lexicon: Lexicon) -> bool:
    """Whether there is more than "hello" or "your mission is to"."""
    lows, place = [word.low for word in words], 0
    while place < len(lows):
        hit = lexicon.passed_over.at(lows, place) or lexicon.openings.at(lows, place)
        if hit is None and lows[place] != "," and not is_mark(lows, place):
            return True
        place += hit[1] if hit else 1
    return False


def without_openings(words: list[Word], lexicon: Lexicon) -> tuple[list[Word], tuple[str, ...]]:
    """The words behind "please", "the robots should" and the like, if a verb follows; else all of them, save marks."""
    words = [word for word in words if not is_mark([word.low], 0)]
    lows, start, passed = [word.low for word in words], 0, []
    while start < len(lows):
        if (hit := lexicon.passed_over.at(lows, start)) is not None:
            passed.append(hit[0])
        elif (hit := lexicon.openings.at(lows, start)) is None and lows[start] == ",":
            hit = (",", 1)
        if hit is None:
            break
        start += hit[1]
    if lexicon.verb_at(lows, start, "base", "gerund") is not None:
        return words[start:], tuple(passed)
    return words, ()


def _without_passed_over(words: list[Word], lexicon: Lexicon) -> tuple[list[Word], tuple[str, ...]]:
    lows, kept, passed, place = [word.low for word in words], [], [], 0
    while place < len(words):
        if (hit := lexicon.passed_over.at(lows, place)) is not None:
            passed.append(hit[0])
            place += hit[1]
        else:
            kept.append(words[place])
            place += 1
    return kept, tuple(passed)


def _particle_to_verb(words: list[Word], lexicon: Lexicon) -> list[Word]:
    """The words with "pick the parcel up" as "pick up the parcel"."""
    lows = [word.low for word in words]
    for place in range(2, len(lows)):
        ends = place + 1 == len(lows) or lows[place + 1] in _BEHIND_PARTICLE
        if lows[place] in _PARTICLES and ends and " ".join((lows[0], lows[place])) in lexicon.goals_of:
            return [words[0], words[place], *words[1:place], *words[place + 1 :]]
    return words


_PARTICLES = frozenset({"up", "over", "off", "down", "out", "on", "away"})
_BEHIND_PARTICLE = frozenset({"to", "at", "in", "on", "from", "into", "onto", ","})


def _without_order(words: list[Word]) -> tuple[list[Word], bool]:
    """The words without a closing "in that order", and whether there was one."""
    while words and words[-1].low == ",":
        words = words[:-1]
    for phrase in _IN_ORDER:
        width = len(phrase)
        if len(words) > width and tuple(word.low for word in words[-width:]) == phrase:
            return words[:-width], True
    return words, False
