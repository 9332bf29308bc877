"""Robots that the mission names: "with the tele-robot", "use the tele-robot to ...", "the tele-robot should ..."."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from missiontree.authoring.language.lexicon import Lexicon, PhraseTable, phrase_table
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.words import MARK, Word, words_of_text
from missiontree.mission.fleet import Fleet

_WITH = phrase_table("robots", "with")
_ORDER = frozenset(
    {"use", "have", "let", "send", "ask", "tell", "order", "get", "instruct", "command", "make", "dispatch", "deploy"}
)
_MUST = phrase_table("robots", "must")
_WANT = phrase_table("robots", "want")
_BEGINS = frozenset(
    {
        ",",
        ".",
        "!",
        "?",
        ";",
        ":",
        "-",
        "and",
        "then",
        "while",
        "whilst",
        "until",
        "before",
        "after",
        "finally",
        "first",
        "or",
        "but",
    }
    | {"please", "next", "only", "either", "meanwhile", "afterwards"}
)
_SINGLE = frozenset({"a", "an", "one"})
_DETERMINERS = frozenset({"the", "our", "my", "your", "any", "either", *_SINGLE})
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
    names = robot_names(fleet, known)
    return _Marker(words, names, lexicon).marked() if names else words


def named_robots(fleet: Fleet, known: frozenset[str]) -> PhraseTable:
    """Every name of a robot or a robot type, plurals too, to what is shown of it."""
    singular = {low: low for kind in fleet.types for low in (kind.id, kind.label)} | {
        name: name for name in fleet.robots
    }
    forms = {form: shown for name, shown in singular.items() for form in _spellings(name)}
    return PhraseTable({form: shown for form, shown in _with_plurals(forms).items() if " ".join(form) not in known})


def robot_names(fleet: Fleet, known: frozenset[str]) -> PhraseTable | None:
    """Every name that stands for a robot type, plurals too, to the type's id; None if there is none."""
    table: dict[tuple[str, ...], str] = {}
    for kind in fleet.types:
        own = [robot.id for robot in kind.members] if len(kind.members) == 1 else []
        for name in (kind.id, kind.label, *own):
            table |= dict.fromkeys(_spellings(name), kind.id)
    table |= {form: kind for form, kind in by_last_word(fleet).items() if form not in table}
    table = {form: kind for form, kind in _with_plurals(table).items() if " ".join(form) not in known}
    return PhraseTable(table) if table else None


def robots_carried(clauses: Sequence[Clause]) -> tuple[Clause, ...]:
    """The clauses; who is told to do one thing "and" another does both, unless another robot is named."""
    kept: list[Clause] = []
    leading: tuple[tuple[str, ...], ...] = ()
    for index, clause in enumerate(clauses):
        new = clause.relation not in _GOES_ON or index == 0 or clause.sentence != clauses[index - 1].sentence
        if new or clause.leads:
            leading = clause.asked if clause.leads else ()
        goes_on = clause.relation in _GOES_ON and not clause.asked and not clause.own_subject
        kept.append(replace(clause, asked=leading) if goes_on else clause)
    return tuple(kept)


def by_last_word(fleet: Fleet) -> dict[tuple[str, ...], str]:
    """The last word of labels of several words, where one type alone has it: the scooter, for a mobile scooter."""
    last: dict[str, list[str]] = {}
    for kind in fleet.types:
        words = [word.low for word in words_of_text(kind.label.replace("_", " ").replace("-", " "))]
        if len(words) > 1:
            last.setdefault(words[-1], []).append(kind.id)
    generic = {"robot", "robots", "unit", "machine", "vehicle"}
    return {
        (word,): kinds[0] for word, kinds in last.items() if len(kinds) == 1 and word not in generic and word.isalpha()
    }


@dataclass(frozen=True, slots=True)
class Named:
    """Robot types named in a row, how many words that takes, and whether *and* joins them."""

    types: tuple[str, ...]
    length: int
    together: bool = False


