"""Who is meant by a noun phrase: somebody of the scene, or, if the scene has none such, somebody to be introduced."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

from missiontree.authoring.language.kinds import is_abstract
from missiontree.authoring.matching import listed
from missiontree.authoring.methods.mention import Mention, UnclearError, title
from missiontree.authoring.reading.ones import other_of_two, picked, with_noun
from missiontree.authoring.reading.phrase import Phrase, kind_of_phrase
from missiontree.authoring.reading.phrases import ONES
from missiontree.authoring.reading.places import is_designation, plain, spellings
from missiontree.authoring.reading.plurals import is_plural, plural, singular
from missiontree.authoring.reading.pronouns import antecedent, fits
from missiontree.authoring.reading.quantity import ORDINALS
from missiontree.authoring.reading.scene_names import SceneNames
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene

_OWNERS = frozenset({"his", "her", "its", "their"})
_TWO = frozenset({"former", "latter"})
_EVERYBODY = frozenset({"everyone", "everybody", "anyone", "anybody"})


@dataclass
class Speakers:
    """All that was mentioned so far, in a world; ``complete`` if somebody wrote down what it has."""

    scene: Scene
    complete: bool = False
    described: dict[str, str] = field(default_factory=dict)
    said: list[list[tuple[Mention, ...]]] = field(default_factory=list)
    """Mentions clause by clause, those that were named together in one."""
    lost: set[str] = field(default_factory=set)
    """Names of those who were stated to be lost."""
    numbered: dict[str, tuple[Mention, ...]] = field(default_factory=dict)
    """Those who were introduced by their number, such as the three crates, by their noun."""

    sentence: int = 0
    sentence_start: int = 0
    """Index among the clauses of the first of the sentence under way."""
    owned: dict[str, tuple[str, int]] = field(default_factory=dict)
    """By whose word something was called theirs, and in which clause."""
    owned_here: set[str] = field(default_factory=set)
    open_choice: set[str] = field(default_factory=set)
    """Names of those of whom only one is chosen, so that no pronoun can mean them."""
    moved_away: set[str] = field(default_factory=set)
    """Names of those who were brought somewhere."""
    starts: dict[str, str] = field(default_factory=dict)
    """Where somebody or something was taken from, by name."""

    @property
    def names(self) -> SceneNames:
        """What the entities of the scene are called."""
        return SceneNames(self.scene, self.complete)

    def kept(self) -> Speakers:
        """A copy, to come back to if a way of reading a clause leads nowhere."""
        said = [list(groups) for groups in self.said]
        return replace(
            self,
            described=dict(self.described),
            said=said,
            lost=set(self.lost),
            numbered=dict(self.numbered),
            starts=dict(self.starts),
            open_choice=set(self.open_choice),
            moved_away=set(self.moved_away),
            owned=dict(self.owned),
            owned_here=set(self.owned_here),
        )

    def joined(self, other: Speakers, clauses: int) -> Speakers:
        """These, with what another way of reading the clause under way has mentioned beside it."""
        mine, its = self.kept(), other.kept()
        for number in range(max(clauses - 1, 0), len(its.said)):
            if number == len(mine.said):
                mine.said.append([])
            mine.said[number] += [group for group in its.said[number] if group not in mine.said[number]]
        mine.described |= its.described
        mine.numbered |= its.numbered
        mine.starts |= its.starts
        return mine

    def next_clause(self, sentence: int = 0) -> None:
        """What is said from now on belongs to a new clause, of a sentence by number."""
        if not self.said or self.said[-1]:
            self.said.append([])
        if sentence != self.sentence:
            self.sentence, self.sentence_start = sentence, len(self.said) - 1

    def remember(self, groups: tuple[tuple[Mention, ...], ...]) -> None:
        """Keep what was mentioned, for pronouns."""
        self.said[-1].extend(groups)

    def resolved(
        self, phrases: Sequence[Phrase], slot: int, kind: str = "", beside: Collection[str] = ()
    ) -> tuple[Mention, ...]:
        """
        Who is meant by phrases that stand together, in a slot by number; see :meth:`resolve`.

        A noun that is not known is taken to be of ``kind``, if the slot is for that kind alone.
        """
        found: tuple[Mention, ...] = ()
        for phrase in phrases:
            if phrase.other and phrase.name.lower() in ONES and (left := other_of_two(phrase, self.said)):
                found += tuple(self._again(mention) for mention in left)
                continue
            found += self.resolve(with_noun(phrase, self.said, slot, found), kind, beside)
        return found

    def were_moved(self, names: Collection[str]) -> None:
        """Keep who was brought somewhere."""
        self.moved_away |= set(names)

    def came_from(self, read: Mapping[str, tuple[Phrase, ...]], said: Mapping[str, tuple[Mention, ...]]) -> None:
        """Keep where things were taken from, for what is brought back."""
        for slot, phrases in read.items():
            for phrase in phrases:
                preposition, _, place = phrase.description.partition(" ")
                if preposition.lower() == "from":
                    start = re.sub(r"^(the|a|an|my|our|her|his|their) ", "", place, flags=re.IGNORECASE)
                    self.starts |= {mention.name: start for mention in said[slot]}

    def moved(self, phrase: Phrase) -> tuple[Mention, ...]:
        """Who is meant by what is brought back; of several that a pronoun may mean, the one that was taken from somewhere."""
        try:
            return self.kept().resolve(phrase)
        except UnclearError:
            groups = next((groups for groups in reversed(self.said) if groups), [])
            taken = {m.name: m for group in groups for m in group if m.name in self.starts and fits(m, phrase)}
            if phrase.pronoun not in {"thing", "person"} or len(taken) != 1:
                raise
            return tuple(taken.values())

    def start_of(self, mention: Mention) -> str:
        """Where somebody or something was taken from, or is by the scene; empty if nobody knows."""
        if mention.name in self.starts:
            return self.starts[mention.name]
        entity = self.scene.by_id.get(mention.name) if mention.name in self.moved_away else None
        place = self.scene.by_id.get(entity.place) if entity is not None and entity.place is not None else None
        return place.label if place is not None else ""

    def resolve(self, phrase: Phrase, expected: str = "", beside: Collection[str] = ()) -> tuple[Mention, ...]:
        """
        Who is meant: one, or for a plural all of the scene that it fits.

        Raises
        ------
        UnclearError
            If it may be several, or nobody.
        """
        if phrase.pronoun:
            meant = antecedent(phrase, self.said, beside, self.sentence_start)
            if open_ones := [mention.label for mention in meant if mention.name in self.open_choice]:
                raise UnclearError(
                    f"{phrase.text!r} may mean {' or '.join(open_ones)}, of which only one is chosen; say which"
                )
            return tuple(self._again(mention) for mention in meant)
        if phrase.name.lower() in _EVERYBODY:
            phrase = replace(phrase, name="people" if self.complete else phrase.name)
        if group := self._numbered(phrase):
            return tuple(self._again(mention) for mention in group)
        if phrase.name.lower() in _TWO:
            return (self._one_of_two(phrase),)
        found = self.names.at_place(self.names.called(phrase), phrase)
        if found or phrase.without:
            return self._of_found(phrase, found)
        return self._new(phrase, expected)

    def _of_found(self, phrase: Phrase, found: list[Entity]) -> tuple[Mention, ...]:
        """Those of the scene whom a phrase means, of all that are called so."""
        options = listed(sorted(entity.id for entity in found))
        if phrase.without:
            return self._all_but(phrase, tuple(self._of_scene(entity, phrase) for entity in found))
        if phrase.other:
            several = replace(phrase, every=True)
            everyone = self.names.at_place(self.names.called(several), several)
            return picked(phrase, tuple(self._of_scene(entity, phrase) for entity in everyone), self.said)
        if phrase.count is not None and len(found) != phrase.count:
            raise UnclearError(f"{phrase.text!r} are {phrase.count}, and the scene has {len(found)}: {options}")
        if phrase.ordinal or (len(found) > 1 and not phrase.several):
            raise UnclearError(f"{phrase.text!r} may be any of {options}; say which one")
        return tuple(self._of_scene(entity, phrase) for entity in found)

    def _again_in_short(self, phrase: Phrase) -> Mention | None:
        """The one who was introduced with more words: the oak cask, for "the cask"; None if nobody was."""
        if not phrase.text.lower().startswith("the ") or len(phrase.name.split()) > 1:
            return None
        noun = phrase.name.lower()
        new = {m.name: m for groups in self.said for group in groups for m in group if m.new}
        if any(mention.label.lower() == noun for mention in new.values()):
            return None
        alike = [mention for mention in new.values() if mention.label.lower().split()[-1] == noun]
        if len(alike) > 1:
            raise UnclearError(f"{phrase.text!r} may be {' or '.join(m.label for m in alike)}; say which one")
        return self._again(alike[0]) if alike else None

    def _new(self, phrase: Phrase, expected: str) -> tuple[Mention, ...]:
        """Somebody whom the scene does not have; a question if that may be a slip."""
        if (short := self._again_in_short(phrase)) is not None:
            return (short,)
        if like := self.names.alike(phrase):
            options = ", ".join(sorted(entity.label for entity in like))
            raise UnclearError(f"the scene has {options}, and none of them is called {phrase.name!r}")
        self.names.refuse_misspelt(phrase)
        self.names.refuse_none(phrase)
        if phrase.ordinal and kind_of_phrase(phrase) == "person":  # a rank: "the second engineer"
            rank = next(word for word, number in ORDINALS.items() if number == phrase.ordinal)
            phrase = replace(phrase, name=f"{rank} {phrase.name}", ordinal=None)
        if phrase.ordinal:
            raise UnclearError(f"it is not clear what {phrase.text!r} means; give it a name")
        if phrase.count is not None:
            return self._counted(phrase)
        return (self._introduced(phrase, expected),)

    def _numbered(self, phrase: Phrase) -> tuple[Mention, ...]:
        """Those introduced by number whom a phrase means: "the crates", "the other crate", "the second one"."""
        group = self.numbered.get(singular(plain(phrase.name)), ())
        if not group or not (phrase.several or phrase.other or phrase.ordinal):
            return ()
        if phrase.other or phrase.ordinal:
            return picked(phrase, group, self.said)
        if phrase.count not in {None, len(group)}:
            raise UnclearError(f"{phrase.text!r} are {phrase.count}, and before they were {len(group)}")
        return group

    def _counted(self, phrase: Phrase) -> tuple[Mention, ...]:
        """As many as the words say, numbered."""
        assert phrase.count is not None
        *before, noun = phrase.name.split()
        one = " ".join((*before, singular(noun.lower()) if noun.islower() else singular(noun)))
        alone = replace(phrase, name=one, count=None, every=False, determined=True)
        first = self._introduced(alone)
        group = tuple(
            replace(
                first, name=f"{first.name} {number}", label=f"{first.label} {number}", full=f"{first.full} {number}"
            )
            for number in range(1, phrase.count + 1)
        )
        self.numbered[singular(plain(phrase.name))] = group
        return group

    def _all_but(self, phrase: Phrase, found: tuple[Mention, ...]) -> tuple[Mention, ...]:
        """All that are meant, without those who are left out."""
        if not found:
            raise UnclearError(
                f"nobody knows which are meant by {phrase.text!r}; declare them in the scene, or name them"
            )
        out = {m.name for one in phrase.without for m in self.resolve(with_noun(one, self.said, 0, found))}
        left = tuple(mention for mention in found if mention.name not in out)
        if not left or len(left) == len(found):
            raise UnclearError(f"it is not clear whom {phrase.text!r} leaves out")
        return left

    def _one_of_two(self, phrase: Phrase) -> Mention:
        """Whom "the former" or "the latter" means: one of the last two that were named together."""
        for groups in reversed(self.said[:-1]):
            pairs = [group for group in groups if len({mention.name for mention in group}) == 2]
            if len(pairs) == 1:
                return self._again(pairs[0][phrase.name.lower() == "latter"])
            if groups:
                break
        raise UnclearError(f"it is not clear which two {phrase.text!r} speaks of")

    def implied(self, name: str, kind: str, known_as: tuple[str, ...] = ()) -> Mention:
        """Somebody whom a method needs: of the scene under one of the names, or introduced."""
        for spelling in (*known_as, name):
            phrase = Phrase(name=spelling, text=spelling)
            everyone = self.scene.all_entities
            exact = [entity for entity in everyone if entity.id == spelling]
            exact = exact or [entity for entity in everyone if plain(spelling) in spellings(entity)]
            if len(exact) == 1:
                return self._of_scene(exact[0], phrase)
            if len(exact) > 1:
                raise UnclearError(
                    f"{spelling!r} may be any of {', '.join(sorted(e.id for e in exact))}; say which one"
                )
        return Mention(
            name=name,
            label=name,
            full=name,
            kind=kind,
            determined=False,
            plural=is_plural(name.split(" of ", maxsplit=1)[0]),
        )

    def _of_scene(self, entity: Entity, phrase: Phrase) -> Mention:
        states = " ".join(title(state) for state in phrase.states)
        return Mention(
            name=entity.id,
            label=entity.label,
            full=f"{states} {entity.label}".strip(),
            kind=self.scene.base_kind(entity.kind),
            determined=phrase.determined,
            new=False,
            known=not self.complete or self.scene.whereabouts(entity).source == "known",
            lost=phrase.lost or entity.id in self.lost,
            plural=phrase.several,
        )

    def _refuse_others(self, phrase: Phrase) -> None:
        """The other crate is another one only if one crate was told from it before."""
        if not phrase.other:
            return
        noun = singular(phrase.name.lower().split()[-1])
        named = [m for groups in self.said for group in groups for m in group if m.label.lower().split()[-1] == noun]
        told = any(len(mention.label.split()) > 1 and mention.name not in self.open_choice for mention in named)
        if phrase.several or not told or any(mention.name in self.open_choice for mention in named):
            raise UnclearError(f"it is not clear what {phrase.text!r} means; give it a name")

    def _refuse_another_owner(self, phrase: Phrase, label: str) -> None:
        """The office of one and the office of another are two."""
        owner = phrase.text.lower().split()[0]
        if owner not in _OWNERS:
            return
        before = self.owned.setdefault(label, (owner, len(self.said)))
        if before[0] != owner or (before[1] == len(self.said) and label in self.owned_here):
            raise UnclearError(
                f'it is not clear whose {phrase.name} {phrase.text!r} is; name it, as in "Anna\'s {phrase.name}"'
            )
        self.owned_here = {*self.owned_here, label} if before[1] == len(self.said) else set()

    def _introduced(self, phrase: Phrase, expected: str = "") -> Mention:
        first, label = phrase.text.lower().split()[0], title(phrase.name)
        if first in {"this", "that", "these", "those"} and label.lower() not in self.described:
            raise UnclearError(f"it is not clear what {phrase.text!r} means; give it a name")
        if first in {"a", "an"} and any(m.label == label for groups in self.said for g in groups for m in g):
            raise UnclearError(f"it is not clear whether {phrase.text!r} is the {phrase.name} of before or another one")
        if is_abstract(phrase.name) and not phrase.is_own_name and expected != "place":
            raise UnclearError(f"{phrase.text!r} is nothing that a robot can find, reach or carry")
        everybody = phrase.name.lower() in _EVERYBODY
        self._refuse_others(phrase)
        self._refuse_another_owner(phrase, label)
        if phrase.other and not phrase.several:
            phrase = replace(phrase, name=f"other {phrase.name}")
        elif phrase.every and not (everybody or phrase.count):
            phrase = replace(phrase, name=plural(phrase.name))
        label = title(phrase.name)
        described = self.described.setdefault(label.lower(), phrase.description)
        if phrase.description and described != phrase.description:
            raise UnclearError(
                f"it is not clear whether {phrase.text!r} is the {phrase.name} of before; give them different names"
            )
        several, kind = phrase.several, "person" if everybody else kind_of_phrase(phrase)
        numbered = is_designation(phrase.name.split()[-1].lower())
        kind = "place" if expected == "place" and kind == "object" and numbered else kind or expected or None
        if kind is None and not (phrase.determined or several or is_designation(phrase.name.split()[-1].lower())):
            raise UnclearError(f"{phrase.text!r} is no noun that is known; say 'the {phrase.name}' if it is a thing")
        return Mention(
            label,
            label,
            title(phrase.full),
            kind or "object",
            determined=phrase.determined,
            lost=phrase.lost or label in self.lost,
            plural=several,
        )

    def _again(self, mention: Mention) -> Mention:
        """Somebody who is spoken of again; still lost if a statement said so."""
        return replace(mention, lost=mention.name in self.lost, determined=True)
