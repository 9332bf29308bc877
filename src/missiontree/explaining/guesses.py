"""Numbers that may be just enough: what reasons say is needed, what limits are compared with, what a plan without the limit uses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from missiontree.explaining.case import Case
from missiontree.explaining.changes.needs import Needs
from missiontree.explaining.probing import Answer
from missiontree.mission.change import Change
from missiontree.mission.explanation import Shortfall
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.schedule import Schedule


def guesses(change: Change, case: Case, needs: Needs, free: Answer, known: Sequence[Shortfall]) -> Iterator[float]:
    """
    Numbers worth trying first.

    Parameters
    ----------
    change
        What is to be sized.
    case
        The mission with the number as far as it can go.
    needs
        What its routines need.
    free
        What is known of that mission.
    known
        What falls short in the mission as it is.
    """
    name = "deadline_s" if change.kind == "extend_deadline" else change.name
    yield from (shortfall.needs for shortfall in known if shortfall.quantity == name)
    yield from needs.at_least.get(name, ())
    yield from needs.at_most.get(name, ())
    used = used_in(change, case, free)
    if used is not None:
        yield used


def used_in(change: Change, case: Case, answer: Answer) -> float | None:
    """What the schedule that was found takes of what a change is about; None if nothing was found, or that is not told by a number."""
    if answer.best is None or answer.grounding is None:
        return None
    tree, schedule = answer.grounding.tree, answer.best
    match change.kind:
        case "extend_deadline":
            return _end(tree, schedule, change.target)
        case "extend_stay":
            mine = (act for act in schedule.actions if change.target in {act.robot, tree.action(act.leaf).robot_type})
            return max((act.end_s for act in mine), default=0.0)
        case "raise_limit" | "raise_total" | "raise_stock":
            used = uses_by_robot(case, tree, schedule, change.name)
            of_type = case.brief.fleet.type_of
            whose = [amount for robot, amount in used.items() if change.target in {"", of_type[robot].id}]
            return max(whose, default=0.0) if change.kind == "raise_limit" else sum(whose)
        case _:
            return None


def _end(tree: GroundedTree, schedule: Schedule, node_id: str) -> float:
    """When all below a node of the mission tree has ended; all, if it is none."""
    if not node_id:
        return schedule.makespan_s
    inside: set[int] = set()
    for index, node in enumerate(tree.nodes):
        if node.source == node_id or node.parent in inside:
            inside.add(index)
    return max((act.end_s for act in schedule.actions if act.leaf in inside), default=0.0)


def uses_by_robot(case: Case, tree: GroundedTree, schedule: Schedule, name: str) -> dict[str, float]:
    """What each robot uses of a budget in a schedule, travel included."""
    used: dict[str, float] = {}
    for act in schedule.actions:
        used[act.robot] = used.get(act.robot, 0.0) + tree.action(act.leaf).uses.get(name, 0.0)
    for leg in schedule.ways:
        per_m = case.brief.fleet.type_of[leg.robot].uses_per_m.get(name, 0.0)
        used[leg.robot] = used.get(leg.robot, 0.0) + per_m * leg.distance_m
    return used
