"""
Hand-overs in a task graph: who hands over to whom, what that adds to the order, and which hand-overs can never be.

The last action of the giver ends when the first action of the taker starts. In the graph the end of the giver's action is the end of
what it takes by itself; that the giver waits from then on for the taker is said by one more rule: whatever must not be before the
giver's end must not be before the taker's start. So the graph stays free of cycles, and its bounds are those of the mission.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from missiontree.mission.reason import Reason
from missiontree.scheduling.precedence import TaskGraph

RULE = "hand_over_unfit"


@dataclass(frozen=True, slots=True)
class HandOvers:
    """
    The hand-overs of one alternative.

    Parameters
    ----------
    taker
        By activity that ends with a hand-over: the activity that it starts.
    between
        By activity that ends with a hand-over: activities that must be done just then, in no time.
    """

    taker: dict[int, int] = field(default_factory=dict)
    between: dict[int, tuple[int, ...]] = field(default_factory=dict)

    def __bool__(self) -> bool:
        return bool(self.taker)

    def givers(self, activity: int) -> list[int]:
        """Activities that hand over to one."""
        return [giver for giver, taker in self.taker.items() if taker == activity]


NO_HAND_OVERS = HandOvers()


def hand_overs_of(graph: TaskGraph) -> HandOvers | list[Reason]:
    """The hand-overs of a graph, which learns their order; or why some of them can never be."""
    found: dict[int, int] = {}
    reasons: list[Reason] = []
    for first, second in graph.links("hand_over"):
        if not (graph.below(first) and graph.below(second)):
            continue
        pair = _ends(graph, first, second)
        if isinstance(pair, Reason):
            reasons.append(pair)
        elif found.setdefault(pair[0], pair[1]) != pair[1]:
            reasons.append(_unfit(graph, first, second, f"{_named(graph, pair[0])} would hand over to two"))
    for giver in found:
        if giver in found.values():
            leaf = graph.activities[giver][0]
            why = f"{graph.name(leaf)!r} both takes over and hands over; a robot needs an action for each"
            reasons.append(
                Reason(rule=RULE, message=f"{why}.", node=graph.name(leaf), hint="Give the role a second action.")
            )
    if reasons or not found:
        return reasons or NO_HAND_OVERS
    between = {giver: _connect(graph, giver, taker) for giver, taker in found.items()}
    return HandOvers(found, {giver: inside for giver, inside in between.items() if inside})


def _ends(graph: TaskGraph, first: int, second: int) -> tuple[int, int] | Reason:
    """The activity that ends with a hand-over, and the one that starts with it."""
    lasts = {graph.activity_of[graph.roles[role][-1]] for role in graph.roles_below(first)}
    firsts = {graph.activity_of[graph.roles[role][0]] for role in graph.roles_below(second)}
    own = {*graph.below(first)}, {*graph.below(second)}
    cut = [graph.roles[role][-1] not in own[0] for role in graph.roles_below(first)]
    cut += [graph.roles[role][0] not in own[1] for role in graph.roles_below(second)]
    if len(lasts) > 1 or any(cut):
        return _unfit(graph, first, second, f"{graph.name(first)!r} does not end with one action of one robot")
    if len(firsts) > 1:
        return _unfit(graph, first, second, f"{graph.name(second)!r} does not start with one action of one robot")
    giver, taker = lasts.pop(), firsts.pop()
    if giver == taker:
        return _unfit(graph, first, second, "they are done together")
    given = [graph.tree.action(leaf) for leaf in graph.activities[giver]]
    taken = [graph.tree.action(leaf) for leaf in graph.activities[taker]]
    if any(action.open_ended for action in given):
        return _unfit(graph, first, second, f"{_named(graph, giver)} has no end of its own")
    if any(action.moves or action.at is None for action in taken):
        return _unfit(graph, first, second, f"{_named(graph, taker)} is not done at a place")
    there = [left_at(graph, action.role) for action in given]
    if any(action.at not in places for action in taken for places in there):
        what = f"{_named(graph, giver)} does not end where {_named(graph, taker)} starts"
        return _unfit(graph, first, second, what)
    roles = {action.role for action in (*given, *taken)}
    names = {name for action in taken for name in (action.at,) if name is not None} | set[str]().union(*there)
    if (mover := _taken_away(graph, names, roles, giver, taker)) is not None:
        what = f"{_named(graph, mover)} may take away in between what they meet at; give it an order"
        return _unfit(graph, first, second, what)
    return giver, taker


def left_at(graph: TaskGraph, role: int) -> set[str]:
    """Entities at whose place a role ends: where it was last, and what it brought there."""
    here: set[str] = set()
    for action in (graph.tree.action(leaf) for leaf in graph.roles[role]):
        if action.moves:
            here = {name for name in (action.at, *action.brings) if name is not None}
        elif action.at is not None and action.at not in here:
            here = {action.at}
    return here


def _taken_away(graph: TaskGraph, names: set[str], roles: set[int], giver: int, taker: int) -> int | None:
    """An activity of others that moves one of some entities, and that surely comes neither before the giver's role nor after the taker."""
    firsts = {
        2 * graph.activity_of[graph.roles[role][0]]
        for role in roles
        if graph.roles[role][-1] in graph.activities[giver]
    }
    before = set[int]().union(*(_reaching(graph, first) for first in firsts))
    for activity, leaves in enumerate(graph.activities):
        actions = [graph.tree.action(leaf) for leaf in leaves]
        if any(names & {*action.brings} and action.role not in roles for action in actions):
            surely_after = 2 * taker in _reaching(graph, 2 * activity)
            if 2 * activity + 1 not in before and not surely_after:
                return activity
    return None


def _named(graph: TaskGraph, activity: int) -> str:
    return repr(graph.name(graph.activities[activity][0]))


def _unfit(graph: TaskGraph, first: int, second: int, why: str) -> Reason:
    return Reason(
        rule=RULE,
        message=f"{graph.name(first)!r} cannot hand over to {graph.name(second)!r}: {why}.",
        node=graph.name(second),
        needed="a last action of the giver, and a first action of the taker at the same place or at what the giver brings",
        hint="Choose another way of doing it, or drop the hand-over.",
    )


def _connect(graph: TaskGraph, giver: int, taker: int) -> tuple[int, ...]:
    """The taker comes after the giver, and so does what comes after the giver come after the taker's start; what lies in between."""
    end, start = 2 * giver + 1, 2 * taker
    graph.successors[end].append(start)
    before = _reaching(graph, start)
    seen, stack, inside = {end}, [end], []
    while stack:
        for after in list(graph.successors[stack.pop()]):
            if after == start or after in seen:
                continue
            seen.add(after)
            if after in before:
                stack.append(after)
                if after % 2 == 0 and after < 2 * len(graph.activities):
                    inside.append(after // 2)
            else:
                graph.successors[start].append(after)
    return tuple(inside)


def _reaching(graph: TaskGraph, goal: int) -> set[int]:
    """Events that come no later than one."""
    earlier: list[list[int]] = [[] for _ in graph.successors]
    for event, successors in enumerate(graph.successors):
        for after in successors:
            earlier[after].append(event)
    found, stack = {goal}, [goal]
    while stack:
        fresh = [event for event in earlier[stack.pop()] if event not in found]
        found.update(fresh)
        stack += fresh
    return found
