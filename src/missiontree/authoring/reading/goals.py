"""A clause to what it asks for: a method's steps or a routine, a goal that nobody serves, or words that are not understood."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace

from missiontree.authoring.methods.mention import UnclearError
from missiontree.authoring.methods.outline import Outline
from missiontree.authoring.reading.asides import without_asides
from missiontree.authoring.reading.clause import MAX_CLAUSE_WORDS, Clause
from missiontree.authoring.reading.hearing import Hearing
from missiontree.authoring.reading.idioms import idiom_in
from missiontree.authoring.reading.outcomes import Goal, Trouble, Unserved, trouble
from missiontree.authoring.reading.phrases import EXCEPTIONS
from missiontree.authoring.reading.statements import CANNOT, cause_of, event_of, loses
from missiontree.authoring.reading.telling import Telling
from missiontree.authoring.reading.understanding import Understanding
from missiontree.authoring.reading.wishes import errand_of, wish_of
from missiontree.authoring.reading.wording import with_object
from missiontree.mission.reason import Reason

_DOUBTS = {
    "first": (
        "it is said to come first, and it is not clear whether it comes before what was said before it",
        "Say 'before that' or 'then' in place of 'first'.",
    ),
    "last": (
        "it is a list, and it is not clear whether all of it comes at the end, or the last part alone",
        "Say 'then' before what comes last.",
    ),
}


@dataclass
class GoalReader:
    """Understands the clauses of one mission, one after the other; later ones may speak of what earlier ones named."""

    hearing: Hearing
    _telling: Telling = field(init=False)
    _understanding: Understanding = field(init=False)
    _outlines: list[Outline] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._telling = Telling(self.hearing)
        self._understanding = Understanding(self.hearing)

    def read(self, clause: Clause, following: Clause | None = None) -> Goal | Unserved | Trouble:
        """What a clause asks for; ``following`` lends its object to a clause that has none ("find and rescue the dog")."""
        heard = self.hearing
        heard.speakers.next_clause(clause.sentence)
        if (again := self._event(clause)) is not None:
            return again
        clause, asides = without_asides(clause, heard.phrases, heard.lexicon)
        if (refused := self._refused(clause)) is not None:
            return refused
        wished = wish_of(clause, heard.phrases, heard.lexicon) if clause.verb is None else None
        clause = wished or clause
        if clause.verb is None and (errand := errand_of(clause, heard.phrases, heard.lexicon)) is not None:
            asides = (*asides, _without_verb(clause))
            clause = errand
        if clause.verb is None:
            told = self._telling.told(clause)
            if isinstance(told, Unserved):
                self._remember_object(clause, 1)
            return told
        words, cause = cause_of(with_object(clause, following))
        dangers = tuple(heard.lexicon.hazards_in([word.low for word in cause]))
        if cause and not dangers:
            said = " ".join(word.text for word in cause)
            return trouble("words_left_over", clause, f"it is not clear what {said!r} changes")
        heard.hazards += dangers
        return self._kept(
            clause, self._understanding.understood(replace(clause, words=words)), asides, wished is not None
        )

    def _refused(self, clause: Clause) -> Trouble | None:
        """Why a clause is not understood whatever it asks for; None if nothing speaks against it."""
        advice = self.hearing.advice
        if set(clause.decisive) - self._excepting(clause):
            words = ", ".join(repr(word) for word in clause.decisive)
            detail = f"the offline author does not know what to make of {words} there"
            return trouble("decisive_words", clause, detail, advice.on_leaving_out(clause))
        if clause.doubt:
            return trouble("order_unclear", clause, *_DOUBTS[clause.doubt])
        if single := advice.single(clause):
            return trouble("single_robot", clause, single)
        if idiom := idiom_in(clause, self.hearing.lexicon):
            plain = "Say what is to be done in plain words."
            return trouble("figure_of_speech", clause, f"{idiom!r} is a figure of speech", plain)
        if len(clause.words) > MAX_CLAUSE_WORDS:
            long = f"it has {len(clause.words)} words without an end; at most {MAX_CLAUSE_WORDS} are read"
            return trouble("clause_too_long", clause, long)
        if len(clause.asked) > 1:
            robots = " and ".join(" or ".join(types) for types in clause.asked)
            return trouble("several_robots", clause, f"it names {robots}; name one type for each part")
        if clause.robots and not set(clause.robots) - set(clause.without):
            return trouble("several_robots", clause, f"it asks for {' or '.join(clause.robots)} and leaves that out")
        return None

    def _excepting(self, clause: Clause) -> set[str]:
        """Words that are understood here: the exception in "all crates but the red one", and "she cannot find her keys"."""
        lows = [word.low for word in clause.words]
        if clause.verb is None and loses(clause):
            return set(CANNOT)
        return EXCEPTIONS if {"all", "every", "each", "everyone", "everybody"} & set(lows) else set()

    def _kept(
        self, clause: Clause, goal: Goal | Unserved | Trouble, asides: tuple[Reason, ...], wished: bool
    ) -> Goal | Unserved | Trouble:
        """The goal with what was taken for granted; who it is about is kept for later clauses."""
        if isinstance(goal, Unserved):
            self._remember_object(clause, clause.verb.length if clause.verb is not None else 1)
        if not isinstance(goal, Goal):
            return goal
        leaves = [leaf for piece in goal.outline.pieces for leaf in piece.leaves]
        several = len(leaves) > 1 or any(mention.plural for leaf in leaves for mention in leaf.mentions)
        if several and any(aside.rule == "exception_unused" for aside in asides):
            return trouble("decisive_words", clause, "it is not clear who is left out", "Say 'all pumps but pump 4'.")
        goal = replace(goal, assumptions=(*asides, *goal.assumptions), wished=wished)
        self._outlines.append(goal.outline)
        ordered = clause.in_order and (len(goal.outline.pieces) > 1 or clause.relation != "and")
        return self._understanding.in_order(goal) if ordered else goal

    def _remember_object(self, clause: Clause, length: int) -> None:
        """Keep who or what an order that nobody serves is about, behind its verb, for pronouns of later clauses."""
        words = clause.words[length:]
        read = self.hearing.phrases.phrases(words) or ()
        with suppress(UnclearError):
            mentions = tuple(mention for phrase in read for mention in self.hearing.speakers.resolve(phrase))
            self.hearing.speakers.remember((mentions,))

    def _event(self, clause: Clause) -> Goal | Trouble | None:
        """What an earlier clause asks for, if this one names only its end: "until she is there", "once the box is delivered"."""
        event = event_of(clause, self.hearing.phrases, self.hearing.lexicon)
        if event is None:
            return None
        try:
            names = {mention.name for mention in self.hearing.speakers.kept().resolve(event)} if event.name else set()
        except UnclearError as unclear:
            return trouble("unclear", clause, str(unclear))
        for outline in reversed(self._outlines):
            leaves = [leaf for piece in outline.pieces for leaf in piece.leaves if len(leaf.mentions) > 1]
            fitting = [leaf for leaf in leaves if leaf.mentions[0].name in names]
            if fitting and {leaf.mentions[0].name for leaf in fitting} == names:
                same = [replace(leaf, pieces=[]) for leaf in fitting]
                return Goal(
                    clause, Outline(same), f"{clause.text!r}: the end of {', '.join(leaf.label for leaf in same)}"
                )
        return None

    def unused_statements(self, goals: Sequence[Goal]) -> Iterator[Reason]:
        """Assumptions about what was stated and changes nothing."""
        return self._telling.unused_statements(goals)


def _without_verb(clause: Clause) -> Reason:
    message = f"{clause.text!r} has no verb; it is read as an order to bring."
    return Reason(rule="verb_assumed", message=message, severity="assumption", node=clause.text[:200])
