"""One way of doing the mission: a child at every reached XOR, a robot type in every role. And the ranked list of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from missiontree.mission.certificate import Certificate
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.limit_use import LimitUse
from missiontree.mission.reason import Reason
from missiontree.mission.value import Count, Id, Index, Value

RankingStatus = Literal["exact", "partial", "infeasible", "unknown"]


@dataclass(frozen=True, slots=True)
class Choice(Value):
    """
    The child taken at a reached XOR.

    Parameters
    ----------
    xor
        Index of the XOR node in the grounded tree.
    child
        Index of the node taken below it.
    """

    xor: Index
    child: Index


@dataclass(frozen=True, slots=True)
class RoleType(Value):
    """
    The robot type that fills a role.

    Parameters
    ----------
    role
        Index of the role in the grounded tree.
    robot_type
        Id of the type.
    """

    role: Index
    robot_type: Id


@dataclass(frozen=True, slots=True)
class Assignment(Value):
    """
    The robot that fills a role.

    Parameters
    ----------
    role
        Index of the role in the grounded tree.
    robot
        Id of the robot.
    """

    role: Index
    robot: Id


@dataclass(frozen=True, slots=True, kw_only=True)
class Alternative(Value):
    """
    A complete staffing of the mission by robot types.

    Parameters
    ----------
    rank
        From 1, best first.
    utility
        Sum over the selected actions, in steps of 1e-6.
    choices
        Child taken at every reached XOR, in preorder.
    roles
        Type of every reached role, in order of role index.
    witness
        A robot per role that keeps every budget by what allocation knows; empty if nothing couples the robots.
    uses
        What is used of every limit of which anything is used, type by type, and at last of those of the whole mission.
    certificate
        Whether this rank is proven.
    """

    rank: Count
    utility: float
    choices: tuple[Choice, ...]
    roles: tuple[RoleType, ...]
    witness: tuple[Assignment, ...] = ()
    uses: tuple[LimitUse, ...] = ()
    certificate: Certificate


@dataclass(frozen=True, slots=True, kw_only=True)
class Ranking(Value):
    """
    Alternatives, best first: by utility, then by choice indices in preorder.

    Parameters
    ----------
    alternatives
        At most k of them.
    status
        ``exact``: every rank is proven and, if fewer than k are listed, there are no more. ``partial``: stopped early, or by a
        method that proves nothing. ``infeasible``: proven that there is none. ``unknown``: none was found, none is excluded.
    certificate
        What is known of everything not listed.
    examined
        How many candidates were looked at.
    reasons
        Why there is none, or why candidates were dropped.
    """

    alternatives: tuple[Alternative, ...]
    status: RankingStatus
    certificate: Certificate
    examined: int = 0
    reasons: tuple[Reason, ...] = ()


def selected_nodes(tree: GroundedTree, choices: Sequence[Choice]) -> Iterator[int]:
    """
    Nodes selected by the choices, in preorder.

    Raises
    ------
    KeyError
        If no choice is given for a reached XOR.
    """
    taken = {choice.xor: choice.child for choice in choices}
    stack = [0]
    while stack:
        node = stack.pop()
        yield node
        if tree.nodes[node].kind == "xor":
            stack.append(taken[node])
        else:
            stack.extend(reversed(tree.children[node]))


def selected_leaves(tree: GroundedTree, choices: Sequence[Choice]) -> tuple[int, ...]:
    """Selected actions, in preorder."""
    return tuple(node for node in selected_nodes(tree, choices) if tree.nodes[node].kind == "action")
