"""Robots that the mission names: "with the tele-robot", "use the tele-robot to ...", "the tele-robot should ..."."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from missiontree.authoring.language.lexicon import Lexicon, PhraseTable
from missiontree.authoring.reading.clauses import MARK, Clause, Word, words_of_text
from missiontree.mission.fleet import Fleet

_WITH = PhraseTable({tuple(text.split()): text for text in ("with", "using", "by", "by means of", "with the help of")})
_ORDER = frozenset({"use", "have", "let", "send", "ask", "tell", "order", "get", "instruct", "command"})
_MUST = PhraseTable(
    {
        tuple(text.split()): text
        for text in ("should", "must", "shall", "will", "has to", "have to", "needs to", "is to", "ought to")
    }
)
_BEGINS = frozenset(
    {",", ".", "!", "?", ";", ":", "and", "then", "while", "whilst", "until", "before", "after", "finally", "first"}
)
_DETERMINERS = frozenset({"the", "a", "an", "our", "my", "your"})
_GOES_ON = frozenset({"and", "then", "shares"})


def robots_marked(words: tuple[Word, ...], fleet: Fleet, lexicon: Lexicon, known: frozenset[str]) -> tuple[Word, ...]:
    """
    The words with every naming of who shall do it made one marked word.

    Parameters
    ----------
    words
        All words of the mission.
    fleet
        Its robot types are named by id or label; a robot's own name stands for its type if that has no other robot.
    lexicon
        What verbs there are.
    known
        Names of the scene, which are never taken for a robot.
    """
    names = _names(fleet, known)
    return _Marker(words, names, lexicon).marked() if names else words


def named_robots(fleet: Fleet, known: frozenset[str]) -> PhraseTable:
    """Every name of a robot or a robot type, plurals too, to what is shown of it."""
    singular = {low: low for kind in fleet.types for low in (kind.id, kind.label)} | {
        name: name for name in fleet.robots
    }
    forms = {form: shown for name, shown in singular.items() for form in _spellings(name)}
    plural = {(*form[:-1], form[-1] + "s"): shown for form, shown in forms.items()}
    return PhraseTable({form: shown for form, shown in (plural | forms).items() if " ".join(form) not in known})


def robots_carried(clauses: Sequence[Clause]) -> tuple[Clause, ...]:
    """The clauses; who is told to do one thing "and" another does both, unless another robot is named."""
    kept: list[Clause] = []
    leading: tuple[str, ...] = ()
    for index, clause in enumerate(clauses):
        if index == 0 or clause.sentence != clauses[index - 1].sentence or clause.leads:
            leading = clause.robots if clause.leads else ()
        goes_on = clause.relation in _GOES_ON and not clause.robots
        kept.append(replace(clause, robots=leading) if goes_on else clause)
    return tuple(kept)


def _names(fleet: Fleet, known: frozenset[str]) -> PhraseTable | None:
    table: dict[tuple[str, ...], str] = {}
    for kind in fleet.types:
        own = [robot.id for robot in kind.members] if len(kind.members) == 1 else []
        for name in (kind.id, kind.label, *own):
            table |= {form: kind.id for form in _spellings(name) if " ".join(form) not in known}
    return PhraseTable(table) if table else None


def _spellings(name: str) -> set[tuple[str, ...]]:
    texts = (name, name.replace("_", " "), name.replace("_", " ").replace("-", " "))
    return {form for text in texts if (form := tuple(word.low for word in words_of_text(text)))}


@dataclass
class _Marker:
    """Walks over the words once."""

    words: tuple[Word, ...]
    names: PhraseTable
    lexicon: Lexicon
    lows: list[str] = field(init=False)

    def __post_init__(self) -> None:
        self.lows = [word.low for word in self.words]

    def marked(self) -> tuple[Word, ...]:
        made: list[Word] = []
        place = 0
        while place < len(self.words):
            width, more = self._at(place)
            made += more or (self.words[place],)
            place += width or 1
        return tuple(made)

    def _at(self, place: int) -> tuple[int, tuple[Word, ...]]:
        """How many words a naming takes here, and what stands for them; nothing if there is none."""
        begins = place == 0 or self.lows[place - 1] in _BEGINS
        for found in (
            self._instrument(place),
            self._order(place) if begins else None,
            self._subject(place) if begins else None,
        ):
            if found is not None:
                return found
        return 0, ()

    def _robot(self, place: int) -> tuple[str, int] | None:
        """The robot type that is named here, and how many words that takes with its article."""
        article = place < len(self.lows) and self.lows[place] in _DETERMINERS
        hit = self.names.at(self.lows, place + article)
        return (hit[0], hit[1] + article) if hit is not None else None

    def _instrument(self, place: int) -> tuple[int, tuple[Word, ...]] | None:
        hit = _WITH.at(self.lows, place)
        robot = self._robot(place + hit[1]) if hit is not None else None
        if hit is None or robot is None:
            return None
        end = place + hit[1] + robot[1]
        return hit[1] + robot[1], (self._mark(place, end, robot[0]),)

    def _order(self, place: int) -> tuple[int, tuple[Word, ...]] | None:
        robot = self._robot(place + 1) if self.lows[place] in _ORDER else None
        if robot is None:
            return None
        end = place + 1 + robot[1]
        to = self.lows[end : end + 1] == ["to"]
        if self._verb(end + to):
            return end + to - place, (self._mark(place, end, robot[0]),)
        if self.lows[place] == "send" and to:
            return end - place, (self._mark(place, end, robot[0]), Word("go", "go"))
        return None

    def _subject(self, place: int) -> tuple[int, tuple[Word, ...]] | None:
        robot = self._robot(place)
        if robot is None:
            return None
        end = place + robot[1]
        must = _MUST.at(self.lows, end)
        if must is not None and self._verb(end + must[1]):
            return end + must[1] - place, (self._mark(place, end, robot[0]),)
        if self.lows[end : end + 1] in ([","], [":"]) and self._verb(end + 1):
            return end + 1 - place, (self._mark(place, end, robot[0]),)
        going_on = self.lows[end : end + 1] == ["is"] and place > 0 and self.lows[place - 1] in {"while", "whilst"}
        if going_on and self.lexicon.verb_at(self.lows, end + 1, "gerund") is not None:
            return end + 1 - place, (self._mark(place, end, robot[0]),)
        return None

    def _verb(self, place: int) -> bool:
        while (hit := self.lexicon.passed_over.at(self.lows, place)) is not None:
            place += hit[1]
        return self.lexicon.verb_at(self.lows, place, "base") is not None

    def _mark(self, start: int, end: int, kind: str) -> Word:
        return Word(" ".join(word.text for word in self.words[start:end]), MARK + kind)
