"""The critical chain in parts that people can follow: one robot in one role each, and why it did not begin earlier."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from missiontree.mission.chain import Step
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.critical.chain import chain_of
from missiontree.reporting.critical.spans import ms
from missiontree.reporting.escape import one_line


@dataclass(frozen=True, slots=True)
class Part:
    """
    Steps of the chain that one robot does in one role, or a wait.

    Parameters
    ----------
    robot
        Who does it, or comes late, or waits.
    what
        The role, the way home, or what is waited for.
    start_s, end_s
        From when to when.
    travel_s
        Seconds of it on the way.
    waits
        Whether nothing is done.
    after
        Why it does not begin earlier, in words; empty at the start of the mission.
    """

    robot: str
    what: str
    start_s: float
    end_s: float
    travel_s: float
    waits: bool
    after: str


def parts_of(plan: Plan, schedule: Schedule) -> tuple[Part, ...]:
    """The chain of a schedule of a plan in parts, in order of time."""
    assert plan.grounding is not None
    tree = plan.grounding.tree
    runs: list[list[Step]] = []
    for step in chain_of(plan, schedule).steps:
        if runs and _goes_on(tree, runs[-1][-1], step):
            runs[-1].append(step)
        else:
            runs.append([step])
    chargers = plan.brief.scene.chargers if plan.brief.scene is not None else ()
    labels = {charger.id: one_line(charger.label) for charger in chargers}
    at = {(one.robot, ms(one.start_s)): labels.get(one.charger, one.charger) for one in schedule.recharges}
    return tuple(_parts(tree, runs, at))


def _goes_on(tree: GroundedTree, before: Step, step: Step) -> bool:
    waits = "wait" in {before.kind, step.kind} or step.kind in {"home", "refill"} or before.kind == "refill"
    same = before.robot == step.robot and tree.action(before.leaf).role == tree.action(step.leaf).role
    return same and not waits


def _parts(
    tree: GroundedTree, runs: Sequence[Sequence[Step]], chargers: Mapping[tuple[str, int], str]
) -> Iterator[Part]:
    """The parts; ``chargers``: what the one is called at which a robot begins to refill at a moment."""
    for place, run in enumerate(runs):
        before = runs[place - 1][-1] if place else None
        first, last = run[0], run[-1]
        waits = first.kind == "wait"
        yield Part(
            first.robot,
            _waiting(tree, first, runs[place + 1][0] if place + 1 < len(runs) else None)
            if waits
            else _doing(tree, first),
            first.start_s,
            last.end_s,
            sum(ms(step.end_s) - ms(step.start_s) for step in run if _moving(tree, step)) / 1000,
            waits,
            "" if before is None or before.kind == "wait" else _after(tree, before, first, chargers),
        )


def _doing(tree: GroundedTree, step: Step) -> str:
    if step.kind == "refill":
        return "refilling" if step.bond == "resource" else "refilling, the way to the charger included"
    return "the way home" if step.kind == "home" else one_line(tree.roles[tree.action(step.leaf).role].label)


def _moving(tree: GroundedTree, step: Step) -> bool:
    return step.kind in {"travel", "home"} or (step.kind == "action" and tree.action(step.leaf).moves)


def _waiting(tree: GroundedTree, step: Step, then: Step | None) -> str:
    held_by = "unexplained" if then is None else then.bond
    going_home = then is not None and then.kind == "home"
    text = "the way home" if going_home else one_line(tree.action(step.leaf).text)
    if held_by == "resource":
        return f"nothing: {text} waits for room in what robots share"
    if held_by == "release":
        return f"nothing: {text} may not start before"
    if held_by == "refill":
        return f"nothing: {text} waits for a robot that refills first"
    if held_by == "available":
        return f"nothing: {text} waits for a robot that comes then"
    return f"nothing, and the schedule does not say why: {text} could start earlier"


def _after(tree: GroundedTree, before: Step, step: Step, chargers: Mapping[tuple[str, int], str]) -> str:
    if step.kind == "refill" and step.bond == "resource":
        return f"once {before.robot} has left {chargers[step.robot, ms(step.start_s)]}"
    text = one_line(tree.action(before.leaf).text)
    if before.kind == "travel":
        text = f"on the way to: {text}"
    if step.bond == "refill":
        return f"once {step.robot} has refilled"
    if step.bond == "robot" or (step.bond == "role" and before.robot == step.robot):
        return f"once {step.robot} is free"
    if step.bond == "resource":
        return f"once {before.robot} has left what both need: {text}"
    if step.bond == "until":
        return f"ends with {before.robot}: {text}"
    if step.bond == "hand_over":
        return f"to hand over, after {before.robot}: {text}"
    if step.bond == "partner":
        return f"for joint work, after {before.robot}: {text}"
    if before.kind == "under_way":
        return f"once {before.robot} is at it: {text}"
    return f"after {before.robot}: {text}"
