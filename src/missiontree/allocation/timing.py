"""What allocation knows of time: least durations, the order of actions, release times and deadlines; in ticks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from missiontree.mission.grounded import GroundedTree
from missiontree.mission.ticks import ticks
from missiontree.mission.times import Window
from missiontree.mission.tree import IN_ORDER


@dataclass(frozen=True, slots=True)
class Timing:
    """
    The times of one problem that has a deadline, as columns indexed by node.

    Parameters
    ----------
    windows
        Release time and deadline of each node, with those of the nodes above it.
    length
        How long each leaf takes at least: its working time, or, of a move, the travel that is certain. 0 elsewhere.
    lag
        Travel before each leaf that is certain once its role is under way. An approach counts 0, and so does a move.
    sync
        Number of the joint work that a leaf is part of; such leaves start and end together. Leaves that are not joint do not appear.
    open_ended
        Leaves that may end with another node, whenever that is.
    precedence, until
        Links about time, as pairs of nodes.
    """

    windows: tuple[Window, ...]
    length: tuple[int, ...]
    lag: tuple[int, ...]
    sync: Mapping[int, int]
    open_ended: frozenset[int]
    precedence: tuple[tuple[int, int], ...]
    until: tuple[tuple[int, int], ...]


def timing_of(tree: GroundedTree) -> Timing | None:
    """The times of a tree; None if it has no deadline, since release times alone refuse nothing."""
    if all(node.deadline_s is None for node in tree.nodes):
        return None
    length, lag = [0] * len(tree.nodes), [0] * len(tree.nodes)
    sync: dict[int, int] = {}
    for leaf, node in enumerate(tree.nodes):
        action = node.action
        if action is None:
            continue
        travel = ticks(action.travel_at_least_s)
        length[leaf], lag[leaf] = (travel, 0) if action.moves else (ticks(action.duration_s), travel)
        if action.sync is not None:
            sync[leaf] = action.sync
    actions = ((leaf, node.action) for leaf, node in enumerate(tree.nodes))
    return Timing(
        windows=tree.windows,
        length=tuple(length),
        lag=tuple(lag),
        sync=sync,
        open_ended=frozenset(leaf for leaf, action in actions if action is not None and action.open_ended),
        precedence=tuple((link.first, link.second) for link in tree.links if link.kind in IN_ORDER),
        until=tuple((link.first, link.second) for link in tree.links if link.kind == "until"),
    )
