"""
What holding adds to the order.

A robot in a role does nothing else until the role is over. So if some action of role X must end before some action of role R
ends, and one robot fills both, then all of X comes before all of R. Such orders may imply further ones, and in the end a
cycle: the robot would be held while waiting for work that only it can do.
"""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.mission.fleet import Fleet
from missiontree.mission.ticks import ticks
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing


def order_held_roles(graph: TaskGraph, staffing: Staffing, fleet: Fleet) -> list[int] | None:
    """
    Add to the graph what holding implies, until nothing is added.

    Parameters
    ----------
    graph
        A task graph without a cycle; it is changed.
    staffing, fleet
        Which roles one robot must fill.

    Returns
    -------
    list of int or None
        The events in order, or None if the graph now has a cycle: then no schedule exists.
    """
    rivals = _rivals(graph, staffing, fleet)
    order = graph.order()
    added: set[tuple[int, int]] = set()
    while order is not None and rivals:
        before = graph.marks_before(order, _marks(graph, rivals))
        fresh = [pair for pair in _implied(graph, rivals, before) if pair not in added]
        if not fresh:
            break
        for earlier, later in fresh:
            added.add((earlier, later))
            graph.successors[graph.end(graph.roles[earlier][-1])].append(graph.start(graph.roles[later][0]))
        order = graph.order()
    return order


def _rivals(graph: TaskGraph, staffing: Staffing, fleet: Fleet) -> dict[int, list[int]]:
    """For each role, the others that its robot must fill too; left out where all of them are single actions."""
    sharing: dict[object, list[int]] = {}
    for role in graph.roles:
        sharing.setdefault(staffing.one_robot(fleet, role), []).append(role)
        if fleet.by_id[staffing.type_of[role]].usable == 1:
            sharing.setdefault((staffing.group_of[role],), []).append(role)
    rivals: dict[int, set[int]] = {}
    for roles in sharing.values():
        if len(roles) > 1 and any(len(graph.roles[role]) > 1 for role in roles):
            for role in roles:
                rivals.setdefault(role, set()).update(roles)
    return {role: sorted(others - {role}) for role, others in rivals.items()}


def _marks(graph: TaskGraph, rivals: dict[int, list[int]]) -> dict[int, int]:
    """A bit per role, at the end of each of its actions from the first that takes time on."""
    marks: dict[int, int] = {}
    for role in rivals:
        begun = 0
        for leaf in graph.roles[role]:
            action = graph.tree.action(leaf)
            if not action.moves and graph.activity_of[leaf] not in graph.until:
                begun += ticks(action.duration_s)
            if begun:  # a role that has taken no time yet could, in principle, follow at the same tick
                marks[graph.end(leaf)] = marks.get(graph.end(leaf), 0) | 1 << role
    return marks


def _implied(graph: TaskGraph, rivals: dict[int, list[int]], before: Sequence[int]) -> list[tuple[int, int]]:
    implied: list[tuple[int, int]] = []
    for role, others in rivals.items():
        seen = 0
        for leaf in graph.roles[role]:
            seen |= before[graph.end(leaf)]
        implied.extend((other, role) for other in others if seen >> other & 1)
    return implied
