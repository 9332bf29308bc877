"""The largest part of a mission by brute force: every set of parts is left out in turn, and what remains is planned."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import combinations

from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.explaining.lost import lost_uses
from missiontree.mission.control import Control
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.tree import MissionNode, MissionTree
from missiontree.planner import plan_authored


def best_by_force(request: Request, authored: Authored, weight: dict[str, Fraction]) -> tuple[Fraction | None, bool]:
    """The greatest weight that can be kept, None if nothing can be done; and whether each question was decided."""
    tree = authored.tree
    assert tree is not None
    best: Fraction | None = None
    decided = True
    for left_out in sets_of(tree):
        kept = _rest(tree, left_out, request.brief.routines)
        if kept is None:
            continue
        worth = weight[tree.root.id] - sum(weight[node] for node in left_out)
        if best is not None and worth <= best:
            continue
        if not lost_uses(kept, request.brief) <= lost_uses(tree, request.brief):
            continue  # somebody lost would be fetched with nobody to find him first
        made = plan_authored(request, _with(authored, kept), Control())
        if made.outcome == "delivered":
            best = worth
        decided = decided and made.outcome in {"delivered", "cannot_be_done"}
    return best, decided


def _with(authored: Authored, tree: MissionTree) -> Authored:
    return Authored(status="complete", tree=tree, author="given", notices=authored.notices)


def sets_of(tree: MissionTree) -> list[tuple[str, ...]]:
    """Every set of parts that can be left out, the empty one included."""
    optional = [
        child for node in tree.nodes if node.gate == "and" and len(node.children) > 1 for child in node.children
    ]
    return [
        chosen
        for size in range(len(optional) + 1)
        for chosen in combinations(optional, size)
        if not any(one != other and tree.contains(one, other) for one in chosen for other in chosen)
    ]


def _rest(tree: MissionTree, left_out: tuple[str, ...], library: RoutineLibrary) -> MissionTree | None:
    """The tree built anew from the root down; None if a task loses all its children."""
    nodes: list[MissionNode] = []
    waiting = [tree.root.id]
    while waiting:
        node = tree.by_id[waiting.pop()]
        children = tuple(child for child in node.children if child not in left_out)
        if node.children and not children:
            return None
        nodes.append(replace(node, children=children))
        waiting += reversed(children)
    names = {node.id for node in nodes}
    links = tuple(link for link in tree.links if names >= {link.first, link.second})
    links = tuple(link for link in links if link.kind != "until" or _goes_on(tree, link.first, names, library))
    return replace(tree, nodes=tuple(nodes), links=links)


def _goes_on(tree: MissionTree, node: str, names: set[str], library: RoutineLibrary) -> bool:
    """Whether some action that is left below a node has no end of its own."""
    below = [one for one in tree.nodes if one.id in names and tree.contains(node, one.id) and one.routine is not None]
    waiting = [library.by_id[one.routine or ""] for one in below]
    while waiting:
        routine = waiting.pop()
        for branch in routine.branches:
            if any(step.open_ended for role in branch.roles for step in role.actions):
                return True
        waiting += [library.by_id[part.routine] for part in routine.parts]
    return False
