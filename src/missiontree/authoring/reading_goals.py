"""A clause to what it asks for: a method's steps or a routine, a goal that nobody serves, or words that are not understood."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from missiontree.authoring.lexicon import Lexicon, Verb
from missiontree.authoring.method_outline import Outline, StepError, fill, leaf_of, outline_of
from missiontree.authoring.method_patterns import Element, Form, Span, first_words, fixed_words, matches
from missiontree.authoring.methods import RESPONDER, Method, MethodLibrary, built_in_methods
from missiontree.authoring.reading import MAX_CLAUSE_WORDS, Clause, Word
from missiontree.authoring.reading_entities import Mention, Speakers, UnclearError
from missiontree.authoring.reading_phrases import Phrase, PhraseReader
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason
from missiontree.mission.routine import Routine
from missiontree.routines.library import built_in

_TO = "to|into|onto|toward|towards"
_ANY = f"{_TO}|at|in|on|from|with|for|inside|near|against|under|over|around|between|about|by"
_PREPOSITIONS = frozenset(_ANY.split("|"))
_DETERMINERS = frozenset({"the", "a", "her", "his", "my", "our", "their", "its", "your"})
_PARTICLES = frozenset({"back", "over", "along", "away", "down", "up"})
_OWN_METHOD, _OWN_ROUTINE, _METHOD, _ROUTINE, _SAME_GOAL = range(5)


@dataclass(frozen=True, slots=True)
class Trouble:
    """A clause that is not understood, and why."""

    reason: Reason


@dataclass(frozen=True, slots=True)
class Unserved:
    """A clause that is understood, but asks for what no routine does."""

    goal: str
    verb: str


@dataclass(frozen=True, slots=True)
class Goal:
    """A clause that is understood: what is to be built, how it was read, and what was taken for granted."""

    clause: Clause
    outline: Outline
    reading: str
    assumptions: tuple[Reason, ...] = ()


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A way of understanding a clause; smaller ranks are tried first."""

    rank: tuple[int, int, int]
    form: Form
    method: Method | None = None
    routine: Routine | None = None


