"""Every selection of a small tree, written out plainly, to hold claims against."""

from __future__ import annotations

from collections.abc import Iterator
from operator import add, mul

from missiontree.checking.case import Case
from missiontree.checking.ranking import choice_key, team_of, utility_of
from missiontree.checking.soonest import too_late
from missiontree.checking.staff_search import can_be_staffed
from missiontree.checking.staffing import Staffing
from missiontree.mission.alternative import Alternative, Choice
from missiontree.mission.certificate import Certificate
from missiontree.mission.grounded import GroundedTree

MOST_SELECTIONS = 2000
MOST_NODES = 200_000

Choices = tuple[tuple[int, int], ...]


def selections(tree: GroundedTree) -> list[Choices] | None:
    """Choices of every selection, in preorder; None if there are more than 2,000 below some node."""
    if _too_many(tree):
        return None
    below: dict[int, list[Choices]] = {}
    for node in range(len(tree.nodes) - 1, -1, -1):
        children = tree.children[node]
        if tree.nodes[node].kind == "xor":
            ways = [((node, child), *rest) for child in children for rest in below[child]]
        else:
            ways = [()]
            for child in children:
                ways = [(*first, *rest) for first in ways for rest in below[child]]
        below[node] = ways
    return below[0]


def _too_many(tree: GroundedTree) -> bool:
    """Whether there are more than 2,000 selections below some node."""
    number: dict[int, int] = {}
    for node in range(len(tree.nodes) - 1, -1, -1):
        together = add if tree.nodes[node].kind == "xor" else mul
        number[node] = int(together is mul)
        for child in tree.children[node]:
            number[node] = together(number[node], number[child])
            if number[node] > MOST_SELECTIONS:
                return True
    return False


def best_first(case: Case) -> Iterator[Staffing | None]:
    """
    Every alternative that robots can fill and that can meet its deadlines, best first: by utility, then by choice indices in preorder.

    Where teams are to differ, only the first of each team.

    None comes in place of one of which it cannot be told whether robots can fill it, or of all where there are too many.
    """
    tree = case.tree
    ways = selections(tree) if tree is not None else None
    if tree is None or ways is None or len(ways) * len(tree.nodes) > MOST_NODES:
        yield None
        return
    brief, teams = case.plan.brief, set[frozenset[str]]()
    staffings = [Staffing(tree, case.mission_tree, _bare(choices)) for choices in ways]
    staffings.sort(key=lambda staffing: (-utility_of(staffing, brief), choice_key(staffing)))
    for staffing in staffings:
        if brief.diverse and team_of(staffing) in teams:
            continue
        known = all(type_id in case.fleet.by_id for type_id in staffing.type_of_role.values())
        fits = can_be_staffed(staffing, case) if known else None
        if known and too_late(case, staffing) is not None:
            continue
        teams |= {team_of(staffing)} if fits else set()
        if fits is not False:
            yield staffing if fits else None


def _bare(choices: Choices) -> Alternative:
    return Alternative(
        rank=1,
        utility=0.0,
        choices=tuple(Choice(xor, child) for xor, child in choices),
        roles=(),
        certificate=Certificate(claim="unproven", method="enumeration"),
    )
