"""
The task graph of one alternative: what is selected, and which event comes no later than which.

Events are the starts and ends of the selected nodes, as in :mod:`missiontree.mission.precedence`. Two things differ. Only selected
nodes are there, so a link binds only if both its nodes are. And joint actions are one *activity* with one start and one end,
so that whatever holds one of them back holds back all.
"""

from __future__ import annotations

import heapq
import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from missiontree.mission.alternative import Choice, selected_nodes
from missiontree.mission.grounded import GroundedTree


@dataclass(slots=True)
class TaskGraph:
    """
    Activities of one alternative and their order.

    Parameters
    ----------
    tree
        The grounded tree.
    nodes
        Selected nodes in preorder.
    activities
        Leaves that start and end together; single leaves mostly. In order of their first leaf.
    roles
        Leaves of each reached role, in the order in which they are done.
    until
        Activities that end when others do, see :class:`missiontree.mission.tree.Link`, with the activities of which the latest
        sets their end. Those have an end of their own, and one of them must end after the start of what waits for it.
    successors
        For each event, the events that come no earlier. Activity a starts at event 2a and ends at 2a + 1; inner nodes follow.
    release, deadline
        Ticks before which an activity cannot start, and by which it must have ended, by activity: its leaves' own times and those of
        all nodes above them. Only activities with such a time are there.
    due_to
        Node that sets the deadline of an activity.
    """

    tree: GroundedTree
    nodes: tuple[int, ...]
    activities: tuple[tuple[int, ...], ...]
    roles: dict[int, tuple[int, ...]]
    until: Mapping[int, frozenset[int]] = field(default_factory=dict)
    successors: list[list[int]] = field(default_factory=list)
    release: dict[int, int] = field(default_factory=dict)
    deadline: dict[int, int] = field(default_factory=dict)
    due_to: dict[int, int] = field(default_factory=dict)
    activity_of: dict[int, int] = field(default_factory=dict)
    number: dict[int, int] = field(default_factory=dict)
    place: dict[int, int] = field(default_factory=dict)
    size: dict[int, int] = field(default_factory=dict)

    def start(self, node: int) -> int:
        """Event at which a selected node starts."""
        return 2 * self.number[node]

    def end(self, node: int) -> int:
        """Event at which a selected node ends."""
        return 2 * self.number[node] + 1

    def below(self, node: int) -> list[int]:
        """Selected leaves of a selected node, in preorder; the node itself if it is one."""
        first = self.place[node]
        return [leaf for leaf in self.nodes[first : first + self.size[node]] if leaf in self.activity_of]

    def roles_below(self, node: int) -> list[int]:
        """Roles with a selected leaf under a selected node, in order of index."""
        return sorted({self.tree.action(leaf).role for leaf in self.below(node)})

    def links(self, kind: str) -> list[tuple[int, int]]:
        """Links of a kind that bind: both nodes are selected."""
        binding = (link for link in self.tree.links if link.kind == kind)
        return [(link.first, link.second) for link in binding if link.first in self.place and link.second in self.place]

    def order(self) -> list[int] | None:
        """Events, each after those that come before it; None if there is a cycle. Ties go to the smaller event."""
        missing = indegrees(self.successors)
        ready = [event for event, count in enumerate(missing) if not count]
        ordered: list[int] = []
        while ready:
            event = heapq.heappop(ready)
            ordered.append(event)
            for after in self.successors[event]:
                missing[after] -= 1
                if not missing[after]:
                    heapq.heappush(ready, after)
        return ordered if len(ordered) == len(missing) else None

    def marks_before(self, order: Sequence[int], marks: Mapping[int, int]) -> list[int]:
        """For each event, the bits of the marked events that come before it; ``marks`` maps event to bits."""
        before = [0] * len(self.successors)
        for event in order:
            seen = before[event] | marks.get(event, 0)
            for after in self.successors[event]:
                before[after] |= seen
        return before

    def cycle(self) -> list[int] | None:
        """Nodes along some cycle, in order; None if there is none."""
        node_of = {number: node for node, number in reversed(self.number.items())}
        events = next(_cycles(self.successors), None)
        return None if events is None else list(dict.fromkeys(node_of[event // 2] for event in events))

    def name(self, node: int) -> str:
        """What people call a node: the text of an action, the label of any other node."""
        action = self.tree.nodes[node].action
        return self.tree.nodes[node].label if action is None else action.text


def task_graph(tree: GroundedTree, choices: Sequence[Choice]) -> TaskGraph:
    """The task graph that the choices select."""
    nodes = tuple(selected_nodes(tree, choices))
    joint: dict[object, list[int]] = {}
    roles: dict[int, list[int]] = {}
    for node in nodes:
        action = tree.nodes[node].action
        if action is not None:
            joint.setdefault(("alone", node) if action.sync is None else action.sync, []).append(node)
            roles.setdefault(action.role, []).append(node)
    graph = TaskGraph(
        tree=tree,
        nodes=nodes,
        activities=tuple(tuple(leaves) for leaves in joint.values()),
        roles={role: tuple(leaves) for role, leaves in sorted(roles.items())},
    )
    _number(graph)
    _connect(graph)
    _time(graph)
    return graph


def order_by_robot(graph: TaskGraph, robot_of: Mapping[int, str]) -> dict[str, tuple[int, ...]]:
    """
    The paper's result: for each robot its actions in a topological order (section III-C), before any clock is known.

    Parameters
    ----------
    graph
        A task graph without a cycle.
    robot_of
        Robot of every reached role.
    """
    ordered: dict[str, list[int]] = {}
    for event in graph.order() or ():
        if event % 2 == 0 and event // 2 < len(graph.activities):
            for leaf in graph.activities[event // 2]:
                ordered.setdefault(robot_of[graph.tree.action(leaf).role], []).append(leaf)
    return {robot: tuple(leaves) for robot, leaves in sorted(ordered.items())}


def indegrees(successors: Sequence[Sequence[int]]) -> list[int]:
    """How many events come directly before each."""
    missing = [0] * len(successors)
    for after in successors:
        for event in after:
            missing[event] += 1
    return missing


def _number(graph: TaskGraph) -> None:
    for activity, leaves in enumerate(graph.activities):
        for leaf in leaves:
            graph.activity_of[leaf] = graph.number[leaf] = activity
    inner = (node for node in graph.nodes if node not in graph.activity_of)
    graph.number.update((node, index) for index, node in enumerate(inner, start=len(graph.activities)))
    graph.place.update((node, index) for index, node in enumerate(graph.nodes))
    graph.size.update((node, 1) for node in graph.nodes)
    for node in reversed(graph.nodes[1:]):
        graph.size[graph.tree.nodes[node].parent] += graph.size[node]
    graph.successors = [[] for _ in range(2 * len(set(graph.number.values())))]


def _connect(graph: TaskGraph) -> None:
    add = graph.successors
    for activity in range(len(graph.activities)):
        add[2 * activity].append(2 * activity + 1)
    for node in graph.nodes[1:]:
        parent = graph.tree.nodes[node].parent
        add[graph.start(parent)].append(graph.start(node))
        add[graph.end(node)].append(graph.end(parent))
    for leaves in graph.roles.values():
        for before, after in itertools.pairwise(leaves):
            add[graph.end(before)].append(graph.start(after))
    for first, second in (*graph.links("precedence"), *graph.links("hand_over")):
        add[graph.end(first)].append(graph.start(second))
    _connect_until(graph)


def _time(graph: TaskGraph) -> None:
    """Joint actions start with the last release of them all, and end by the first deadline."""
    windows = graph.tree.windows
    for activity, leaves in enumerate(graph.activities):
        for window in (windows[leaf] for leaf in leaves):
            if window.release:
                graph.release[activity] = max(graph.release.get(activity, 0), window.release)
            if window.deadline is not None and window.deadline < graph.deadline.get(activity, window.deadline + 1):
                graph.deadline[activity], graph.due_to[activity] = window.deadline, window.due_to


def _connect_until(graph: TaskGraph) -> None:
    nodes: dict[int, list[int]] = {}
    for first, second in graph.links("until"):
        for leaf in graph.below(first):
            if graph.tree.action(leaf).open_ended and graph.below(second):
                graph.successors[graph.end(second)].append(graph.end(leaf))
                nodes.setdefault(graph.activity_of[leaf], []).append(second)
    given = {
        activity: {graph.activity_of[leaf] for second in seconds for leaf in graph.below(second)}
        for activity, seconds in nodes.items()
    }
    graph.until = {activity: _of_their_own(activity, given) for activity in given}
    for activity, seconds in nodes.items():
        ends = {graph.end(seconds[0])} if len(seconds) == 1 else set()
        roles = {graph.tree.action(leaf).role for one in graph.until[activity] for leaf in graph.activities[one][:1]}
        if len(roles) == 1:
            ends.add(2 * max(graph.until[activity], key=lambda one: graph.activities[one][0]) + 1)
        # Else the latest of several ends counts, and nobody knows which that is.
        graph.successors[2 * activity] += sorted(ends)


def _of_their_own(activity: int, given: Mapping[int, set[int]]) -> frozenset[int]:
    """Activities that set an end, through others that end with them."""
    seen, stack = {activity}, [activity]
    while stack:
        fresh = given.get(stack.pop(), set()) - seen
        seen |= fresh
        stack += sorted(fresh)
    return frozenset(seen - given.keys())


def _cycles(successors: Sequence[Sequence[int]]) -> Iterator[list[int]]:
    """Cycles met by one depth-first search, iteratively."""
    colour = bytearray(len(successors))  # 0 new, 1 on the path, 2 done
    for root in range(len(successors)):
        if colour[root]:
            continue
        colour[root], path, rest = 1, [root], [iter(successors[root])]
        while path:
            after = next(rest[-1], None)
            if after is None:
                colour[path.pop()] = 2
                rest.pop()
            elif colour[after] == 1:
                yield path[path.index(after) :]
            elif colour[after] == 0:
                colour[after] = 1
                path.append(after)
                rest.append(iter(successors[after]))
