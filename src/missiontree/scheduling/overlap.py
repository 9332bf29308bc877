"""Proof that what an until link wants under way at once cannot be: one robot would have to do both."""

from __future__ import annotations

from missiontree.mission.fleet import Fleet
from missiontree.mission.reason import Reason
from missiontree.mission.ticks import ticks
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing


def overlaps_of_one_robot(graph: TaskGraph, staffing: Staffing, fleet: Fleet) -> list[Reason]:
    """
    Open-ended actions whose robot would have to do, at the same time, whatever may set their end.

    If the other role came first, it would end before the action starts; if it came later, only after the action had ended.
    """
    reasons: list[Reason] = []
    for open_ended, ends in sorted(graph.until.items()):
        leaf = graph.activities[open_ended][0]
        own = graph.tree.action(leaf).role
        robot = staffing.one_robot(fleet, own)
        if not all(_by(graph, staffing, fleet, one, own, robot) for one in ends):
            continue
        other = graph.activities[max(ends, key=lambda one: graph.activities[one][0])][0]
        kind = fleet.by_id[staffing.type_of[own]]
        reasons.append(
            Reason(
                rule="until_needs_two",
                message=f"{graph.name(leaf)!r} must be under way when {graph.name(other)!r} ends, and one robot would have to "
                "do both.",
                node=graph.name(leaf),
                robot=kind.id,
                found="one robot",
                needed="two robots",
                hint="Give the two to different robots, or drop the until link between them.",
            )
        )
    return reasons


def _by(graph: TaskGraph, staffing: Staffing, fleet: Fleet, activity: int, own: int, robot: object) -> bool:
    """Whether the robot must do an activity too, in another role that has taken time by the activity's end."""
    for leaf in graph.activities[activity]:
        role = graph.tree.action(leaf).role
        if role != own and staffing.one_robot(fleet, role) == robot and _takes_time(graph, role, leaf):
            return True
    return False


def _takes_time(graph: TaskGraph, role: int, last: int) -> bool:
    for leaf in graph.roles[role]:
        action = graph.tree.action(leaf)
        if not action.moves and graph.activity_of[leaf] not in graph.until and ticks(action.duration_s):
            return True
        if leaf == last:
            return False
    return False
