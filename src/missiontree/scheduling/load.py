"""The load bound: what the robots of a type must do, travel into roles included where it is certain, shared evenly among them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from missiontree.mission.fleet import Fleet
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.sharing import Sharing
from missiontree.scheduling.staffing import Staffing


class Piece(NamedTuple):
    """
    A role as a piece of work for one robot, in ticks.

    Parameters
    ----------
    role, type_id, group
        The role, the type that fills it, and the group of roles that one robot fills.
    head
        It begins no earlier.
    hold
        How long it holds its robot at least.
    tail
        How long the mission goes on after it at least.
    """

    role: int
    type_id: str
    group: int
    head: int
    hold: int
    tail: int


NOWHERE: Mapping[int, int] = {}


def pieces_of(
    graph: TaskGraph,
    staffing: Staffing,
    duration: Sequence[int],
    lag: Mapping[int, int],
    heads: Sequence[int],
    tails: Sequence[int],
    entries: Mapping[int, int] = NOWHERE,
) -> list[Piece]:
    """
    Every role as a piece of work, with the least travel into it (``entries``, by role) as its part.

    A robot that travels early and waits at the place could as well have set out later: so a piece with its travel begins no earlier
    than its first action can, less the travel.
    """
    pieces: list[Piece] = []
    for role, leaves in graph.roles.items():
        hold = sum(duration[graph.activity_of[leaf]] + lag.get(leaf, 0) for leaf in leaves)
        head, tail = heads[graph.start(leaves[0])], tails[graph.end(leaves[-1])]
        entry = entries.get(role, 0)
        if graph.tree.action(leaves[0]).moves:
            # the way is the action itself, which may last longer for the sake of others
            hold += max(0, entry - duration[graph.activity_of[leaves[0]]])
        else:
            head, hold = max(0, head - entry), hold + entry
        pieces.append(Piece(role, staffing.type_of[role], staffing.group_of[role], head, hold, tail))
    return pieces


def shares(pieces: Iterable[Piece], fleet: Fleet) -> list[tuple[list[Piece], int]]:
    """Pieces that a number of robots share: those of a type, and those of a group that one robot fills."""
    by_type: dict[str, list[Piece]] = {}
    by_group: dict[int, list[Piece]] = {}
    for piece in pieces:
        by_type.setdefault(piece.type_id, []).append(piece)
        by_group.setdefault(piece.group, []).append(piece)
    found = [(own, fleet.by_id[kind].usable) for kind, own in by_type.items()]
    return found + [(own, 1) for own in by_group.values() if len(own) > 1]


def load_bound(pieces: Iterable[Piece], fleet: Fleet) -> int:
    """The largest load bound over all types, and over all groups of roles that one robot fills."""
    return max((_shared(own, robots) for own, robots in shares(pieces, fleet)), default=0)


def holding_bound(sharing: Sharing, duration: Sequence[int], heads: Sequence[int], tails: Sequence[int]) -> int:
    """The largest load bound over all shared resources: each place in one is held by one robot at a time."""
    return max(
        (_shared(pieces, sharing.capacity[name]) for name, pieces in holds_of(sharing, duration, heads, tails).items()),
        default=0,
    )


def holds_of(
    sharing: Sharing, duration: Sequence[int], heads: Sequence[int], tails: Sequence[int]
) -> dict[str, list[Piece]]:
    """By shared resource, every activity that holds it as a piece of work for it: once for each robot that does."""
    return {
        name: [
            Piece(-1, name, activity, heads[2 * activity], duration[activity], tails[2 * activity + 1])
            for activity, robots in sharing.holders(name).items()
            for _ in range(robots)
        ]
        for name in sharing.capacity
    }


def _shared(pieces: list[Piece], robots: int) -> int:
    """The largest, over sets of pieces, of least head + load per robot + least tail."""
    pieces = sorted(pieces, key=lambda piece: -piece.tail)  # the longest first
    heads = sorted({piece.head for piece in pieces})
    if len(heads) * len(pieces) > 1_000_000:
        heads = heads[:: len(heads) * len(pieces) // 1_000_000 + 1]
    best = 0
    for least in heads:
        load = 0
        for piece in pieces:
            if piece.head >= least:
                load += piece.hold
                best = max(best, least - (-load // robots) + piece.tail)
    return best