def named_at(names: PhraseTable, lows: Sequence[str], start: int, joins: frozenset[str]) -> Named | None:
    """The robot types that are named from a place on, joined by the words given; None if there are none."""
    types: list[str] = []
    place, end, together = start, start, False
    while True:
        article = place < len(lows) and lows[place] in _DETERMINERS
        hit = names.at(lows, place + article)
        following = lows[place + article + hit[1] : place + article + hit[1] + 2] if hit is not None else []
        if hit is None or _is_numbered(following):
            break
        types.append(hit[0])
        end = place + article + hit[1]
        together |= len(types) > 1 and "and" in lows[place - 2 : place]
        place = end
        while place < len(lows) and lows[place] in joins:
            place += 1
        if place == end:
            break
    return Named(tuple(dict.fromkeys(types)), end - start, together) if types else None


def _is_numbered(following: Sequence[str]) -> bool:
    """Whether a number behind a type asks for one robot of it: "tele-robot 2"."""
    number = following[1:2] if following[:1] in (["number"], ["no"]) else following[:1]
    return bool(number) and number[0].isdecimal()


OR = frozenset({"or", ","})
"""What joins robots of which any may do it."""


def _with_plurals(forms: dict[tuple[str, ...], str]) -> dict[tuple[str, ...], str]:
    return {(*form[:-1], form[-1] + "s"): shown for form, shown in forms.items()} | forms