@dataclass
class GoalReader:
    """Understands the clauses of one mission, one after the other; later ones may speak of what earlier ones named."""

    brief: MissionBrief
    library: MethodLibrary
    speakers: Speakers = field(init=False)
    lexicon: Lexicon = field(init=False)
    phrases: PhraseReader = field(init=False)

    def __post_init__(self) -> None:
        verbs = [verb.lower() for routine in self.brief.routines.routines for verb in routine.verbs if verb.strip()]
        verbs += [
            words for m in self.library.methods for forms in m.forms for form in forms if (words := first_words(form))
        ]
        self.lexicon = Lexicon(verbs)
        entities = self.brief.world.all_entities
        names = (name for entity in entities for name in (entity.id, entity.label, *entity.aliases))
        known = frozenset(
            form for name in names for form in (name.lower(), name.lower().replace("_", " ").replace("-", " "))
        )
        self.phrases = PhraseReader(self.lexicon, known)
        self.speakers = Speakers(self.brief.world)

    def read(self, clause: Clause, following: Clause | None = None) -> Goal | Unserved | Trouble:
        """What a clause asks for; ``following`` lends its object to a clause that has none ("find and rescue the dog")."""
        self.speakers.next_clause()
        if clause.decisive:
            words = ", ".join(repr(word) for word in clause.decisive)
            return _trouble("decisive_words", clause, f"the offline author does not know what to make of {words} there")
        if clause.verb is None:
            return self._no_verb(clause)
        if len(clause.words) > MAX_CLAUSE_WORDS:
            return _trouble(
                "clause_too_long",
                clause,
                f"it has {len(clause.words)} words without an end; at most {MAX_CLAUSE_WORDS} are read",
            )
        candidates = sorted(self._candidates(clause.verb), key=lambda candidate: candidate.rank)
        if not candidates:
            return Unserved(
                (*self.lexicon.goals_of.get(clause.verb.phrase, ()), clause.verb.phrase)[0], clause.verb.phrase
            )
        read = _plain_order(_with_object(clause, following))
        try:
            for candidate in candidates:
                if (goal := self._tried(candidate, clause, read)) is not None:
                    return goal
        except (UnclearError, StepError) as unclear:
            return _trouble("unclear", clause, str(unclear))
        said = "; ".join(list(dict.fromkeys(_example(candidate, clause.verb) for candidate in candidates))[:3])
        behind = read[clause.verb.length :]
        left = self._left_over(read)
        if not behind:
            detail = f"'{clause.verb.phrase}' lacks its object"
        elif self.phrases.phrases(behind) is not None:
            detail = f"'{clause.verb.phrase}' does not go with {' '.join(word.text for word in behind)!r} alone"
        else:
            detail = f"the verb '{clause.verb.phrase}' is understood, but not {left!r}"
        return _trouble("words_left_over", clause, detail, f"Understood would be: {said}.")

    def _candidates(self, verb: Verb) -> Iterator[_Candidate]:
        shipped = {method.id: method for method in built_in_methods().methods}
        for order, method in enumerate(self.library.methods):
            tier = _METHOD if shipped.get(method.id) is method else _OWN_METHOD
            for forms in method.forms:
                for form in forms:
                    if self._begins(form, verb):
                        yield _Candidate((tier, -fixed_words(form), order), form, method=method)
        ours = built_in().by_id
        goals = set(self.lexicon.goals_of.get(verb.phrase, ()))
        for order, routine in enumerate(self.brief.routines.routines):
            own = ours.get(routine.id) != routine
            verbs = [known.lower() for known in routine.verbs]
            exact = verb.phrase in verbs
            if exact or any(goals & set(self.lexicon.goals_of.get(known, ())) for known in verbs):
                tier = (_OWN_ROUTINE if own else _ROUTINE) if exact else _SAME_GOAL
                form = _routine_form(routine, verb, own)
                yield _Candidate((tier, -len(routine.arguments), order), form, routine=routine)

    def _begins(self, form: Form, verb: Verb) -> bool:
        if form[0].kind == "goal":
            return verb.phrase in self.lexicon.phrases_of.get(form[0].text, ())
        return form[0].text == verb.phrase.split()[0]

    def _tried(self, candidate: _Candidate, clause: Clause, words: tuple[Word, ...]) -> Goal | None:
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
        read = {
            slot: self.phrases.phrases(words[start:end]) or ()
            for slot, (start, end) in sorted(spans.items(), key=_by_place)
        }
        self._refuse_robots(phrase for phrases in read.values() for phrase in phrases)
        bindings = {
            slot: tuple(m for phrase in phrases for m in self.speakers.resolve(phrase))
            for slot, phrases in read.items()
        }
        if candidate.method is not None and not self._holds(candidate.method, bindings, read, words):
            return None
        if several := [slot for slot, phrases in list(read.items())[1:] if len(phrases) > 1]:
            raise UnclearError(
                f"it is not clear which of {' and '.join(p.text for p in read[several[0]])} is meant for which"
            )
        said = bindings
        if candidate.method is not None:
            bindings = self._completed(candidate.method, bindings, words)
            outline = outline_of(candidate.method, bindings, self.brief.routines)
        else:
            assert candidate.routine is not None
            outline = Outline()
            objects, *rest = bindings.values()
            outline.pieces = [leaf_of(candidate.routine, (one, *(mentions[0] for mentions in rest))) for one in objects]
        if not outline.pieces:
            return None
        self.speakers.remember(tuple(mention for mentions in said.values() for mention in mentions))
        reading = self._reading(candidate, clause, read, said)
        return Goal(clause, outline, reading, tuple(self._assumed(outline, read, said)))

    def _refuse_robots(self, phrases: Iterable[Phrase]) -> None:
        """Who shall do it is no description of whom it is done to."""
        robots = {name.lower() for kind in self.brief.fleet.types for name in (kind.id, kind.label)}
        robots |= {robot.lower() for robot in self.brief.fleet.robots}
        for phrase in phrases:
            text = f" {phrase.text.lower()} "
            named = next((robot for robot in sorted(robots) if f" {robot} " in text), None)
            if named is not None and phrase.name.lower() not in self.phrases.known:
                raise UnclearError(
                    f"{named!r} is a robot of the fleet; which robot does what is not read from the words"
                )

    def _holds(
        self,
        method: Method,
        bindings: dict[str, tuple[Mention, ...]],
        read: dict[str, tuple[Phrase, ...]],
        words: tuple[Word, ...],
    ) -> bool:
        for slot, conditions in method.where.items():
            if slot not in bindings:
                continue
            hazard = any(self.lexicon.hazard_words.within(phrase.name.lower().split()) for phrase in read[slot])
            holds = {"hazard"} if hazard else {mention.kind for mention in bindings[slot]}
            if any(mention.to_be_found for mention in bindings[slot]):
                holds.add("lost")
            if not holds & set(conditions):
                return False
        return True

    def _completed(
        self, method: Method, bindings: dict[str, tuple[Mention, ...]], words: tuple[Word, ...]
    ) -> dict[str, tuple[Mention, ...]]:
        """The slots with what the method implies, and those who are called for the hazards that the words name."""
        complete = dict(bindings)
        for name, implied in method.implies.items():
            complete[name] = (self.speakers.implied(fill(implied.name, bindings), implied.kind, implied.known_as),)
        hazards = dict.fromkeys(name for name, _, _ in self.lexicon.hazard_words.within([word.low for word in words]))
        called = dict.fromkeys(str(self.lexicon.hazards[name]["responder"]) for name in hazards)
        complete[RESPONDER] = tuple(self.speakers.implied(name, "person") for name in called)
        return complete

    def _reading(
        self,
        candidate: _Candidate,
        clause: Clause,
        read: dict[str, tuple[Phrase, ...]],
        said: dict[str, tuple[Mention, ...]],
    ) -> str:
        by = (
            f"method {candidate.method.id}"
            if candidate.method
            else f"routine {candidate.routine.id}"
            if candidate.routine
            else ""
        )
        slots = ", ".join(
            f"{slot} = {' and '.join(phrase.text for phrase in phrases)} ({', '.join(m.label for m in said[slot])})"
            for slot, phrases in read.items()
        )
        over = f"; passed over: {', '.join(clause.passed_over)}" if clause.passed_over else ""
        return f"{clause.text!r}: {by}, {_shown(candidate.form)}; {slots}{over}"

    def _assumed(
        self, outline: Outline, read: dict[str, tuple[Phrase, ...]], said: dict[str, tuple[Mention, ...]]
    ) -> Iterator[Reason]:
        used = {mention.name for piece in outline.pieces for leaf in piece.leaves for mention in leaf.mentions}
        for slot, phrases in read.items():
            for phrase in phrases:
                if phrase.description and not self._is_used(phrase.description):
                    message = f"{phrase.description!r} is taken to describe {phrase.name}; the plan makes no use of it."
                    yield Reason(rule="description_unused", message=message, severity="assumption", node=phrase.name)
            for mention in said[slot]:
                if (
                    mention.name not in used
                    and not any(mention.label in piece.label for piece in outline.pieces)
                    and not self._implied_by(mention, used)
                ):
                    message = f"{mention.label} does not change what is planned."
                    yield Reason(rule="words_unused", message=message, severity="assumption", node=mention.label)
                elif mention.plural and mention.new:
                    message = f"{mention.label} are planned for as one group."
                    yield Reason(
                        rule="planned_as_one",
                        message=message,
                        severity="assumption",
                        node=mention.label,
                        hint="Declare each of them in the scene if they are to be planned for one by one.",
                    )

    def _is_used(self, description: str) -> bool:
        """Whether the description says that somebody is lost, or names a hazard."""
        lows = description.lower().split()
        return lows[0] in self.lexicon.words["lost"] or bool(self.lexicon.hazard_words.within(lows))

    @staticmethod
    def _implied_by(mention: Mention, used: set[str]) -> bool:
        return any(name.endswith(f" of {mention.label}") for name in used)

    def _no_verb(self, clause: Clause) -> Trouble:
        first = clause.words[0].low
        near = difflib.get_close_matches(
            first[:40], [phrase for phrase in self.lexicon.goals_of if " " not in phrase], n=2, cutoff=0.75
        )
        hint = f"Did you mean {' or '.join(map(repr, near))}? " if near else ""
        return _trouble(
            "verb_unknown",
            clause,
            "it does not begin with a verb that is known",
            f"{hint}Begin with what is to be done: 'Find ...', 'Bring ... to ...'.",
        )

    def _left_over(self, words: tuple[Word, ...]) -> str:
        """The words from the first that belongs to no noun phrase."""
        assert words
        verb = self.lexicon.verb_at([word.low for word in words], 0, "base")
        start = verb.length if verb else 1
        end = start
        while end < len(words) and self.phrases.phrases(words[start : end + 1]) is not None:
            end += 1
        for longer in range(min(len(words), end + 12), end, -1):
            if self.phrases.phrases(words[start:longer]) is not None:
                end = longer
                break
        return " ".join(word.text for word in words[end if end < len(words) else start :])


