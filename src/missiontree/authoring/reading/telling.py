"""A clause that asks for nothing: what it states for the clauses beside it, or why it is not understood."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field

from missiontree.authoring.language.verbs import english_verbs
from missiontree.authoring.methods.mention import Mention, UnclearError
from missiontree.authoring.methods.outline import Outline
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.hearing import Hearing
from missiontree.authoring.reading.outcomes import Goal, Trouble, Unserved, trouble
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.statements import Statement, danger_of, feeling_of, place_of, site_of, statement_of
from missiontree.authoring.reading.words import OBJECTS
from missiontree.mission.reason import Reason

_ALIKE = 0.82  # "serch" is like "search"; "send" is not like "mend"


@dataclass
class Telling:
    """Takes statements into the state of a hearing."""

    hearing: Hearing
    _statements: list[tuple[Clause, tuple[Mention, ...], tuple[str, ...]]] = field(default_factory=list)

    def told(self, clause: Clause) -> Goal | Trouble | Unserved:
        """What a clause without a verb states; trouble if that is nothing of use."""
        if dangers := danger_of(clause, self.hearing.phrases, self.hearing.lexicon):
            self.hearing.hazards += dangers
            site = site_of(clause, self.hearing.phrases)
            if site is not None:
                with suppress(UnclearError):
                    self.hearing.speakers.remember((self.hearing.speakers.resolve(site),))
            self._statements.append((clause, (), dangers))
            return Goal(clause, Outline(), f"{clause.text!r}: a statement; danger: {', '.join(dangers)}")
        if (stated := statement_of(clause, self.hearing.phrases, self.hearing.lexicon)) is not None:
            return self._stated(clause, stated)
        if (placed := place_of(clause, self.hearing.phrases)) is not None:
            return self._placed(clause, *placed)
        if (feeling := feeling_of(clause, self.hearing.phrases)) is not None:
            return self._placed(clause, feeling, clause.text)
        return self._no_verb(clause)

    def _placed(self, clause: Clause, phrases: tuple[Phrase, ...], where: str) -> Goal | Trouble:
        """Where somebody is said to be; the scene has the last word, and without one the plan makes no use of it."""
        try:
            self.hearing.doers.robots(phrases)
            mentions = tuple(mention for phrase in phrases for mention in self.hearing.speakers.resolve(phrase))
        except UnclearError as unclear:
            return trouble("unclear", clause, str(unclear))
        self.hearing.speakers.remember((mentions,))
        about = ", ".join(mention.label for mention in mentions)
        message = f"{about}: {where!r} is taken as said; the plan makes no use of it."
        unused = (
            []
            if self.hearing.brief.scene is not None
            else [Reason(rule="description_unused", message=message, severity="assumption", node=about)]
        )
        return Goal(clause, Outline(), f"{clause.text!r}: a statement; {about}: {where}", tuple(unused))

    def _stated(self, clause: Clause, stated: Statement) -> Goal | Trouble:
        try:
            self.hearing.doers.robots(stated.phrases)
            losers = tuple(m for phrase in stated.losers for m in self.hearing.speakers.resolve(phrase))
            groups = tuple(self.hearing.speakers.resolve(phrase) for phrase in stated.phrases)
        except UnclearError as unclear:
            return trouble("unclear", clause, str(unclear))
        mentions = tuple(mention for group in groups for mention in group)
        self.hearing.speakers.remember((mentions, losers) if losers else (mentions,))
        self.hearing.speakers.lost |= {mention.name for mention in mentions if stated.lost}
        self.hearing.hazards += stated.hazards
        self._statements.append((clause, mentions, stated.hazards))
        states = ["lost"] if stated.lost else []
        about = ", ".join(mention.label for mention in mentions)
        return Goal(
            clause, Outline(), f"{clause.text!r}: a statement; {about}: {', '.join([*states, *stated.hazards])}"
        )

    def _no_verb(self, clause: Clause) -> Trouble | Unserved:
        detail, hint = self.hearing.advice.on_order(clause)
        if detail:
            return trouble("robot_unclear", clause, detail, hint)
        first = clause.words[0].low
        if _is_order(clause):
            return Unserved(first, first)
        verbs = [phrase for phrase in self.hearing.lexicon.goals_of if " " not in phrase]
        near = difflib.get_close_matches(first[:40], verbs, n=2, cutoff=_ALIKE)
        hint = f"Did you mean {' or '.join(map(repr, near))}? " if near else ""
        begin = f"{hint}Begin with what is to be done: 'Find ...', 'Bring ... to ...'."
        return trouble("verb_unknown", clause, "it does not begin with a verb that is known", begin)

    def unused_statements(self, goals: Sequence[Goal]) -> Iterator[Reason]:
        """Assumptions about what was stated and changes nothing."""
        spoken = {
            m.name for goal in goals for piece in goal.outline.pieces for leaf in piece.leaves for m in leaf.mentions
        }
        for clause, mentions, hazards in self._statements:
            if not ({mention.name for mention in mentions} & spoken or set(hazards) & self.hearing.called_for):
                message = f"{clause.text!r} does not change what is planned."
                about = mentions[0].label if mentions else ""
                yield Reason(rule="words_unused", message=message, severity="assumption", node=about)


_SAYS = frozenset(
    {"is", "are", "was", "were", "has", "have", "will", "must", "should", "can", "could", "may", "does", "did"}
)


def _is_order(clause: Clause) -> bool:
    """Whether a clause is an order with a verb that nobody serves: "wax the skis"; a statement has a verb of its own elsewhere."""
    lows = [word.low for word in clause.words]
    return len(lows) > 1 and lows[0] in english_verbs() and lows[1] in OBJECTS and not _SAYS & set(lows)
