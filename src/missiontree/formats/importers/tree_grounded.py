"""A tree in columns as values: a grounded tree and a fleet, which every stage takes. Small trees; big ones stay columns."""

from __future__ import annotations

from collections.abc import Mapping

from missiontree.mission.columns import BUDGET, KINDS, LEAF, TreeColumns
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, Role

DOES = "act"


def fleet_of(columns: TreeColumns, *, budgets: bool = True) -> Fleet:
    """
    A type for every robot, of as many robots as it stands for.

    Parameters
    ----------
    columns
        The tree.
    budgets
        Whether its budgets limit them. Default true.
    """
    held = columns.budget if budgets else None
    return Fleet(
        tuple(
            RobotType(
                id=columns.robot_id(robot),
                capabilities={DOES: 1.0},
                limits={} if held is None else {BUDGET: float(held[robot])},
                count=1 if columns.count is None else columns.count[robot],
            )
            for robot in range(columns.robots)
        )
    )


def grounded_of(columns: TreeColumns, *, disjoint: bool = False) -> GroundedTree:
    """
    The tree as a value. With the weights :data:`~missiontree.mission.columns.WEIGHTS` its utilities are those of the columns.

    Parameters
    ----------
    columns
        The tree.
    disjoint
        Whether children of the ANDs in ``disjoint`` are kept to different robots. Default false.
    """
    uses: dict[int, Mapping[str, float]] = {0: FrozenMap({})}
    estimates: dict[tuple[int, int], Estimate] = {}
    nodes: list[GroundedNode] = []
    roles: list[Role] = []
    for node, (kind, parent) in enumerate(zip(columns.kind, columns.parent, strict=True)):
        label, action = columns.label(node), None
        if kind == LEAF:
            action = _action(columns, node, len(roles), uses, estimates)
            roles.append(Role(label=label))
        nodes.append(GroundedNode(parent=parent, kind=KINDS[kind], label=label, action=action))
    links = [GroundedLink(before, after) for before, after in columns.precedence]
    if disjoint:
        links += [GroundedLink(one, other, "different_robot") for one, other in columns.apart()]
    return GroundedTree(objective="A tree in columns", nodes=tuple(nodes), roles=tuple(roles), links=tuple(links))


def _action(
    columns: TreeColumns,
    leaf: int,
    role: int,
    uses: dict[int, Mapping[str, float]],
    estimates: dict[tuple[int, int], Estimate],
) -> Action:
    """The action of a leaf; equal parts of several actions are one value."""
    used, utility, duration = columns.consumption[leaf], columns.utility[leaf], columns.duration[leaf]
    if used not in uses:
        uses[used] = FrozenMap({BUDGET: float(used)})
    if (utility, duration) not in estimates:
        estimates[utility, duration] = Estimate(float(max(utility, 0)), float(duration), float(max(-utility, 0)))
    return Action(
        name=DOES,
        text=columns.label(leaf),
        role=role,
        robot_type=columns.robot_id(columns.robot[leaf]),
        capability=DOES,
        estimate=estimates[utility, duration],
        duration_s=float(duration),
        uses=uses[used],
        uses_at_least=uses[used],
    )
