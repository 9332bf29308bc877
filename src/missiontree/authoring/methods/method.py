"""
Mission methods: what is said, and the tree-building steps that follow from it. Data, as in HTN planning (Erol, Hendler and Nau 1994).

A method never names what a mission is about; it has slots for that.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib import resources
from pathlib import Path
from typing import Literal

from missiontree.errors import InputError
from missiontree.formats.document import read_as
from missiontree.formats.source import load_text
from missiontree.mission.call import call_of
from missiontree.mission.pattern import Form, forms_of
from missiontree.mission.scene import BASE_KINDS
from missiontree.mission.value import Id, Value, require_unique

RESPONDER = "responder"
CONDITIONS = (*BASE_KINDS, "lost", "hazard", "vessel", "topic")
BUILT_IN_FILES = ("bringing", "finding", "helping", "reaching", "rescuing")
_SLOT = re.compile(r"[a-z][a-z0-9_]*")
_FIELD = re.compile(r"\{(?:the )?(?:full )?([^{}]*)\}")


@dataclass(frozen=True, slots=True, kw_only=True)
class Implied(Value):
    """
    Somebody or something that a method needs and that nobody mentions, such as a safe place.

    Parameters
    ----------
    name
        What it is called if it has to be introduced; ``{slot}`` stands for what a slot is filled with.
    kind
        Its kind.
    known_as
        Names under which the scene may have it already.
    """

    name: str
    kind: Literal["person", "animal", "object", "place"]
    known_as: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Step(Value):
    """
    A part of the tree that a method builds: a routine, or a task with steps of its own.

    Parameters
    ----------
    do
        A routine and its arguments in order, by slot: ``ReachAndTransport(lost, keeper)``. Either this or ``task``.
    task
        Label of a task; ``{lost}``, ``{the lost}``, ``{full lost}`` and ``{the full lost}`` stand for what is in a slot.
    steps
        What the task consists of.
    gate
        ``and``: all steps of the task; ``xor``: exactly one of them.
    name
        What other steps of the method call this one.
    after
        Names of the steps that end before this one starts.
    until
        Name of the step whose end also ends what is open-ended in this one.
    unless_known
        A slot: the step is left out if the scene knows where that is and the words do not say that it is lost.
    by
        Robot types that may do it, and what it consists of; default: all.
    capability
        Only robot types that have this capability may do it, and what it consists of.
    """

    do: str = ""
    task: str = ""
    steps: tuple[Step, ...] = ()
    gate: Literal["and", "xor"] = "and"
    name: str = ""
    after: tuple[str, ...] = ()
    until: str = ""
    unless_known: str = ""
    by: tuple[Id, ...] = ()
    capability: str = ""

    def _check(self) -> None:
        if bool(self.do) == bool(self.task):
            raise ValueError("a step has either do (a routine) or task (a label with steps).")
        if self.do and (self.steps or self.gate != "and"):
            raise ValueError(f"the step {self.do!r} is a routine; steps and gate belong to tasks.")
        if self.task and not self.steps:
            raise ValueError(f"the task {self.task!r} has no steps.")
        call = call_of(self.do)
        if self.do and (call is None or not all(map(_SLOT.fullmatch, call.arguments))):
            raise ValueError(f"{self.do!r} is not of the form Routine(slot) or Routine(slot, slot).")

    @property
    def routine(self) -> str:
        """Id of the routine."""
        call = call_of(self.do)
        return call.routine if call else ""

    @property
    def arguments(self) -> tuple[str, ...]:
        """Slots, in the order of the routine's arguments."""
        call = call_of(self.do)
        return call.arguments if call else ()

    @property
    def mentions(self) -> tuple[str, ...]:
        """Slots that the step itself speaks of."""
        spare = (self.unless_known,) if self.unless_known else ()
        return (*self.arguments, *_FIELD.findall(self.task), *spare)

    def below(self) -> Iterator[Step]:
        """The step and all steps of its task."""
        open_steps = [self]
        while open_steps:
            step = open_steps.pop()
            yield step
            open_steps.extend(reversed(step.steps))


