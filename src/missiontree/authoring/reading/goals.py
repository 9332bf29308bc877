"""A clause to what it asks for: a method's steps or a routine, a goal that nobody serves, or words that are not understood."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.methods.method import RESPONDER, Method, MethodLibrary
from missiontree.authoring.methods.outline import Outline, StepError, fill, leaf_of, outline_of
from missiontree.authoring.methods.patterns import Span, first_words, matches
from missiontree.authoring.reading.advice import RobotAdvice
from missiontree.authoring.reading.candidates import Candidate, candidates
from missiontree.authoring.reading.clauses import MAX_CLAUSE_WORDS, Clause, Word
from missiontree.authoring.reading.entities import Mention, Speakers, UnclearError
from missiontree.authoring.reading.outcomes import Goal, Trouble, Unserved, trouble
from missiontree.authoring.reading.phrases import Phrase, PhraseReader
from missiontree.authoring.reading.places import stands_at
from missiontree.authoring.reading.remarks import Read, Said, reading_line, unused_words
from missiontree.authoring.reading.statements import Statement, statement_of
from missiontree.authoring.reading.wording import plain_order, receiver_behind, with_object
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason

Bindings = dict[str, tuple[Mention, ...]]
_ALIKE = 0.82  # "serch" is like "search"; "send" is not like "mend"


@dataclass
class GoalReader:
    """Understands the clauses of one mission, one after the other; later ones may speak of what earlier ones named."""

    brief: MissionBrief
    library: MethodLibrary
    speakers: Speakers = field(init=False)
    lexicon: Lexicon = field(init=False)
    phrases: PhraseReader = field(init=False)
    hazards: list[str] = field(default_factory=list)
    """Hazards of places and people that were stated."""
    called_for: set[str] = field(default_factory=set)
    """Hazards for which somebody was called."""
    _statements: list[tuple[Clause, tuple[Mention, ...], tuple[str, ...]]] = field(default_factory=list)

    def __post_init__(self) -> None:
        verbs = [verb.lower() for routine in self.brief.routines.routines for verb in routine.verbs if verb.strip()]
        verbs += [
            words for m in self.library.methods for forms in m.forms for form in forms if (words := first_words(form))
        ]
        self.lexicon = Lexicon(verbs)
        world = self.brief.world
        names = {
            form: world.base_kind(entity.kind)
            for entity in world.all_entities
            for name in (entity.id, entity.label, *entity.aliases)
            for form in (name.lower(), name.lower().replace("_", " ").replace("-", " "))
        }
        self.phrases = PhraseReader(self.lexicon, names)
        self.speakers = Speakers(world, complete=self.brief.scene is not None)
        self._advice = RobotAdvice(self.brief.fleet, frozenset(names), self.lexicon)

    def read(self, clause: Clause, following: Clause | None = None) -> Goal | Unserved | Trouble:
        """What a clause asks for; ``following`` lends its object to a clause that has none ("find and rescue the dog")."""
        self.speakers.next_clause()
        if clause.decisive:
            words = ", ".join(repr(word) for word in clause.decisive)
            detail = f"the offline author does not know what to make of {words} there"
            return trouble("decisive_words", clause, detail, self._advice.on_leaving_out(clause))
        if single := self._advice.single(clause):
            return trouble("single_robot", clause, single)
        if clause.verb is None:
            stated = statement_of(clause, self.phrases, self.lexicon)
            return self._no_verb(clause) if stated is None else self._stated(clause, stated)
        if len(clause.words) > MAX_CLAUSE_WORDS:
            long = f"it has {len(clause.words)} words without an end; at most {MAX_CLAUSE_WORDS} are read"
            return trouble("clause_too_long", clause, long)
        ways = candidates(clause.verb, self.library, self.brief.routines, self.lexicon)
        if not ways:
            goals = self.lexicon.goals_of.get(clause.verb.phrase, ())
            return Unserved((*goals, clause.verb.phrase)[0], clause.verb.phrase)
        if len(clause.robots) > 1:
            return trouble(
                "several_robots", clause, f"it names {' and '.join(clause.robots)}; name one type for each part"
            )
        worded = self._worded(clause, following)
        try:
            for candidate in ways:
                if (goal := self._tried(candidate, clause, worded)) is not None:
                    return goal
        except (UnclearError, StepError) as unclear:
            return trouble("unclear", clause, str(unclear))
        return self._left_over(clause, worded, ways)

    def unused_statements(self, goals: Sequence[Goal]) -> Iterator[Reason]:
        """Assumptions about what was stated and changes nothing."""
        spoken = {
            m.name for goal in goals for piece in goal.outline.pieces for leaf in piece.leaves for m in leaf.mentions
        }
        for clause, mentions, hazards in self._statements:
            if not ({mention.name for mention in mentions} & spoken or set(hazards) & self.called_for):
                message = f"{clause.text!r} does not change what is planned."
                yield Reason(rule="words_unused", message=message, severity="assumption", node=mentions[0].label)

    def _stated(self, clause: Clause, stated: Statement) -> Goal | Trouble:
        try:
            self._refuse_robots(stated.phrases)
            groups = tuple(self.speakers.resolve(phrase) for phrase in stated.phrases)
        except UnclearError as unclear:
            return trouble("unclear", clause, str(unclear))
        mentions = tuple(mention for group in groups for mention in group)
        self.speakers.remember((mentions,))
        self.speakers.lost |= {mention.name for mention in mentions if stated.lost}
        self.hazards += stated.hazards
        self._statements.append((clause, mentions, stated.hazards))
        states = ["lost"] if stated.lost else []
        about = ", ".join(mention.label for mention in mentions)
        return Goal(
            clause, Outline(), f"{clause.text!r}: a statement; {about}: {', '.join([*states, *stated.hazards])}"
        )

    def _worded(self, clause: Clause, following: Clause | None) -> tuple[Word, ...]:
        """The words of a clause in plain order, with all that is left out."""
        assert clause.verb is not None
        words = plain_order(with_object(clause, following))
        if "bring" not in self.lexicon.goals_of.get(clause.verb.phrase, ()):
            return words
        return receiver_behind(words, len(clause.verb.phrase.split()), self.phrases)

    def _tried(self, candidate: Candidate, clause: Clause, words: tuple[Word, ...]) -> Goal | None:
        """What a clause asks for if it is understood in one way; None if that does not fit."""
        read = self._matched(candidate, clause, words)
        if read is None:
            return None
        self._refuse_robots(phrase for phrases in read.values() for phrase in phrases)
        self._refuse_instruments(phrase for phrases in read.values() for phrase in phrases)
        for phrases in read.values():
            self._refuse_two_places(phrases)
        said = {slot: tuple(m for p in phrases for m in self.speakers.resolve(p)) for slot, phrases in read.items()}
        if candidate.method is not None and not self._holds(candidate.method, said, read):
            return None
        if any(element.text == "and" for element in candidate.form) and any(len(p) > 1 for p in read.values()):
            raise UnclearError("it is not clear who is meant for whom")
        if several := [slot for slot, phrases in list(read.items())[1:] if len(phrases) > 1]:
            texts = " and ".join(phrase.text for phrase in read[several[0]])
            raise UnclearError(f"it is not clear which of {texts} is meant for which")
        outline = self._outline(candidate, said, words)
        if not outline.pieces:
            return None
        for leaf in (leaf for piece in outline.pieces for leaf in piece.leaves):
            leaf.resources = clause.robots
        self._refuse_other_places(outline, said)
        self.speakers.remember(tuple(group for slot, group in said.items() if not self._is_hazard(read[slot])))
        remarks = unused_words(outline, read, said, self.lexicon, self.brief.world)
        return Goal(clause, outline, reading_line(candidate, clause, read, said), tuple(remarks))

    def _matched(self, candidate: Candidate, clause: Clause, words: tuple[Word, ...]) -> Read | None:
        assert clause.verb is not None
        spans = matches(
            candidate.form,
            [word.low for word in words],
            clause.verb,
            self.lexicon.phrases_of,
            lambda start, end: self.phrases.phrases(words[start:end]) is not None,
        )
        if spans is None:
            return None
        by_place = sorted(spans.items(), key=_place)
        return {slot: self.phrases.phrases(words[start:end]) or () for slot, (start, end) in by_place}

    def _outline(self, candidate: Candidate, said: Bindings, words: tuple[Word, ...]) -> Outline:
        if candidate.method is not None:
            return outline_of(candidate.method, self._completed(candidate.method, said, words), self.brief.routines)
        assert candidate.routine is not None
        objects, *rest = said.values()
        return Outline([leaf_of(candidate.routine, (one, *(mentions[0] for mentions in rest))) for one in objects])

    def _refuse_robots(self, phrases: Iterable[Phrase]) -> None:
        """Who shall do it is no description of whom it is done to."""
        for phrase in phrases:
            named = self._advice.named_in(phrase.text)
            if named and phrase.name.lower() not in self.phrases.known:
                raise UnclearError(self._advice.on(named[0]))

    def _refuse_instruments(self, phrases: Iterable[Phrase]) -> None:
        """What it shall be done with is no description either, if it is no robot of the fleet."""
        for phrase in phrases:
            lows = phrase.description.lower().split()
            if lows[:1] == ["with"] and lows[-1] in self.lexicon.words["instruments"]:
                named = f"names no robot of the fleet ({self._advice.types})"
                raise UnclearError(f"{phrase.description!r} may say who does it, and {named}")

    def _refuse_two_places(self, phrases: tuple[Phrase, ...]) -> None:
        """In "the child in the park and the forest" the forest is no second child."""
        kinds = [self.phrases.kind_of(phrase) for phrase in phrases]
        for place, phrase in enumerate(phrases[:-1]):
            if phrase.description and kinds[place] != "place" and "place" in kinds[place + 1 :]:
                raise UnclearError(f"it is not clear what goes with {phrase.description!r}")

    def _refuse_other_places(self, outline: Outline, said: Said) -> None:
        """A place that only says where somebody is must be where the scene has them."""
        world = self.brief.world
        used = {mention.name for piece in outline.pieces for leaf in piece.leaves for mention in leaf.mentions}
        mentions = [mention for group in said.values() for mention in group if not mention.new]
        for site in (mention for mention in mentions if mention.kind == "place" and mention.name not in used):
            for mention in mentions:
                if (
                    mention.name in used
                    and stands_at(world.by_id[mention.name], world.by_id[site.name], world) is False
                ):
                    raise UnclearError(f"the scene has {mention.label} elsewhere, not at {site.label}")

    def _holds(self, method: Method, said: Said, read: Read) -> bool:
        """Whether the conditions of a method hold."""
        for slot, conditions in method.where.items():
            if slot not in said:
                continue
            holds = {"hazard"} if self._is_hazard(read[slot]) else {mention.kind for mention in said[slot]}
            if any(mention.to_be_found for mention in said[slot]):
                holds.add("lost")
            if not holds & set(conditions):
                return False
        return True

    def _is_hazard(self, phrases: tuple[Phrase, ...]) -> bool:
        heads = (phrase.name.lower().split(" of ")[0] for phrase in phrases)
        return any(self.lexicon.hazard_words.within(head.split()) for head in heads)

    def _completed(self, method: Method, said: Bindings, words: tuple[Word, ...]) -> Bindings:
        """The slots with what the method implies, and those who are called for the hazards that the words name."""
        complete = dict(said)
        for name, implied in method.implies.items():
            complete[name] = (self.speakers.implied(fill(implied.name, said), implied.kind, implied.known_as),)
        hazards = [name for name, _, _ in self.lexicon.hazard_words.within([word.low for word in words])] + self.hazards
        called = dict.fromkeys(str(self.lexicon.hazards[name]["responder"]) for name in hazards)
        complete[RESPONDER] = tuple(self.speakers.implied(name, "person") for name in called)
        if any(RESPONDER in step.mentions for step in method.all_steps):
            self.called_for |= set(hazards)
        return complete

    def _no_verb(self, clause: Clause) -> Trouble:
        detail, hint = self._advice.on_order(clause)
        if detail:
            return trouble("robot_unclear", clause, detail, hint)
        first = clause.words[0].low
        verbs = [phrase for phrase in self.lexicon.goals_of if " " not in phrase]
        near = difflib.get_close_matches(first[:40], verbs, n=2, cutoff=_ALIKE)
        hint = f"Did you mean {' or '.join(map(repr, near))}? " if near else ""
        begin = f"{hint}Begin with what is to be done: 'Find ...', 'Bring ... to ...'."
        return trouble("verb_unknown", clause, "it does not begin with a verb that is known", begin)

    def _left_over(self, clause: Clause, words: tuple[Word, ...], ways: Sequence[Candidate]) -> Trouble:
        assert clause.verb is not None
        examples = list(dict.fromkeys(candidate.example(clause.verb) for candidate in ways))[:3]
        behind = words[len(clause.verb.phrase.split()) :]
        if not behind:
            detail = f"'{clause.verb.phrase}' lacks its object"
        elif self.phrases.phrases(behind) is not None:
            detail = f"'{clause.verb.phrase}' does not go with {' '.join(word.text for word in behind)!r} alone"
        else:
            left = " ".join(word.text for word in self.phrases.left_over(behind))
            detail = f"the verb '{clause.verb.phrase}' is understood, but not {left!r}"
        return trouble("words_left_over", clause, detail, f"Understood would be: {'; '.join(examples)}.")


def _place(entry: tuple[str, Span]) -> Span:
    return entry[1]
