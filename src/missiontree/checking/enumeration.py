"""Every selection of a small tree, written out plainly, to hold claims against."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.ranking import choice_key, utility_of
from missiontree.checking.staff_search import can_be_staffed
from missiontree.checking.staffing import Staffing
from missiontree.mission.alternative import Alternative, Choice
from missiontree.mission.certificate import Certificate
from missiontree.mission.grounded import GroundedTree

MOST_SELECTIONS = 2000
MOST_LEAVES = 20_000

Choices = tuple[tuple[int, int], ...]


def selections(tree: GroundedTree) -> list[Choices] | None:
    """Choices of every selection, in preorder; None if there are more than 2,000 below some node."""
    below: dict[int, list[Choices]] = {}
    for node in range(len(tree.nodes) - 1, -1, -1):
        children = tree.children[node]
        if tree.nodes[node].kind == "xor":
            ways = [((node, child), *rest) for child in children for rest in below[child]]
        else:
            ways = [()]
            for child in children:
                if len(ways) * len(below[child]) > MOST_SELECTIONS:
                    return None
                ways = [(*first, *rest) for first in ways for rest in below[child]]
        if len(ways) > MOST_SELECTIONS:
            return None
        below[node] = ways
    return below[0]


def every_alternative(case: Case) -> list[Staffing] | None:
    """
    Every alternative that can be staffed, best first; None if there are too many, or it cannot be told of one.

    By utility, then by choice indices in preorder.
    """
    found = list(_staffed(case))
    if any(entry is None for entry in found):
        return None
    weights = case.plan.brief.weights
    whole = [entry for entry in found if entry is not None]
    return sorted(whole, key=lambda staffing: (-utility_of(staffing, weights), choice_key(staffing)))


def _staffed(case: Case) -> Iterator[Staffing | None]:
    ways = selections(case.tree) if case.tree is not None else None
    if case.tree is None or ways is None or len(ways) * len(case.tree.nodes) > MOST_LEAVES * 100:
        yield None
        return
    for choices in ways:
        staffing = Staffing(case.tree, case.mission_tree, _bare(choices))
        if any(type_id not in case.fleet.by_id for type_id in staffing.type_of_role.values()):
            yield None
            return
        fits = can_be_staffed(staffing, case.fleet)
        if fits is None:
            yield None
            return
        if fits:
            yield staffing


def _bare(choices: Choices) -> Alternative:
    return Alternative(
        rank=1,
        utility=0.0,
        choices=tuple(Choice(xor, child) for xor, child in choices),
        roles=(),
        certificate=Certificate(claim="unproven", method="enumeration"),
    )
