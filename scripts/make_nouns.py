"""
Make the table of common nouns, ``src/missiontree/authoring/language/nouns.txt``, from WordNet 3.0.

::

    python scripts/make_nouns.py

It needs the dictionary files of WordNet 3.0 in ``/usr/share/wordnet`` (Debian: ``wordnet-base``; another folder is given with
``--wordnet``). Same dictionary and same ``nouns_by_hand.yaml``, same bytes. Every sense of a noun is put under a kind by its hypernyms
(``anchors``) or, failing these, by the file of WordNet that it stands in (``files``); the senses then vote, weighed by how often each
was counted in tagged text. A word that is rather a verb, an adjective or an adverb is left out, and so is one whose senses disagree.
"""

from __future__ import annotations

import argparse
import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

import yaml

ROOT = Path(__file__).resolve().parents[1]
TABLE = ROOT / "src" / "missiontree" / "authoring" / "language" / "nouns.txt"
BY_HAND = Path(__file__).with_name("nouns_by_hand.yaml")
KINDS = ("person", "animal", "object", "place", "abstract")
POS = {"noun": "1", "verb": "2", "adj": "35", "adv": "4"}
OFFENSIVE = {"obscenity", "disparagement", "ethnic_slur", "vulgarism", "taboo"}
IRREGULAR_ENDINGS = (("ies", "y"), ("ves", "f"), ("ves", "fe"), ("men", "man"), ("es", ""), ("s", ""))

FIRST_SENSE = (
    1.5  # counts that a first sense has for nothing, the second half of it, and so on: most nouns were never counted
)
SURE_ABSTRACT = 0.75  # of the vote: a noun that may be refused must hardly ever mean something else
SURE_CONCRETE = 0.35
MUCH_RATHER_A_VERB = 6  # times as often: "monitor" and "drill" are nouns as well, "find" and "carry" hardly are
OFTEN_SAID = 2  # times that a definition or an example of WordNet uses the word
RARE_BUT_USABLE = {6, 13, 15, 17, 18}  # artifacts, food, locations, natural objects, persons
MAX_SINGLE = 22_000
MAX_COMPOUNDS = 1_000


@dataclass(frozen=True, slots=True)
class Synset:
    """One meaning: its words as they are written, its WordNet file, what it is a kind of, and the styles it belongs to."""

    words: tuple[str, ...]
    file: int
    above: tuple[int, ...]
    named: bool
    styles: tuple[int, ...]
    gloss: str


@dataclass(slots=True)
class WordNet:
    """The dictionary files, as far as they are needed."""

    folder: Path
    synsets: dict[int, Synset] = field(default_factory=dict)
    senses: dict[str, dict[str, tuple[int, ...]]] = field(default_factory=dict)
    counts: Counter[tuple[str, str, int]] = field(default_factory=Counter)
    inflected: dict[str, set[str]] = field(default_factory=lambda: defaultdict(set))
    said: Counter[str] = field(default_factory=Counter)
    plurals: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for pos in POS:
            self.senses[pos] = dict(self._index(pos))
            for line in self._lines(f"data.{pos}"):
                gloss = line.partition("|")[2]
                self.said.update(re.findall(r"[a-z]+(?:-[a-z]+)*", gloss.lower()))
                words = re.findall(r"[a-z]+", gloss.lower())
                self.said.update(f"{one}_{two}" for one, two in pairwise(words))
                if pos == "noun":
                    self.synsets[int(line[:8])] = _synset(line)
            for line in self._lines(f"{pos}.exc", comments=False):
                form, *bases = line.split()
                if pos == "noun":
                    self.plurals[form] = bases[0]
                elif form not in bases:
                    self.inflected[pos].add(form)
        kinds = {digit: pos for pos, digits in POS.items() for digit in digits}
        for line in self._lines("cntlist.rev", comments=False):
            key, number, count = line.split()
            lemma, _, rest = key.partition("%")
            self.counts[lemma, kinds[rest[0]], int(number)] += int(count)

    def _lines(self, name: str, *, comments: bool = True) -> Iterator[str]:
        with (self.folder / name).open(encoding="ascii") as lines:
            for line in lines:
                if not (comments and line.startswith("  ")):
                    yield line.rstrip("\n")

    def _index(self, pos: str) -> Iterator[tuple[str, tuple[int, ...]]]:
        for line in self._lines(f"index.{pos}"):
            parts = line.split()
            yield parts[0], tuple(int(offset) for offset in parts[-int(parts[2]) :])

    def total(self, lemma: str, pos: str) -> int:
        """How often a word was counted as a part of speech."""
        return sum(self.counts[lemma, pos, number + 1] for number in range(len(self.senses[pos].get(lemma, ()))))

    def licence(self) -> list[str]:
        """The licence text at the head of a dictionary file."""
        with (self.folder / "data.noun").open(encoding="ascii") as lines:
            head = [line for line in lines if line.startswith("  ")]
        return [re.sub(r"^ *\d+ ", "", line).rstrip() for line in head]


