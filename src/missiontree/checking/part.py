"""Is a plan for a part of a mission marked as one, is it of that part, and is there no larger one?"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from missiontree.checking.case import Case
from missiontree.checking.enumeration import best_first
from missiontree.checking.fault import Fault
from missiontree.mission.brief import MissionBrief
from missiontree.mission.partial import Partial
from missiontree.mission.plan import Plan
from missiontree.mission.routine import Routine
from missiontree.mission.tree import MissionTree
from missiontree.routines.ground import ground
from missiontree.routines.open_ended import pointless_until

MOST_SETS = 64
"""Lighter sets of parts beyond which it is not asked of each whether it could have been left out instead."""

CLOSE = Fraction(1, 10**9)


def partial_unsaid(case: Case) -> Iterator[Fault]:
    """The plan leaves something out and its outcome does not say so, or the other way round."""
    plan = case.plan
    if (plan.outcome == "partial") != (plan.partial is not None):
        yield Fault(
            f"the plan's outcome is {plan.outcome}, and it {'does not say what' if plan.partial is None else 'says what'} it leaves out.",
            found=plan.outcome,
            needed="partial, with what is left out, or neither",
        )


def part_not_of_whole(case: Case) -> Iterator[Fault]:
    """What is planned is not the whole mission without what is said to be left out, or that cannot be left out."""
    partial, tree = case.plan.partial, case.plan.tree
    if partial is None:
        return
    whole = partial.whole
    wrong = next((one.node for one in partial.left_out if not _can_be_left_out(whole, one.node)), None)
    if not partial.left_out or wrong is not None:
        yield Fault(
            f"{wrong or 'nothing'} is said to be left out; only children of an AND that has others can be.",
            node=wrong or "",
            needed="a child of an AND that has others",
        )
        return
    needed = _rest(whole, [one.node for one in partial.left_out], case.plan.brief)
    if needed is None or tree != needed:
        yield Fault(
            "the mission tree is not what is left of the whole mission.",
            found=f"{len(tree.nodes) if tree is not None else 0} nodes",
            needed=f"{len(needed.nodes) if needed is not None else 0} nodes",
        )


def part_weight_wrong(case: Case) -> Iterator[Fault]:
    """The weights are not those that the mission states and the tree gives."""
    partial = case.plan.partial
    if partial is None or not all(one.node in partial.whole.by_id for one in partial.left_out):
        return
    weight = _weights(partial.whole, case)
    lost = sum((weight[one.node] for one in partial.left_out), Fraction())
    total = weight[partial.whole.root.id]
    said = [(one.node, one.weight, weight[one.node]) for one in partial.left_out]
    said += [("the whole", partial.total, total), ("what is done", partial.kept, total - lost)]
    for what, found, needed in said:
        if abs(Fraction(found) - needed) > CLOSE * max(Fraction(1), needed):
            yield Fault(
                f"{what} is said to weigh {found:g}, and weighs {float(needed):g}.",
                node=what,
                found=f"{found:g}",
                needed=f"{float(needed):g}",
            )


def part_not_largest(case: Case) -> Iterator[Fault]:
    """In a small mission without times and places, all alternatives written out show that more of it can be done."""
    verdict = judge_part(case)
    if isinstance(verdict, Fault):
        yield verdict


def judge_part(case: Case) -> Fault | bool:
    """What all alternatives of all larger parts say of the claim: refuted, borne out (true), or more than can be told (false)."""
    partial = case.plan.partial
    if partial is None or partial.claim != "proven":
        return partial is None
    if not all(_can_be_left_out(partial.whole, one.node) for one in partial.left_out):
        return False
    lighter = _lighter(partial, case)
    if lighter is None:
        return False
    sure = True
    for left_out in lighter:
        possible = _possible(case.plan, partial.whole, left_out)
        if possible and _nothing_but_robots(case, partial):
            labels = ", ".join(partial.whole.by_id[node].label for node in left_out) or "nothing"
            return Fault(
                f"no larger part is said to be possible, and it is enough to leave out: {labels}.",
                found="proven",
                needed=labels,
            )
        sure = sure and possible is False
    return sure


def _can_be_left_out(whole: MissionTree, node: str) -> bool:
    parent = whole.by_id.get(whole.parent.get(node, ""))
    return parent is not None and parent.gate == "and" and len(parent.children) > 1


def _rest(whole: MissionTree, left_out: list[str], brief: MissionBrief) -> MissionTree | None:
    """The whole without some nodes, all below, and links that bind nothing then; None if nothing is left somewhere."""
    gone: set[str] = set()
    for node in whole.nodes:  # parents come first
        if node.id in left_out or whole.parent.get(node.id) in gone:
            gone.add(node.id)
    nodes = []
    for node in whole.nodes:
        if node.id in gone:
            continue
        children = tuple(child for child in node.children if child not in gone)
        if node.children and not children:
            return None
        nodes.append(replace(node, children=children))
    links = tuple(link for link in whole.links if not {link.first, link.second} & gone)
    if not nodes:
        return None
    rest = replace(whole, nodes=tuple(nodes), links=links)
    return replace(rest, links=tuple(link for link in links if not pointless_until(rest, link, brief.routines)))


def _weights(whole: MissionTree, case: Case) -> dict[str, Fraction]:
    """From the leaves up what each node counts by itself, then from the root down what share of its parent's weight it has."""
    stated = {_plain(name): Fraction(str(weight)) for name, weight in case.plan.brief.weighed.items()}
    labels = {entity.id: entity.label or entity.id for entity in case.scene.all_entities}
    by_itself: dict[str, Fraction] = {}
    for node in whole.nodes[::-1]:
        calls = []
        if node.routine is not None:
            calls = [
                f"{node.routine}({', '.join(node.arguments.values())})",
                f"{node.routine}({', '.join(labels.get(name, name) for name in node.arguments.values())})",
            ]
        names = [_plain(name) for name in (node.id, node.label, *calls, node.routine or node.id)]
        own = next((stated[name] for name in names if name in stated), None)
        below = [by_itself[child] for child in node.children]
        if own is None:
            own = sum(below, Fraction()) if node.gate == "and" else min(below, default=Fraction(1))
        by_itself[node.id] = own
    found = {whole.root.id: by_itself[whole.root.id]}
    for node in whole.nodes:
        if node.gate == "xor":
            found |= dict.fromkeys(node.children, found[node.id])
        elif node.children:
            total = sum(by_itself[child] for child in node.children)
            found |= {child: found[node.id] * by_itself[child] / total for child in node.children}
    return found


