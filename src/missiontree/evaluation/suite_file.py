"""What a file of a suite holds: the missions of one setting, and what each of them should become."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from missiontree.evaluation.expected import Expected, PlanEntry
from missiontree.mission.value import Id, Value, require_unique

Decline = Literal["impossible", "unclear"]


@dataclass(frozen=True, kw_only=True)
class SuiteMission(Value):
    """
    A mission in words, and what is right for it: plans, or to decline it.

    Parameters
    ----------
    id
        Name, unique in the suite.
    say
        The mission in words.
    plan
        Entries of the right plan: calls such as ``Reach(Anna) by social_robot``, ``{xor: [...]}``, and within it ``{and: [...]}``.
    order
        Relations between the calls of the plan, numbered from 1: ``1 < 2`` ends before, ``1 ~ 2`` lasts until.
    accept
        Further plans that are just as right.
    declined
        ``impossible``: it is understood, and no routine or no robot can do it. ``unclear``: it is not clear what is asked for, or a
        tree cannot hold it. Either this or ``plan``.
    because
        What is missing, or the words that cannot be kept; needed if it is to be declined.
    note
        Why, where a reader may wonder.
    """

    id: Id
    say: str
    plan: tuple[PlanEntry, ...] = ()
    order: tuple[str, ...] = ()
    accept: tuple[Expected, ...] = ()
    declined: Decline | None = None
    because: str = ""
    note: str = ""

    def _check(self) -> None:
        if not self.say.strip():
            raise ValueError(f"mission {self.id!r} has no words.")
        if bool(self.plan) == (self.declined is not None):
            raise ValueError(
                f"mission {self.id!r} has either a plan or declined; it has {'both' if self.plan else 'neither'}."
            )
        if self.declined is not None and (self.order or self.accept):
            raise ValueError(f"mission {self.id!r} is to be declined; order and accept belong to a plan.")
        if (self.declined is not None) != bool(self.because.strip()):
            raise ValueError(f"mission {self.id!r} needs because exactly if it is to be declined.")
        if self.plan:
            main = Expected(plan=self.plan, order=self.order)
            object.__setattr__(self, "plan", main.plan)
            if len(set(self.expected)) < len(self.expected):
                raise ValueError(f"mission {self.id!r} accepts a plan that it has already.")

    @cached_property
    def expected(self) -> tuple[Expected, ...]:
        """The right plans, the first as written under ``plan``; none if the mission is to be declined."""
        return (Expected(plan=self.plan, order=self.order), *self.accept) if self.plan else ()


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
