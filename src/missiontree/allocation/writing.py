"""From a selection to the values that leave allocation."""

from __future__ import annotations

from missiontree.allocation.feasibility import Verdict
from missiontree.allocation.flat import Flat
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.selection import Selection
from missiontree.allocation.usage import Usage
from missiontree.mission.alternative import Alternative, Assignment, Choice, Ranking, RoleType
from missiontree.mission.certificate import Certificate
from missiontree.mission.estimate import MICRO
from missiontree.mission.limit_use import LimitUse
from missiontree.mission.reason import Reason

FREE = Verdict("yes")

Parts = tuple[tuple[Choice, ...], tuple[RoleType, ...]]
"""Choices in preorder, and roles in order."""


def require_count(k: int) -> None:
    """Refuse to look for fewer than one alternative."""
    if k < 1:
        raise ValueError(f"k must be at least 1, got {k}.")


class Writer:
    """Writes alternatives of one problem; equal parts of several alternatives are one value."""

    def __init__(self, flat: Flat) -> None:
        self._flat = flat
        self._usage = Usage(flat)
        self._choices: dict[tuple[int, int], Choice] = {}
        self._roles: dict[tuple[int, str], RoleType] = {}
        self._robots: dict[tuple[int, str], Assignment] = {}

    def alternative(
        self, rank: int, utility: int, selection: Selection, verdict: Verdict, certificate: Certificate
    ) -> Alternative:
        """One alternative; the utility is in millionths."""
        types = sorted({(self._flat.role[leaf], self._flat.robot_type[leaf]) for leaf in selection.leaves})
        choices = tuple(self._choice(xor, child) for xor, child in selection.choices)
        roles = tuple(self._role(role, type_id) for role, type_id in types)
        uses = self._usage.of(selection.leaves, dict(verdict.witness))
        return self.of_parts(rank, utility, (choices, roles), verdict, certificate, uses)

    def of_parts(
        self,
        rank: int,
        utility: int,
        parts: Parts,
        verdict: Verdict,
        certificate: Certificate,
        uses: tuple[LimitUse, ...] = (),
    ) -> Alternative:
        """One alternative whose choices and roles are values already; default: of a problem without limits."""
        choices, roles = parts
        return Alternative(
            rank=rank,
            utility=utility / MICRO,
            choices=choices,
            roles=roles,
            witness=tuple(self._robot(role, robot) for role, robot in verdict.witness),
            uses=uses,
            certificate=certificate,
        )

    def _choice(self, xor: int, child: int) -> Choice:
        if (xor, child) not in self._choices:
            self._choices[xor, child] = Choice(xor, child)
        return self._choices[xor, child]

    def _role(self, role: int, type_id: str) -> RoleType:
        if (role, type_id) not in self._roles:
            self._roles[role, type_id] = RoleType(role, type_id)
        return self._roles[role, type_id]

    def _robot(self, role: int, robot: str) -> Assignment:
        if (role, robot) not in self._robots:
            self._robots[role, robot] = Assignment(role, robot)
        return self._robots[role, robot]


def impossible(method: str, detail: str, reasons: tuple[Reason, ...], examined: int = 0) -> Ranking:
    """Proven that there is none."""
    certificate = Certificate(claim="proven", method=method, detail=detail)
    return Ranking(alternatives=(), status="infeasible", certificate=certificate, examined=examined, reasons=reasons)


def no_robot_able(flat: Flat, limit: int = 8) -> tuple[Reason, ...]:
    """Why there is no way through the tree: the XORs without children that block it, in preorder."""
    possible = structurally_possible(flat)
    blocking: list[str] = []
    stack = [0]
    while stack and len(blocking) < limit:
        node = stack.pop()
        if not possible[node]:
            stack.extend(flat.children[node][::-1])
            blocking += [] if flat.children[node] else [flat.label[node]]
    message = "has no robot able to do it, and there is no way round it."
    return tuple(Reason(rule="no_robot_able", message=f'"{label}" {message}', node=label) for label in blocking)