@dataclass(frozen=True, kw_only=True)
class Method(Value):
    """
    How a mission that is worded in a certain way is done.

    Parameters
    ----------
    id
        Name; the reading says which method matched.
    purpose
        What it is for, one sentence.
    says
        Patterns, see :mod:`~missiontree.mission.pattern`.
    where
        What must hold of a slot, by its name, any of: ``person``, ``animal``, ``object``, ``place``, ``lost``, ``hazard``,
        ``vessel`` (a thing that people are in, such as a ship or a tent), ``topic`` (what is only spoken of: it need not be in the scene,
        and no step does anything with it).
    implies
        What the method needs and nobody mentions, by the name that steps use. ``responder`` is always there: those who are
        called for the hazards that the words name, maybe nobody; a step that speaks of nobody is left out.
    steps
        What is built below the objective; all of it is done.
    assumes
        What the method takes for granted, a sentence that the plan states as an assumption; ``{slot}`` as in a task.
    """

    id: Id
    purpose: str
    says: tuple[str, ...]
    where: Mapping[Id, tuple[str, ...]] = field(default_factory=dict)
    implies: Mapping[Id, Implied] = field(default_factory=dict)
    steps: tuple[Step, ...]
    assumes: str = ""

    def _check(self) -> None:
        if not self.says or not self.steps:
            raise ValueError(f"method {self.id!r} needs patterns (says) and steps.")
        slots = self._slots()
        spoken = [name for step in self.all_steps for name in step.mentions]
        spoken += _FIELD.findall(self.assumes)
        spoken += [name for implied in self.implies.values() for name in _FIELD.findall(implied.name)]
        for name in spoken:
            if name not in slots and name not in self.implies and name != RESPONDER:
                raise ValueError(
                    f"method {self.id!r} speaks of {name!r}, which is no slot of all its patterns: {', '.join(sorted(slots)) or 'none'}."
                )
        for slot, conditions in self.where.items():
            if slot not in self._slots(set.union):
                raise ValueError(
                    f"method {self.id!r} has a condition on {slot!r}, which is a slot of none of its patterns."
                )
            for condition in conditions:
                if condition not in CONDITIONS:
                    raise ValueError(
                        f"method {self.id!r} has the condition {condition!r}; there are {', '.join(CONDITIONS)}."
                    )
        names = tuple(step.name for step in self.all_steps if step.name)
        require_unique("step", names)
        for step in self.all_steps:
            for name in (*step.after, *((step.until,) if step.until else ())):
                if name not in names:
                    raise ValueError(
                        f"method {self.id!r} refers to step {name!r}; named steps are: {', '.join(names) or 'none'}."
                    )

    def _slots(self, merge: Callable[..., set[str]] = set.intersection) -> set[str]:
        """Slots that every form of every pattern has; with ``set.union``, those that any has."""
        return merge(
            *({element.text for element in form if element.kind == "slot"} for forms in self.forms for form in forms)
        )

    @cached_property
    def forms(self) -> tuple[tuple[Form, ...], ...]:
        """The forms of each pattern."""
        return tuple(forms_of(pattern) for pattern in self.says)

    @property
    def all_steps(self) -> tuple[Step, ...]:
        """All steps, tasks before what they consist of."""
        return tuple(step for top in self.steps for step in top.below())


@dataclass(frozen=True, kw_only=True)
class MethodFile(Value):
    """
    Methods of one file.

    Parameters
    ----------
    methods
        At least one.
    """

    methods: tuple[Method, ...]

    def _check(self) -> None:
        if not self.methods:
            raise ValueError("a file of methods needs at least one method.")


@dataclass(frozen=True, kw_only=True)
class MethodLibrary(Value):
    """
    The methods on offer, those of the user first: of two that match equally well, the first is taken.

    Parameters
    ----------
    methods
        Methods; ids are unique.
    """

    methods: tuple[Method, ...]

    def _check(self) -> None:
        require_unique("method", tuple(method.id for method in self.methods))


@cache
def built_in_methods() -> MethodLibrary:
    """The methods that ship with missiontree."""
    folder = resources.files("missiontree.authoring") / "methods" / "library"
    texts = ((f"{name}.yaml", (folder / f"{name}.yaml").read_text(encoding="utf-8")) for name in BUILT_IN_FILES)
    return MethodLibrary(
        methods=tuple(method for source, text in texts for method in read_methods(text, source).methods)
    )


def load_methods(paths: Iterable[Path | str] = ()) -> MethodLibrary:
    """
    The methods of the user's files, then the built-in ones. A method of the user replaces a built-in one of the same id.

    Parameters
    ----------
    paths
        YAML or JSON files of methods.

    Raises
    ------
    InputError
        If a file cannot be read or is no file of methods, with file and line.
    """
    own: dict[str, tuple[Method, str]] = {}
    for path in map(str, paths):
        for method in read_methods(load_text(Path(path)), path).methods:
            if method.id in own:
                raise InputError(
                    f"method {method.id!r} stands twice",
                    file=path,
                    where=method.id,
                    hint=f"{own[method.id][1]} has it too.",
                )
            own[method.id] = (method, path)
    kept = tuple(method for method in built_in_methods().methods if method.id not in own)
    return MethodLibrary(methods=(*(method for method, _ in own.values()), *kept))


def read_methods(text: str, source: str) -> MethodFile:
    """
    The methods of a text in YAML or JSON.

    Raises
    ------
    InputError
        With the line of what is wrong.
    """
    return read_as(text, "methods", MethodFile, source)
