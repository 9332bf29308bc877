"""The ways there are: a road graph with lifts, or a grid of free and blocked cells."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.position import Position
from missiontree.mission.value import Id, NonNegative, Positive, Value, require_unique


@dataclass(frozen=True, slots=True, kw_only=True)
class RoadNode(Value):
    """
    A named point of the road graph.

    Parameters
    ----------
    id
        Name, used by roads and lifts.
    position
        Where it is.
    """

    id: Id
    position: Position


@dataclass(frozen=True, slots=True, kw_only=True)
class Road(Value):
    """
    An edge of the road graph.

    Parameters
    ----------
    ends
        Two ids of road nodes, or of places with a position.
    length_m
        Length, default the straight distance of the ends.
    one_way
        Only from the first end to the second. Default false.
    blocked
        Nobody can pass. Default false.
    types
        Robot types allowed; None (default) means all.
    zone
        Zone the road runs through; only types allowed there pass.
    resource
        Shared resource of the scene that robots hold on every way along this road, from setting out to arriving: a narrow corridor, a
        door. Default: none.
    """

    ends: tuple[Id, Id]
    length_m: NonNegative | None = None
    one_way: bool = False
    blocked: bool = False
    types: tuple[Id, ...] | None = None
    zone: Id | None = None
    resource: Id | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Lift(Value):
    """
    Joins road nodes on different floors.

    Parameters
    ----------
    id
        Name of the lift.
    stops
        Road nodes or places it stops at, at least two.
    ride_s
        Seconds from any stop to any other, waiting included.
    blocked
        Out of order. Default false.
    types
        Robot types allowed; None (default) means all.
    resource
        Shared resource of the scene that robots hold on every way by this lift, in the same way. Default: none.
    """

    id: Id
    stops: tuple[Id, ...]
    ride_s: NonNegative
    blocked: bool = False
    types: tuple[Id, ...] | None = None
    resource: Id | None = None

    def _check(self) -> None:
        if len(self.stops) < 2:
            raise ValueError(f"lift {self.id!r} needs at least two stops.")


@dataclass(frozen=True, kw_only=True)
class RoadGraph(Value):
    """
    The ways there are. Points off the road join the nearest node of their floor straight.

    Parameters
    ----------
    nodes
        Named points; places with a position may be used as nodes too.
    roads
        Edges.
    lifts
        What joins floors.
    """

    nodes: tuple[RoadNode, ...] = ()
    roads: tuple[Road, ...] = ()
    lifts: tuple[Lift, ...] = ()

    def _check(self) -> None:
        require_unique("road node", tuple(node.id for node in self.nodes))
        require_unique("lift", tuple(lift.id for lift in self.lifts))


@dataclass(frozen=True, kw_only=True)
class OccupancyGrid(Value):
    """
    A map of free and blocked cells. Robots move in 8 directions and cut no corners.

    Parameters
    ----------
    rows
        Strings of ``.`` (free) and ``#`` (blocked), all of one length; the first row has the largest y, as on a printed map.
    cell_m
        Side of a cell in metres, above 0.
    x_m, y_m
        Lower left corner of the grid, default (0, 0).
    floor
        Floor, default ``ground``.
    """

    rows: tuple[str, ...]
    cell_m: Positive
    x_m: float = 0.0
    y_m: float = 0.0
    floor: Id = "ground"

    def _check(self) -> None:
        if not self.rows or not self.rows[0]:
            raise ValueError("a grid needs at least one row with at least one cell.")
        for number, row in enumerate(self.rows, start=1):
            if len(row) != len(self.rows[0]):
                raise ValueError(f"row {number} of the grid has {len(row)} cells, row 1 has {len(self.rows[0])}.")
            if wrong := set(row) - {".", "#"}:
                raise ValueError(
                    f"row {number} of the grid has {sorted(wrong)[0]!r}; cells are '.' (free) or '#' (blocked)."
                )
