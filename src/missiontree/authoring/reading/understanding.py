"""A clause that begins with a verb, to what it asks for: as it stands, as a choice, or as two clauses with one verb."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

from missiontree.authoring.language.lexicon import Verb
from missiontree.authoring.methods.mention import UnclearError
from missiontree.authoring.methods.outline import NobodyError, StepError
from missiontree.authoring.reading.candidates import Candidate, candidates
from missiontree.authoring.reading.choosing import both_of, choice_of
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.coordination import Cut, choices, gaps, has_choice
from missiontree.authoring.reading.entities import Speakers
from missiontree.authoring.reading.fitting import Fitting
from missiontree.authoring.reading.hearing import Hearing
from missiontree.authoring.reading.outcomes import Goal, Trouble, Unserved, trouble
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.wording import (
    GOING,
    MOVING,
    PREPOSITIONS,
    TO,
    by_doing,
    exception_first,
    plain_order,
    receiver_behind,
    without_message,
)
from missiontree.authoring.reading.words import Word

_TAKING = frozenset({"pick up", "collect", "get", "fetch", "grab", "retrieve", "recover"})


@dataclass
class Understanding:
    """Understands clauses in the state of a hearing."""

    hearing: Hearing
    fitting: Fitting = field(init=False)
    within: Goal | Unserved | Trouble | None = None
    """What is not clear within an option of the choice under way."""

    def __post_init__(self) -> None:
        self.fitting = Fitting(self.hearing)

    def understood(self, clause: Clause) -> Goal | Unserved | Trouble:
        """What a clause asks for: as it stands, or as a choice, or as two with one verb, or with the verb of its manner."""
        before = self.hearing.speakers.kept()
        self.within = None
        as_it_stands = self._plainly(clause)
        if isinstance(as_it_stands, Goal):
            return as_it_stands
        assert clause.verb is not None
        length = len(clause.verb.phrase.split())
        if has_choice(clause.words):
            ways: Iterator[Goal | None] = (self._chosen(clause, cut, before) for cut in choices(clause.words, length))
        else:
            ways = (self._both(clause, pair, before) for pair in gaps(clause.words, length))
        manner = by_doing(clause, self.hearing.lexicon)
        if manner is not None and isinstance(goal := self._again(manner, before), Goal):
            return replace(goal, clause=clause)
        found = next((goal for goal in ways if goal is not None), None)
        if found is None:
            self.hearing.speakers = before
            if has_choice(clause.words) and self.within is not None:
                return self.within
            if has_choice(clause.words):
                return trouble("decisive_words", clause, "it is not clear between what 'or' leaves the choice")
        return found or as_it_stands

    def _again(self, clause: Clause, before: Speakers) -> Goal | Unserved | Trouble:
        self.hearing.speakers = before.kept()
        return self.understood(clause)

    def _variant(self, clause: Clause, words: tuple[Word, ...]) -> Clause:
        """The clause with other words behind the same verb."""
        assert clause.verb is not None
        return replace(clause, words=words, verb=Verb(clause.verb.phrase, "base", len(clause.verb.phrase.split())))

    def _chosen(self, clause: Clause, cut: Cut, before: Speakers) -> Goal | None:
        """The clause as a choice between the variants; None if any of them is not understood."""
        if not (cut.whole or self._alike(cut.options)):
            return None
        made: list[Goal] = []
        named: list[set[str]] = []
        after = before
        for words in cut.variants:
            self.hearing.speakers = before.kept()
            goal = self.understood(self._variant(clause, words))
            if not isinstance(goal, Goal):
                unclear = isinstance(goal, Trouble) and goal.reason.rule == "unclear"
                self.within = goal if self.within is None and unclear else self.within
                return None
            made.append(goal)
            named.append(
                {m.name for groups in self.hearing.speakers.said[len(before.said) - 1 :] for g in groups for m in g}
            )
            after = after.joined(self.hearing.speakers, len(before.said))
        if len({goal.slots for goal in made}) > 1:
            return (
                None  # "search the hall or the lab for Anna" is no choice between searching the hall and finding Anna
            )
        everybody = set[str]().union(*named)
        after.open_choice |= {name for name in everybody if any(name not in names for names in named)}
        self.hearing.speakers = after
        return choice_of(clause, made)

    def _alike(self, options: Sequence[tuple[Word, ...]]) -> bool:
        """Whether options are of one kind: two places, or two things, or two ways that begin with the same word."""
        if all(option[0].low in PREPOSITIONS for option in options) and options[0][0].low != "by":
            return True
        kinds: set[str | None] = set()
        for option in options:
            words = option[1:] if option[0].low in PREPOSITIONS else option
            phrases = self.hearing.phrases.phrases(words)
            if option[0].low == "by" and self.hearing.lexicon.verb_at([word.low for word in option], 1, "gerund"):
                return all(other[0].low == "by" for other in options)
            if not phrases:
                return len(words) == 1 or all(any(word.low == "to" for word in other) for other in options)
            kinds.add(self.hearing.phrases.kind_of(phrases[0]))
        kinds.discard(None)
        return len(kinds) < 2 or kinds <= {"person", "animal"}

    def _both(self, clause: Clause, pair: tuple[tuple[Word, ...], tuple[Word, ...]], before: Speakers) -> Goal | None:
        """The clause as two with the same verb, both to be done; None if either is not understood."""
        self.hearing.speakers = before.kept()
        first = self._plainly(self._variant(clause, pair[0]))
        if not isinstance(first, Goal) or first.slots < 2:
            return None
        second = self.understood(self._variant(clause, pair[1]))
        if not isinstance(second, Goal) or second.slots != first.slots or _ends_in(second) != _ends_in(first):
            return None  # "move the box to the hall and from the hall to the yard" moves, and goes nowhere
        return both_of(clause, (first, second))

    @staticmethod
    def in_order(goal: Goal) -> Goal | Trouble:
        """The parts of a goal one after the other, as they are named."""
        pieces = goal.outline.pieces
        if len(pieces) < 2:
            return trouble("order_of_one", goal.clause, "it asks for an order, and there is only one thing to be done")
        for one, other in pairwise(pieces):
            goal.outline.link(one, other)
        return goal

    def ways(self, verb: Verb) -> list[Candidate]:
        """The ways in which a clause that begins with a verb may be understood."""
        return candidates(verb, self.hearing.library, self.hearing.brief.routines, self.hearing.lexicon)

    def _plainly(self, clause: Clause) -> Goal | Unserved | Trouble:
        """What a clause asks for as it stands."""
        assert clause.verb is not None
        ways = self.ways(clause.verb)
        if not ways:
            goals = self.hearing.lexicon.goals_of.get(clause.verb.phrase, ())
            return Unserved((*goals, clause.verb.phrase)[0], clause.verb.phrase)
        try:
            worded = self._worded(clause)
        except UnclearError as unclear:
            return trouble("unclear", clause, str(unclear))
        before = self.hearing.speakers.kept()
        try:
            for candidate in ways:
                said = (clause.words, worded) if candidate.is_own and clause.words != worded else (worded,)
                for words in said:
                    if (goal := self.fitting.fitted(candidate, clause, words)) is not None:
                        return goal
                self.hearing.speakers = before.kept()
        except (UnclearError, StepError) as unclear:
            return trouble("unclear", clause, str(unclear))
        except NobodyError as nobody:
            return Unserved(nobody.capability, clause.verb.phrase, robots_lack=True)
        return self._left_over(clause, worded, ways)

    def _worded(self, clause: Clause) -> tuple[Word, ...]:
        """The words of a clause in plain order."""
        assert clause.verb is not None
        lexicon, length = self.hearing.lexicon, len(clause.verb.phrase.split())
        goals = set(lexicon.goals_of.get(clause.verb.phrase, ()))
        words = exception_first(self._at_that_place(clause, moves=bool(goals & GOING)), length)
        if "warn" in goals:
            return without_message(words, lexicon)
        spoken = replace(clause, words=words)
        back = self._back(spoken) if goals & MOVING else None
        words = back or plain_order(spoken, moves=bool(goals & GOING))
        return receiver_behind(words, length, self.hearing.phrases) if "bring" in goals else words

    def _at_that_place(self, clause: Clause, *, moves: bool) -> tuple[Word, ...]:
        """The words with "the crates there" as "the crates at the dock", where *there* is not where something goes."""
        assert clause.verb is not None
        length, made = len(clause.verb.phrase.split()), list[Word]()
        for place, word in enumerate(clause.words):
            last = place == len(clause.words) - 1 and clause.verb.phrase not in _TAKING
            before = clause.words[place - 1].low if place else ""
            describes = word.low == "there" and place > length and before not in PREPOSITIONS and not (last and moves)
            if not describes:
                made.append(word)
                continue
            (where,) = self.hearing.speakers.kept().resolve(Phrase("there", "there", pronoun="place"))
            label = (Word(part, part.lower()) for part in where.label.split())
            made += [Word("at", "at"), *(() if not where.determined and where.new else (Word("the", "the"),)), *label]
        return tuple(made)

    def _back(self, clause: Clause) -> tuple[Word, ...] | None:
        """The words "take it back" as "take it to the lab", where it came from; None if they say where to, or not *back*."""
        assert clause.verb is not None
        length = len(clause.verb.phrase.split())
        words = clause.words
        back = len(words) > length + 1 and words[-1].low == "back"
        if not back or any(word.low in TO.split("|") for word in words[length:]):
            return None
        if len(receiver_behind(words[:-1], length, self.hearing.phrases)) > len(words) - 1:
            return words[:-1]  # "give Anna her keys back"
        phrases = self.hearing.phrases.phrases(words[length:-1]) or ()
        moved = [mention for phrase in phrases for mention in self.hearing.speakers.moved(phrase)]
        starts = list(dict.fromkeys(self.hearing.speakers.start_of(mention) for mention in moved))
        if len(starts) != 1 or not starts[0]:
            raise UnclearError("it is not clear where 'back' is; say where to")
        named = words[length:-1]
        if len(moved) == 1:
            named = (Word("the", "the"), *(Word(part, part.lower()) for part in moved[0].label.split()))
        return (
            *words[:length],
            *named,
            Word("to", "to"),
            Word("the", "the"),
            *(Word(part, part.lower()) for part in starts[0].split()),
        )

    def _left_over(self, clause: Clause, words: tuple[Word, ...], ways: Sequence[Candidate]) -> Trouble:
        assert clause.verb is not None
        examples = list(dict.fromkeys(candidate.example(clause.verb) for candidate in ways))[:3]
        behind = words[len(clause.verb.phrase.split()) :]
        if not behind:
            detail = f"'{clause.verb.phrase}' lacks its object"
        elif self.hearing.phrases.phrases(behind) is not None:
            detail = f"'{clause.verb.phrase}' does not go with {' '.join(word.text for word in behind)!r} alone"
        else:
            left = " ".join(word.text for word in self.hearing.phrases.left_over(behind))
            detail = f"the verb '{clause.verb.phrase}' is understood, but not {left!r}"
        return trouble("words_left_over", clause, detail, f"Understood would be: {'; '.join(examples)}.")


def _ends_in(goal: Goal) -> set[str]:
    """Ids of the routines that a goal ends in."""
    return {leaf.routine.id for piece in goal.outline.pieces for leaf in piece.leaves if leaf.routine is not None}
