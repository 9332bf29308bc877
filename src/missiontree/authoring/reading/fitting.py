"""A clause held against one way of understanding it: a pattern of a method, or the verb and the arguments of a routine."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from itertools import pairwise

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.methods.mention import Mention, UnclearError, topic
from missiontree.authoring.methods.method import RESPONDER, Method
from missiontree.authoring.methods.outline import NobodyError, Outline, fill, leaf_of, outline_of
from missiontree.authoring.methods.slots import Span, matches
from missiontree.authoring.reading.candidates import Candidate
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.hearing import Hearing
from missiontree.authoring.reading.outcomes import Goal
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.plurals import noun_of
from missiontree.authoring.reading.remarks import Read, Said, assumed, reading_line, unused_words
from missiontree.authoring.reading.wording import GOING
from missiontree.authoring.reading.words import DETERMINERS, Word
from missiontree.mission.scene import BASE_KINDS

Bindings = dict[str, tuple[Mention, ...]]


@dataclass
class Fitting:
    """Tries ways of understanding in the state of a hearing."""

    hearing: Hearing

    def fitted(self, candidate: Candidate, clause: Clause, words: tuple[Word, ...]) -> Goal | None:
        """What a clause asks for if it is understood in one way; None if that does not fit."""
        read = self._matched(candidate, clause, words)
        if read is None:
            return None
        read = _from_site(read)
        self.hearing.doers.robots(phrase for phrases in read.values() for phrase in phrases)
        self.hearing.doers.instruments(phrase for phrases in read.values() for phrase in phrases)
        for phrases in read.values():
            self.hearing.refusals.two_places(phrases)
            self.hearing.refusals.apposition(phrases, [word.low for word in clause.words])
            self.hearing.refusals.belongings(phrases)
        self._refuse_company(candidate, clause, read)
        if candidate.is_own:
            self.hearing.doers.with_what(phrase for phrases in read.values() for phrase in phrases)
        said = self._said(candidate, read)
        for mentions in said.values():
            self.hearing.refusals.compared(mentions, self.hearing.speakers.said)
        if candidate.method is not None and not self._holds(candidate.method, said, read):
            return None
        self.hearing.refusals.each_its_own(read)
        if any(element.text == "and" for element in candidate.form) and any(len(p) > 1 for p in read.values()):
            raise UnclearError("it is not clear who is meant for whom")
        if several := [slot for slot, phrases in list(read.items())[1:] if len(phrases) > 1]:
            texts = " and ".join(phrase.text for phrase in read[several[0]])
            raise UnclearError(f"it is not clear which of {texts} is meant for which")
        said = _without_goal(said)
        self._refuse_several(candidate, said)
        outline = self._outline(candidate, said, words)
        steps = candidate.method.all_steps if candidate.method is not None else ()
        capability = next((step.capability for step in steps if step.capability), "")
        if not outline.pieces:
            return None
        for leaf in (leaf for piece in outline.pieces for leaf in piece.leaves):
            leaf.resources = self._allowed(clause, leaf.resources, capability)
        self.hearing.refusals.other_places(outline, said)
        self.hearing.speakers.came_from(read, said)
        pairs = (leaf.mentions for piece in outline.pieces for leaf in piece.leaves if len(leaf.mentions) > 1)
        self.hearing.speakers.were_moved({mentions[0].name for mentions in pairs})
        named = tuple(group for slot, group in said.items() if not self._is_hazard(read[slot]))
        self.hearing.speakers.remember((*named, *_made(candidate)))
        remarks = list(unused_words(outline, read, said, self.hearing.lexicon, self.hearing.brief.world))
        remarks += assumed(candidate.method, said)
        return Goal(
            clause,
            outline,
            reading_line(candidate, clause, read, said),
            tuple(remarks),
            len(read),
            returns=_returns(clause),
            standing=self._standing(clause),
        )

    def _refuse_company(self, candidate: Candidate, clause: Clause, read: Read) -> None:
        """Whoever is said to come along, or may be meant to."""
        assert clause.verb is not None
        goals = self.hearing.lexicon.goals_of.get(clause.verb.phrase, ())
        self.hearing.doers.companions(clause.words, goals)
        if not read:
            return
        self.hearing.doers.sent(next(iter(read.values())), clause.verb.phrase)
        self.hearing.doers.ridden(next(iter(read.values())), clause.verb.phrase)
        if len(read) > 1 and not candidate.is_own:
            self.hearing.refusals.done_there(list(read.values())[-1])
        if "evacuate" in goals:
            self.hearing.refusals.evacuated(next(iter(read.values())))
        *before, last = read.values()
        self.hearing.doers.company((phrase for phrases in before for phrase in phrases), goes=False)
        self.hearing.doers.company(last, goes=bool(set(goals) & GOING))

    def _refuse_several(self, candidate: Candidate, said: Bindings) -> None:
        """Several in a slot that is no list of errands: who of them is meant for what is not said."""
        steps = candidate.method.all_steps if candidate.method is not None else ()
        first = next(iter(said), "")
        for slot, mentions in said.items():
            beside = candidate.method is None or any(slot in step.arguments[1:] for step in steps)
            if slot != first and len(mentions) > 1 and beside:
                raise UnclearError(
                    f"it is not clear which of {' and '.join(m.label for m in mentions)} is meant for which"
                )

    def _said(self, candidate: Candidate, read: Read) -> Bindings:
        """Who fills the slots: first those who are named, then those whom pronouns mean, who are others."""
        said: Bindings = {}
        for pronouns in (False, True):
            for number, (slot, phrases) in enumerate(read.items()):
                if any(phrase.pronoun for phrase in phrases) == pronouns:
                    beside = {mention.name for mentions in said.values() for mention in mentions}
                    said[slot] = self._named(candidate, slot, phrases, number, beside)
        return {slot: said[slot] for slot in read}

    def _named(
        self, candidate: Candidate, slot: str, phrases: tuple[Phrase, ...], number: int, beside: Collection[str]
    ) -> tuple[Mention, ...]:
        """Who fills a slot; a hazard that only tells who is called, and a topic, need not be in the scene."""
        conditions = candidate.method.where.get(slot, ()) if candidate.method is not None else ()
        if "topic" in conditions or ("hazard" in conditions and self._is_hazard(phrases)):
            return tuple(topic(phrase.name, phrase.full) for phrase in phrases)
        return self.hearing.speakers.resolved(phrases, number, _only_kind(candidate, slot), beside)

    def _standing(self, clause: Clause) -> tuple[str, ...]:
        """Robot types that the mission allows for what is added to a clause; none for no restriction."""
        if not (clause.without or clause.throughout):
            return ()
        types = (kind.id for kind in self.hearing.brief.fleet.types)
        asked = clause.throughout
        return tuple(name for name in types if name not in clause.without and (not asked or name in asked))

    def _allowed(self, clause: Clause, by_method: tuple[str, ...], capability: str) -> tuple[str, ...]:
        """Robot types that may do it, of those that a method allows for a capability; none for no restriction."""
        if not (clause.robots or clause.without or by_method):
            return ()
        types = [kind.id for kind in self.hearing.brief.fleet.types]
        for asked in (clause.robots, by_method):
            types = [name for name in types if not asked or name in asked]
        allowed = tuple(name for name in types if name not in clause.without)
        if not allowed and by_method and capability:
            raise NobodyError(capability)
        if not allowed:
            raise UnclearError("no robot type is left that may do it")
        return allowed

    def _matched(self, candidate: Candidate, clause: Clause, words: tuple[Word, ...]) -> Read | None:
        assert clause.verb is not None
        spans = matches(
            candidate.form,
            [word.low for word in words],
            clause.verb,
            self.hearing.lexicon.phrases_of,
            lambda start, end: self.hearing.phrases.phrases(words[start:end]) is not None,
        )
        if spans is None:
            return None
        by_place = sorted(spans.items(), key=_place)
        return {slot: self.hearing.phrases.phrases(words[start:end]) or () for slot, (start, end) in by_place}

    def _outline(self, candidate: Candidate, said: Bindings, words: tuple[Word, ...]) -> Outline:
        if candidate.method is not None:
            return outline_of(
                candidate.method,
                self._completed(candidate.method, said, words),
                self.hearing.brief.routines,
                self.hearing.brief.fleet,
            )
        assert candidate.routine is not None
        several = next(iter(said.values()))
        rows = [
            tuple(one if said[a.name] is several else said[a.name][0] for a in candidate.routine.arguments)
            for one in several
        ]
        return Outline([leaf_of(candidate.routine, row) for row in rows])

    def _holds(self, method: Method, said: Said, read: Read) -> bool:
        """Whether the conditions of a method hold."""
        for slot, conditions in method.where.items():
            if slot not in said:
                continue
            if "topic" in conditions:
                continue
            holds = {"hazard"} if self._is_hazard(read[slot]) else {mention.kind for mention in said[slot]}
            if all(noun_of(mention.label) in self.hearing.lexicon.words["vessels"] for mention in said[slot]):
                holds.add("vessel")
            if any(mention.to_be_found for mention in said[slot]):
                holds.add("lost")
            if not holds & set(conditions):
                return False
        return True

    def _is_hazard(self, phrases: tuple[Phrase, ...]) -> bool:
        heads = (phrase.name.lower().split(" of ")[0] for phrase in phrases)
        return any(self.hearing.lexicon.hazards_in(head.split()) for head in heads)

    def _completed(self, method: Method, said: Bindings, words: tuple[Word, ...]) -> Bindings:
        """The slots with what the method implies, and those who are called for the hazards that the words name."""
        complete = dict(said)
        for name, implied in method.implies.items():
            complete[name] = tuple(
                self.hearing.speakers.implied(fill(implied.name, one), implied.kind, implied.known_as)
                for one in _one_by_one(implied.name, said)
            )
        hazards = self.hearing.lexicon.hazards_in([word.low for word in words]) + self.hearing.hazards
        called = dict.fromkeys(str(self.hearing.lexicon.hazards[name]["responder"]) for name in hazards)
        complete[RESPONDER] = tuple(self.hearing.speakers.implied(name, "person") for name in called)
        if any(RESPONDER in step.mentions for step in method.all_steps):
            self.hearing.called_for |= set(hazards)
        return complete


def _only_kind(candidate: Candidate, slot: str) -> str:
    """The kind that an argument of a routine is of, if it is one of the base kinds alone; empty if it is not."""
    kinds = set(candidate.routine.argument_kinds[slot]) if candidate.routine is not None else set()
    return next(iter(kinds)) if len(kinds) == 1 and kinds <= set(BASE_KINDS) else ""


def _made(candidate: Candidate) -> tuple[tuple[Mention, ...], ...]:
    """The photo of "take a photo of the owl": an "it" behind that may mean it, too."""
    words = [element.text for element in candidate.form if element.kind == "word"] if candidate.is_own else []
    made = [noun for article, noun in pairwise(words) if article in {"a", "an"} and kind_of(noun) == "object"]
    return tuple((topic(noun),) for noun in made)


def _returns(clause: Clause) -> bool:
    """Whether something is brought back to where it was before."""
    lows = [word.low for word in clause.words]
    return lows[:1] == ["return"] or any(
        low == "back" and lows[at - 1] not in DETERMINERS for at, low in enumerate(lows)
    )


def _from_site(read: Read) -> Read:
    """In "evacuate the cows from the barn", those in the barn are meant."""
    if "site" not in read or len(read["site"]) != 1:
        return read
    victim, site = next(iter(read)), read["site"][0]
    where = f"in {site.text}"
    meant = tuple(replace(p, description=where) if p.several and not p.description else p for p in read[victim])
    return {**read, victim: meant}


def _without_goal(said: Bindings) -> Bindings:
    """The slots, without those who would be brought to themselves."""
    if len(said) < 2:
        return said
    first, *others = said.items()
    goals = {mention.name for _, mentions in others for mention in mentions}
    left = tuple(mention for mention in first[1] if mention.name not in goals)
    if not left and first[1]:
        raise UnclearError(f"{first[1][0].label} cannot be brought to {first[1][0].label}")
    return {**said, first[0]: left}


def _one_by_one(template: str, said: Bindings) -> list[Bindings]:
    """The slots as they are, or once for each of several in the slot that a template speaks of."""
    several = [slot for slot, mentions in said.items() if f"{{{slot}}}" in template and len(mentions) > 1]
    return [{**said, several[0]: (mention,)} for mention in said[several[0]]] if several else [said]


def _place(entry: tuple[str, Span]) -> Span:
    return entry[1]
