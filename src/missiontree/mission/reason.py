"""One value for every refusal and finding, wherever it arises."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.value import Id, Value

Severity = Literal["error", "warning", "notice", "assumption"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Reason(Value):
    """
    Why something was refused, found wrong, assumed or changed.

    Parameters
    ----------
    rule
        Code of the rule, such as ``capability_missing``; the reference lists them all.
    message
        The whole reason as one sentence a person can act on.
    severity
        ``error``: it cannot stand. ``warning``: it stands, but look at it. ``notice``: something was done on your behalf.
        ``assumption``: something unknown was taken for granted.
    node
        Id or name of the tree node, routine or entity concerned; empty if none.
    robot
        Id of the robot or robot type concerned; empty if none.
    found
        What there is: ``payload_kg 4``.
    needed
        What was needed: ``payload_kg 12``.
    hint
        What to do about it, or what would be accepted.
    """

    rule: Id
    message: str
    severity: Severity = "error"
    node: str = ""
    robot: str = ""
    found: str = ""
    needed: str = ""
    hint: str = ""