def _by_place(entry: tuple[str, Span]) -> Span:
    return entry[1]


def _routine_form(routine: Routine, verb: Verb, own: bool) -> Form:
    """The verb, then the arguments in order with prepositions between them."""
    form = [Element("word", word) for word in verb.phrase.split()]
    for number, argument in enumerate(routine.arguments):
        if number:
            form.append(Element("word", _ANY if own else _TO))
        form.append(Element("slot", argument.name))
    return tuple(form)


def _with_object(clause: Clause, following: Clause | None) -> Clause:
    """The clause, with the object of the one behind it if it shares that."""
    assert clause.verb is not None
    base = tuple(Word(part, part) for part in clause.verb.phrase.split())
    rest = clause.words[clause.verb.length :]
    if clause.relation == "shares" and following is not None and following.verb is not None and not rest:
        behind = following.words[following.verb.length :]
        end = next((place for place, word in enumerate(behind) if place and word.low in _TO.split("|")), len(behind))
        rest = behind[:end]
    return replace(clause, words=(*base, *rest))


def _plain_order(clause: Clause) -> tuple[Word, ...]:
    """The words with "back to" as "to", and "home" and "there" behind a "to"."""
    words: list[Word] = []
    assert clause.verb is not None
    for place, word in enumerate(clause.words):
        following = clause.words[place + 1].low if place + 1 < len(clause.words) else ""
        if place >= clause.verb.length and word.low in _PARTICLES and following in {*_PREPOSITIONS, "home", "there"}:
            continue
        before = words[-1].low if words else ""
        if word.low in {"home", "there"} and not following and place > clause.verb.length:
            object_her = before == "her" and place == clause.verb.length + 1
            if object_her or not (before in _PREPOSITIONS | _DETERMINERS or before.endswith("'s")):
                words.append(Word("to", "to"))
        words.append(word)
    return tuple(words)


def _shown(form: Form) -> str:
    return " ".join(
        {"slot": f"{{{e.text}}}", "goal": f"<{e.text}>", "doing": "<doing>"}.get(e.kind, e.text.split("|")[0])
        for e in form
    )


def _example(candidate: _Candidate, verb: Verb) -> str:
    """The pattern as somebody would say it."""
    if candidate.method is None:
        return _shown(candidate.form)
    return re.sub("<[^<>]*>", verb.phrase, candidate.method.says[0], count=1)


def _trouble(rule: str, clause: Clause, detail: str, hint: str = "") -> Trouble:
    message = f"{clause.text[:200]!r} is not understood: {detail}."
    way_out = "Reword it, set a model, or add a method (docs/how-to/write-a-method.md)."
    return Trouble(Reason(rule=rule, message=message, found=clause.text[:200], hint=f"{hint} {way_out}".strip()))
