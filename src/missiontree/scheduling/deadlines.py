"""
Proofs that no schedule keeps a deadline, and whether a draft keeps all of them.

*Critical path*: what must come before takes longer than there is. *Load*: what robots of a type must do within some span takes more
time than they have in it (the energetic argument of parallel machines with release times and deadlines).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from missiontree.mission.fleet import Fleet
from missiontree.mission.reason import Reason
from missiontree.mission.ticks import seconds
from missiontree.scheduling.bounds import NEVER, Bounds, weights
from missiontree.scheduling.load import Piece, pieces_of, shares
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.problem import Draft, Problem
from missiontree.scheduling.staffing import Staffing

RULE = "deadline_missed"
MOST_PAIRS = 1_000_000
"""Roles of a type times spans, beyond which spans are left out."""
_MOST_NAMED = 6


def deadlines_out_of_reach(graph: TaskGraph, staffing: Staffing, bounds: Bounds, fleet: Fleet) -> list[Reason]:
    """Why some deadline cannot be kept, whatever robots are taken; empty if nothing shows that."""
    if not graph.deadline:
        return []
    late = {
        activity: bounds.heads[2 * activity + 1] - deadline
        for activity, deadline in graph.deadline.items()
        if bounds.heads[2 * activity + 1] > deadline
    }
    worst: dict[int, int] = {}  # by the node that sets the deadline: its latest activity
    for activity, by in late.items():
        node = graph.due_to[activity]
        if node not in worst or by > late[worst[node]]:
            worst[node] = activity
    if worst:
        return [_late_by_path(graph, bounds, activity) for _, activity in sorted(worst.items())]
    return _late_by_load(graph, staffing, bounds, fleet)


@dataclass(frozen=True, slots=True, order=True)
class Late:
    """
    A draft that misses deadlines.

    Parameters
    ----------
    ticks
        By how much, summed over the nodes that set them.
    reasons
        Which deadlines, each with the latest action under it.
    """

    ticks: int
    reasons: tuple[Reason, ...] = field(compare=False)


def deadlines_missed(problem: Problem, draft: Draft) -> Late | None:
    """Which deadlines a draft misses; None if it keeps all."""
    graph, worst = problem.graph, dict[int, tuple[int, int]]()
    for done in draft.done if graph.deadline else ():
        activity = graph.activity_of[done.leaf]
        by = done.end - graph.deadline.get(activity, done.end)
        if by > 0 and by > worst.get(graph.due_to[activity], (0, 0))[0]:
            worst[graph.due_to[activity]] = by, done.leaf
    reasons = tuple(_late_in_draft(graph, node, by, leaf) for node, (by, leaf) in sorted(worst.items()))
    late_home = 0 if problem.home_by is None else max(0, draft.makespan - problem.home_by)
    if late_home and 0 not in worst:
        reasons += (_home_late(problem.home_by or 0, late_home),)
    late = sum(by for by, _ in worst.values()) + late_home
    return Late(late, reasons) if late else None


def _late_by_path(graph: TaskGraph, bounds: Bounds, activity: int) -> Reason:
    """The chain of actions that shows it: back from the late one, always by what holds it up."""
    node, deadline, earliest = graph.due_to[activity], graph.deadline[activity], bounds.heads[2 * activity + 1]
    what = _owner(graph, node)
    return Reason(
        rule=RULE,
        message=f"{what} must end by {_shown(deadline)}, and cannot before {_shown(earliest)}: {_chain(graph, bounds, activity)}.",
        node=graph.name(node),
        found=_shown(earliest),
        needed=f"by {_shown(deadline)}",
        hint=f"Move the deadline by {_shown(earliest - deadline)} or more, or give the task another way of being done.",
    )


def _chain(graph: TaskGraph, bounds: Bounds, activity: int) -> str:
    before: list[list[int]] = [[] for _ in graph.successors]
    for event, successors in enumerate(graph.successors):
        for after in successors:
            before[after].append(event)
    weight = weights(graph, bounds.duration, bounds.lag)
    event, links = 2 * activity + 1, list[str]()
    while True:
        if event < 2 * len(graph.activities) and event % 2 == 1:
            links.append(_link(graph, bounds, event // 2))
        held_up = (one for one in before[event] if bounds.heads[one] + weight(one, event) == bounds.heads[event])
        earlier = min(held_up, default=None)
        if earlier is None:
            break
        event = earlier
    if (begin := bounds.heads[event]) > 0:
        links.append(f"nothing before {_shown(begin)}")
    links.reverse()
    if len(links) > _MOST_NAMED:
        half = _MOST_NAMED // 2
        links[half:-half] = [f"{len(links) - 2 * half} more"]
    return ", then ".join(links)


def _link(graph: TaskGraph, bounds: Bounds, activity: int) -> str:
    leaf = graph.activities[activity][0]
    lag = max(bounds.lag.get(one, 0) for one in graph.activities[activity])
    way = f"{_shown(lag)} on the way and " if lag else ""
    return f"{graph.name(leaf)!r} {way}{_shown(bounds.duration[activity])}"


def _late_by_load(graph: TaskGraph, staffing: Staffing, bounds: Bounds, fleet: Fleet) -> list[Reason]:
    for entries in ({}, bounds.entries) if bounds.entries else ({},):
        pieces = pieces_of(graph, staffing, bounds.duration, bounds.lag, bounds.heads, bounds.tails, entries)
        for own, robots in shares(pieces, fleet):
            if (reason := _overloaded(graph, bounds, own, robots)) is not None:
                return [reason]
    return []


def _overloaded(graph: TaskGraph, bounds: Bounds, pieces: Sequence[Piece], robots: int) -> Reason | None:
    """A span in which roles that cannot be outside it need more time of robots than there is."""
    until = {piece.role: bounds.latest[graph.end(graph.roles[piece.role][-1])] for piece in pieces}
    ordered = sorted(pieces, key=lambda piece: until[piece.role])
    begins = sorted({piece.head for piece in pieces})
    if len(begins) * len(pieces) > MOST_PAIRS:
        begins = begins[:: len(begins) * len(pieces) // MOST_PAIRS + 1]
    for begin in begins:
        inside: list[Piece] = []
        load = 0
        for piece in ordered:
            end = until[piece.role]
            if piece.head < begin or end == NEVER:
                continue
            inside.append(piece)
            load += piece.hold
            if load > robots * (end - begin):
                return _too_much(graph, inside, robots, load, begin, end)
    return None


def _too_much(graph: TaskGraph, pieces: Sequence[Piece], robots: int, load: int, begin: int, end: int) -> Reason:
    labels = [graph.tree.roles[piece.role].label for piece in pieces]
    named = ", ".join(repr(label) for label in labels[:_MOST_NAMED])
    more = f" and {len(labels) - _MOST_NAMED} more" if len(labels) > _MOST_NAMED else ""
    due = [graph.due_to[one] for one in graph.deadline if graph.deadline[one] >= end] or list(graph.due_to.values())
    type_id = pieces[0].type_id
    who = f"{robots} robots of type {type_id} have" if robots > 1 else f"one robot of type {type_id} has"
    return Reason(
        rule=RULE,
        message=f"Between {_shown(begin)} and {_shown(end)}, the last that deadlines allow, {named}{more} need {_shown(load)} of "
        f"robots' time; {who} {_shown(robots * (end - begin))}.",
        node=graph.name(due[0]),
        robot=type_id,
        found=_shown(load),
        needed=f"at most {_shown(robots * (end - begin))}",
        hint=f"Move the deadline, or add a robot of type {type_id}.",
    )


def _late_in_draft(graph: TaskGraph, node: int, by: int, leaf: int) -> Reason:
    deadline = graph.deadline[graph.activity_of[leaf]]
    action = f" with {graph.name(leaf)!r}" if leaf != node else ""
    return Reason(
        rule=RULE,
        message=f"{_owner(graph, node)} must end by {_shown(deadline)}; the best try ended{action} at {_shown(deadline + by)}.",
        node=graph.name(node),
        found=_shown(deadline + by),
        needed=f"by {_shown(deadline)}",
        hint="Nothing proves that no schedule keeps it; more robots or a later deadline would help.",
    )


def _home_late(home_by: int, by: int) -> Reason:
    return Reason(
        rule=RULE,
        message=f"All robots must be home by {_shown(home_by)}; in the best try the last was at {_shown(home_by + by)}.",
        found=_shown(home_by + by),
        needed=f"by {_shown(home_by)}",
        hint="Nothing proves that no schedule keeps it; more robots, a later deadline, or robots that stay out would help.",
    )


def _owner(graph: TaskGraph, node: int) -> str:
    return "The mission" if node == 0 else repr(graph.name(node))


def _shown(count: int) -> str:
    return f"{seconds(count):g} s"
