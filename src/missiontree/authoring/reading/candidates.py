"""The ways in which a clause may be understood: patterns of methods, and the verbs of routines."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from missiontree.authoring.language.lexicon import Lexicon, Verb
from missiontree.authoring.methods.method import Method, MethodLibrary, built_in_methods
from missiontree.authoring.reading.wording import ANY, ANY_BUT_WITH, TO
from missiontree.mission.pattern import Element, Form, fixed_words
from missiontree.mission.routine import Routine, RoutineLibrary
from missiontree.routines.library import built_in

# Who fills a thing says with what, and not where.
_FILLING = frozenset({"load", "fill", "pack", "supply", "provide", "stock", "equip", "cover", "stuff", "refill", "fit"})
_OWN_METHOD, _OWN_ROUTINE, _METHOD, _ROUTINE, _SAME_GOAL = range(5)


@dataclass(frozen=True, slots=True)
class Candidate:
    """A way of understanding a clause; smaller ranks are tried first."""

    rank: tuple[int, int, int]
    form: Form
    method: Method | None = None
    routine: Routine | None = None

    @property
    def is_own(self) -> bool:
        """Whether the user wrote it."""
        return self.rank[0] in {_OWN_METHOD, _OWN_ROUTINE}

    @property
    def source(self) -> str:
        """What matched, for the reading."""
        return f"method {self.method.id}" if self.method else f"routine {self.routine.id}" if self.routine else ""

    @property
    def shown(self) -> str:
        """The form as it is written in a method."""
        brackets = {"slot": "{{{}}}", "goal": "<{}>", "doing": "<doing>"}
        return " ".join(brackets.get(e.kind, "{}").format(e.text.split("|")[0]) for e in self.form)

    def example(self, verb: Verb) -> str:
        """The pattern as somebody would say it."""
        return self.shown if self.method is None else re.sub("<[^<>]*>", verb.phrase, self.method.says[0], count=1)


def candidates(verb: Verb, methods: MethodLibrary, routines: RoutineLibrary, lexicon: Lexicon) -> list[Candidate]:
    """All that begin with a verb, in the order in which they are tried: the user's own first, then those that say more."""
    found = [*_of_methods(verb, methods, lexicon), *_of_routines(verb, routines, lexicon)]
    return sorted(found, key=lambda candidate: candidate.rank)


def _of_methods(verb: Verb, library: MethodLibrary, lexicon: Lexicon) -> Iterator[Candidate]:
    shipped = {method.id: method for method in built_in_methods().methods}
    for order, method in enumerate(library.methods):
        tier = _METHOD if shipped.get(method.id) == method else _OWN_METHOD
        for form in (form for forms in method.forms for form in forms):
            if _begins(form, verb, lexicon):
                yield Candidate((tier, -fixed_words(form), order), form, method=method)


def _of_routines(verb: Verb, library: RoutineLibrary, lexicon: Lexicon) -> Iterator[Candidate]:
    ours = built_in().by_id
    goals = set(lexicon.goals_of.get(verb.phrase, ()))
    for order, routine in enumerate(library.routines):
        own = ours.get(routine.id) != routine
        verbs = [known.lower() for known in routine.verbs]
        tier = _OWN_ROUTINE if own else _ROUTINE
        for form in (form for forms in routine.forms for form in forms if _begins(form, verb, lexicon)):
            yield Candidate((tier, -fixed_words(form) - len(routine.arguments), order), form, routine=routine)
        exact = verb.phrase in verbs
        if exact or (not own and any(goals & set(lexicon.goals_of.get(known, ())) for known in verbs)):
            tier = tier if exact else _SAME_GOAL
            yield Candidate((tier, -len(routine.arguments), order), _form(routine, verb, own=own), routine=routine)


def _begins(form: Form, verb: Verb, lexicon: Lexicon) -> bool:
    if form[0].kind == "goal":
        return verb.phrase in lexicon.phrases_of.get(form[0].text, ())
    return form[0].text == verb.phrase.split()[0]


def _form(routine: Routine, verb: Verb, *, own: bool) -> Form:
    """The verb, then the arguments in order with prepositions between them."""
    form = [Element("word", word) for word in verb.phrase.split()]
    for number, argument in enumerate(routine.arguments):
        if number:
            form.append(Element("word", (ANY_BUT_WITH if verb.phrase.split()[0] in _FILLING else ANY) if own else TO))
        form.append(Element("slot", argument.name))
    return tuple(form)
