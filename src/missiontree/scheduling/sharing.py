"""
Shared resources of one alternative: who holds what, and what follows from it for the order.

Only resources that are too small for all their holders at once matter; the others are left out, so that a mission without such a
resource costs nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations

from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.ticks import ticks
from missiontree.scheduling.hand_overs import HandOvers
from missiontree.scheduling.precedence import TaskGraph


@dataclass(frozen=True, slots=True)
class Sharing:
    """
    What activities hold of shared resources.

    Parameters
    ----------
    capacity
        How many robots may hold each resource at one time; only resources that are scarce are there.
    demand
        By activity: how many robots of it hold each resource, from its start to its end.
    on_ways
        Whether some resource is held on ways, whatever the activities hold. Default false.
    """

    capacity: Mapping[str, int] = field(default_factory=dict)
    demand: Mapping[int, Mapping[str, int]] = field(default_factory=dict)
    on_ways: bool = False

    def __bool__(self) -> bool:
        return bool(self.capacity)

    def holders(self, resource: str) -> dict[int, int]:
        """Activities that hold a resource, with how many robots of each do."""
        return {activity: held[resource] for activity, held in self.demand.items() if resource in held}

    def rivals(self, resource: str) -> list[tuple[int, int]]:
        """Pairs of activities that have no room beside each other, the smaller one first."""
        holders = self.holders(resource)
        most = self.capacity[resource]
        return [pair for pair in combinations(sorted(holders), 2) if holders[pair[0]] + holders[pair[1]] > most]


NOTHING_SHARED = Sharing()


def sharing_of(graph: TaskGraph, scene: Scene) -> Sharing:
    """What the activities of a graph hold."""
    demand: dict[int, dict[str, int]] = {}
    total: dict[str, int] = {}
    for activity, leaves in enumerate(graph.activities):
        for leaf in leaves:
            for name in graph.tree.action(leaf).holds:
                if name in scene.shared:
                    held = demand.setdefault(activity, {})
                    held[name] = held.get(name, 0) + 1
                    total[name] = total.get(name, 0) + 1
    passed = {name for names in scene.passages.values() for name in names}
    names = sorted({*total, *passed})
    scarce = {
        name: scene.shared[name].capacity
        for name in names
        if name in passed or total[name] > scene.shared[name].capacity
    }
    kept = {
        activity: {name: count for name, count in held.items() if name in scarce} for activity, held in demand.items()
    }
    return Sharing(scarce, {activity: held for activity, held in kept.items() if held}, bool(passed))


def too_crowded(graph: TaskGraph, sharing: Sharing, scene: Scene) -> list[Reason]:
    """Joint actions of which more robots hold a resource than it has room for: each reason alone proves that there is no schedule."""
    reasons = []
    for activity, held in sharing.demand.items():
        for name, robots in held.items():
            if robots > sharing.capacity[name]:
                leaf = graph.activities[activity][0]
                reasons.append(
                    Reason(
                        rule="resource_too_small",
                        message=f"{graph.name(leaf)!r} has {robots} robots hold {scene.shared[name].label} at once, and it has room "
                        f"for {sharing.capacity[name]}.",
                        node=graph.name(leaf),
                        found=f"capacity {sharing.capacity[name]}",
                        needed=f"capacity {robots}",
                        hint=f"Raise the capacity of {name}, or let the robots act one after the other.",
                    )
                )
    return reasons


def order_open_ended(graph: TaskGraph, sharing: Sharing, hand_overs: HandOvers, order: Sequence[int]) -> bool:
    """
    Add to the graph what open-ended holding implies; whether anything was added.

    An action that lasts until another ends holds what it holds until then; one that ends with a hand-over, until the taker starts. What
    surely ends no later, takes time and finds no room beside it can only be over before it starts.
    """
    marks = {2 * activity + 1: 1 << activity for activity in sharing.demand}
    until = {activity: 2 * activity + 1 for activity in graph.until}
    until |= {giver: 2 * taker for giver, taker in hand_overs.taker.items()}
    before = graph.marks_before(order, marks) if any(activity in until for activity in sharing.demand) else []
    added = False
    for name in sharing.capacity if before else ():
        for pair in sharing.rivals(name):
            for lasting, other in (pair, pair[::-1]):
                if lasting in until and before[until[lasting]] >> other & 1 and _takes_time(graph, other):
                    graph.successors[2 * other + 1].append(2 * lasting)
                    added = True
    return added


def _takes_time(graph: TaskGraph, activity: int) -> bool:
    actions = (graph.tree.action(leaf) for leaf in graph.activities[activity])
    return activity not in graph.until and any(not action.moves and ticks(action.duration_s) > 0 for action in actions)
