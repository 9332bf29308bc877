"""A cause told with the number that a repair was proven to need: lower bounds of the stages leave out what they do not know."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.mission.chain import Step
from missiontree.mission.change import Change
from missiontree.mission.explanation import Cause, Repair, Shortfall
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.reporting.critical.chain import critical_chain

QUANTITIES = {"extend_deadline": "deadline_s", "extend_stay": "available_until_s"}


def closer(cause: Cause, repairs: Sequence[Repair]) -> Cause:
    """
    The cause, with the least that is enough where it is known.

    Parameters
    ----------
    cause
        What falls short.
    repairs
        What would make the mission possible. One counts that changes nothing but that number, and that was proven to be the smallest.
    """
    rule = {"robot_away": "extend_stay", "deadline_missed": "extend_deadline"}.get(cause.rule)
    fitting = [
        repair
        for repair in repairs
        if len(repair.changes) == 1 and repair.claim == "smallest_proven" and _fits(repair.changes[0], cause, rule)
    ]
    if len(fitting) != 1:
        return cause
    change = fitting[0].changes[0]
    if change.was is None or change.to is None:
        return cause
    quantity = QUANTITIES.get(change.kind, change.name)
    shortfall = Shortfall(quantity=quantity, has=change.was, needs=change.to)
    whole = change.kind == "extend_deadline" and not change.target
    return replace(cause, shortfall=shortfall, chain=_chain(fitting[0].plan) if whole else ())


def _chain(plan: Plan | None) -> tuple[str, ...]:
    """What makes the best schedule of a plan take as long as it does, step by step."""
    if plan is None or plan.grounding is None:
        return ()
    tree = plan.grounding.tree
    schedule = next(one for one in plan.schedules if one.status in {"optimal", "feasible"})
    steps = critical_chain(tree, schedule, plan.brief.world)
    return tuple(f"{step.start_s:g} s to {step.end_s:g} s: {step.robot}: {_does(tree, step)}" for step in steps)


def _does(tree: GroundedTree, step: Step) -> str:
    action = tree.action(step.leaf)
    match step.kind:
        case "travel":
            return f"on the way to {action.at}"
        case "home":
            return "on the way home"
        case "wait":
            return f"waits for {action.text!r}"
        case _:
            return action.text


def _fits(change: Change, cause: Cause, kind: str | None) -> bool:
    """Whether a change is of the number that a cause speaks of."""
    if kind is not None:
        return change.kind == kind
    return cause.shortfall is not None and change.name == cause.shortfall.quantity and change.to is not None
