"""The numbers of a reason: what there is, and what is needed."""

from __future__ import annotations

import re

from missiontree.mission.explanation import Shortfall
from missiontree.mission.reason import Reason

_NUMBER = r"(?:at most |at least )?(-?[0-9][0-9.,]*(?:e[+-]?[0-9]+)?)"
_AMOUNT = re.compile(rf"(?P<name>[A-Za-z][\w-]*) {_NUMBER}(?![\w.])")
_TIME = re.compile(rf"(?:by |from )?{_NUMBER} s\b")


def shortfall_of(reason: Reason) -> Shortfall | None:
    """What falls short, if the reason says it in numbers: ``payload_kg 4`` found and ``payload_kg 12`` needed."""
    has, needs = _AMOUNT.match(reason.found), _AMOUNT.match(reason.needed)
    if has is not None and needs is not None and has["name"] == needs["name"]:
        return Shortfall(quantity=has["name"], has=_number(has[2]), needs=_number(needs[2]))
    if reason.rule == "deadline_missed":
        ends, due = _TIME.match(reason.found), _TIME.match(reason.needed)
        if ends is not None and due is not None:
            return Shortfall(quantity="deadline_s", has=_number(due[1]), needs=_number(ends[1]))
    return None


def _number(text: str) -> float:
    return float(text.replace(",", ""))
