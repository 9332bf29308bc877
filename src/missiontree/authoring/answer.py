"""What every tree-building call answers: done or refused, and the state that the caller needs next."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from missiontree.authoring.nearly_able import nearly_able
from missiontree.mission.reason import Reason

_SHOWN = ("rule", "message", "hint")
# What helps people is a file to edit; what helps a model is a call to make.
_REPLACED = {
    "entity_introduced": "Introduce it with its kind by introduceEntity, if that is wrong.",
    "no_robot_able": "If no other routine serves the mission, call declareImpossible with what is missing.",
}
_ADDED = {"unknown_robot": "If the mission insists on it, call declareImpossible; put no other in its place."}


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer:
    """
    The answer to one call.

    Parameters
    ----------
    ok
        Whether the call applied. A call that did not has changed nothing.
    data
        State for the caller's next step: new ids, open leaves, offers. Plain JSON values.
    reasons
        Why the call was refused; empty if it was not.
    notices
        What was done on the caller's behalf (severity ``notice``) or taken for granted (severity ``assumption``).
    picture
        An SVG, from ``plotTree`` only. Kept apart from ``data`` since it is for people.
    """

    ok: bool
    data: Mapping[str, Any] = field(default_factory=dict)
    reasons: tuple[Reason, ...] = ()
    notices: tuple[Reason, ...] = ()
    picture: str = ""

    @property
    def text(self) -> str:
        """
        The answer as one JSON object, for models.

        JSON and not prose, so that a name out of the scene stands quoted and cannot pass for words of ours.
        """
        plain: dict[str, Any] = {"ok": self.ok}
        if self.reasons:
            plain["refused"] = _refused(self.reasons)
        if self.notices:
            plain["notices"] = [_shown(reason) for reason in self.notices]
        return json.dumps(plain | dict(self.data), ensure_ascii=False, separators=(",", ":"))


class RefusalError(Exception):
    """Leaves a call early; never leaves the tree-building functions, which turn it into an :class:`Answer`."""

    def __init__(self, *reasons: Reason) -> None:
        super().__init__(reasons[0].message)
        self.reasons = reasons


def refuse(rule: str, message: str, **more: str) -> RefusalError:
    """The refusal of that rule, ready to be raised."""
    return RefusalError(Reason(rule=rule, message=message, **more))  # type: ignore[arg-type]  # severity stays "error"


def _refused(reasons: tuple[Reason, ...]) -> list[dict[str, str]]:
    """
    Reasons of a refusal, those that a model can do something about first.

    A robot type that lacks a capability is out whatever else it lacks, so such types are named together, and last.
    """
    if not reasons:
        return []
    lacking: dict[str, dict[str, None]] = {}
    for reason in reasons[1:]:
        if reason.rule == "capability_missing" and reason.robot and reason.needed:
            lacking.setdefault(reason.needed, {})[reason.robot] = None
    out = {robot for robots in lacking.values() for robot in robots}
    near = [_shown(reason) for reason in reasons[1:] if reason.robot not in out]
    far = [
        {"rule": "capability_missing", "message": f"{', '.join(robots)}: no {needed}."}
        for needed, robots in lacking.items()
    ]
    return [_shown(reasons[0]), *_nearest(reasons), *near, *far]


def _nearest(reasons: tuple[Reason, ...]) -> list[dict[str, str]]:
    """Of a routine that nobody can do: which robot types lack one thing only, and what."""
    said = nearly_able(reasons[1:]) if reasons[0].rule == "no_robot_able" else ""
    return [{"rule": "nearly_able", "message": said}] if said else []


def _shown(reason: Reason) -> dict[str, str]:
    shown = {name: getattr(reason, name) for name in _SHOWN if getattr(reason, name)}
    if reason.hint and reason.rule in _REPLACED:
        shown["hint"] = _REPLACED[reason.rule]
    if reason.rule in _ADDED:
        shown["hint"] = f"{reason.hint} {_ADDED[reason.rule]}".strip()
    return shown
