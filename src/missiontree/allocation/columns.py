"""From a foreign tree's columns to those of allocation, without a value per node."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import compress, count

from missiontree.allocation.flat import AMOUNT_SCALE, Flat, Stock
from missiontree.mission.columns import BUDGET, KINDS, LEAF, Labels, TreeColumns
from missiontree.mission.estimate import MICRO


def flat_of_columns(columns: TreeColumns, *, budgets: bool = True, disjoint: bool = False) -> Flat:
    """
    What :func:`~missiontree.allocation.flat.flatten` makes of the same tree, of its fleet and of its weights.

    Parameters
    ----------
    columns
        The tree.
    budgets
        Whether its budgets limit the robots. Default true.
    disjoint
        Whether children of the ANDs in ``disjoint`` are kept to different robots. Default false.
    """
    robots = [columns.robot_id(robot) for robot in range(columns.robots)]
    held = columns.budget if budgets else None
    nodes, next_role = len(columns.kind), count()
    role = [next(next_role) if kind == LEAF else -1 for kind in columns.kind]
    return Flat(
        kind=tuple(map(KINDS.__getitem__, columns.kind)),
        parent=tuple(columns.parent),
        children=_children(columns),
        label=Labels(columns),
        utility=tuple([MICRO * utility for utility in columns.utility]),
        role=tuple(role),
        robot_type=tuple(
            [robots[robot] if kind == LEAF else "" for kind, robot in zip(columns.kind, columns.robot, strict=True)]
        ),
        uses=((_NOTHING,) * nodes) if held is None else _uses(columns),
        team=(None,) * next(next_role),
        same_robot=(),
        different_robot=tuple(columns.apart()) if disjoint else (),
        stocks=_stocks(columns, robots, held),
    )


_NOTHING: Mapping[str, int] = {}


def _children(columns: TreeColumns) -> tuple[tuple[int, ...], ...]:
    """Children of each node; leaves share the empty list, so that only gates take room."""
    below: list[list[int] | None] = [None if kind == LEAF else [] for kind in columns.kind]
    for node, parent in enumerate(columns.parent):
        if parent >= 0:
            above = below[parent]
            assert above is not None  # no leaf has children
            above.append(node)
    return tuple(() if children is None else tuple(children) for children in below)


def _uses(columns: TreeColumns) -> tuple[Mapping[str, int], ...]:
    """What each leaf uses; equal uses are one mapping."""
    known = {used: {BUDGET: used * AMOUNT_SCALE} if used else _NOTHING for used in set(columns.consumption)}
    return tuple(map(known.__getitem__, columns.consumption))


def _stocks(columns: TreeColumns, robots: list[str], held: Sequence[int] | None) -> dict[str, Stock]:
    # A gate has robot 0 and consumes nothing, so that gates are to be told apart in the first case only.
    named = dict.fromkeys(robot for kind, robot in zip(columns.kind, columns.robot, strict=True) if kind == LEAF)
    using = set(compress(columns.robot, columns.consumption))
    stocks = {}
    for robot in named:
        budget = {BUDGET: held[robot] * AMOUNT_SCALE} if held is not None and robot in using else {}
        stocks[robots[robot]] = Stock((f"{robots[robot]}-1",), (budget,), {})
    return stocks
