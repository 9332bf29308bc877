"""Plans that were damaged by hand or by a foreign tool so that no page can be made of them."""

from __future__ import annotations

from missiontree.errors import InputError
from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.reporting.references import refuse_dangling

_HINT = "The plan is damaged; `missiontree check` lists its faults."


def refuse_damaged(plan: Plan) -> None:
    """
    Refuse a plan whose parts do not fit each other. Faults that can be shown are no reason; the checker names them.

    Raises
    ------
    InputError
        With the place of the first part that does not fit.
    """
    refuse_dangling(plan)
    try:
        plan.brief.world.extended(plan.tree.entities if plan.tree is not None else ())
    except ValueError as error:
        raise InputError(str(error), where="tree.entities", hint=_HINT) from error
    if plan.grounding is None:
        return
    tree = plan.grounding.tree
    alternatives = plan.ranking.alternatives if plan.ranking is not None else ()
    for place, alternative in enumerate(alternatives):
        if alternative.rank != place + 1:
            where = f"ranking.alternatives[{place}].rank"
            raise InputError(f"rank {alternative.rank}", where=where, accepted=str(place + 1), hint=_HINT)
        _refuse_astray(alternative, tree, f"ranking.alternatives[{place}]")
    for place, schedule in enumerate(plan.schedules):
        if schedule.rank > len(alternatives):
            where, ranks = f"schedules[{place}].rank", f"1 to {len(alternatives)}"
            raise InputError(f"rank {schedule.rank}", where=where, accepted=ranks, hint=_HINT)
        for index, assignment in enumerate(schedule.assignments):
            if assignment.role >= len(tree.roles):
                where, roles = f"schedules[{place}].assignments[{index}].role", f"0 to {len(tree.roles) - 1}"
                raise InputError(f"there is no role {assignment.role}", where=where, accepted=roles, hint=_HINT)


def _refuse_astray(alternative: Alternative, tree: GroundedTree, where: str) -> None:
    """Refuse an alternative whose choices do not lead through the tree, or that leaves a role which it reaches to nobody."""
    for choice in alternative.choices:
        if choice.xor >= len(tree.nodes) or choice.child not in tree.children[choice.xor]:
            found = f"node {choice.child} is not below node {choice.xor}"
            raise InputError(found, where=f"{where}.choices", hint=_HINT)
    try:
        leaves = selected_leaves(tree, alternative.choices)
    except KeyError as error:
        raise InputError(f"no child is chosen at node {error}", where=f"{where}.choices", hint=_HINT) from error
    filled = {entry.role for entry in alternative.roles}
    for leaf in leaves:
        if (role := tree.action(leaf).role) not in filled:
            raise InputError(f"nobody fills role {role}, which is reached", where=f"{where}.roles", hint=_HINT)
