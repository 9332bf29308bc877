"""What a mission shall achieve, stated formally: routines, methods and tasks by name, with no language in between."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal

from missiontree.mission.call import call_of
from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.times import check_times
from missiontree.mission.tree import Gate
from missiontree.mission.value import Id, NonNegative, Positive, Value, require_unique

Bond = Literal["after", "until", "same_robot", "different_robot", "takes_over_from"]
WAITS: tuple[Bond, ...] = ("after", "until", "takes_over_from")
"""Of those, which are about when."""
APART: tuple[Bond, ...] = ("different_robot", "takes_over_from")
"""And which keep robots apart."""
_NO_NAME = frozenset("()[]{};")


@dataclass(frozen=True, slots=True, kw_only=True)
class Goal(Value):
    """
    A goal: a routine, a mission method, or a task with goals of its own. It has one of ``do``, ``method`` and ``task``.

    Parameters
    ----------
    do
        A routine and whom or what it is about, in order, by id or label: ``ReachAndTransport(keys, Anna)``.
    method
        Id of a mission method, built in or of the user's own.
    slots
        What the slots of the method are filled with, by id or label: ``{victim: Anna, site: barn}``; a list fills one with several.
    task
        Label of a task.
    goals
        What the task consists of.
    gate
        ``and``: all goals of the task; ``xor``: exactly one of them.
    name
        What other goals call this one.
    after
        Names of the goals that end before this one starts.
    until
        Name of the goal whose end also ends what is open-ended in this one.
    same_robot
        Names of goals that are done by one robot together with this one: it fills every role of all of them.
    different_robot
        Names of goals of which no robot does anything that does anything of this one.
    takes_over_from
        Name of the goal whose last action ends when and where the first action of this one starts, by another robot: a hand-over.
    by
        Robot types that may do it; default: all.
    not_by
        Robot types that may not.
    release_s
        Nothing of the goal starts earlier; seconds from the mission's start, at least 0. Default 0. A robot may be on its way before.
    deadline_s
        All of the goal has ended by then; seconds from the mission's start, at least 0. None (default) means no deadline.
    weight
        How much the goal counts where not all of the mission can be done, above 0; for routines and tasks only. Default: see
        :class:`missiontree.mission.partial.Partial`.
    """

    do: str = ""
    method: Id | None = None
    slots: Mapping[Id, str | tuple[str, ...]] = field(default_factory=dict)
    task: str = ""
    goals: tuple[Goal, ...] = ()
    gate: Gate = "and"
    name: str = ""
    after: tuple[str, ...] = ()
    until: str = ""
    same_robot: tuple[str, ...] = ()
    different_robot: tuple[str, ...] = ()
    takes_over_from: str = ""
    by: tuple[Id, ...] | None = None
    not_by: tuple[Id, ...] = ()
    release_s: NonNegative = 0.0
    deadline_s: NonNegative | None = None
    weight: Positive | None = None

    def _check(self) -> None:
        self._freeze_slots()
        check_times(f"the goal {self.shown!r}", self.release_s, self.deadline_s)
        if sum(map(bool, (self.do, self.method, self.task))) != 1:
            raise ValueError("a goal has one of do (a routine), method (a mission method) and task (with goals).")
        if self.do:
            self._check_call()
        if self.task and not self.goals:
            raise ValueError(f"the task {self.task!r} has no goals.")
        if not self.task and (self.goals or self.gate != "and"):
            raise ValueError(f"the goal {self.shown!r} is no task; goals and gate belong to tasks.")
        if self.method and self.weight is not None:
            raise ValueError(
                f"the goal {self.shown!r} names a method, and has no weight of its own; weigh what it leads to by 'parts' of the mission."
            )
        if not self.method and self.slots:
            raise ValueError(f"the goal {self.shown!r} names no method; slots belong to methods.")
        for slot in self.slots:
            if not self.filling(slot) or not all(name.strip() for name in self.filling(slot)):
                raise ValueError(f"the slot {slot!r} is filled with nothing; leave it out.")
        if self.by is not None and not self.by:
            raise ValueError(f"the goal {self.shown!r} allows no robot type by 'by'; leave it out to allow all.")
        if both := [kind for kind in self.by or () if kind in self.not_by]:
            raise ValueError(f"the goal {self.shown!r} is for robot type {both[0]!r} by 'by' and not by 'not_by'.")

    def _freeze_slots(self) -> None:
        """Text stays text; a list of texts becomes a tuple, so that the value can be hashed."""
        frozen = {
            slot: given if isinstance(given, str) else tuple(given) if isinstance(given, list | tuple) else given
            for slot, given in self.slots.items()
        }
        for slot, given in frozen.items():
            if not all(isinstance(name, str) for name in (given if isinstance(given, tuple) else (given,))):
                raise ValueError(f"slots.{slot} must be text or a list of texts, got {given!r}.")
        object.__setattr__(self, "slots", FrozenMap(frozen))

    def _check_call(self) -> None:
        call = call_of(self.do)
        if call is None or not all(call.arguments):
            raise ValueError(f"{self.do!r} is not of the form Routine(entity) or Routine(entity, entity).")
        for name in call.arguments:
            if strange := next((sign for sign in name if sign in _NO_NAME), ""):
                raise ValueError(
                    f"{self.do!r} names {name!r}, and a name in a goal has no {strange!r}; write one routine for each goal, "
                    f"and whoever is called so by id."
                )

    @property
    def routine(self) -> str:
        """Id of the routine; empty if the goal is none."""
        call = call_of(self.do)
        return call.routine if call else ""

    @property
    def arguments(self) -> tuple[str, ...]:
        """Whom or what the routine is about, in order."""
        call = call_of(self.do)
        return call.arguments if call else ()

    def filling(self, slot: str) -> tuple[str, ...]:
        """What a slot is filled with."""
        given = self.slots[slot]
        return (given,) if isinstance(given, str) else tuple(given)

    @property
    def entities(self) -> tuple[str, ...]:
        """Everybody and everything that the goal itself names."""
        return (*self.arguments, *(name for slot in self.slots for name in self.filling(slot)))

    @property
    def bonds(self) -> tuple[tuple[Bond, str], ...]:
        """All goals that this one refers to: by which field, and their names."""
        fields: tuple[tuple[Bond, Iterable[str]], ...] = (
            ("after", self.after),
            ("until", filter(None, (self.until,))),
            ("same_robot", self.same_robot),
            ("different_robot", self.different_robot),
            ("takes_over_from", filter(None, (self.takes_over_from,))),
        )
        return tuple((bond, name) for bond, names in fields for name in names)

    @property
    def shown(self) -> str:
        """The goal in a few words: ``Search(keys)``, ``rescue(victim = Anna)``, or the label of its task."""
        slots = ", ".join(f"{slot} = {' and '.join(self.filling(slot))}" for slot in self.slots)
        return self.do or self.task or f"{self.method}({slots})"

    def below(self) -> Iterator[Goal]:
        """The goal and all goals of its task."""
        waiting = [self]
        while waiting:
            goal = waiting.pop()
            yield goal
            waiting.extend(reversed(goal.goals))


def all_goals(goals: Iterable[Goal]) -> Iterator[Goal]:
    """The goals and those of their tasks, in the order in which they are written."""
    for goal in goals:
        yield from goal.below()


def in_words(goals: Iterable[Goal]) -> str:
    """What the goals ask for, in one line."""
    return "; ".join(goal.shown for goal in goals)


def check_goals(goals: tuple[Goal, ...]) -> None:
    """
    Refuse goals that refer to each other in vain.

    Raises
    ------
    ValueError
        If a name stands twice, nothing answers to a name, a goal waits for one that it is part of, or goals wait for each other.
    """
    every = tuple(all_goals(goals))
    named = {goal.name: goal for goal in every if goal.name}
    require_unique("goal", tuple(goal.name for goal in every if goal.name))
    for goal in every:
        for bond, name in goal.bonds:
            if name not in named:
                known = ", ".join(named) or "none"
                raise ValueError(f"the goal {goal.shown!r} refers to goal {name!r}; named goals are: {known}.")
            if _holds(goal, named[name]) or _holds(named[name], goal):
                why = "wait for" if bond in WAITS else f"name, by {bond},"
                related = "that is the same goal" if goal is named[name] else "one is part of the other"
                raise ValueError(f"the goal {goal.shown!r} cannot {why} {name!r}; {related}.")
    _refuse_opposed(every)
    _refuse_circle(every)


def _refuse_opposed(goals: Iterable[Goal]) -> None:
    """One robot and different ones for the same two goals; a hand-over is between different ones."""
    named = {goal.name: place for place, goal in enumerate(goals) if goal.name}
    bound = {frozenset((place, named[name])) for place, goal in enumerate(goals) for name in goal.same_robot}
    for place, goal in enumerate(goals):
        for bond, name in goal.bonds:
            if bond in APART and frozenset((place, named[name])) in bound:
                raise ValueError(
                    f"the goal {goal.shown!r} names {name!r} by {bond}, and one robot is to do both by same_robot; take one of them away."
                )


def _holds(outer: Goal, inner: Goal) -> bool:
    return any(goal is inner for goal in outer.below())


def _refuse_circle(goals: tuple[Goal, ...]) -> None:
    """Take away, again and again, what waits for nothing that is left; what never goes waits for itself."""
    waits = {
        goal.name: {name for bond, name in goal.bonds if bond in ("after", "takes_over_from")}
        for goal in goals
        if goal.name
    }
    while free := [name for name, others in waits.items() if not others & waits.keys()]:
        for name in free:
            del waits[name]
    if not waits:
        return
    circle = [next(iter(waits))]
    while circle.count(circle[-1]) == 1:
        circle.append(min(waits[circle[-1]] & waits.keys()))
    circle = circle[circle.index(circle[-1]) :]
    raise ValueError(f"the order of the goals is a circle: {' after '.join(map(repr, circle))}.")
