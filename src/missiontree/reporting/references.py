"""Numbers in a plan that point at nodes and roles which are not there: a plan that cannot even be shown."""

from __future__ import annotations

from missiontree.errors import InputError
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule


def refuse_dangling(plan: Plan) -> None:
    """
    Refuse a plan, damaged by hand or by a foreign tool, whose alternatives or schedules point past its grounded tree.

    Raises
    ------
    InputError
        With the place of the first such number.
    """
    if plan.grounding is None:
        if plan.schedules:
            raise InputError("the plan has schedules, and no grounding that they could belong to", where="schedules")
        return
    tree = plan.grounding.tree
    for number, alternative in enumerate(plan.ranking.alternatives if plan.ranking else ()):
        for index, filled in enumerate(alternative.roles):
            if filled.role >= len(tree.roles):
                where = f"ranking.alternatives[{number}].roles[{index}].role"
                raise _dangling(f"there is no role {filled.role}", where, f"0 to {len(tree.roles) - 1}")
    for number, schedule in enumerate(plan.schedules):
        _refuse_leaves(schedule, tree, f"schedules[{number}].actions")


def _refuse_leaves(schedule: Schedule, tree: GroundedTree, where: str) -> None:
    for index, scheduled in enumerate(schedule.actions):
        if scheduled.leaf >= len(tree.nodes) or tree.nodes[scheduled.leaf].action is None:
            found = f"node {scheduled.leaf} of the grounded tree is not an action"
            raise _dangling(found, f"{where}[{index}].leaf", "the index of a node of kind 'action'")


def _dangling(found: str, where: str, accepted: str) -> InputError:
    hint = "The plan is damaged; `missiontree check` lists its faults."
    return InputError(found, where=where, accepted=accepted, hint=hint)