def _synset(line: str) -> Synset:
    data, _, gloss = line.partition("|")
    parts = data.split()
    width = int(parts[3], 16)
    pointers = parts[5 + 2 * width :]
    links = [(pointers[at], int(pointers[at + 1])) for at in range(0, len(pointers) - 3, 4)]
    return Synset(
        words=tuple(parts[4 : 4 + 2 * width : 2]),
        file=int(parts[1]),
        above=tuple(to for kind, to in links if kind in {"@", "@i"}),
        named=any(kind == "@i" for kind, _ in links),
        styles=tuple(to for kind, to in links if kind == ";u"),
        gloss=gloss.strip(),
    )


class Judge:
    """Says which kind a noun is of, or that it is of none."""

    def __init__(self, wordnet: WordNet, by_hand: dict[str, Any]) -> None:
        self.wordnet = wordnet
        self.hand = {word: kind for kind in (*KINDS, "unsure") for word in by_hand["words"].get(kind, ())}
        self.never = {word for words in by_hand["never"].values() for word in words}
        if both := sorted(self.never & set(self.hand)):
            raise ValueError(
                f"Words of nouns_by_hand.yaml are given a kind and are to be left out: {', '.join(both)}. Keep one."
            )
        self.files: dict[int, str] = by_hand["files"]
        self.anchors: dict[int, str] = {
            self._anchor(name): kind for kind, names in by_hand["anchors"].items() for name in names
        }
        self.offensive = {
            offset for offset, synset in wordnet.synsets.items() if OFFENSIVE & {word.lower() for word in synset.words}
        }

    def _anchor(self, name: str) -> int:
        word, _, number = name.partition(".")
        return self.wordnet.senses["noun"][word][int(number) - 1]

    def meaning(self, offset: int) -> str:
        """Kind of one sense: that of the nearest anchor above it, or else that of its file."""
        level, seen = [offset], {offset}
        while level:
            for one in level:
                if (kind := self.anchors.get(one)) is not None:
                    return kind
            level = [above for one in level for above in self.wordnet.synsets[one].above if above not in seen]
            seen.update(level)
        return self.files[self.wordnet.synsets[offset].file]

    def votes(self, lemma: str) -> dict[str, float]:
        """How much speaks for each kind; senses that are proper names have no vote."""
        votes: dict[str, float] = defaultdict(float)
        place = 0
        for number, offset in enumerate(self.wordnet.senses["noun"][lemma], start=1):
            synset = self.wordnet.synsets[offset]
            if synset.named or lemma not in synset.words:
                continue
            place += 1
            votes[self.meaning(offset)] += self.wordnet.counts[lemma, "noun", number] + FIRST_SENSE / place
        return votes

    def kind(self, lemma: str) -> str | None:
        """The everyday kind of a noun; None if it has none, or may not be a noun at all."""
        if lemma in self.hand:
            return self.hand[lemma] if self.hand[lemma] in KINDS else None
        if (
            lemma in self.never
            or self._is_plural(lemma)
            or self._is_offensive(lemma)
            or not self.is_rather_a_noun(lemma)
        ):
            return None
        votes = self.votes(lemma)
        total = sum(votes.values())
        if not total:
            return None
        if votes["abstract"] / total >= SURE_ABSTRACT:
            return "abstract"
        best = max(("person", "animal", "object", "place"), key=lambda kind: votes[kind])
        return best if votes[best] / total >= SURE_CONCRETE and votes[best] >= votes["unsure"] else None

    def _is_plural(self, lemma: str) -> bool:
        """Whether it is the plural of another noun by rule, which then decides: "hands" are what a hand is."""
        nouns = self.wordnet.senses["noun"]
        singulars = (lemma[: -len(end)] + tail for end, tail in IRREGULAR_ENDINGS if lemma.endswith(end))
        if lemma[-2:] in {"ss", "us", "is"}:
            return False
        return any(
            one in nouns and len(one) > 2 and 2 * self.usability(one) >= self.usability(lemma) for one in singulars
        )

    def _is_offensive(self, lemma: str) -> bool:
        synsets = [self.wordnet.synsets[offset] for offset in self.wordnet.senses["noun"][lemma]]
        return any(self.offensive & set(synset.styles) for synset in synsets)

    def is_rather_a_noun(self, lemma: str) -> bool:
        """Whether it is said as a noun rather than as a verb, an adjective or an adverb, and is no form of a verb."""
        word = self.wordnet
        noun = word.total(lemma, "noun")
        for pos, share in (("verb", MUCH_RATHER_A_VERB), ("adj", 1), ("adv", 1)):
            if lemma in word.senses[pos]:
                other = word.total(lemma, pos)
                if other > share * noun or (pos != "verb" and other == noun):
                    return False
        verbs = word.senses["verb"]
        stem = lemma[:-3]
        gerund = lemma.endswith("ing") and (
            stem in verbs or stem + "e" in verbs or (len(stem) > 3 and stem[:-1] in verbs)
        )
        long_past = lemma.endswith("ed") and not lemma.endswith("eed") and len(lemma) > 4
        past = long_past and (
            lemma[:-2] in verbs or lemma[:-1] in verbs or (lemma[-3] == lemma[-4] and lemma[:-3] in verbs)
        )
        return not (gerund or past or lemma in word.inflected["verb"] or lemma in word.inflected["adj"])

    def usability(self, lemma: str) -> float:
        """How likely the noun is to be said."""
        return 3 * self.wordnet.total(lemma, "noun") + self.wordnet.said[lemma]

    def least_usability(self, lemma: str, kind: str) -> int:
        """How usable a noun must be: what people make, eat, are or go to may be named however rarely it is said elsewhere."""
        if kind == "abstract":
            return OFTEN_SAID
        return 0 if self.wordnet.synsets[self.wordnet.senses["noun"][lemma][0]].file in RARE_BUT_USABLE else 1


