"""The load bound: what the robots of a type must do, travel into roles included where it is certain, shared evenly among them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from missiontree.mission.fleet import Fleet
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing

_Piece = tuple[int, int, int]


def load_bound(
    graph: TaskGraph,
    staffing: Staffing,
    fleet: Fleet,
    duration: Sequence[int],
    lag: dict[int, int],
    heads: Sequence[int],
    tails: Sequence[int],
    entries: Mapping[int, int],
) -> int:
    """The largest load bound over all types, and over all groups of roles that one robot fills, with and without entries."""
    plain, entered = _Pieces(), _Pieces()
    for role, leaves in graph.roles.items():
        hold = sum(duration[graph.activity_of[leaf]] + lag.get(leaf, 0) for leaf in leaves)
        head, tail = heads[graph.start(leaves[0])], tails[graph.end(leaves[-1])]
        whose = staffing.type_of[role], staffing.group_of[role]
        plain.add(*whose, (head, hold, tail))
        entry = entries.get(role, 0)
        if graph.tree.action(leaves[0]).moves:
            # the way is the action itself, which may last longer for the sake of others
            hold += max(0, entry - duration[graph.activity_of[leaves[0]]])
        else:
            head, hold = max(0, head - entry), hold + entry
        entered.add(*whose, (head, hold, tail))
    return max(plain.bound(fleet), entered.bound(fleet) if entries else 0)


class _Pieces:
    """Roles as pieces of work by type and by group: earliest begin, time that they hold a robot, least time that follows."""

    def __init__(self) -> None:
        self._by_type: dict[str, list[_Piece]] = {}
        self._by_group: dict[int, list[_Piece]] = {}

    def add(self, type_id: str, group: int, piece: _Piece) -> None:
        self._by_type.setdefault(type_id, []).append(piece)
        self._by_group.setdefault(group, []).append(piece)

    def bound(self, fleet: Fleet) -> int:
        loads = [_shared(pieces, fleet.by_id[kind].usable) for kind, pieces in self._by_type.items()]
        loads += [_shared(pieces, 1) for pieces in self._by_group.values() if len(pieces) > 1]
        return max(loads, default=0)


def _shared(pieces: Iterable[tuple[int, int, int]], robots: int) -> int:
    """The largest, over sets of pieces, of least head + load per robot + least tail."""
    pieces = sorted(pieces, key=lambda piece: -piece[2])  # by tail, the longest first
    heads = sorted({head for head, _, _ in pieces})
    if len(heads) * len(pieces) > 1_000_000:
        heads = heads[:: len(heads) * len(pieces) // 1_000_000 + 1]
    best = 0
    for least in heads:
        load = 0
        for head, hold, tail in pieces:
            if head >= least:
                load += hold
                best = max(best, least - (-load // robots) + tail)
    return best
