"""Plans that were damaged by hand or by a foreign tool so that their parts do not fit each other: they cannot even be shown."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from missiontree.errors import InputError
from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.as_ranking import as_ranking, options_of
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule


def refuse_dangling(plan: Plan) -> None:
    """
    Refuse a plan whose alternatives or schedules point past its grounded tree: enough for whoever shows one of its parts.

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
    if options := options_of(plan):
        _refuse_options(as_ranking(plan, options), refuse_dangling)


def _refuse_options(options: Plan, refuse: Callable[[Plan], None]) -> None:
    """Refuse options that point astray, as alternatives and schedules of a plan are refused."""
    try:
        refuse(options)
    except InputError as error:
        raise replace(error, where=f"front or chosen, as {error.where}") from error


def refuse_damaged(plan: Plan) -> None:
    """
    Refuse a plan of which not all can be told. Faults that can be shown are no reason; the checker names them.

    Raises
    ------
    InputError
        With the place of the first part that does not fit.
    """
    refuse_dangling(plan)
    world_of(plan)
    if plan.grounding is None:
        return
    tree = plan.grounding.tree
    alternatives = plan.ranking.alternatives if plan.ranking is not None else ()
    for place, alternative in enumerate(alternatives):
        if alternative.rank != place + 1:
            raise _dangling(f"rank {alternative.rank}", f"ranking.alternatives[{place}].rank", str(place + 1))
        _refuse_astray(alternative, tree, f"ranking.alternatives[{place}]")
    for place, schedule in enumerate(plan.schedules):
        if schedule.rank > len(alternatives):
            raise _dangling(f"rank {schedule.rank}", f"schedules[{place}].rank", f"1 to {len(alternatives)}")
        for index, assignment in enumerate(schedule.assignments):
            if assignment.role >= len(tree.roles):
                where = f"schedules[{place}].assignments[{index}].role"
                raise _dangling(f"there is no role {assignment.role}", where, f"0 to {len(tree.roles) - 1}")
    for shown in (plan.front.options if plan.front is not None else (), (plan.chosen.option,) if plan.chosen else ()):
        if shown:
            _refuse_options(as_ranking(plan, shown), refuse_damaged)


def world_of(plan: Plan) -> Scene:
    """
    The world of a plan, introduced entities included.

    Raises
    ------
    InputError
        If an entity stands in it twice.
    """
    try:
        return plan.brief.world.extended(plan.tree.entities if plan.tree is not None else ())
    except ValueError as error:
        raise _dangling(str(error), "tree.entities") from error


def _refuse_astray(alternative: Alternative, tree: GroundedTree, where: str) -> None:
    """Refuse an alternative whose choices do not lead through the tree, or that leaves a role which it reaches to nobody."""
    for choice in alternative.choices:
        if choice.xor >= len(tree.nodes) or choice.child not in tree.children[choice.xor]:
            raise _dangling(f"node {choice.child} is not below node {choice.xor}", f"{where}.choices")
    try:
        leaves = selected_leaves(tree, alternative.choices)
    except KeyError as error:
        raise _dangling(f"no child is chosen at node {error}", f"{where}.choices") from error
    filled = {entry.role for entry in alternative.roles}
    for leaf in leaves:
        if (role := tree.action(leaf).role) not in filled:
            raise _dangling(f"nobody fills role {role}, which is reached", f"{where}.roles")


def _refuse_leaves(schedule: Schedule, tree: GroundedTree, where: str) -> None:
    for index, scheduled in enumerate(schedule.actions):
        if scheduled.leaf >= len(tree.nodes) or tree.nodes[scheduled.leaf].action is None:
            found = f"node {scheduled.leaf} of the grounded tree is not an action"
            raise _dangling(found, f"{where}[{index}].leaf", "the index of a node of kind 'action'")


def _dangling(found: str, where: str, accepted: str = "") -> InputError:
    hint = "The plan is damaged; `missiontree check` lists its faults."
    return InputError(found, where=where, accepted=accepted, hint=hint)