def single_nouns(wordnet: WordNet, judge: Judge) -> dict[str, str]:
    """The most usable nouns of one word, and irregular plurals that no rule undoes."""
    kinds: dict[str, str] = {}
    for lemma in wordnet.senses["noun"]:
        kind = judge.kind(lemma) if re.fullmatch(r"[a-z]{3,}", lemma) else None
        if kind is not None and (lemma in judge.hand or judge.usability(lemma) >= judge.least_usability(lemma, kind)):
            kinds[lemma] = kind
    for word, kind in judge.hand.items():
        if "_" not in word and kind in KINDS:
            kinds[word] = kind
    order = sorted(kinds, key=lambda lemma: (lemma not in judge.hand, -judge.usability(lemma), len(lemma), lemma))
    kept = {lemma: kinds[lemma] for lemma in order[:MAX_SINGLE]}
    refused = judge.never | {word for word, kind in judge.hand.items() if kind not in KINDS}
    for plural, noun in wordnet.plurals.items():
        by_rule = any(plural.endswith(end) and plural[: -len(end)] + tail == noun for end, tail in IRREGULAR_ENDINGS)
        verb = (
            plural in wordnet.inflected["verb"] or plural in wordnet.senses["verb"] or plural in wordnet.senses["adj"]
        )
        if noun in kept and not by_rule and not verb and plural.isalpha() and plural not in refused:
            kept.setdefault(plural, kept[noun])
    return kept


def compounds(wordnet: WordNet, judge: Judge, single: dict[str, str]) -> dict[str, str]:
    """Nouns of two or three words whose kind their last word does not tell."""
    kinds: dict[str, str] = {}
    for lemma in wordnet.senses["noun"]:
        words = lemma.split("_")
        if len(words) not in {2, 3} or not all(word.isalpha() for word in words) or lemma in judge.never:
            continue
        kind = judge.kind(lemma)
        if kind is None or kind in {"abstract", single.get(words[-1])} or judge.never & set(words):
            continue
        if judge.usability(lemma) >= OFTEN_SAID and judge.is_rather_a_noun(words[-1]):
            kinds[lemma] = kind
    for word, kind in judge.hand.items():
        if "_" in word and kind in KINDS:
            kinds[word] = kind
    order = sorted(kinds, key=lambda lemma: (lemma not in judge.hand, -judge.usability(lemma), len(lemma), lemma))
    return {lemma: kinds[lemma] for lemma in order[:MAX_COMPOUNDS]}


def table(wordnet: WordNet, by_hand: dict[str, Any]) -> str:
    """The text of the file: comments, then one line for each kind, and one for the names of people."""
    judge = Judge(wordnet, by_hand)
    single = single_nouns(wordnet, judge)
    nouns = single | compounds(wordnet, judge, single)
    head = [
        "Common nouns and the kind of what they name in everyday speech. Made by scripts/make_nouns.py; not to be edited by hand.",
        "Derived from WordNet 3.0, whose licence follows.",
        "",
        *wordnet.licence(),
    ]
    lines = [f"# {line}".rstrip() for line in head]
    for kind in KINDS:
        lines.append(f"{kind}: {_joined(noun for noun, its in nouns.items() if its == kind)}")
    lines.append(f"names: {_joined(set(by_hand['names']))}")
    return "\n".join(lines) + "\n"


def _joined(nouns: Iterable[str]) -> str:
    return ", ".join(sorted(noun.replace("_", " ") for noun in nouns))


def main() -> None:
    """Write the table."""
    parser = argparse.ArgumentParser(description="Make the table of common nouns from WordNet 3.0.")
    parser.add_argument(
        "--wordnet", type=Path, default=Path("/usr/share/wordnet"), help="folder of the dictionary files"
    )
    parser.add_argument("--out", type=Path, default=TABLE, help="the file to write")
    given = parser.parse_args()
    by_hand = yaml.safe_load(BY_HAND.read_text(encoding="utf-8"))
    given.out.write_text(table(WordNet(given.wordnet), by_hand), encoding="utf-8")


if __name__ == "__main__":
    main()
