"""What a file of a suite holds: the missions of one setting, and what each of them should become."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from missiontree.evaluation.expected import Expected, PlanEntry
from missiontree.evaluation.loose import Loose
from missiontree.mission.value import Id, Value, require_unique

Decline = Literal["impossible", "unclear"]
WholeOutcome = Literal["delivered", "cannot_be_done"]


@dataclass(frozen=True, kw_only=True)
class SuiteMission(Value):
    """
    A mission in words, and what is right for it: plans, what every right plan has, or to decline it.

    Parameters
    ----------
    id
        Name, unique in the suite.
    say
        The mission in words.
    fleet, scene
        Paths of a fleet and a scene for this mission alone; default: the setting's.
    plan
        Entries of the right plan: calls such as ``Reach(Anna) by social_robot``, ``{xor: [...]}``, and within it ``{and: [...]}``.
    must
        Calls, each of which a right plan has; ``*`` for an argument means anything. With ``must_not`` and ``entities`` instead of ``plan``.
    must_not
        Calls that a right plan does not have.
    order
        Relations between the calls of ``plan`` or ``must``, numbered from 1: ``1 < 2`` ends before, ``1 ~ 2`` lasts until.
    entities
        Names of whom and what some routine is about.
    accept
        Further plans that are just as right as ``plan``.
    outcome
        What planning the right tree to its end comes to: ``delivered``, the default, or ``cannot_be_done``.
    declined
        ``impossible``: it is understood, and no routine or no robot can do it. ``unclear``: it is not clear what is asked for, or a
        tree cannot hold it. Instead of a plan or expectations.
    because
        What is missing, or the words that cannot be kept; needed if it is to be declined. ``|`` parts words of which any will do.
    twin
        Id of the mission that is possible and differs in one thing from this one, which is impossible.
    removed
        What was taken from the twin, in words.
    note
        Why, where a reader may wonder.
    """

    id: Id
    say: str
    fleet: str | None = None
    scene: str | None = None
    plan: tuple[PlanEntry, ...] = ()
    must: tuple[str, ...] = ()
    must_not: tuple[str, ...] = ()
    order: tuple[str, ...] = ()
    entities: tuple[str, ...] = ()
    accept: tuple[Expected, ...] = ()
    outcome: WholeOutcome | None = None
    declined: Decline | None = None
    because: str = ""
    twin: Id | None = None
    removed: str = ""
    note: str = ""

    def _check(self) -> None:
        if not self.say.strip():
            raise ValueError(f"mission {self.id!r} has no words.")
        self._check_one_expectation()
        if self.declined is not None and (self.order or self.accept or self.outcome):
            raise ValueError(f"mission {self.id!r} is to be declined; order, accept and outcome belong to a plan.")
        if (self.declined is not None) != bool(self.because.strip()):
            raise ValueError(f"mission {self.id!r} needs because exactly if it is to be declined.")
        if self.declined is not None and not all(words.strip() for words in self.because.split("|")):
            raise ValueError(f"mission {self.id!r} has nothing on one side of a '|' in because.")
        if (self.twin is not None or self.removed) and self.declined != "impossible":
            raise ValueError(f"mission {self.id!r} is possible; twin and removed belong to an impossible one.")
        if self.twin == self.id or bool(self.removed.strip()) != (self.twin is not None):
            raise ValueError(f"mission {self.id!r} needs the id of another mission as its twin, and what was removed.")
        if self.plan:
            main = Expected(plan=self.plan, order=self.order)
            object.__setattr__(self, "plan", main.plan)
            if len(set(self.expected)) < len(self.expected):
                raise ValueError(f"mission {self.id!r} accepts a plan that it has already.")

    def _check_one_expectation(self) -> None:
        loosely = bool(self.must or self.must_not or self.entities)
        ways = {"plan": bool(self.plan), "must": loosely, "declined": self.declined is not None}
        given = [name for name, is_given in ways.items() if is_given]
        if len(given) != 1:
            raise ValueError(
                f"mission {self.id!r} needs one of plan, must and declined; it has {' and '.join(given) or 'none'}."
            )
        if loosely:
            if self.accept:
                raise ValueError(f"mission {self.id!r} has must; accept belongs to a plan.")
            assert self.loose is not None

    @cached_property
    def expected(self) -> tuple[Expected, ...]:
        """The right plans, the first as written under ``plan``; none if there is no plan."""
        return (Expected(plan=self.plan, order=self.order), *self.accept) if self.plan else ()

    @cached_property
    def loose(self) -> Loose | None:
        """What every right plan has; None if a plan is written out or the mission is to be declined."""
        if not (self.must or self.must_not or self.entities):
            return None
        return Loose(must=self.must, must_not=self.must_not, order=self.order, entities=self.entities)

    @property
    def wanted(self) -> tuple[str, ...]:
        """What is right, in words, each line one way of being right."""
        if self.declined is not None:
            return (f"declined as {self.declined}, because of {self.because!r}",)
        return tuple(map(str, self.expected)) if self.loose is None else (str(self.loose),)


@dataclass(frozen=True, kw_only=True)
class SuiteFile(Value):
    """
    The missions of one setting. Paths are relative to the file.

    Parameters
    ----------
    setting
        Name of the setting, unique in the suite.
    scene
        Path of the scene; default: none.
    fleet
        Path of the fleet; default: the paper's sample fleet.
    routines
        Paths of files with routines beside the built-in ones.
    missions
        At least one.
    """

    setting: Id
    scene: str | None = None
    fleet: str | None = None
    routines: tuple[str, ...] = ()
    missions: tuple[SuiteMission, ...]

    def _check(self) -> None:
        if not self.missions:
            raise ValueError("a file of a suite needs at least one mission.")
        require_unique("mission", tuple(mission.id for mission in self.missions))
