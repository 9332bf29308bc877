"""
Patterns of what is said: ``<rescue> {victim} [from {site}]``.

``<goal>`` stands for any verb that asks for the same, ``{slot}`` for somebody or something, ``[...]`` for what may be left out,
``(a|b)`` for either, ``<doing>`` for any word in *-ing*; every other word stands for itself.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import pairwise, product
from typing import Literal

MAX_FORMS = 64
DOING = "doing"
_PART = re.compile(r"<([^<>]+)>|\{([a-z][a-z0-9_]*)\}|\(([^()\[\]]+)\)|\[([^\[\]]+)\]|([^\s<>{}()\[\]|]+)|(\S)")


@dataclass(frozen=True, slots=True)
class Element:
    """A goal, a slot, a word in -ing, or a word; words separated by ``|`` are equally good."""

    kind: Literal["goal", "slot", "doing", "word"]
    text: str


Form = tuple[Element, ...]


def forms_of(pattern: str) -> tuple[Form, ...]:
    """
    Everything a pattern may look like once choices are made, longest first.

    Raises
    ------
    ValueError
        If it is not a pattern, does not begin with a verb, or has more than 64 forms.
    """
    forms = tuple(dict.fromkeys(_expand(pattern)))
    for form in forms:
        if not form or form[0].kind not in {"goal", "word"}:
            raise ValueError(f"the pattern {pattern!r} does not begin with a verb, such as <bring> or 'bring'.")
        slots = [element.text for element in form if element.kind == "slot"]
        if len(slots) != len(set(slots)):
            raise ValueError(f"the pattern {pattern!r} has a slot twice.")
        if any(one.kind == other.kind == "slot" for one, other in pairwise(form)):
            raise ValueError(f"the pattern {pattern!r} has two slots with no word between them.")
    return tuple(sorted(forms, key=lambda form: -len(form)))


def _expand(pattern: str) -> list[Form]:
    choices: list[list[Form]] = []
    count = 1
    for goal, slot, either, optional, word, stray in _PART.findall(pattern):
        if stray:
            raise ValueError(f"the pattern {pattern!r} has a {stray!r} that is not closed or has no meaning.")
        if goal:
            choices.append([(Element("doing" if goal == DOING else "goal", goal.strip()),)])
        elif slot:
            choices.append([(Element("slot", slot),)])
        elif either:
            words = [part.strip().lower() for part in either.split("|")]
            plain = all(part.isalpha() and part != "and" for part in words) and any(
                e.kind != "word" for e in _first(choices)
            )
            # Behind a verb the nearest of the words decides where a slot ends.
            one: list[Form] = [(Element("word", "|".join(words)),)]
            choices.append(one if plain else [form for part in either.split("|") for form in _expand(part)])
        elif optional:
            choices.append([*_expand(optional), ()])
        else:
            choices.append([(Element("word", word.lower()),)])
        count *= len(choices[-1])
        if count > MAX_FORMS:
            raise ValueError(f"the pattern {pattern!r} has more than {MAX_FORMS} forms; write several patterns.")
    return [tuple(element for part in parts for element in part) for parts in product(*choices)]


def _first(choices: list[list[Form]]) -> Form:
    """The elements so far, with the first of each choice."""
    return tuple(element for forms in choices for element in (forms[0] if forms else ()))


def first_words(form: Form) -> str:
    """The plain words that a form begins with: a verb that the lexicon may not have."""
    words: list[str] = []
    for element in form:
        if element.kind != "word":
            break
        words.append(element.text)
    return " ".join(words)


def fixed_words(form: Form) -> int:
    """How many words of a form are not open: the more, the more it says."""
    return sum(element.kind in {"word", "goal"} for element in form)