def _plain(name: str) -> str:
    """A name by which parts are compared: letter case, punctuation within names and articles before words aside."""
    pieces = []
    for piece in re.split(r"[(),]", name.casefold()):
        words = "".join(sign if sign.isalnum() else " " for sign in piece).split()
        pieces.append(" ".join(word for word in words[:-1] if word not in {"the", "a", "an"}).split() + words[-1:])
    return "|".join(" ".join(piece) for piece in pieces if piece)


def _lighter(partial: Partial, case: Case) -> list[tuple[str, ...]] | None:
    """Sets of parts that weigh less than what is left out, the empty one included; None if there are too many."""
    whole, weight = partial.whole, _weights(partial.whole, case)
    most = sum((weight[one.node] for one in partial.left_out), Fraction())
    sets: list[tuple[str, ...]] = [()]
    for node in whole.nodes:
        if not _can_be_left_out(whole, node.id):
            continue
        for known in list(sets):
            apart = not any(whole.contains(other, node.id) or whole.contains(node.id, other) for other in known)
            if apart and sum((weight[other] for other in known), weight[node.id]) < most:
                sets.append((*known, node.id))
        if len(sets) > MOST_SETS:
            return None
    return sets


def _possible(plan: Plan, whole: MissionTree, left_out: tuple[str, ...]) -> bool | None:
    """Whether robots can fill some alternative of the mission without some parts; None if it cannot be told."""
    tree = _rest(whole, list(left_out), plan.brief)
    if tree is None or tree.open_leaves:
        return False
    if plan.brief.estimator is not None or _search_left_out(whole, left_out, plan.brief):
        return None
    try:
        grounding = ground(tree, plan.brief)
    except Exception:  # a damaged whole may break whatever grounding relies on
        return None
    case = Case(replace(plan, tree=tree, grounding=grounding, ranking=None, schedules=(), partial=None))
    for staffing in best_first(case):
        return None if staffing is None else True
    return False


def _search_left_out(whole: MissionTree, left_out: tuple[str, ...], brief: MissionBrief) -> bool:
    """Whether something is left out that may find somebody with whom the rest has to do: then there may be nobody to fetch."""
    gone = {node.id for node in whole.nodes for top in left_out if whole.contains(top, node.id)}
    found = {
        node.arguments.get(step.finds)
        for node in whole.nodes
        if node.id in gone and node.routine is not None
        for routine in _with_parts(node.routine, brief)
        for branch in routine.branches
        for role in branch.roles
        for step in role.actions
        if step.finds is not None
    }
    return any(found & set(node.arguments.values()) for node in whole.nodes if node.id not in gone)


def _with_parts(name: str, brief: MissionBrief) -> list[Routine]:
    """A routine, and all that it is composed of."""
    known = [brief.routines.by_id[name]] if name in brief.routines.by_id else []
    for routine in known:
        for part in routine.parts:
            other = brief.routines.by_id.get(part.routine)
            if other is not None and other not in known:
                known.append(other)
    return known


def _nothing_but_robots(case: Case, partial: Partial) -> bool:
    """Whether any alternative that robots can fill can be scheduled: there are no times, places, or links but orders."""
    brief = case.plan.brief
    timed = brief.deadline_s is not None or any(
        node.release_s or node.deadline_s is not None for node in partial.whole.nodes
    )
    robots = [robot for kind in brief.fleet.types for robot in kind.members]
    comes_and_goes = any(one.available_from_s or one.available_until_s is not None for one in robots)
    limited = any(kind.limits or kind.total_limits for kind in brief.fleet.types)
    ordered = all(link.kind == "precedence" for link in partial.whole.links)
    return brief.scene is None and not timed and not comes_and_goes and not limited and ordered
