"""
Which roles must be under way together.

Two roles that wait for each other in turn (joint work; the one's second action after the other's first, and before the other's
second) cannot be done one after the other: they form a *bundle*. Bundles themselves are ordered without cycles, so if each gets all
its robots at once, and only when everything outside that it waits for is settled, no robot is ever held in vain.
"""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.scheduling.hand_overs import NO_HAND_OVERS, HandOvers
from missiontree.scheduling.precedence import TaskGraph


@dataclass(frozen=True, slots=True)
class Bundles:
    """
    Bundles of one alternative, with the inner events between them.

    Parameters
    ----------
    of_role
        Bundle of each reached role.
    leaves
        How many leaves each bundle has; 0 for an inner event.
    after
        Bundles directly after each.
    """

    of_role: dict[int, int]
    leaves: tuple[int, ...]
    after: tuple[tuple[int, ...], ...]

    @property
    def roles(self) -> dict[int, list[int]]:
        """Roles of each bundle that has any."""
        found: dict[int, list[int]] = {}
        for role, bundle in self.of_role.items():
            found.setdefault(bundle, []).append(role)
        return found


def bundles_of(graph: TaskGraph, hand_overs: HandOvers = NO_HAND_OVERS) -> Bundles:
    """Roles that wait for each other in turn (strongly connected components over roles and inner events)."""
    vertex = _vertices(graph, hand_overs)
    count = max(vertex, default=-1) + 1
    successors: list[set[int]] = [set() for _ in range(count)]
    for event, after in enumerate(graph.successors):
        successors[vertex[event]].update(vertex[later] for later in after)
    component = _components([sorted(after) for after in successors])
    number = max(component, default=-1) + 1
    leaves = [0] * number
    after_all: list[set[int]] = [set() for _ in range(number)]
    for activity, joint in enumerate(graph.activities):
        leaves[component[vertex[2 * activity]]] += len(joint)
    for here, later_ones in enumerate(successors):
        after_all[component[here]].update(component[later] for later in later_ones)
    return Bundles(
        of_role={role: component[vertex[graph.start(role_leaves[0])]] for role, role_leaves in graph.roles.items()},
        leaves=tuple(leaves),
        after=tuple(tuple(sorted(after - {here})) for here, after in enumerate(after_all)),
    )


def crews_of(graph: TaskGraph, hand_overs: HandOvers = NO_HAND_OVERS) -> dict[int, int]:
    """For each role a number that it shares with the roles it works with jointly or hands over to, directly or through others."""
    vertex = _vertices(graph, hand_overs)
    return {role: vertex[graph.start(leaves[0])] for role, leaves in graph.roles.items()}


def _vertices(graph: TaskGraph, hand_overs: HandOvers) -> list[int]:
    """A number per event: one for all events of roles that work jointly or hand over to each other, one for each inner event."""
    leader: dict[int, int] = {role: role for role in graph.roles}

    def find(role: int) -> int:
        while leader[role] != role:
            leader[role] = leader[leader[role]]
            role = leader[role]
        return role

    met = [(*graph.activities[giver], *graph.activities[taker]) for giver, taker in hand_overs.taker.items()]
    for joint in (*graph.activities, *met):
        for leaf in joint[1:]:
            low, high = sorted((find(graph.tree.action(joint[0]).role), find(graph.tree.action(leaf).role)))
            leader[high] = low
    crews = {role: index for index, role in enumerate(sorted({find(role) for role in graph.roles}))}
    inner = len(graph.successors) - 2 * len(graph.activities)
    crew_of_activity = [crews[find(graph.tree.action(joint[0]).role)] for joint in graph.activities]
    return [crew for crew in crew_of_activity for _ in range(2)] + [len(crews) + index for index in range(inner)]


def _components(successors: list[list[int]]) -> list[int]:
    """Number of the strongly connected component of each vertex (Tarjan 1972, without recursion)."""
    size = len(successors)
    found, low, component = [-1] * size, [0] * size, [-1] * size
    open_stack: list[int] = []
    counter = components = 0
    for root in range(size):
        if found[root] >= 0:
            continue
        path = [(root, iter(successors[root]))]
        while path:
            here, rest = path[-1]
            if found[here] < 0:
                found[here] = low[here] = counter
                counter += 1
                open_stack.append(here)
            after = next(rest, None)
            if after is not None:
                if found[after] < 0:
                    path.append((after, iter(successors[after])))
                elif component[after] < 0:
                    low[here] = min(low[here], found[after])
                continue
            path.pop()
            if path:
                low[path[-1][0]] = min(low[path[-1][0]], low[here])
            if low[here] == found[here]:
                while component[here] < 0:
                    component[open_stack.pop()] = components
                components += 1
    return component
