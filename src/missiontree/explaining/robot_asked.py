"""Why does this robot type not do that task? Planned again with it there, at each role that it could fill."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from missiontree.briefing import Request
from missiontree.explaining.answering import best_of, moved_in_words, named, side_by_side, verdict_of
from missiontree.explaining.pinned import Found, pinned, plan_with
from missiontree.explaining.tasks import moved_between, tasks_of
from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.control import Control
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.objective import WEIGHTED, Objective
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Schedule
from missiontree.mission.tree import MissionNode
from missiontree.mission.why_not import WhyNot

BEST: dict[Objective, str] = {
    "utility": "best",
    "makespan": "fastest",
    "utility-makespan": "best",
    "weighted-team": "weightiest",
    "weighted-sum": "weightiest",
}
"""What a plan is that the objective chooses."""

MOST_ROLES = 60
"""Roles at which a type is tried before the answer is no longer called proven."""


def why_not_robot(plan: Plan, request: Request, type_id: str, nodes: Sequence[MissionNode], control: Control) -> WhyNot:
    """
    Say why robots of a type do not do a task, or what it would cost.

    Parameters
    ----------
    plan, request
        A delivered plan, and how it was made.
    type_id
        The robot type.
    nodes
        What it should do: routines or tasks, any of which will do.
    control
        Time limit.
    """
    assert plan.grounding is not None
    best = best_of(plan)
    assert best is not None
    tree, label = plan.grounding.tree, _label(plan, type_id)
    routines = _routines(plan, nodes)
    what = (
        nodes[0].label
        if len(nodes) == 1
        else f"one of {', '.join(node.label for node in nodes[:3])}{', …' if len(nodes) > 3 else ''}"
    )
    question = f"Why not {label} for {what}?"
    if plan.tree is not None and nodes and nodes[0].id == plan.tree.root.id:
        question, what = f"Why not {label}?", "any part of the mission"
    done = _done_already(tree, best[0], type_id, routines)
    if done:
        who = _by_whom(plan, best[1], done[0], type_id)
        words = (f"{label} does {_named(plan, done[0])} in {named(plan, best[0])} already{who}.",)
        return WhyNot(
            question=question,
            verdict="same",
            claim="proven",
            words=words,
            utility=best[0].utility,
            makespan_s=best[1].makespan_s,
        )
    roles = [(node, forbidden) for node in routines for forbidden in _ways_with(tree, node, type_id)]
    if not roles:
        return _refused(plan, question, type_id, what, routines, best)
    found: list[tuple[str, Found]] = [
        (node, pinned(plan, request, forbidden, control.part(1 / (len(roles) - place))))
        for place, (node, forbidden) in enumerate(roles[:MOST_ROLES])
    ]
    proven = len(roles) <= MOST_ROLES and all(one.proven for _, one in found)
    there = [(node, one) for node, one in found if one.alternative is not None and one.schedule is not None]
    if not there:
        return _in_vain(question, label, what, [one for _, one in found], best, proven)
    node, first = min(there, key=lambda one: _order(one[1], plan.brief.objective))
    return _beside(plan, question, f"{label} for {_named(plan, node)}", first, best, proven, type_id, node)


def _order(found: Found, objective: Objective) -> tuple[float, float]:
    assert found.alternative is not None
    assert found.schedule is not None
    utility, makespan_s = found.alternative.utility, found.schedule.makespan_s
    if objective in WEIGHTED and found.chosen is not None:
        return -found.chosen.worth, makespan_s
    return (makespan_s, -utility) if objective == "makespan" else (-utility, makespan_s)


def _label(plan: Plan, type_id: str) -> str:
    kind = plan.brief.fleet.by_id[type_id]
    return kind.label or kind.id


def _named(plan: Plan, node: str) -> str:
    return plan.tree.by_id[node].label if plan.tree is not None and node in plan.tree.by_id else node


def _routines(plan: Plan, nodes: Sequence[MissionNode]) -> list[str]:
    """Routine nodes at or below some nodes, in tree order."""
    assert plan.tree is not None
    tree = plan.tree
    return [
        node.id
        for node in tree.nodes
        if node.routine is not None and any(tree.contains(top.id, node.id) for top in nodes)
    ]


def _done_already(tree: GroundedTree, alternative: Alternative, type_id: str, routines: Sequence[str]) -> list[str]:
    selected = selected_leaves(tree, alternative.choices)
    done = {tree.nodes[leaf].source for leaf in selected if tree.action(leaf).robot_type == type_id}
    return [node for node in routines if node in done]


def _by_whom(plan: Plan, schedule: Schedule, node: str, type_id: str) -> str:
    """Which robot of the type does it, and that the others are its equals."""
    assert plan.grounding is not None
    tree, fleet = plan.grounding.tree, plan.brief.fleet
    robots = [
        assigned.robot
        for assigned in schedule.assignments
        if tree.roles[assigned.role].source == node and fleet.type_of[assigned.robot].id == type_id
    ]
    several = len(fleet.by_id[type_id].members) > 1
    alike = "; which robot of a type does it is decided when times are" if several else ""
    return f" ({', '.join(robots)}{alike})" if robots else ""


def _ways_with(tree: GroundedTree, node: str, type_id: str) -> Iterator[tuple[int, ...]]:
    """For each role of a routine that a type can fill, the nodes to forbid so that it fills it."""
    top = next(index for index, one in enumerate(tree.nodes) if one.source == node)
    reaching = tuple(_others_above(tree, top))
    alone = [child for child in tree.children[top] if not _forks(tree, child) and type_id in _types(tree, child)]
    if alone:
        yield (*reaching, *(child for child in tree.children[top] if child not in alone))
    for child in tree.children[top]:
        for fork in _forks(tree, child):
            able = [one for one in tree.children[fork] if type_id in _types(tree, one)]
            if able:
                others = (one for one in tree.children[top] if one != child)
                yield (*reaching, *others, *(one for one in tree.children[fork] if one not in able))


def _others_above(tree: GroundedTree, node: int) -> Iterator[int]:
    """What must not be chosen above a node so that it is reached."""
    while (parent := tree.nodes[node].parent) >= 0:
        if tree.nodes[parent].kind == "xor":
            yield from (child for child in tree.children[parent] if child != node)
        node = parent


def _forks(tree: GroundedTree, node: int) -> list[int]:
    return [below for below in _below(tree, node) if tree.nodes[below].kind == "xor"]


def _types(tree: GroundedTree, node: int) -> set[str]:
    return {tree.action(below).robot_type for below in _below(tree, node) if tree.nodes[below].kind == "action"}


def _below(tree: GroundedTree, node: int) -> Iterator[int]:
    waiting = [node]
    while waiting:
        one = waiting.pop()
        yield one
        waiting.extend(reversed(tree.children[one]))


def _refused(
    plan: Plan, question: str, type_id: str, what: str, routines: Sequence[str], best: tuple[Alternative, Schedule]
) -> WhyNot:
    """No role of it is offered to the type: the rules that refused it."""
    assert plan.grounding is not None
    told = [reason for reason in plan.grounding.not_offered if reason.node in routines]
    reasons = tuple(
        dict.fromkeys(
            [reason for reason in told if reason.robot == type_id] + [reason for reason in told if not reason.robot]
        )
    )
    words = [f"{_label(plan, type_id)} cannot do {what}; it is not offered at all."]
    return WhyNot(
        question=question,
        verdict="refused",
        claim="proven",
        words=tuple(words),
        reasons=reasons,
        utility=best[0].utility,
        makespan_s=best[1].makespan_s,
    )


def _in_vain(
    question: str, label: str, what: str, found: Sequence[Found], best: tuple[Alternative, Schedule], proven: bool
) -> WhyNot:
    """It could do a part of it, but no plan with that was found."""
    reasons = tuple(dict.fromkeys(reason for one in found for reason in one.reasons))
    if proven:
        words = f"{label} is able to do {what}, and no plan with that keeps all limits and times; proven."
    else:
        words = f"No plan with {label} for {what} was found in the time given; none is excluded."
    return WhyNot(
        question=question,
        verdict="impossible" if proven else "undecided",
        claim="proven" if proven else "found",
        words=(words,),
        reasons=reasons,
        utility=best[0].utility,
        makespan_s=best[1].makespan_s,
    )


def _beside(
    plan: Plan,
    question: str,
    asked: str,
    found: Found,
    best: tuple[Alternative, Schedule],
    proven: bool,
    type_id: str,
    node: str,
) -> WhyNot:
    """The best plan that is as asked for beside the plan."""
    assert found.alternative is not None
    assert found.schedule is not None
    (alternative, schedule), other, ends = best, found.alternative, found.schedule
    moved = moved_between(tasks_of(plan, alternative), tasks_of(plan, other))
    compared = side_by_side(
        alternative.utility, other.utility, schedule.makespan_s, ends.makespan_s, plan.brief.aim.worth
    )
    best_known = f"the {BEST[plan.brief.objective]} plan {'' if proven else 'found '}with that"
    words = [
        f"It can be done: {asked}. Of {best_known}: {compared}.",
        *_qualities(plan, alternative, other, node, type_id),
    ]
    notice = Reason(
        rule="asked_for",
        message=f"This plan is the best with {asked}, as it was asked for; it is not the best of all.",
        severity="notice",
        node=node,
        robot=type_id,
    )
    return WhyNot(
        question=question,
        verdict=verdict_of(
            alternative.utility, other.utility, schedule.makespan_s, ends.makespan_s, plan.brief.objective
        ),
        claim="proven" if proven else "found",
        words=(*words, *moved_in_words(moved)),
        asked_utility=other.utility,
        asked_makespan_s=ends.makespan_s,
        moved=moved,
        plan=plan_with(plan, found, notice),
        utility=best[0].utility,
        makespan_s=best[1].makespan_s,
    )


def _qualities(plan: Plan, one: Alternative, other: Alternative, node: str, type_id: str) -> Iterator[str]:
    """How well each of the two types does it, where both are rated by the same capability."""
    assert plan.grounding is not None
    tree = plan.grounding.tree

    def rated(alternative: Alternative) -> dict[str, tuple[str, float]]:
        leaves = [leaf for leaf in selected_leaves(tree, alternative.choices) if tree.nodes[leaf].source == node]
        return {
            tree.action(leaf).capability: (tree.action(leaf).robot_type, tree.action(leaf).estimate.quality)
            for leaf in leaves
        }

    before, after = rated(one), rated(other)
    for capability, (who, quality) in after.items():
        if who == type_id and capability in before and before[capability][1] != quality:
            was, better = before[capability]
            yield f"Quality of {capability}: {_label(plan, type_id)} {quality:g}, {_label(plan, was)} {better:g}."
