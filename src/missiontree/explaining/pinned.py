"""
A mission planned again with some choices forbidden, on the very tree of the plan.

What is forbidden is made impossible: below the AND of each forbidden child of an XOR an XOR without children is added, at the end of the
list of nodes. So all other nodes keep their numbers, and what is found is an alternative of the plan's own tree, which the
checker can hold against it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from missiontree.briefing import Request
from missiontree.checking import check
from missiontree.choosing.choose import choose
from missiontree.errors import InternalError
from missiontree.mission.alternative import Alternative, Ranking
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.front import Chosen, Option
from missiontree.mission.grounded import GroundedNode, GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Schedule
from missiontree.planner import staff_and_schedule
from missiontree.scheduling import SCHEDULERS

WORKING = ("optimal", "feasible")


@dataclass(frozen=True, slots=True)
class Found:
    """
    What planning again came to.

    Parameters
    ----------
    alternative, schedule
        The best alternative that can be scheduled; None if there is none.
    proven
        Whether it is proven that there is none better, or none at all.
    reasons
        Why there is none.
    chosen
        The same as the objective of the mission chooses it; None if that is utility alone.
    """

    alternative: Alternative | None
    schedule: Schedule | None
    proven: bool
    reasons: tuple[Reason, ...] = ()
    chosen: Chosen | None = None


def pinned(plan: Plan, request: Request, forbidden: Collection[int], control: Control) -> Found:
    """
    The best alternative, by the objective of the mission, of a plan's tree that selects none of the forbidden nodes.

    Parameters
    ----------
    plan, request
        The plan, and how it was made.
    forbidden
        Nodes below an XOR.
    control
        Time limit.
    """
    assert plan.grounding is not None
    assert plan.tree is not None
    grounding = replace(plan.grounding, tree=without_nodes(plan.grounding.tree, forbidden))
    alone = replace(request, brief=replace(request.brief, diverse=False), k=1)
    scene = plan.brief.world.extended(plan.tree.entities)
    ranking, schedules = staff_and_schedule(grounding, alone, scene, control)
    works = any(schedule.status in WORKING for schedule in schedules)
    if works and request.brief.objective != "utility":
        with_ = SCHEDULERS[request.scheduler]
        chosen = choose(grounding.tree, alone.brief, scene, with_, control, ranking, schedules).chosen
        if chosen is not None:
            one = chosen.option
            return Found(one.alternative, one.schedule, one.certificate.claim == "proven", (), chosen)
    proven = ranking.status in {"exact", "infeasible"}
    for alternative, schedule in zip(ranking.alternatives, schedules, strict=True):
        if schedule.status in WORKING:
            return Found(alternative, schedule, proven)
        proven = proven and schedule.status == "infeasible"
    complete = ranking.certificate.bound is None
    reasons = (*ranking.reasons, *(reason for schedule in schedules for reason in schedule.reasons))
    return Found(None, None, proven and complete, tuple(dict.fromkeys(reasons)))


def without_nodes(tree: GroundedTree, forbidden: Collection[int]) -> GroundedTree:
    """The same tree, in which nothing selects the forbidden nodes."""
    dead = [node for start in sorted(forbidden) for node in _ands(tree, start)]
    added = tuple(GroundedNode(parent=node, kind="xor", label=tree.nodes[node].label) for node in dead)
    return replace(tree, nodes=(*tree.nodes, *added))


def _ands(tree: GroundedTree, start: int) -> Iterator[int]:
    """The ANDs that have to be impossible so that a node is."""
    waiting = [start]
    while waiting:
        node = waiting.pop()
        if tree.nodes[node].kind == "and":
            yield node
        else:
            waiting.extend(tree.children[node])


def plan_with(plan: Plan, found: Found, notice: Reason) -> Plan:
    """The plan with what was found in place of its alternatives; it claims nothing of their rank."""
    assert found.alternative is not None
    assert found.schedule is not None
    assert plan.ranking is not None
    unranked = Certificate(claim="unproven", method=plan.ranking.certificate.method)
    alternative = replace(found.alternative, rank=1, certificate=unranked)
    chosen = None
    if found.chosen is not None:
        unproven = Certificate(claim="unproven", method=found.chosen.option.certificate.method)
        option = Option(alternative=alternative, schedule=replace(found.schedule, rank=1), certificate=unproven)
        chosen = Chosen(option=option, worth=found.chosen.worth)
    made = replace(
        plan,
        chosen=chosen,
        front=None,
        ranking=Ranking(alternatives=(alternative,), status="partial", certificate=unranked),
        schedules=(replace(found.schedule, rank=1),),
        notices=(*plan.notices, notice),
        assumptions=tuple(dict.fromkeys((*plan.assumptions, *found.schedule.assumptions))),
    )
    if faults := check(made):
        raise InternalError(f"the checker refuses a plan that was asked for: {faults[0].rule}: {faults[0].message}")
    return made