def _spellings(name: str) -> set[tuple[str, ...]]:
    plain = name.replace("_", " ").replace("-", " ")
    texts = (name, name.replace("_", " "), plain, plain.replace(" ", "-"), plain.replace(" ", ""))
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
        begins = place == 0 or self.lows[place - 1] in _BEGINS or self.lows[place - 1].startswith(MARK)
        for found in (
            self._instrument(place),
            self._wanted(place) if begins else None,
            self._order(place) if begins else None,
            self._subject(place) if begins else None,
        ):
            if found is not None:
                return found
        return 0, ()

    def _robots(self, place: int) -> Named | None:
        """The robot types that are named here, any of which may do it."""
        return named_at(self.names, self.lows, place, OR)

    def _only(self, place: int) -> int:
        return int(self.lows[place : place + 1] in (["only"], ["just"], ["exclusively"]))

    def _instrument(self, place: int) -> tuple[int, tuple[Word, ...]] | None:
        """Words such as "with the drone", "either with the drone or with the crawler", "using only drones"."""
        start = place + self._only(place)
        start += self.lows[start : start + 1] == ["either"]
        hit = _WITH.at(self.lows, start)
        if hit is None:
            return None
        behind = start + hit[1] + self._only(start + hit[1])
        named = self._robots(behind)
        if named is None:
            return None
        types, end = named.types, behind + named.length
        while self.lows[end : end + 1] == ["or"] and (more := _WITH.at(self.lows, end + 1)) is not None:
            if (also := self._robots(end + 1 + more[1])) is None:
                break
            types, end = (*types, *also.types), end + 1 + more[1] + also.length
        end += self._only(end)
        return end - place, (self._mark(place, end, types),)

    def _wanted(self, place: int) -> tuple[int, tuple[Word, ...]] | None:
        """Words such as "I want the drone to ..."."""
        wish = _WANT.at(self.lows, place)
        named = self._robots(place + wish[1]) if wish is not None else None
        if wish is None or named is None:
            return None
        end = place + wish[1] + named.length
        told = self.lows[end : end + 1] == ["to"] and self._verb(end + 1)
        return (end + 1 - place, (self._mark(place, end, named.types),)) if told else None

    def _order(self, place: int) -> tuple[int, tuple[Word, ...]] | None:
        """Words such as "use the drone to ...", "send a drone to ...", "have the drone ..."."""
        start = place + self._only(place)
        if self.lows[start : start + 1] == [] or self.lows[start] not in _ORDER:
            return None
        behind = start + 1 + self._only(start + 1)
        named = self._robots(behind)
        if named is None:
            return self._any(start, behind)
        end = behind + named.length
        to = self.lows[end : end + 1] in (["to"], ["for"])
        if self.lows[end : end + 1] == ["for"] and self.lexicon.verb_at(self.lows, end + 1, "gerund") is not None:
            return end + 1 - place, (self._mark(place, end, named.types),)
        if self._verb(end + to) and self.lows[end : end + 1] != ["for"]:
            return end + to - place, (self._mark(place, end, named.types),)
        if self.lows[start] in {"send", "dispatch", "deploy"} and self.lows[end : end + 1] == ["to"]:
            return end - place, (self._mark(place, end, named.types), Word("go", "go"))
        if self.lows[start] in {"send", "dispatch"} and self.lows[end : end + 1] == ["after"]:
            return end + 1 - place, (self._mark(place, end, named.types), Word("follow", "follow"))
        return None

    def _any(self, start: int, place: int) -> tuple[int, tuple[Word, ...]] | None:
        """Words such as "send a robot to the gate", which name no type: somebody goes there."""
        end = place + (self.lows[place : place + 1] != [] and self.lows[place] in _DETERMINERS | {"some"})
        generic = self.lows[end : end + 1] in (["robot"], ["robots"]) and self.lows[start] in {"send", "dispatch"}
        if not generic or self.lows[end + 1 : end + 2] != ["to"] or self._verb(end + 2):
            return None
        return end + 1 - start, (Word("go", "go"),)

    def _subject(self, place: int) -> tuple[int, tuple[Word, ...]] | None:
        """Words such as "the drone should ...", "only a drone may ...", "drone: ..."."""
        start = place + self._only(place)
        named = named_at(self.names, self.lows, start, OR | {"and"})
        if named is None:
            return None
        end = start + named.length
        must = _MUST.at(self.lows, end)
        only_may = start > place or must is None or must[0] not in {"may", "can"}
        if must is not None and only_may and self._verb(end + must[1] + (self.lows[end + must[1] :][:1] == ["then"])):
            marks = [named.types] if not named.together else [(kind,) for kind in named.types]
            then = tuple(word for word in self.words[end + must[1] : end + must[1] + 1] if word.low == "then")
            told = tuple(self._mark(place, end, types) for types in marks)
            return end + must[1] + len(then) - place, (*then, *told)
        if named.together:
            return None
        if self.lows[end : end + 1] in ([","], [":"]) and self._verb(end + 1):
            return end + 1 - place, (self._mark(place, end, named.types),)
        sent = {"send", "dispatch", "deploy"} & set(self.lows[max(0, place - 12) : place])
        if sent and self.lows[end : end + 1] == ["to"] and self.lows[place - 1] == "and" and not self._verb(end + 1):
            return end - place, (self._mark(place, end, named.types), Word("go", "go"))
        going_on = (
            self.lows[end : end + 1] in (["is"], ["are"]) and place > 0 and self.lows[place - 1] in {"while", "whilst"}
        )
        if going_on and self.lexicon.verb_at(self.lows, end + 1, "gerund") is not None:
            return end + 1 - place, (self._mark(place, end, named.types),)
        finite = self.lexicon.verb_at(self.lows, end, "third")
        if finite is None and end > start and self.lows[end - 1].endswith("s"):
            finite = self.lexicon.verb_at(self.lows, end, "base")  # "the porters carry the bed"
        if finite is not None:
            base = tuple(Word(part, part) for part in finite.phrase.split())
            return end + finite.length - place, (self._mark(place, end, named.types), *base)
        return None

    def _verb(self, place: int) -> bool:
        while (hit := self.lexicon.passed_over.at(self.lows, place)) is not None:
            place += hit[1]
        return self.lexicon.verb_at(self.lows, place, "base") is not None

    def _mark(self, start: int, end: int, types: Sequence[str]) -> Word:
        return Word(" ".join(word.text for word in self.words[start:end]), MARK + "|".join(types))
