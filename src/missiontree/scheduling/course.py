"""What a schedule decides, times left out: who fills what, and in which order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.problem import Draft


@dataclass(frozen=True, slots=True)
class Course:
    """
    The decisions of a schedule; :mod:`missiontree.scheduling.replay` makes a draft of them.

    Parameters
    ----------
    robots
        Robot of each role.
    tours
        Roles of each robot, in order.
    after_end, after_start
        Pairs of activities: the second starts no sooner than the first has ended, or has started.
    under_way
        For an open-ended activity, one of those that set its end, which ends later than it starts.
    """

    robots: Mapping[int, str]
    tours: Mapping[str, Sequence[int]]
    after_end: Sequence[tuple[int, int]] = ()
    after_start: Sequence[tuple[int, int]] = ()
    under_way: Mapping[int, int] = field(default_factory=dict)


def along(tours: Mapping[str, Sequence[int]]) -> Course:
    """The course that tours alone decide: who waits for whom for other reasons is left to order and to the moment."""
    return Course({role: robot for robot, roles in tours.items() for role in roles}, tours)


def tours_of(draft: Draft, graph: TaskGraph) -> dict[str, list[int]]:
    """Roles of each robot of a draft that does any, in the order in which it does them."""
    spans = {one.leaf: (one.start, one.end) for one in draft.done}
    order = {role: (spans[leaves[0]][0], spans[leaves[-1]][1], role) for role, leaves in graph.roles.items()}
    tours: dict[str, list[int]] = {}
    for role in sorted(order, key=lambda role: order[role]):
        tours.setdefault(draft.robot_of[role], []).append(role)
    return tours


def passings(graph: TaskGraph, tours: Mapping[str, Sequence[int]]) -> list[tuple[int, int]]:
    """Pairs of activities of robots that go from one role to the next: with the first a role ends, with the second one begins."""
    return [
        (graph.activity_of[graph.roles[earlier][-1]], graph.activity_of[graph.roles[later][0]])
        for roles in tours.values()
        for earlier, later in pairwise(roles)
    ]


def begun_is_enough(graph: TaskGraph, first: int, second: int) -> bool | None:
    """Whether one activity need only wait for another to begin, for the sake of what they move; None if it need not wait at all."""
    waits: bool | None = None
    for earlier in (graph.tree.action(leaf) for leaf in graph.activities[first]):
        for later in (graph.tree.action(leaf) for leaf in graph.activities[second]):
            if {*earlier.brings} & {*later.brings, later.at}:
                return False
            if earlier.at is not None and earlier.at in later.brings:
                if not earlier.open_ended:
                    return False
                waits = True
    return waits
