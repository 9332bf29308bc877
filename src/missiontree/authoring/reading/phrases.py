"""Noun phrases: "her lost child", "the cat trapped in a building on fire", "room 12", "Anna's keys"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache

from missiontree.authoring.language.kinds import is_listed, kind_of
from missiontree.authoring.language.lexicon import Lexicon, PhraseTable
from missiontree.authoring.language.verbs import english_verbs
from missiontree.authoring.reading.describing import Descriptions
from missiontree.authoring.reading.listing import all_but_these, is_letter, parts_of
from missiontree.authoring.reading.phrase import Phrase, kind_of_phrase
from missiontree.authoring.reading.plurals import is_plural
from missiontree.authoring.reading.quantity import number_of, quantity_of
from missiontree.authoring.reading.words import Word

MAX_NAME_WORDS = 5
ONES = frozenset({"one", "ones"})
MAX_PHRASE_WORDS = 24
EXCEPTIONS = {"but", "except", "excluding", "other than"}
_TITLES_ALONE = frozenset({"mr", "mrs", "ms", "miss", "dr", "sir", "messrs"})
_SOME_OF = frozenset({"couple", "pair", "lot", "bunch", "number", "handful", "dozen", "half", "most", "some", "few"})
_BEFORE_NOUNS = frozenset({"light", "heavy", "old", "young", "dear", "poor", "blind", "best"})


class PhraseReader:
    """Reads noun phrases strictly: a word that may mean something else makes it no phrase at all."""

    def __init__(self, lexicon: Lexicon, known: Mapping[str, str] | None = None) -> None:
        self._lexicon = lexicon
        self.known = known or {}  # names of the scene, to their base kinds
        self._small = lexicon.words
        self._descriptions = Descriptions(lexicon)
        self._determiners = lexicon.table("determiners")
        names = {tuple(name.split()): name for name in self.known if {"and", "&", ","} & set(name.split())}
        self._with_and = PhraseTable(names)
        self._read = lru_cache(maxsize=4096)(self._one)

    def phrases(self, words: Sequence[Word]) -> tuple[Phrase, ...] | None:
        """The phrases that the words are, joined by commas and *and*; None if they are not wholly phrases."""
        if not words or len(words) > MAX_PHRASE_WORDS * 4:
            return None
        if (whole := self._whole_name(tuple(words))) is not None:
            return (whole,)
        if words[0].low == "both" and any(word.low == "and" for word in words):
            words = words[1:]  # "both Anna and Bob"
        read = [self._read(part) for part in parts_of(words, self._with_and)]
        found = tuple(phrase for phrase in read if phrase is not None)
        return all_but_these(found) if len(found) == len(read) else None

    def parts(self, words: Sequence[Word]) -> tuple[tuple[Word, ...], ...] | None:
        """The words of each phrase; None if they are not wholly phrases."""
        if self.phrases(words) is None:
            return None
        return (tuple(words),) if self._whole_name(tuple(words)) is not None else tuple(parts_of(words, self._with_and))

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
        return Phrase(name=_text(words[start:]), text=_text(words), determined=start > 0)

    def _one(self, words: tuple[Word, ...]) -> Phrase | None:
        if not words or len(words) > MAX_PHRASE_WORDS:
            return None
        if (known := self._whole_name(words)) is not None:
            return known
        if (
            len(words) == 1
            and self._lexicon.hazard_words.at([words[0].low], 0) is not None
            and words[0].low.endswith("ing")
        ):
            return Phrase(name=words[0].text, text=words[0].text)  # "from drowning"
        pronouns: dict[str, str] = self._lexicon.small["pronouns"]
        if len(words) == 1 and words[0].low in pronouns:
            return Phrase(name=words[0].low, text=words[0].text, pronoun=pronouns[words[0].low])
        if (them := self._them(words)) is not None or (them := self._everybody(words)) is not None:
            return them
        many = quantity_of(words)
        start = many.length or self._determiner(words)
        end = self._end_of_name(words, start)
        states, name = self._states(words[start:end])
        behind = words[end:]
        if not self._is_name(name):
            return None
        lost_owner = any(word.low in self._small["lost"] for word in states) and name[0].low.endswith("'s")
        one_alone = len(name) == 1 and name[0].low in ONES and not (many.other or many.ordinal or behind)
        if lost_owner or one_alone or (many.other and not many.determined):
            return None
        if behind and behind[0].low == "of" and name[-1].low in ONES | _SOME_OF:
            return None
        if behind and behind[0].low == "of":
            belonging, behind = self._belonging(behind)
            name = (*name, *belonging)
        behind, left_out = self._left_out(behind) if many.every else (behind, ())
        if left_out is None or not self._descriptions.describe(behind):
            return None
        if many.count is not None and not is_plural(_text(name)):
            return None
        return Phrase(
            name=_text(name),
            text=_text(words),
            determined=(many.determined if many.length else start > 0) or "'" in name[0].text,
            states=tuple(word.low for word in states),
            description=_text(behind),
            lost=any(word.low in self._small["lost"] for word in states) or self._descriptions.say_lost(behind),
            every=many.every,
            count=many.count,
            other=many.other,
            ordinal=many.ordinal,
            without=left_out,
        )

    def _left_out(self, behind: tuple[Word, ...]) -> tuple[tuple[Word, ...], tuple[Phrase, ...] | None]:
        """The words before a "but", and whom the words behind it leave out of all; None for them if they name nobody."""
        lows = [word.low for word in behind]
        place = next(
            (at for at, low in enumerate(lows) if low in EXCEPTIONS or lows[at : at + 2] == ["apart", "from"]), -1
        )
        if place < 0:
            return behind, ()
        start = place + 1 + (lows[place + 1 : place + 2] in (["for"], ["from"], ["than"]))
        one = self._one(behind[start:]) if start < len(behind) else None
        return behind[:place], (one,) if one is not None and not one.pronoun else None

    def _them(self, words: tuple[Word, ...]) -> Phrase | None:
        """Words such as "both of them", "all three of them", "each of them", "them all", "the two of them", "both"."""
        lows = [word.low for word in words]
        if lows == ["both"] or lows in (["the", "two"], ["them", "both"]):
            return Phrase(name="them", text=_text(words), pronoun="several", count=2)
        if lows in (["them", "all"], ["all"]):
            return Phrase(name="them", text=_text(words), pronoun="several")
        if lows[-2:] != ["of", "them"] and lows[-2:] != ["of", "these"] and lows[-2:] != ["of", "those"]:
            return None
        before = [low for low in lows[:-2] if low not in {"the", "all", "each", "every", "one"}]
        if lows[:-2] in (["each"], ["all"], ["each", "one"], ["every", "one"]):
            return Phrase(name="them", text=_text(words), pronoun="several")
        number = 2 if before == ["both"] else number_of(before[0]) if len(before) == 1 else None
        return Phrase(name="them", text=_text(words), pronoun="several", count=number) if number else None

    def _everybody(self, words: tuple[Word, ...]) -> Phrase | None:
        """Words such as "everyone in the building", "anybody who is trapped": all people that the words fit."""
        if words[0].low not in self._small["everybody"]:
            return None
        said, left_out = self._left_out(words[1:])
        if left_out is None or not self._descriptions.describe(said):
            return None
        lost = any(word.low in self._small["lost"] for word in words[1:])
        return Phrase(
            name=words[0].low,
            text=_text(words),
            description=_text(said),
            every=True,
            lost=lost,
            determined=False,
            without=left_out,
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
            if low in _BEFORE_NOUNS:
                continue  # "the traffic light"
            if low in EXCEPTIONS:
                return place
            if state and before not in self._small["lost"] and before not in self._small["states"]:
                return place
            if (kind_of(before) is not None or words[place - 1].text.istitle()) and self._is_participle(low):
                return place
        return len(words)

    def _is_participle(self, low: str) -> bool:
        """Whether a word is what somebody is doing: "walking", and neither "building" nor "bring"."""
        noun = kind_of(low) is not None or low in self.known
        return low.endswith("ing") and len(low) > 4 and not noun and self._lexicon.verb_at([low], 0, "base") is None

    def _states(self, words: tuple[Word, ...]) -> tuple[tuple[Word, ...], tuple[Word, ...]]:
        count = 0
        if len(words) > 1 and is_listed(_text(words)):
            return (), words
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
        if lows[-1] in _TITLES_ALONE and len(lows) == 1:
            return False
        if len(lows) == 1 and lows[0] in self._small["lost"] and kind_of(lows[0]) is None:
            return False
        if lows[-1] in ONES:  # "the blue one"
            return all(self._may_be_named(low, 0, 2, modifies=True) for low in lows[:-1])
        known = self._known_words(lows)
        for place, low in enumerate(lows):
            if known[place]:
                continue
            follows_known = place + 1 < len(lows) and known[place + 1]
            if place > 0 and is_letter(words[place]) and not words[place - 1].text.isupper():
                continue  # "Block A"
            named = words[place].text[:1].isupper()
            if not self._may_be_named(low, place, len(lows), modifies=follows_known or named):
                return False
            verb = self._lexicon.verb_at(lows, place, "base", "past")
            if place > 0 and verb is not None and words[place].text[:1].islower():
                return False
        whole_known = kind_of(" ".join(lows)) is not None
        if len(lows) > 1 and not whole_known and words[-1].text.islower() and self._is_complement(words[-2], words[-1]):
            return False
        proper = words[-1].text[:1].isupper() or any(letter.isdigit() for letter in lows[-1])
        return (
            known[-1]
            or whole_known
            or proper
            or not any(known[:-1])
            or self._lexicon.verb_at(lows, len(lows) - 1, "past", "third") is None
        )

    def _is_complement(self, before: Word, last: Word) -> bool:
        """Whether the last word is no part of the name: "paint the hull blue", "follow Anna unseen", "watch the monkeys feed"."""
        if kind_of(last.low) is not None and last.low not in self._small["complements"]:
            return False
        named = before.text[:1].isupper() and before.text[1:].islower() and kind_of(before.low) is None
        noun = kind_of(before.low) is not None or before.low in self.known
        does = is_plural(before.low) and last.low in english_verbs()
        return named or (noun and (last.low in self._small["complements"] or does))

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


def _text(words: Sequence[Word]) -> str:
    return " ".join(word.text for word in words)
