"""Who comes nearest to a routine that no robot can do: robot types that lack one thing only."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.mission.reason import Reason

MOST_TYPES = 4
_NOT_LACKING = frozenset({"left_out", "resource_excluded", "kind_refused", "no_robot_able"})


def nearly_able(refused: Sequence[Reason]) -> str:
    """
    One sentence on the robot types that lack one thing only, whatever the way of doing it; empty if there is none.

    A number that falls short comes before a capability that is missing. What is said is what would have to change for a repair, or what
    to name as missing; that it is enough is not said, since other roles of the same way may be unfilled.
    """
    lacking: dict[str, list[Reason]] = {}
    for reason in refused:
        if reason.robot and reason.needed and reason.rule not in _NOT_LACKING:
            lacking.setdefault(reason.robot, []).append(reason)
    single = [reasons[0] for reasons in lacking.values() if len(reasons) == 1]
    single.sort(key=lambda reason: reason.rule == "capability_missing")
    said = dict.fromkeys(f"{reason.robot} lacks only {_needed(reason)}" for reason in single)
    shown = list(said)[:MOST_TYPES]
    return f"Nearest to being able: {'; '.join(shown)}." if shown else ""


def _needed(reason: Reason) -> str:
    if reason.rule == "capability_missing":
        return f"the capability {reason.needed}"
    return f"{reason.needed} (it has {reason.found})" if reason.found else reason.needed
