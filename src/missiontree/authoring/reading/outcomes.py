"""What the reading of a clause came to."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.authoring.methods.outline import Outline
from missiontree.authoring.reading.clause import Clause
from missiontree.mission.reason import Reason


@dataclass(frozen=True, slots=True)
class Trouble:
    """A clause that is not understood, and why."""

    reason: Reason


@dataclass(frozen=True, slots=True)
class Unserved:
    """A clause that is understood, but asks for what no routine does, or for a capability that no robot type has."""

    goal: str
    verb: str
    robots_lack: bool = False


@dataclass(frozen=True, slots=True)
class Goal:
    """A clause that is understood: what is to be built (nothing for a statement), how it was read, what was taken for granted.

    ``slots`` is the number of arguments that its words fill; ``returns`` tells that something is brought back,
    ``standing`` are the robot types that the mission allows for anything that is added (none: all),
    ``wished`` tells that somebody needs it, which a later clause may ask for in full.
    """

    clause: Clause
    outline: Outline
    reading: str
    assumptions: tuple[Reason, ...] = ()
    slots: int = 0
    wished: bool = False
    standing: tuple[str, ...] = ()
    returns: bool = False


def trouble(rule: str, clause: Clause, detail: str, hint: str = "") -> Trouble:
    """A clause that is not understood, in words."""
    message = f"{clause.text[:200]!r} is not understood: {detail}."
    way_out = "Reword it, set a model, or add a method (docs/how-to/write-a-method.md)."
    return Trouble(Reason(rule=rule, message=message, found=clause.text[:200], hint=f"{hint} {way_out}".strip()))
