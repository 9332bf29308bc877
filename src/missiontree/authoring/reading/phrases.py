"""Noun phrases: "her lost child", "the cat trapped in a building on fire", "room 12", "Anna's keys"."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clauses import Word

MAX_NAME_WORDS = 5
MAX_PHRASE_WORDS = 24
_SINGULAR = frozenset({"gas", "lens", "canvas", "atlas", "news"})
# A description that holds one of these says what is to be done, or with what, and not who is meant.
_NOT_DESCRIBING = frozenset(
    {
        "using",
        "help",
        "order",
        "sequence",
        "turn",
        "turns",
        "means",
        "to",
        "into",
        "onto",
        "for",
        "by",
        "toward",
        "towards",
        "then",
        "as",
        "back",
    }
) | {
    "during",
    "within",
    "through",
    "via",
}


@dataclass(frozen=True, slots=True)
class Phrase:
    """
    Somebody or something that is spoken of.

    Parameters
    ----------
    name
        What it is called, without article, states and descriptions: ``child``, ``red ball``, ``room 12``.
    determined
        Whether it stands with an article or a possessive; a bare "mom" is a name.
    states
        Words such as ``lost`` or ``heavy``, which are not part of what it is called.
    description
        What is said of it behind the noun: ``trapped in a building on fire``.
    pronoun
        ``thing``, ``person``, ``several`` or ``place`` if it is a pronoun; empty if it is not.
    lost
        Whether the words say that nobody knows where it is, or that it cannot come by itself.
    every
        Whether all that are called so are meant: "all crates".
    text
        As it was written.
    """

    name: str
    text: str
    determined: bool = False
    states: tuple[str, ...] = ()
    description: str = ""
    pronoun: str = ""
    lost: bool = False
    every: bool = False

    @property
    def several(self) -> bool:
        """Whether more than one is meant, going by the words: "all staff", "crates"; not "Thomas", which is a name."""
        name_of_its_own = not self.determined and self.name[:1].isupper() and kind_of(self.name) is None
        return self.every or (is_plural(self.name) and not name_of_its_own)

    @property
    def full(self) -> str:
        """The name with its states."""
        return " ".join((*self.states, self.name))


class PhraseReader:
    """Reads noun phrases strictly: a word that may mean something else makes it no phrase at all."""

    def __init__(self, lexicon: Lexicon, known: Mapping[str, str] | None = None) -> None:
        self._lexicon = lexicon
        self.known = known or {}  # names of the scene, to their base kinds
        self._small = lexicon.words
        self._determiners = lexicon.table("determiners")
        self._read = lru_cache(maxsize=4096)(self._one)

    def phrases(self, words: Sequence[Word]) -> tuple[Phrase, ...] | None:
        """The phrases that the words are, joined by commas and *and*; None if they are not wholly phrases."""
        if not words or len(words) > MAX_PHRASE_WORDS * 4:
            return None
        if (whole := self._whole_name(tuple(words))) is not None:
            return (whole,)
        read = [self._read(part) for part in _parts(words)]
        return tuple(phrase for phrase in read if phrase is not None) if None not in read else None

    def parts(self, words: Sequence[Word]) -> tuple[tuple[Word, ...], ...] | None:
        """The words of each phrase; None if they are not wholly phrases."""
        if self.phrases(words) is None:
            return None
        return (tuple(words),) if self._whole_name(tuple(words)) is not None else tuple(_parts(words))

    def kind_of(self, phrase: Phrase) -> str | None:
        """Base kind of who is spoken of: the scene's, that of the noun, or person for a name; None if that cannot be said."""
        return self.known.get(phrase.name.lower()) or kind_of_phrase(phrase)

    def left_over(self, words: Sequence[Word]) -> Sequence[Word]:
        """The words from the first that belongs to no noun phrase."""
        end = 0
        while end < len(words) and self.phrases(words[: end + 1]) is not None:
            end += 1
        longer = range(min(len(words), end + 12), end, -1)
        end = next((place for place in longer if self.phrases(words[:place]) is not None), end)
        return words[end if end < len(words) else 0 :]

    def _whole_name(self, words: tuple[Word, ...]) -> Phrase | None:
        """A name that the scene knows may hold any words."""
        start = 1 if len(words) > 1 and words[0].low in self._small["determiners"] else 0
        name = " ".join(word.low for word in words[start:])
        if name not in self.known:
            return None
        every = start > 0 and words[0].low == "all"
        return Phrase(
            name=" ".join(w.text for w in words[start:]), text=_text(words), determined=start > 0, every=every
        )

    def _one(self, words: tuple[Word, ...]) -> Phrase | None:
        if not words or len(words) > MAX_PHRASE_WORDS:
            return None
        if (known := self._whole_name(words)) is not None:
            return known
        pronouns: dict[str, str] = self._lexicon.small["pronouns"]
        if len(words) == 1 and words[0].low in pronouns:
            return Phrase(name=words[0].low, text=words[0].text, pronoun=pronouns[words[0].low])
        start = self._determiner(words)
        end = self._end_of_name(words, start)
        states, name = self._states(words[start:end])
        behind = words[end:]
        if not self._is_name(name):
            return None
        if behind and behind[0].low == "of":
            belonging, behind = self._belonging(behind)
            name = (*name, *belonging)
        if not self._is_description(behind):
            return None
        return Phrase(
            name=_text(name),
            text=_text(words),
            determined=start > 0 or "'" in name[0].text,
            states=tuple(word.low for word in states),
            description=_text(behind),
            lost=any(word.low in self._small["lost"] for word in (*states, *behind)),
            every=start > 0 and words[0].low == "all",
        )

    def _belonging(self, behind: tuple[Word, ...]) -> tuple[tuple[Word, ...], tuple[Word, ...]]:
        """The "of the team" that belongs to a name, and what is left; nothing if it is no name itself."""
        inner = behind[1:]
        start = self._determiner(inner) if inner else 0
        end = self._end_of_name(inner, start) if inner else 0
        if start < end and self._is_name(inner[start:end]):
            return behind[: end + 1], inner[end:]
        return (), behind

    def _determiner(self, words: tuple[Word, ...]) -> int:
        hit = self._determiners.at([word.low for word in words[:3]], 0)
        return hit[1] if hit is not None and hit[1] < len(words) else 0

    def _end_of_name(self, words: tuple[Word, ...], start: int) -> int:
        """Index of the first word behind the name."""
        for place in range(start + 1, len(words)):
            low, before = words[place].low, words[place - 1].low
            if low in self._small["describing"] or low in self._small["relatives"] or low == "next":
                return place
            state = low in self._small["lost"] or low in self._small["states"]
            if state and before not in self._small["lost"] and before not in self._small["states"]:
                return place
            if kind_of(before) is not None and self._is_participle(low):
                return place
        return len(words)

    def _is_participle(self, low: str) -> bool:
        """Whether a word is what somebody is doing: "walking", and neither "building" nor "bring"."""
        noun = kind_of(low) is not None or low in self.known
        return low.endswith("ing") and len(low) > 4 and not noun and self._lexicon.verb_at([low], 0, "base") is None

    def _states(self, words: tuple[Word, ...]) -> tuple[tuple[Word, ...], tuple[Word, ...]]:
        count = 0
        while count < len(words) - 1 and (
            words[count].low in self._small["lost"]
            or words[count].low in self._small["states"]
            or words[count].low == ","
        ):
            count += 1
        return tuple(word for word in words[:count] if word.low != ","), words[count:]

    def _is_name(self, words: tuple[Word, ...]) -> bool:
        if not 1 <= len(words) <= MAX_NAME_WORDS or words[-1].low.endswith("'s"):
            return False
        lows = [word.low for word in words]
        if lows[0] in self._small["directions"] and len(lows) == 1:
            return False
        known = self._known_words(lows)
        for place, low in enumerate(lows):
            if known[place]:
                continue
            follows_known = place + 1 < len(lows) and known[place + 1]
            if not self._may_be_named(low, place, len(lows), modifies=follows_known):
                return False
            verb = self._lexicon.verb_at(lows, place, "base", "past")
            if place > 0 and verb is not None and words[place].text[:1].islower():
                return False
        whole_known = kind_of(" ".join(lows)) is not None
        proper = words[-1].text[:1].isupper() or any(letter.isdigit() for letter in lows[-1])
        return known[-1] or whole_known or proper or not any(known[:-1])

    def _known_words(self, lows: list[str]) -> list[bool]:
        """Which words are known nouns, or parts of known compounds such as "assembly point"."""
        known = [kind_of(low) is not None or low in self.known for low in lows]
        small = self._small["function_words"] | self._small["describing"]
        for end in range(len(lows)):
            for width in (2, 3):
                if (
                    not known[end]
                    and not small & set(lows[max(0, end + 1 - width) : end + 1])
                    and all(low[0].isalnum() for low in lows[max(0, end + 1 - width) : end + 1])
                    and width <= end + 1
                    and kind_of(" ".join(lows[end + 1 - width : end + 1])) is not None
                ):
                    known[end + 1 - width : end + 1] = [True] * width
        return known

    def _may_be_named(self, low: str, place: int, count: int, *, modifies: bool) -> bool:
        small = self._small
        refused = (
            "function_words",
            "quantities",
            "times",
            "determiners",
            "decisive",
            "passed_over",
            "describing",
            "relatives",
            "vague",
        )
        if any(low in small[name] for name in refused) or low in small["pronouns"]:
            return False
        if low[0].isdigit():
            return low.isalnum() and 0 < place == count - 1
        adverb = low.endswith("ly") and len(low) > 4 and not modifies
        return low[0].isalpha() and not adverb

    def _is_description(self, words: tuple[Word, ...]) -> bool:
        """Whether the words only describe: no quantity, no time, nothing that stands by itself."""
        if not words:
            return True
        small, lows = self._small, [word.low for word in words]
        if len(words) == 1 and lows[0] in small["describing"] | small["relatives"]:
            return False
        states = small["lost"] | small["states"]
        for place, low in enumerate(lows):
            if low in small["quantities"] or low in small["times"] or low in small["decisive"]:
                return False
            if low in _NOT_DESCRIBING:
                return False
            if not (low[0].isalnum() or low in {",", "'"}):
                return False
            if low[0].isdigit() and (place == 0 or lows[place - 1] in small["describing"] or place != len(lows) - 1):
                return False
            if low.endswith("ly") and len(low) > 4 and kind_of(low) is None:
                return False
        last = lows[-1]
        return (
            last not in small["describing"]
            and last not in small["relatives"]
            and (last not in small["determiners"] or last in states)
        )


def kind_of_phrase(phrase: Phrase) -> str | None:
    """Base kind of what a phrase names, going by its noun; a name of its own is taken to be a person's."""
    head, _, last = phrase.name.rpartition(" ")
    numbered = (
        head if head and (last[-1].isdigit() or (last[:1].isupper() and kind_of(phrase.name) is None)) else phrase.name
    )
    proper = not phrase.determined and phrase.name[:1].isupper()
    return kind_of(numbered) or ("person" if proper else None)


def is_plural(name: str) -> bool:
    """Whether the noun looks like more than one."""
    last = name.lower().split()[-1]
    return last in {"people", "men", "women", "children", "mice", "geese"} or (
        last.endswith("s") and not last.endswith(("ss", "us", "is")) and last not in _SINGULAR
    )


def _parts(words: Sequence[Word]) -> Iterator[tuple[Word, ...]]:
    """Split at commas and *and*; commas between adjectives stay."""
    part: list[Word] = []
    for word in words:
        if word.low in {"and", ",", "&"}:
            if part:
                yield tuple(part)
            part = []
        else:
            part.append(word)
    yield tuple(part)


def _text(words: Sequence[Word]) -> str:
    return " ".join(word.text for word in words)
