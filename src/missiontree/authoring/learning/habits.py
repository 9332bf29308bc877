"""What methods with the same goal do that a single tree does not show: whom they call for a hazard, and what a robot must be able to do."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.methods.method import RESPONDER, Method, MethodLibrary, built_in_methods
from missiontree.mission.pattern import Form, forms_of
from missiontree.routines.library import built_in


@dataclass(frozen=True, slots=True)
class Habits:
    """
    What methods with the goal of a pattern do.

    Parameters
    ----------
    calls
        Whether they call somebody for the hazards that are named.
    capabilities
        What they ask of robot types.
    """

    calls: bool = False
    capabilities: tuple[str, ...] = ()


def habits_of(pattern: str, methods: MethodLibrary, lexicon: Lexicon) -> Habits:
    """What the methods do that may be meant by the same words as a pattern, its slots aside."""
    form = forms_of(pattern)[0]
    alike = [method for method in methods.methods if any(_is_like(form, other, lexicon) for other in _forms(method))]
    steps = [step for method in alike for step in method.all_steps]
    return Habits(
        calls=any(RESPONDER in step.mentions for step in steps),
        capabilities=tuple(dict.fromkeys(step.capability for step in steps if step.capability)),
    )


@cache
def served_goals() -> frozenset[str]:
    """The goals that built-in methods and routines serve: the verbs of each ask for the same, whatever it is done with."""
    lexicon = Lexicon()
    verbs = (verb.lower() for routine in built_in().routines for verb in routine.verbs)
    of_routines = {goal for verb in verbs for goal in lexicon.goals_of.get(verb, ())}
    forms = (form for method in built_in_methods().methods for form in _forms(method))
    return frozenset(of_routines | {form[0].text for form in forms if form[0].kind == "goal"})


def _forms(method: Method) -> Iterator[Form]:
    return (form for forms in method.forms for form in forms)


def _is_like(form: Form, other: Form, lexicon: Lexicon) -> bool:
    """Whether another form has the goal of a form, and no words of its own that the form lacks."""
    words = {word for element in form if element.kind == "word" for word in element.text.split("|")}
    fixed = (set(element.text.split("|")) for element in other[1:] if element.kind == "word")
    return other[0].kind == "goal" and other[0].text in _goals(form, lexicon) and all(words & each for each in fixed)


def _goals(form: Form, lexicon: Lexicon) -> tuple[str, ...]:
    if form[0].kind == "goal":
        return (form[0].text,)
    words = [element.text.split("|")[0] if element.kind == "word" else "" for element in form]
    verb = lexicon.verb_at(words, 0, "base")
    return lexicon.goals_of.get(verb.phrase, ()) if verb is not None else ()
